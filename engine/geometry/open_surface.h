// SPDX-License-Identifier: Apache-2.0
// Flat surfaces without an inside: rectangle and disk, as affine images of the unit shapes.
#pragma once

#include <optional>

#include "core/result.h"
#include "core/vec.h"
#include "geometry/mesh.h"
#include "geometry/shape.h"

namespace pol {

/// A ray meets an open surface: distance t of o + t d, and where, for textures.
struct SurfaceHit {
    double distance = 0.0;
    DVec2 uv{};  ///< 0..1 along the object's x and y over the rectangle, or over the square around the disk
};

/// Parallelogram or ellipse in world space; met from both sides.
class OpenSurface {
public:
    /// Error for a size that is not positive and finite, and for a transform that flattens the surface.
    static Result<OpenSurface> from(const RectangleShape& shape, const DMat4& to_world);
    static Result<OpenSurface> from(const DiskShape& shape, const DMat4& to_world);

    /// Nearest point of the surface with distance > 0. `skip` = 0 says that `o` lies on the surface (just left), which
    /// a straight ray cannot meet again; otherwise -1. The boundary belongs to the surface.
    std::optional<SurfaceHit> hit(const DVec3& o, const DVec3& d, int skip) const;

    /// Where on the surface a point of its plane lies; nothing if it is outside the outline by more than `margin`.
    std::optional<DVec2> uv_at(const DVec3& p, double margin) const;

    /// The surface as one facet. A disk is the polygon of 256 of its points: at most 8e-5 of its radius inside it.
    Mesh mesh() const;

    /// Unit normal: the image of object +z, whatever the handedness of the transform.
    const Plane& plane() const { return plane_; }
    double area() const;
    /// World vectors of half the side (rectangle) or of the radius (disk) along the object's x and y.
    const DVec3& half_u() const { return half_u_; }
    const DVec3& half_v() const { return half_v_; }
    const DVec3& center() const { return center_; }

private:
    enum class Outline { rectangle, disk };
    OpenSurface() = default;
    static Result<OpenSurface> make(Outline outline, const DVec2& half_size, const DMat4& to_world);

    Outline outline_{};
    DVec3 center_{}, half_u_{}, half_v_{};
    DVec3 dual_u_{}, dual_v_{};  // dot with (p - center) gives -1..1 over the surface
    Plane plane_{};
};

}  // namespace pol
