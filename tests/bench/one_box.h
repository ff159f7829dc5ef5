// SPDX-License-Identifier: Apache-2.0
// A tracer for one scene and nothing else: a box of glass along the axes, a lamp under it, light all round. The same
// physics and the same stopping rule as the engine's, written by hand: what is general in the engine is measured
// against it.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/complex.h"
#include "core/vec.h"
#include "plan/camera_model.h"
#include "polarization/stokes.h"

namespace pol::bench {

/// The scene; the constants below say the same. A box alone: its edges do not lie on pixel centres.
inline constexpr const char* one_box_scene = R"(
camera: {position: [1.61, -3.02, 2.23], target: [0.01, 0.02, -0.1], fov: 28}
render: {size: [256, 256], wavelengths: [580], mode: point, residual: 1e-3}
media: {glass: 1.5}
background: 0.25
objects:
  - {name: box, shape: {box: {size: 1}}, medium: glass}
  - {name: lamp, shape: {rectangle: {size: 2.4}}, transform: [{translate: [0, 0, -0.6]}], emission: {radiance: 1}}
)";

class OneBox {
public:
    /// Light that reaches the camera along the ray, in its frame. What is outside of the box ends at once, for it is
    /// convex; so there is never more than one branch to follow.
    Stokes<double> look(const CameraRay& ray) {
        light_ = {};
        Branch branch;
        branch.origin = ray.origin;
        branch.direction = ray.direction;
        branch.s = ray.x;
        branch.p = ray.y;
        branch.m[0][0] = branch.m[1][1] = Complex<double>(1.0);
        branch.weight = 1.0;
        int axis = 0;
        double in = -INFINITY;
        double out = INFINITY;
        for (int i = 0; i < 3; ++i) {
            const double side = std::copysign(half, ray.direction[i]);
            const double t = (-side - ray.origin[i]) / ray.direction[i];
            if (t > in) in = t, axis = i;
            out = std::fmin(out, (side - ray.origin[i]) / ray.direction[i]);
        }
        const bool before_lamp = ray.direction.z >= 0.0 || (lamp_height - ray.origin.z) / ray.direction.z > in;
        if (!(in > 0.0 && in < out && before_lamp)) {
            end_outside(branch);
            return light_;
        }
        cross_face(branch, in, axis, 1.0, index);
        while (branch.weight > residual) {
            double nearest = INFINITY;
            for (int i = 0; i < 3; ++i) {
                const double t = (std::copysign(half, branch.direction[i]) - branch.origin[i]) / branch.direction[i];
                if (t < nearest) nearest = t, axis = i;
            }
            cross_face(branch, nearest, axis, index, 1.0);
        }
        return light_;
    }

private:
    static constexpr double index = 1.5;
    static constexpr double half = 0.5;
    static constexpr double lamp_height = -0.6;
    static constexpr double lamp_half = 1.2;
    static constexpr double lamp_radiance = 1.0;
    static constexpr double background = 0.25;
    static constexpr double residual = 1e-3;

    struct Branch {
        DVec3 origin{};
        DVec3 direction{};
        DVec3 s{};
        DVec3 p{};
        Complex<double> m[2][2];  ///< amplitudes along s and p to the camera's x and y
        double weight = 0.0;
    };

    /// A ray that does not meet the box any more ends on the lamp, whose back is black, or in the background.
    void end_outside(const Branch& branch) {
        const double t = (lamp_height - branch.origin.z) / branch.direction.z;
        const DVec3 at = branch.origin + branch.direction * t;
        const bool lamp = t > 0.0 && std::abs(at.x) <= lamp_half && std::abs(at.y) <= lamp_half;
        if (lamp && branch.direction.z > 0.0) return;
        const auto& m = branch.m;
        const double xx = 0.5 * (norm2(m[0][0]) + norm2(m[0][1]));
        const double yy = 0.5 * (norm2(m[1][0]) + norm2(m[1][1]));
        const Complex<double> xy = m[0][0] * conj(m[1][0]) + m[0][1] * conj(m[1][1]);
        light_ += (lamp ? lamp_radiance : background) * Stokes<double>{xx + yy, xx - yy, xy.re, xy.im};
    }

