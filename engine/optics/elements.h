// SPDX-License-Identifier: Apache-2.0
// Thin ideal sheets: they change the polarization of a ray and nothing else. Axes are world space and are projected on
// the plane across the ray, so oblique rays are well defined.
#pragma once

#include <array>
#include <cmath>
#include <variant>

#include "core/complex.h"
#include "core/overloaded.h"
#include "core/vec.h"

namespace pol {

/// Passes the field along `axis`, blocks the rest.
struct LinearPolarizer {
    DVec3 axis{1.0, 0.0, 0.0};
    friend bool operator==(const LinearPolarizer&, const LinearPolarizer&) = default;
};

/// Delays the field across `fast_axis` by `retardance` radians against the field along it.
struct Retarder {
    DVec3 fast_axis{1.0, 0.0, 0.0};
    double retardance = 0.0;
    friend bool operator==(const Retarder&, const Retarder&) = default;
};

enum class Handedness { right, left };

/// Passes circular light of one handedness (as seen by the receiver), from either side, blocks the other.
struct CircularPolarizer {
    Handedness passes = Handedness::right;
    friend bool operator==(const CircularPolarizer&, const CircularPolarizer&) = default;
};

/// One of the two waves of a uniaxial crystal.
enum class CrystalRay { ordinary, extraordinary };

using Sheet = std::variant<LinearPolarizer, Retarder, CircularPolarizer>;

/// `axis` made transverse to the light and unit; zero if it lies along the light, where the sheet has no axis to show.
inline DVec3 transverse_axis(const DVec3& axis, const DVec3& light_direction) {
    const DVec3 across = axis - dot(axis, light_direction) * light_direction;
    const double size2 = length2(across);
    return size2 > 0.0 ? across / std::sqrt(size2) : DVec3(0.0);
}

/// Operator of the sheet on transverse fields, as a matrix between the unit vectors e1 and e2: [i][j] = e_i . F e_j.
///
/// polarizer: F = a a^T, a the projected axis (nothing passes along the axis). Retarder: F = f f^T + exp(i retardance)
/// g g^T, f the projected fast axis and g across it; fields vary as exp(-i omega t), so the slow axis gains positive
/// phase. It is symmetric, and the phase common to both axes is left out; the identity for light along the fast axis.
/// Circular: F = a a^H with a = (1, -i)/sqrt 2 for right, (1, i)/sqrt 2 for left, in a right-handed frame about the
/// light.
///
/// Requires: light_direction, e1, e2 unit; e1 x e2 = +-light_direction (either hand: a backward tracer keeps the
/// field vectors of the light).
inline std::array<std::array<Complex<double>, 2>, 2> sheet_jones(const Sheet& sheet, const DVec3& light_direction,
                                                                 const DVec3& e1, const DVec3& e2) {
    using Matrix = std::array<std::array<Complex<double>, 2>, 2>;
    return std::visit(Overloaded{
                          [&](const LinearPolarizer& polarizer) -> Matrix {
                              const DVec3 a = transverse_axis(polarizer.axis, light_direction);
                              const double x = dot(e1, a);
                              const double y = dot(e2, a);
                              return {{{x * x, x * y}, {x * y, y * y}}};
                          },
                          [&](const Retarder& retarder) -> Matrix {
                              // F = 1 + (exp(i retardance) - 1) g g^T, with g across the fast axis.
                              const DVec3 g =
                                  cross(light_direction, transverse_axis(retarder.fast_axis, light_direction));
                              const double x = dot(e1, g);
                              const double y = dot(e2, g);
                              const Complex<double> turn = unit_phase(retarder.retardance) - Complex<double>(1.0);
                              const Complex<double> one(1.0);
                              return {{{one + turn * (x * x), turn * (x * y)}, {turn * (x * y), one + turn * (y * y)}}};
                          },
                          [&](const CircularPolarizer& polarizer) -> Matrix {
                              // a a^H = 1/2 [[1, i], [-i, 1]] for right in a right-handed frame.
                              const double hand = dot(cross(e1, e2), light_direction) > 0.0 ? 0.5 : -0.5;
                              const Complex<double> half(0.5);
                              const Complex<double> off(0.0, polarizer.passes == Handedness::right ? hand : -hand);
                              return {{{half, off}, {-off, half}}};
                          },
                      },
                      sheet);
}

}  // namespace pol
