// SPDX-License-Identifier: Apache-2.0
// Flat-faced convex solids as sets of half-spaces: exact to rounding, watertight by construction, no epsilon.
#pragma once

#include <span>
#include <vector>

#include "core/result.h"
#include "core/vec.h"
#include "geometry/hit.h"
#include "geometry/mesh.h"
#include "geometry/plane_kernels.h"

namespace pol {

/// Convex polyhedron: the points x with dot(normal_i, x) <= offset_i for every plane i.
///
/// Queries use Highway with run-time dispatch and no fused multiply-add: every instruction set gives the same bits.
/// `facet` and `skip` are indices into mesh().facets; skip = -1: no facet was just left.
/// Thread safety: const members from any thread.
class HalfSpaceSolid {
public:
    /// Error if the mesh is not closed or not convex (within 1e-6 of its size, so that float32 files pass).
    static Result<HalfSpaceSolid> from_mesh(Mesh mesh);
    /// Facet i is planes[i]. Error if the planes do not bound a solid or if one of them does not touch it.
    static Result<HalfSpaceSolid> from_planes(std::span<const Plane> planes);

    /// Where a ray from inside or from the boundary leaves: the nearest plane with normal.d > 0 other than `skip`; of
    /// equally near ones the lowest index. The distance may be a rounding error below zero at edges.
    /// facet = -1 if there is no such plane (the caller's ray is not what it seems: reported, never repaired).
    FacetHit exit(const DVec3& o, const DVec3& d, int skip) const;

    /// Where a ray from outside enters (slab test over all planes); on shared edges one facet, the lowest index.
    /// With skip >= 0 nothing: a straight ray that leaves a convex solid never meets it again. A start that is inside
    /// by a rounding error counts as entering if the entry is nearer than the exit (distance slightly negative).
    FacetHit enter(const DVec3& o, const DVec3& d, int skip) const;

    /// Whether the ray surely stays outside the bounding sphere, and by far more than the scan of the planes may err:
    /// it does not enter.
    bool passes_by(const DVec3& o, const DVec3& d) const;

    /// Whether `p` is inside every plane by more than `margin`; a negative margin lets points slightly outside in.
    bool contains(const DVec3& p, double margin) const;

    int facet_count() const { return static_cast<int>(mesh_.facets.size()); }
    const Plane& plane(int facet) const { return mesh_.facets[static_cast<std::size_t>(facet)]; }
    const Mesh& mesh() const { return mesh_; }
    const std::vector<DVec3>& vertices() const { return mesh_.vertices; }
    /// Bounding sphere: every vertex is within radius() of center().
    const DVec3& center() const { return center_; }
    double radius() const { return radius_; }
    /// How far its surface may be from where it belongs, see mesh_check.h.
    double slack() const { return slack_; }

private:
    explicit HalfSpaceSolid(Mesh mesh);
    Mesh mesh_;
    DVec3 center_{};
    double radius_ = 0.0;
    double slack_ = 0.0;
    std::vector<PlaneBlock> blocks_;
};

}  // namespace pol