    /// Puts in place of the branch what goes on inside, and ends what goes on outside. Fresnel's formulas (Born & Wolf
    /// 1.5.2), flux-normalised, with Verdet's sign of r_p.
    void cross_face(Branch& branch, double distance, int axis, double n1, double n2) {
        const DVec3 point = branch.origin + branch.direction * distance;
        const DVec3 d = branch.direction;
        DVec3 normal{0.0, 0.0, 0.0};
        normal[axis] = std::copysign(1.0, d[axis]);
        const double cosine = std::abs(d[axis]);
        const DVec3 across = cross(normal, d);
        const double sin2 = length2(across);
        const DVec3 s = sin2 > 1e-16 ? across / std::sqrt(sin2) : branch.s;
        const DVec3 p = cross(d, s);
        const double ss = dot(branch.s, s);
        const double ps = dot(branch.p, s);
        const double sp = dot(branch.s, p);
        const double pp = dot(branch.p, p);
        Complex<double> m[2][2];
        for (int row = 0; row < 2; ++row) {
            m[row][0] = branch.m[row][0] * ss + branch.m[row][1] * ps;
            m[row][1] = branch.m[row][0] * sp + branch.m[row][1] * pp;
        }
        const auto go_on = [&](Branch& child, const DVec3& ray, const Complex<double>& a_s,
                               const Complex<double>& a_p) {
            child.origin = point;
            child.direction = ray * (1.5 - 0.5 * length2(ray));
            child.s = s;
            child.p = cross(child.direction, s);
            for (int row = 0; row < 2; ++row) {
                child.m[row][0] = m[row][0] * a_s;
                child.m[row][1] = m[row][1] * a_p;
            }
        };
        const double q1 = n1 * cosine;
        const double q2_squared = q1 * q1 - (n1 - n2) * (n1 + n2);
        DVec3 mirrored = d;
        mirrored[axis] = -d[axis];
        if (q2_squared > 0.0) {
            const double q2 = std::sqrt(q2_squared);
            const double per_s = 1.0 / (q1 + q2);
            const double per_p = 1.0 / (n2 * n2 * q1 + n1 * n1 * q2);
            const double flux = 2.0 * std::sqrt(q1 * q2);
            DVec3 refracted = d * (n1 / n2);
            refracted[axis] = std::copysign(q2 / n2, d[axis]);
            Branch outside;
            const bool comes_in = n1 < n2;
            go_on(comes_in ? outside : branch, mirrored, Complex<double>((q1 - q2) * per_s),
                  Complex<double>((n2 * n2 * q1 - n1 * n1 * q2) * per_p));
            go_on(comes_in ? branch : outside, refracted, Complex<double>(flux * per_s),
                  Complex<double>(flux * n1 * n2 * per_p));
            end_outside(outside);
        } else {  // total reflection: q2 = i sqrt(-q2^2)
            const Complex<double> q2(0.0, std::sqrt(-q2_squared));
            const Complex<double> s1(q1);
            const Complex<double> p1(n2 * n2 * q1);
            const Complex<double> p2 = q2 * (n1 * n1);
            go_on(branch, mirrored, (s1 - q2) / (s1 + q2), (p1 - p2) / (p1 + p2));
        }
        const auto& w = branch.m;
        branch.weight = 0.5 * (norm2(w[0][0]) + norm2(w[1][0]) + norm2(w[0][1]) + norm2(w[1][1]));
    }

    Stokes<double> light_{};
};

/// The whole picture, row by row.
inline std::vector<Stokes<double>> one_box_picture(const CameraModel& camera, int width, int height) {
    std::vector<Stokes<double>> picture;
    picture.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    OneBox box;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) picture.push_back(box.look(camera.ray(x + 0.5, y + 0.5)));
    return picture;
}

/// Root mean square of |dC|_F over that of |C|_F.
inline double relative_difference(const std::vector<Stokes<double>>& a, const std::vector<Stokes<double>>& b) {
    const auto square = [](const Stokes<double>& s) { return s.s0 * s.s0 + s.s1 * s.s1 + s.s2 * s.s2 + s.s3 * s.s3; };
    double difference = 0.0;
    double size = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) difference += square(a[i] - b[i]), size += square(b[i]);
    return a.size() == b.size() ? std::sqrt(difference / size) : INFINITY;
}

}  // namespace pol::bench
