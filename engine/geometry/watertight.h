// SPDX-License-Identifier: Apache-2.0
// Ray against triangle without cracks: S. Woop, C. Benthin, I. Wald, "Watertight ray/triangle intersection",
// JCGT 2(1), 2013, in double precision.
#pragma once

#include <cmath>
#include <optional>
#include <utility>

#include "core/vec.h"

namespace pol {

/// Where the line o + t d crosses a triangle, and which way.
struct TriangleCrossing {
    double distance = 0.0;    ///< t, any sign
    double low_weight = 0.0;  ///< smallest barycentric weight: 0 on an edge
    bool leaving = false;     ///< d points the way of the counter-clockwise normal
};

/// A ray sheared so that it runs along an axis. Each vertex is transformed alone, so triangles see their common edges
/// at the same place; the difference of two rounded products never has the wrong sign (rounding is monotonic), and 0
/// counts as inside: a line through a closed surface cannot slip between its triangles.
class WatertightRay {
public:
    WatertightRay(const DVec3& o, const DVec3& d) : o_(o) {
        const double x = std::abs(d.x);
        const double y = std::abs(d.y);
        const double z = std::abs(d.z);
        z_ = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
        x_ = (z_ + 1) % 3;
        y_ = (z_ + 2) % 3;
        if (d[z_] < 0.0) std::swap(x_, y_);
        shear_ = {d[x_] / d[z_], d[y_] / d[z_], 1.0 / d[z_]};
    }

    std::optional<TriangleCrossing> cross(const DVec3& a_world, const DVec3& b_world, const DVec3& c_world) const {
        const DVec3 a = sheared(a_world);
        const DVec3 b = sheared(b_world);
        const DVec3 c = sheared(c_world);
        const double u = c.x * b.y - c.y * b.x;
        const double v = a.x * c.y - a.y * c.x;
        const double w = b.x * a.y - b.y * a.x;
        if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return std::nullopt;
        const double det = u + v + w;
        if (!(det != 0.0)) return std::nullopt;  // seen edge-on
        const double distance = (u * a.z + v * b.z + w * c.z) * shear_.z / det;
        return TriangleCrossing{distance, std::fmin(u / det, std::fmin(v / det, w / det)), det < 0.0};
    }

private:
    // x and y across the ray, z along it (not yet scaled).
    DVec3 sheared(const DVec3& world) const {
        const DVec3 p = world - o_;
        return {p[x_] - shear_.x * p[z_], p[y_] - shear_.y * p[z_], p[z_]};
    }

    DVec3 o_{};
    DVec3 shear_{};
    int x_ = 0;
    int y_ = 1;
    int z_ = 2;
};

}  // namespace pol
