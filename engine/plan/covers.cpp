// SPDX-License-Identifier: Apache-2.0
#include "plan/covers.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/overloaded.h"
#include "core/result.h"
#include "geometry/facet_contact.h"
#include "plan/compile_media.h"
#include "plan/reach.h"
#include "scene/place.h"

namespace pol {

namespace {

/// What of a body can lie in a face of another one.
struct Boundary {
    Mesh mesh;                       ///< empty: a sphere
    const Sphere* sphere = nullptr;  ///< or null
    bool open = false;               ///< it has no inside: both of its sides can be met
    Box box{};
    double slack = 0.0;
};

Boundary boundary_of(const SurfaceShape& shape) {
    Boundary boundary;
    std::visit(Overloaded{
                   [&](const OpenSurface& s) {
                       boundary.mesh = s.mesh();
                       boundary.open = true;
                   },
                   [&](const HalfSpaceSolid& s) { boundary.mesh = s.mesh(); },
                   [&](const Sphere& s) { boundary.sphere = &s; },
                   [&](const MeshBody& s) {
                       boundary.mesh = s.mesh;
                       boundary.open = !s.closed;
                   },
               },
               shape);
    boundary.box = box_around(shape);
    boundary.slack = slack(shape);
    return boundary;
}

bool is_absorber(const Surface& surface) {
    return std::holds_alternative<AbsorberRole>(surface.role);
}

Error in_one_place(const Scene& scene, const Surface& a, const Surface& b) {
    return at_object(
        {ErrorKind::input,
         "'" + a.name + "' and '" + b.name + "' lie in one surface and overlap: which one does a ray meet?",
         {},
         "transform",
         "leave a small gap between them"},
        scene, b.object);
}

/// Whether some ray could meet either of them in the same point. Faces of closed surfaces that face each other cannot
/// be seen.
bool coincide(const Boundary& a, const Boundary& b) {
    if (a.box.apart(b.box, a.slack + b.slack)) return false;
    if (a.sphere != nullptr && b.sphere != nullptr) return !common_facets(a.sphere, b.sphere, Facing::same).empty();
    if (a.sphere != nullptr || b.sphere != nullptr) return false;
    if (!flush_facets(a.mesh, b.mesh, Facing::same).empty()) return true;
    return (a.open || b.open) && !flush_facets(a.mesh, b.mesh, Facing::opposite).empty();
}

Result<Done> refuse_coincident(const Scene& scene, const Plan& plan, const std::vector<Boundary>& boundaries) {
    for (std::size_t i = 0; i < boundaries.size(); ++i) {
        for (std::size_t j = i + 1; j < boundaries.size(); ++j) {
            const Surface& a = plan.surfaces[i];
            const Surface& b = plan.surfaces[j];
            if (!(is_absorber(a) && is_absorber(b)) && coincide(boundaries[i], boundaries[j]))
                return in_one_place(scene, a, b);
        }
    }
    return Done{};
}

}  // namespace

std::size_t facet_count(const Solid& solid) {
    return std::visit(Overloaded{
                          [](const HalfSpaceSolid& s) { return s.mesh().facets.size(); },
                          [](const Sphere&) { return std::size_t{1}; },
                          [](const MeshBody& s) { return s.mesh.facets.size(); },
                      },
                      solid.shape);
}

void add_contact(Solid& solid, std::vector<std::vector<Contact>> Solid::*list, int facet, const Contact& contact) {
    std::vector<std::vector<Contact>>& by_facet = solid.*list;
    if (by_facet.empty()) by_facet.resize(facet_count(solid));
    by_facet[static_cast<std::size_t>(facet)].push_back(contact);
}

Result<Done> find_covers(const Scene& scene, Plan& plan) {
    std::vector<Boundary> boundaries;
    for (const Surface& surface : plan.surfaces) boundaries.push_back(boundary_of(surface.shape));
    POL_TRY_DONE(refuse_coincident(scene, plan, boundaries));
    for (Solid& solid : plan.solids) {
        if (std::holds_alternative<Sphere>(solid.shape)) continue;
        const auto* half_spaces = std::get_if<HalfSpaceSolid>(&solid.shape);
        const Mesh& mesh = half_spaces != nullptr ? half_spaces->mesh() : std::get<MeshBody>(solid.shape).mesh;
        const Box box = box_around(solid);
        const double own_slack = slack(solid_ref(solid));
        for (std::size_t i = 0; i < boundaries.size(); ++i) {
            if (box.apart(boundaries[i].box, own_slack + boundaries[i].slack)) continue;
            const Surface& surface = plan.surfaces[i];
            for (const Facing facing : {Facing::same, Facing::opposite}) {
                for (const FacetPair& pair : flush_facets(mesh, boundaries[i].mesh, facing)) {
                    if (std::holds_alternative<SheetRole>(surface.role))
                        return at_object({ErrorKind::input,
                                          "sheet '" + surface.name + "' lies in a face of '" + solid.name + "'",
                                          {},
                                          "transform",
                                          "leave a small gap between them"},
                                         scene, surface.object);
                    add_contact(
                        solid, &Solid::covers, pair.a,
                        {plan.solid_count() + static_cast<int>(i), pair.b, facing == Facing::same, pair.distance});
                }
            }
        }
    }
    return Done{};
}

std::vector<std::string> near_misses(const Plan& plan) {
    const int count = plan.solid_count() + static_cast<int>(plan.surfaces.size());
    std::vector<Boundary> boundaries;
    for (const Solid& solid : plan.solids)
        boundaries.push_back(std::visit([](const auto& s) { return boundary_of(SurfaceShape{s}); }, solid.shape));
    for (const Surface& surface : plan.surfaces) boundaries.push_back(boundary_of(surface.shape));
    std::vector<std::string> pairs;
    for (int i = 0; i < count; ++i) {
        for (int j = i + 1; j < count; ++j) {
            const Boundary& a = boundaries[static_cast<std::size_t>(i)];
            const Boundary& b = boundaries[static_cast<std::size_t>(j)];
            const double beyond =
                0.5e-6 * std::min(glm::length(a.box.high - a.box.low), glm::length(b.box.high - b.box.low));
            if (a.box.apart(b.box, a.slack + b.slack + beyond)) continue;
            bool near = false;
            for (const Facing facing : {Facing::same, Facing::opposite})
                near = near || flush_facets(a.mesh, b.mesh, facing, beyond).size() >
                                   flush_facets(a.mesh, b.mesh, facing).size();
            if (near) pairs.push_back("'" + plan.body_name(i) + "' and '" + plan.body_name(j) + "'");
        }
    }
    return pairs;
}

}  // namespace pol
