// SPDX-License-Identifier: Apache-2.0
#include "tracer/crossing.h"

#include <algorithm>
#include <array>
#include <span>
#include <variant>
#include <vector>

#include "core/overloaded.h"

namespace pol {

namespace {

bool is_inside(const Region& region, int solid) {
    return std::binary_search(region.members.begin(), region.members.end(), solid);
}

/// Keeps the nearer of two candidates; on a tie the earlier one stays.
void keep_nearer(Crossing& nearest, double distance, int body, int facet) {
    if (facet >= 0 && (nearest.body < 0 || distance < nearest.distance)) nearest = {distance, body, facet, -1, {}, {}};
}

int skip_of(const Left& left, int body) {
    return left.body == body ? left.facet : -1;
}

void meet_surface(const Plan& plan, int body, const DVec3& origin, const DVec3& direction, const Left& left,
                  Crossing& nearest) {
    const int skip = skip_of(left, body);
    std::visit(Overloaded{
                   [&](const OpenSurface& open) {
                       const auto hit = open.hit(origin, direction, skip);
                       if (!hit) return;
                       keep_nearer(nearest, hit->distance, body, 0);
                       if (nearest.body == body) nearest.uv = hit->uv;
                   },
                   [&](const HalfSpaceSolid& solid) {
                       const FacetHit hit = solid.enter(origin, direction, skip);
                       keep_nearer(nearest, hit.distance, body, hit.facet);
                   },
                   [&](const Sphere& sphere) {
                       const FacetHit hit = sphere.enter(origin, direction, skip);
                       keep_nearer(nearest, hit.distance, body, hit.facet);
                   },
                   [](const MeshBody&) {},  // through the region's caster
               },
               plan.surface(body).shape);
}

/// Meshes that share the face just left with another solid, and that the ray is outside of: its origin lies on them.
void add_flush_meshes(const Plan& plan, const Region& region, const Left& left, std::vector<LeftFacet>& stands) {
    for (const Contact& contact : plan.solid(left.body).contacts[static_cast<std::size_t>(left.facet)])
        for (std::size_t mesh = 0; mesh < region.caster_body.size(); ++mesh)
            if (region.caster_body[mesh] == contact.body && !is_inside(region, contact.body))
                stands.push_back({static_cast<int>(mesh), LeftFacet::outside, -1});
}

void meet_meshes(const Plan& plan, const Region& region, const DVec3& origin, const DVec3& direction, const Left& left,
                 Crossing& nearest) {
    // Where the ray stands with the meshes: on the facet it has just left, inside of some, outside of the rest.
    std::array<LeftFacet, max_nested_meshes + 1> known{};
    std::size_t count = 0;
    for (const LeftFacet& inside : region.caster_inside)
        if (region.caster_body[static_cast<std::size_t>(inside.mesh)] != left.body) known[count++] = inside;
    for (std::size_t mesh = 0; mesh < region.caster_body.size(); ++mesh)
        if (region.caster_body[mesh] == left.body) known[count++] = {static_cast<int>(mesh), left.facet, left.triangle};
    std::span<const LeftFacet> stands(known.data(), count);
    std::vector<LeftFacet> with_flush;
    if (plan.is_solid(left.body) && !plan.solid(left.body).contacts.empty()) {
        with_flush.assign(stands.begin(), stands.end());
        add_flush_meshes(plan, region, left, with_flush);
        stands = with_flush;
    }
    const auto hit = region.caster->nearest(origin, direction, stands);
    if (!hit) return;
    const int body = region.caster_body[static_cast<std::size_t>(hit->mesh)];
    keep_nearer(nearest, hit->distance, body, hit->facet);
    if (nearest.body == body) nearest.triangle = hit->triangle;
}

DVec3 normal_of(const Plan& plan, const Crossing& crossing, const DVec3& point) {
    const auto facet = static_cast<std::size_t>(crossing.facet);
    const Overloaded normal{
        [&](const HalfSpaceSolid& solid) { return solid.plane(crossing.facet).normal; },
        [&](const Sphere& sphere) { return sphere.normal_at(point); },
        [&](const MeshBody& body) { return body.mesh.facets[facet].normal; },
        [&](const OpenSurface& open) { return open.plane().normal; },
    };
    if (plan.is_solid(crossing.body)) return std::visit(normal, plan.solid(crossing.body).shape);
    return std::visit(normal, plan.surface(crossing.body).shape);
}

/// Whether `point`, known to lie in the plane of `facet`, or on a sphere, lies inside that facet's outline.
template <class Shape>
bool facet_covers(const Shape& shape, int facet, const DVec3& point, double margin) {
    return std::visit(Overloaded{
                          [&](const HalfSpaceSolid& half_spaces) {
                              for (int i = 0; i < half_spaces.facet_count(); ++i) {
                                  const Plane& plane = half_spaces.plane(i);
                                  if (i != facet && dot(plane.normal, point) - plane.offset > margin) return false;
                              }
                              return true;
                          },
                          [](const Sphere&) { return true; },
                          [&](const OpenSurface& open) { return open.uv_at(point, margin).has_value(); },
                          [&](const MeshBody& body) {
                              const DVec3 normal = body.mesh.facets[static_cast<std::size_t>(facet)].normal;
                              for (std::size_t t = 0; t < body.mesh.triangles.size(); ++t) {
                                  if (body.mesh.facet_of_triangle[t] != static_cast<std::uint32_t>(facet)) continue;
                                  bool inside = true;
                                  for (std::size_t corner = 0; corner < 3; ++corner) {
                                      const DVec3& a = body.mesh.vertices[body.mesh.triangles[t][corner]];
                                      const DVec3& b = body.mesh.vertices[body.mesh.triangles[t][(corner + 1) % 3]];
                                      if (dot(cross(b - a, point - a), normal) < -margin * glm::length(b - a))
                                          inside = false;
                                  }
                                  if (inside) return true;
                              }
                              return false;
                          },
                      },
                      shape);
}

/// Lamps and absorbers that lie in a solid's face are met there, whatever rounding says of the distances: from outside
/// both, by rays that come out of the solid only those that are black (`leaving`). A lamp has a gap before it.
std::optional<Crossing> meet_cover(const Plan& plan, int solid, int facet, const DVec3& point, double distance,
                                   bool leaving) {
    for (const Contact& cover : plan.solid(solid).covers[static_cast<std::size_t>(facet)]) {
        const Surface& surface = plan.surface(cover.body);
        if (leaving && !std::holds_alternative<AbsorberRole>(surface.role)) continue;
        if (!facet_covers(surface.shape, cover.facet, point, cover.margin)) continue;
        Crossing crossing{distance, cover.body, cover.facet, -1, {}, {}};
        if (const auto* open = std::get_if<OpenSurface>(&surface.shape))
            crossing.uv = open->uv_at(point, cover.margin).value();
        return crossing;
    }
    return std::nullopt;
}

}  // namespace

Crossing next_crossing(const Plan& plan, const Region& region, const DVec3& origin, const DVec3& direction,
                       const Left& left) {
    Crossing nearest;
    if (plan.is_solid(left.body) && !plan.solid(left.body).covers.empty() && !is_inside(region, left.body)) {
        if (const auto cover = meet_cover(plan, left.body, left.facet, origin, 0.0, false)) nearest = *cover;
    }
    for (const int body : region.surfaces) meet_surface(plan, body, origin, direction, left, nearest);
    for (const int body : region.exits) {
        const FacetHit hit =
            std::visit(Overloaded{
                           [](const MeshBody&) { return FacetHit{}; },
                           [&](const auto& solid) { return solid.exit(origin, direction, skip_of(left, body)); },
                       },
                       plan.solid(body).shape);
        keep_nearer(nearest, hit.distance, body, hit.facet);
    }
    for (const int body : region.entries) {
        const FacetHit hit =
            std::visit(Overloaded{
                           [](const MeshBody&) { return FacetHit{}; },
                           [&](const auto& solid) { return solid.enter(origin, direction, skip_of(left, body)); },
                       },
                       plan.solid(body).shape);
        keep_nearer(nearest, hit.distance, body, hit.facet);
    }
    if (region.caster) meet_meshes(plan, region, origin, direction, left, nearest);
    if (nearest.body < 0) return nearest;
    const DVec3 point = origin + direction * nearest.distance;
    if (plan.is_solid(nearest.body) && !plan.solid(nearest.body).covers.empty()) {
        const auto cover =
            meet_cover(plan, nearest.body, nearest.facet, point, nearest.distance, is_inside(region, nearest.body));
        if (cover) nearest = *cover;
    }
    nearest.normal = normal_of(plan, nearest, point);
    return nearest;
}

bool misses_solids(const Plan& plan, const Region& region, const DVec3& origin, const DVec3& direction,
                   const Left& left) {
    return std::all_of(region.entries.begin(), region.entries.end(), [&](int body) {
        if (left.body == body) return true;  // convex
        return std::visit(Overloaded{
                              [&](const HalfSpaceSolid& solid) { return solid.passes_by(origin, direction); },
                              [&](const Sphere& sphere) { return sphere.enter(origin, direction, -1).facet < 0; },
                              [](const MeshBody&) { return false; },
                          },
                          plan.solid(body).shape);
    });
}

FarSide far_side(const Plan& plan, int region, const Crossing& crossing, const DVec3& point) {
    const auto toggle = [&](int from, int solid) {
        return from < 0 ? -1 : plan.regions[static_cast<std::size_t>(from)].toggled[static_cast<std::size_t>(solid)];
    };
    FarSide far{toggle(region, crossing.body), {crossing.body, crossing.facet, crossing.triangle}};
    const Solid& solid = plan.solid(crossing.body);
    far.black = solid.is_black(crossing.facet);
    if (solid.contacts.empty()) return far;
    const Region& here = plan.regions[static_cast<std::size_t>(region)];
    for (const Contact& contact : solid.contacts[static_cast<std::size_t>(crossing.facet)]) {
        // Faces that face each other are crossed from one solid into the other, flush faces into or out of both.
        if ((is_inside(here, crossing.body) == is_inside(here, contact.body)) != contact.flush) continue;
        const Solid& other = plan.solid(contact.body);
        if (!facet_covers(other.shape, contact.facet, point, contact.margin)) continue;
        far.region = toggle(far.region, contact.body);
        far.left = {contact.body, contact.facet, -1};
        far.black = far.black || other.is_black(contact.facet);
    }
    return far;
}

}  // namespace pol
