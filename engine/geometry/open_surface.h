// SPDX-License-Identifier: Apache-2.0
// Flat surfaces without an inside: rectangle and disk, as affine images of the unit shapes.
#pragma once

#include <limits>
#include <optional>

#include "core/lanes.h"
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

/// The same before it is known whether there is such a point, for one ray or several (core/lanes.h).
template <class Real>
struct SurfaceMeeting {
    Real distance{};
    Real along{};  ///< normal.d
    Real u{};
    Real v{};
    MaskOf<Real> met{};
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

    /// hit() of rays that have not just left the surface.
    template <class Real>
    [[nodiscard]] SurfaceMeeting<Real> meet(const Vec3<Real>& o, const Vec3<Real>& d) const {
        const Vec3<Real> center(center_);
        SurfaceMeeting<Real> meeting;
        meeting.along = dot(Vec3<Real>(plane_.normal), d);
        meeting.distance = dot(Vec3<Real>(plane_.normal), center - o) / meeting.along;
        const Vec3<Real> from_center = o + meeting.distance * d - center;
        const Real u = dot(Vec3<Real>(dual_u_), from_center);
        const Real v = dot(Vec3<Real>(dual_v_), from_center);
        const Real one(1.0);
        const Real infinity(std::numeric_limits<double>::infinity());
        const auto ahead = (meeting.distance > Real(0.0)) & (meeting.distance < infinity);
        if (outline_ == Outline::disk)
            meeting.met = ahead & (u * u + v * v <= one);
        else
            meeting.met = ahead & (u <= one) & (-u <= one) & (v <= one) & (-v <= one);
        meeting.u = Real(0.5) * (u + one);
        meeting.v = Real(0.5) * (v + one);
        return meeting;
    }

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
