// SPDX-License-Identifier: Apache-2.0
// Rays against general triangle meshes, closed or open. Embree proposes in float, double precision decides.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/result.h"
#include "core/vec.h"
#include "geometry/mesh.h"

namespace pol {

/// A ray meets triangle `triangle` of mesh `mesh`, in facet `facet` of that mesh, at o + distance d.
struct MeshHit {
    int mesh = -1;
    int facet = -1;
    int triangle = -1;
    double distance = 0.0;
};

/// Where a ray starts with regard to one mesh: on a facet that it has just left, inside, or outside.
struct LeftFacet {
    static constexpr int inside = -1;   ///< for `facet`: in the interior of closed mesh `mesh`
    static constexpr int outside = -2;  ///< for `facet`: not inside closed mesh `mesh`, though perhaps on its surface
    int mesh = -1;
    int facet = inside;
    int triangle = -1;  ///< as MeshHit gave it; -1 if unknown
};

/// Immutable set of meshes in world space.
///
/// Thread safety: const members from any thread.
class RayCaster {
public:
    /// Error if there is nothing to trace, if a coordinate is not finite, or if Embree fails.
    static Result<RayCaster> build(std::vector<Mesh> meshes);

    RayCaster(RayCaster&&) noexcept;
    RayCaster& operator=(RayCaster&&) noexcept;
    ~RayCaster();

    /// Nearest surface ahead. `left` lists the facets that `o` lies on (one, or one of each of two touching meshes);
    /// they are skipped whole. For a closed mesh in `left` the next hit must face the other way (in, then out), so
    /// such a hit may lie a rounding error behind `o`. A closed mesh not in `left` is taken to be entered first; that a
    /// ray starts inside it should be said (facet -1), since finding that out takes time linear in its triangles. Equal
    /// distances: lowest mesh, then facet, then triangle.
    std::optional<MeshHit> nearest(const DVec3& o, const DVec3& d, std::span<const LeftFacet> left = {}) const;

    /// Whether `p` is inside closed mesh `mesh`: parity of crossings, in double over all triangles (slow: set-up only).
    bool contains(int mesh, const DVec3& p) const;

    int mesh_count() const;
    const Mesh& mesh(int index) const;

private:
    struct Impl;
    explicit RayCaster(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace pol
