// SPDX-License-Identifier: Apache-2.0
#include "plan/arrangement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "core/overloaded.h"
#include "geometry/overlap.h"
#include "plan/compile_media.h"

namespace pol {

namespace {

using Relations = std::vector<std::vector<Arrangement>>;

SolidRef ref(const Solid& solid) {
    return std::visit(Overloaded{
                          [](const HalfSpaceSolid& s) -> SolidRef { return &s; },
                          [](const Sphere& s) -> SolidRef { return &s; },
                          [](const MeshBody& s) -> SolidRef { return &s.mesh; },
                      },
                      solid.shape);
}

const std::vector<Plane>& facets(const Solid& solid) {
    static const std::vector<Plane> none;
    return std::visit(Overloaded{
                          [](const HalfSpaceSolid& s) -> const std::vector<Plane>& { return s.mesh().facets; },
                          [](const Sphere&) -> const std::vector<Plane>& { return none; },
                          [](const MeshBody& s) -> const std::vector<Plane>& { return s.mesh.facets; },
                      },
                      solid.shape);
}

bool share_volume(Arrangement a) {
    return a == Arrangement::a_contains_b || a == Arrangement::b_contains_a || a == Arrangement::overlapping;
}

/// Whether `a` fills the volume that both have in common.
bool outranks(const Plan& plan, const Relations& relations, int a, int b) {
    const int rank_a = plan.solid(a).priority.value_or(0);
    const int rank_b = plan.solid(b).priority.value_or(0);
    if (rank_a != rank_b) return rank_a > rank_b;
    return relations[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] == Arrangement::b_contains_a;
}

Error overlap_error(const Scene& scene, const Solid& a, const Solid& b) {
    return at_object({ErrorKind::input,
                      "'" + a.name + "' and '" + b.name + "' overlap: which of them fills the volume that both claim?",
                      {},
                      "priority",
                      "move them apart, let them touch, or give one a higher priority"},
                     scene, b.object);
}

void add_contact(Plan& plan, int solid, int facet, const Contact& contact) {
    Solid& s = plan.solids[static_cast<std::size_t>(solid)];
    if (s.contacts.empty()) s.contacts.resize(facets(s).size());
    s.contacts[static_cast<std::size_t>(facet)].push_back(contact);
}

/// Facets that lie in one plane and look the same way: a nested solid whose face is part of its host's face.
std::vector<FacetPair> flush_facets(const Solid& a, const Solid& b, double margin) {
    std::vector<FacetPair> pairs;
    for (std::size_t i = 0; i < facets(a).size(); ++i)
        for (std::size_t j = 0; j < facets(b).size(); ++j) {
            const Plane& p = facets(a)[i];
            const Plane& q = facets(b)[j];
            if (length2(p.normal - q.normal) < 1e-18 && std::abs(p.offset - q.offset) <= margin)
                pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
        }
    return pairs;
}

Result<Relations> relate(const Scene& scene, Plan& plan) {
    const int count = plan.solid_count();
    Relations relations(static_cast<std::size_t>(count),
                        std::vector<Arrangement>(static_cast<std::size_t>(count), Arrangement::disjoint));
    for (int a = 0; a < count; ++a) {
        for (int b = a + 1; b < count; ++b) {
            const SolidRef ref_a = ref(plan.solid(a));
            const SolidRef ref_b = ref(plan.solid(b));
            const Arrangement ab = arrangement(ref_a, ref_b);
            relations[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] = ab;
            const Arrangement ba = ab == Arrangement::a_contains_b   ? Arrangement::b_contains_a
                                   : ab == Arrangement::b_contains_a ? Arrangement::a_contains_b
                                                                     : ab;
            relations[static_cast<std::size_t>(b)][static_cast<std::size_t>(a)] = ba;
            if (ab == Arrangement::overlapping &&
                plan.solid(a).priority.value_or(0) == plan.solid(b).priority.value_or(0))
                return overlap_error(scene, plan.solid(a), plan.solid(b));
            if (ab == Arrangement::disjoint) continue;
            const bool flush = share_volume(ab);
            const auto pairs = flush ? flush_facets(plan.solid(a), plan.solid(b), 1e-9 * plan.length_scale)
                                     : touching_facets(ref_a, ref_b);
            for (const FacetPair& pair : pairs) {
                add_contact(plan, a, pair.a, {b, pair.b, flush});
                add_contact(plan, b, pair.b, {a, pair.a, flush});
            }
        }
    }
    return relations;
}

/// Points whose convex hull holds the surface, widened by a radius.
struct Hull {
    std::vector<DVec3> points;
    double radius = 0.0;
};

Hull hull_of(const Surface& surface) {
    return std::visit(Overloaded{
                          [](const OpenSurface& s) {
                              const DVec3& c = s.center();
                              const DVec3& u = s.half_u();
                              const DVec3& v = s.half_v();
                              return Hull{{c + u + v, c + u - v, c - u + v, c - u - v}, 0.0};
                          },
                          [](const HalfSpaceSolid& s) {
                              return Hull{s.vertices(), 0.0};
                          },
                          [](const Sphere& s) {
                              return Hull{{s.center}, s.radius};
                          },
                          [](const MeshBody& s) {
                              return Hull{s.mesh.vertices, 0.0};
                          },
                      },
                      surface.shape);
}

/// True if the whole solid lies on one side of the plane; touching it counts as beside.
bool beside(const Plane& plane, const Solid& solid, double margin) {
    const auto one_side = [&](const std::vector<DVec3>& points) {
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (const DVec3& p : points) {
            const double height = dot(plane.normal, p) - plane.offset;
            low = std::min(low, height);
            high = std::max(high, height);
        }
        return low >= -margin || high <= margin;
    };
    return std::visit(
        Overloaded{
            [&](const HalfSpaceSolid& s) { return one_side(s.vertices()); },
            [&](const Sphere& s) { return std::abs(dot(plane.normal, s.center) - plane.offset) >= s.radius - margin; },
            [&](const MeshBody& s) { return one_side(s.mesh.vertices); },
        },
        solid.shape);
}

/// True if the surface surely has no point inside the solid. Lying on its boundary is outside.
bool surely_outside(const Surface& surface, const Hull& hull, const Solid& solid, double margin) {
    if (const auto* open = std::get_if<OpenSurface>(&surface.shape);
        open != nullptr && beside(open->plane(), solid, margin))
        return true;
    const auto* half_spaces = std::get_if<HalfSpaceSolid>(&solid.shape);
    if (half_spaces == nullptr) return false;
    for (int i = 0; i < half_spaces->facet_count(); ++i) {
        const Plane& plane = half_spaces->plane(i);
        if (std::all_of(hull.points.begin(), hull.points.end(),
                        [&](const DVec3& p) { return dot(plane.normal, p) - plane.offset >= hull.radius - margin; }))
            return true;
    }
    return false;
}

/// True if the surface surely lies wholly inside the solid.
bool surely_inside(const Hull& hull, const Solid& solid, double margin) {
    const auto all_in = [&](const auto& shape) {
        return std::all_of(hull.points.begin(), hull.points.end(),
                           [&](const DVec3& p) { return shape.contains(p, hull.radius + margin); });
    };
    return std::visit(Overloaded{
                          [&](const HalfSpaceSolid& s) { return all_in(s); },
                          [&](const Sphere& s) { return all_in(s); },
                          [](const MeshBody&) { return false; },
                      },
                      solid.shape);
}

bool has(const std::vector<int>& sorted, int value) {
    return std::binary_search(sorted.begin(), sorted.end(), value);
}

class RegionBuilder {
public:
    RegionBuilder(const Scene& scene, const Relations& relations, Plan& plan)
        : scene_(scene), relations_(relations), plan_(plan) {}

