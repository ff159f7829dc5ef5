// SPDX-License-Identifier: Apache-2.0
#include "geometry/half_space_solid.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/result.h"
#include "geometry/complaint.h"
#include "geometry/mesh_check.h"
#include "geometry/polytope.h"

namespace pol {
namespace {

std::vector<PlaneBlock> packed(const std::vector<Plane>& planes) {
    std::vector<PlaneBlock> blocks((planes.size() + 7) / 8);
    for (std::size_t i = 0; i < blocks.size() * 8; ++i) {
        const Plane plane = i < planes.size() ? planes[i] : Plane{DVec3(0.0), 1.0};
        PlaneBlock& block = blocks[i / 8];
        block.normal_x[i % 8] = plane.normal.x;
        block.normal_y[i % 8] = plane.normal.y;
        block.normal_z[i % 8] = plane.normal.z;
        block.offset[i % 8] = plane.offset;
    }
    return blocks;
}

}  // namespace

HalfSpaceSolid::HalfSpaceSolid(Mesh mesh) : mesh_(std::move(mesh)), blocks_(packed(mesh_.facets)) {
    DVec3 low = mesh_.vertices.front();
    DVec3 high = low;
    for (const DVec3& p : mesh_.vertices) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    center_ = 0.5 * (low + high);
    for (const DVec3& p : mesh_.vertices) radius_ = std::max(radius_, glm::distance(center_, p));
    slack_ = pol::slack(mesh_);
}

Result<HalfSpaceSolid> HalfSpaceSolid::from_mesh(Mesh mesh) {
    POL_TRY_DONE(check_closed(mesh));
    if (!is_convex(mesh)) return complaint("", "the mesh is not convex", "trace it with RayCaster");
    return HalfSpaceSolid(std::move(mesh));
}

Result<HalfSpaceSolid> HalfSpaceSolid::from_planes(std::span<const Plane> planes) {
    POL_TRY(auto mesh, mesh_from_planes(planes));
    return HalfSpaceSolid(std::move(mesh));
}

FacetHit HalfSpaceSolid::exit(const DVec3& o, const DVec3& d, int skip) const {
    return exit_planes(blocks_, o, d, skip);
}

bool HalfSpaceSolid::passes_by(const DVec3& o, const DVec3& d) const {
    const DVec3 to_center = center_ - o;
    const double distance2 = dot(to_center, to_center);
    // 16 epsilon: the products of the last line round by 8 of distance2 |d|^2 in all.
    const double reach2 = (1.0 + 1e-9) * (radius_ + slack_) * (radius_ + slack_) +
                          16.0 * std::numeric_limits<double>::epsilon() * distance2;
    const double ahead = dot(to_center, d);
    return (distance2 - reach2) * dot(d, d) > std::max(ahead, 0.0) * ahead;
}

FacetHit HalfSpaceSolid::enter(const DVec3& o, const DVec3& d, int skip) const {
    return skip >= 0 || passes_by(o, d) ? FacetHit{} : enter_planes(blocks_, o, d);
}

bool HalfSpaceSolid::contains(const DVec3& p, double margin) const {
    return std::all_of(mesh_.facets.begin(), mesh_.facets.end(),
                       [&](const Plane& plane) { return dot(plane.normal, p) - plane.offset < -margin; });
}

}  // namespace pol
