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

/// Touching faces are told apart from near ones at this fraction of the scene's extent.
constexpr double contact_margin = 1e-12;

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
                       // A solid may stand on an emitter: leaving it, the surface is met at distance 0 give or take
                       // rounding, so look from a little further back.
                       const double back = plan.is_solid(left.body) ? contact_margin * plan.length_scale : 0.0;
                       const auto hit = open.hit(origin - direction * back, direction, skip);
                       if (!hit) return;
                       keep_nearer(nearest, hit->distance - back, body, 0);
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
            if (region.caster_body[mesh] == contact.other_solid &&
                !std::binary_search(region.members.begin(), region.members.end(), contact.other_solid))
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

}  // namespace

Crossing next_crossing(const Plan& plan, const Region& region, const DVec3& origin, const DVec3& direction,
                       const Left& left) {
    Crossing nearest;
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
    if (nearest.body >= 0) nearest.normal = normal_of(plan, nearest, origin + direction * nearest.distance);
    return nearest;
}

namespace {

/// Whether `point`, known to lie in the plane of `facet`, lies inside that facet's outline.
bool facet_covers(const Solid& solid, int facet, const DVec3& point, double margin) {
    return std::visit(Overloaded{
                          [&](const HalfSpaceSolid& half_spaces) {
                              for (int i = 0; i < half_spaces.facet_count(); ++i) {
                                  const Plane& plane = half_spaces.plane(i);
                                  if (i != facet && dot(plane.normal, point) - plane.offset > margin) return false;
                              }
                              return true;
                          },
                          [](const Sphere&) { return false; },
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
                      solid.shape);
}

}  // namespace

FarSide far_side(const Plan& plan, int region, const Crossing& crossing, const DVec3& point) {
    const auto toggle = [&](int from, int solid) {
        return from < 0 ? -1 : plan.regions[static_cast<std::size_t>(from)].toggled[static_cast<std::size_t>(solid)];
    };
    FarSide far{toggle(region, crossing.body), {crossing.body, crossing.facet, crossing.triangle}};
    const Solid& solid = plan.solid(crossing.body);
    if (solid.contacts.empty()) return far;
    const std::vector<int>& members = plan.regions[static_cast<std::size_t>(region)].members;
    const auto inside = [&](int body) { return std::find(members.begin(), members.end(), body) != members.end(); };
    for (const Contact& contact : solid.contacts[static_cast<std::size_t>(crossing.facet)]) {
        // Faces that face each other are crossed from one solid into the other, flush faces into or out of both.
        if ((inside(crossing.body) == inside(contact.other_solid)) != contact.flush) continue;
        if (!facet_covers(plan.solid(contact.other_solid), contact.other_facet, point,
                          contact_margin * plan.length_scale))
            continue;
        far.region = toggle(far.region, contact.other_solid);
        far.left = {contact.other_solid, contact.other_facet, -1};
    }
    return far;
}

}  // namespace pol