    /// All sets of solids that a point can be inside of, reached from outside by crossing one boundary at a time.
    Result<Done> build() {
        find({});
        for (std::size_t i = 0; i < plan_.regions.size(); ++i) {
            std::vector<int> toggled(plan_.solids.size(), -1);
            for (int solid = 0; solid < plan_.solid_count(); ++solid) {
                std::vector<int> members = plan_.regions[i].members;
                if (has(members, solid))
                    std::erase(members, solid);
                else
                    members.insert(std::upper_bound(members.begin(), members.end(), solid), solid);
                if (possible(members)) toggled[static_cast<std::size_t>(solid)] = find(members);
            }
            plan_.regions[i].toggled = std::move(toggled);
            if (plan_.regions.size() > 4096)
                return refusal(plan_.regions.back(), "overlaps others, in more than 4096 ways in all",
                               "use fewer overlapping solids");
        }
        for (Region& region : plan_.regions) {
            if (auto done = list_candidates(region); !done) return done.error();
        }
        return Done{};
    }

private:
    [[nodiscard]] Arrangement relation(int a, int b) const {
        return relations_[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
    }

    [[nodiscard]] bool possible(const std::vector<int>& members) const {
        for (const int a : members)  // few: in most scenes nearly all sets end here
            for (const int b : members)
                if (a < b && !share_volume(relation(a, b))) return false;
        for (const int member : members)
            for (int host = 0; host < plan_.solid_count(); ++host)
                if (relation(host, member) == Arrangement::a_contains_b && !has(members, host)) return false;
        return true;
    }

    /// About the solid that owns the region.
    [[nodiscard]] Error refusal(const Region& region, const std::string& what, std::string hint) const {
        const Solid& owner = plan_.solid(region.owner);
        return at_object({ErrorKind::input, "'" + owner.name + "' " + what, {}, {}, std::move(hint)}, scene_,
                         owner.object);
    }

    int find(const std::vector<int>& members) {
        const auto [entry, is_new] = index_.try_emplace(members, static_cast<int>(plan_.regions.size()));
        if (is_new) {
            Region region;
            region.members = members;
            for (const int member : members)
                if (region.owner < 0 || outranks(plan_, relations_, member, region.owner)) region.owner = member;
            region.medium = region.owner < 0 ? 0 : plan_.solid(region.owner).medium;
            plan_.regions.push_back(std::move(region));
        }
        return entry->second;
    }

    Result<Done> list_candidates(Region& region) {
        std::vector<Mesh> meshes;
        const auto add = [&](int body, const auto& shape, std::vector<int>& list) {
            if (const auto* mesh = std::get_if<MeshBody>(&shape)) {
                meshes.push_back(mesh->mesh);
                region.caster_body.push_back(body);
            } else {
                list.push_back(body);
            }
        };
        for (int solid = 0; solid < plan_.solid_count(); ++solid) {
            if (region.toggled[static_cast<std::size_t>(solid)] < 0) continue;
            add(solid, plan_.solid(solid).shape, has(region.members, solid) ? region.exits : region.entries);
        }
        const double margin = 1e-9 * plan_.length_scale;
        for (std::size_t i = 0; i < plan_.surfaces.size(); ++i) {
            const Hull hull = hull_of(plan_.surfaces[i]);
            bool here = true;
            for (int solid = 0; solid < plan_.solid_count() && here; ++solid)
                here = has(region.members, solid) ? !surely_outside(plan_.surfaces[i], hull, plan_.solid(solid), margin)
                                                  : !surely_inside(hull, plan_.solid(solid), margin);
            if (here) add(plan_.solid_count() + static_cast<int>(i), plan_.surfaces[i].shape, region.surfaces);
        }
        if (meshes.empty()) return Done{};
        for (std::size_t mesh = 0; mesh < region.caster_body.size(); ++mesh)
            if (has(region.members, region.caster_body[mesh]))
                region.caster_inside.push_back({static_cast<int>(mesh), -1, -1});
        if (region.caster_inside.size() > max_nested_meshes)
            return refusal(region, "is nested with other meshes more than 8 deep",
                           "flat convex solids and spheres may be");
        auto caster = RayCaster::build(std::move(meshes));
        if (!caster) return caster.error();
        region.caster = std::make_unique<const RayCaster>(std::move(caster).value());
        return Done{};
    }

    const Scene& scene_;
    const Relations& relations_;
    Plan& plan_;
    std::map<std::vector<int>, int> index_;
};

/// A sheet in a solid's face would be both inside and outside of it.
Result<Done> refuse_glued_sheets(const Scene& scene, const Plan& plan) {
    for (const Surface& surface : plan.surfaces) {
        const auto* open = std::get_if<OpenSurface>(&surface.shape);
        if (open == nullptr || !std::holds_alternative<SheetRole>(surface.role)) continue;
        const double margin = 1e-9 * plan.length_scale;
        for (const Solid& solid : plan.solids) {
            for (const Plane& facet : facets(solid)) {
                const double side = dot(facet.normal, open->plane().normal);
                if (std::abs(std::abs(side) - 1.0) > 1e-12 ||
                    std::abs(dot(facet.normal, open->center()) - facet.offset) > margin)
                    continue;
                const auto* half_spaces = std::get_if<HalfSpaceSolid>(&solid.shape);
                if (half_spaces != nullptr && !half_spaces->contains(open->center(), -margin)) continue;
                return at_object({ErrorKind::input,
                                  "sheet '" + surface.name + "' lies in a face of '" + solid.name + "'",
                                  {},
                                  "transform",
                                  "leave a small gap between them"},
                                 scene, surface.object);
            }
        }
    }
    return Done{};
}

}  // namespace

Result<Done> arrange(const Scene& scene, Plan& plan) {
    if (auto done = refuse_glued_sheets(scene, plan); !done) return done.error();
    const auto relations = relate(scene, plan);
    if (!relations) return relations.error();
    return RegionBuilder(scene, relations.value(), plan).build();
}

int Plan::region_at(const DVec3& point) const {
    std::vector<int> members;
    for (int i = 0; i < solid_count(); ++i) {
        const bool inside = std::visit(Overloaded{
                                           [&](const MeshBody&) {
                                               for (const Region& region : regions)
                                                   for (std::size_t m = 0; m < region.caster_body.size(); ++m)
                                                       if (region.caster_body[m] == i)
                                                           return region.caster->contains(static_cast<int>(m), point);
                                               return false;
                                           },
                                           [&](const auto& shape) { return shape.contains(point, 0.0); },
                                       },
                                       solid(i).shape);
        if (inside) members.push_back(i);
    }
    for (std::size_t i = 0; i < regions.size(); ++i)
        if (regions[i].members == members) return static_cast<int>(i);
    return 0;
}

}  // namespace pol
