// SPDX-License-Identifier: Apache-2.0
// Thin ideal sheets: they change the polarization of a ray and nothing else. Axes are world space; which of them is
// projected on the plane across an oblique ray is said with each sheet.
#pragma once

#include <cmath>
#include <variant>

#include "core/complex.h"
#include "core/overloaded.h"
#include "core/vec.h"
#include "polarization/jones.h"

namespace pol {

/// Which axis of a polarizer a tilted ray sees at its projected direction.
enum class PolarizerModel {
    /// The one in the sheet across `axis`: film and wire grids absorb or reflect the field along it and pass what is
    /// left. Korger et al. 2013, "The polarization properties of a tilted polarizer"; `polarizer` of Mitsuba 3.
    blocking,
    /// `axis` itself, an abstraction.
    passing,
};

/// Passes the field along `axis`, blocks the rest; both models agree where light meets the sheet head on.
struct LinearPolarizer {
    DVec3 axis{1.0, 0.0, 0.0};
    PolarizerModel model = PolarizerModel::blocking;
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
template <class Real>
Vec3<Real> transverse_axis(const Vec3<Real>& axis, const Vec3<Real>& light_direction) {
    using std::sqrt;
    const Vec3<Real> across = axis - dot(axis, light_direction) * light_direction;
    const Real size2 = length2(across);
    return size2 > Real(0) ? across / sqrt(size2) : Vec3<Real>(Real(0));
}

/// Operator of the sheet on transverse fields, as a matrix between the unit vectors e1 and e2: [i][j] = e_i . F e_j.
///
/// polarizer: F = a a^T, with a the projected axis (nothing passes along the axis), or, with b in the sheet across the
/// axis blocking, a across the projected b, unit(light x b). Retarder: F = f f^T + exp(i retardance)
/// g g^T, f the projected fast axis and g across it, at any tilt with the same retardance; fields vary as exp(-i omega
/// t), so the slow axis gains positive phase. It is symmetric, and the phase common to both axes is left out; the
/// identity for light along the fast axis. Circular: F = a a^H with a = (1, -i)/sqrt 2 for right, (1, i)/sqrt 2 for
/// left, in a right-handed frame about the light.
///
/// Requires: normal (of the sheet, either sign), light_direction, e1, e2 unit; e1 x e2 = +-light_direction (either
/// hand: a backward tracer keeps the field vectors of the light).
template <class Real>
JonesMatrix<Real> sheet_jones(const Sheet& sheet, const Vec3<Real>& normal, const Vec3<Real>& light_direction,
                              const Vec3<Real>& e1, const Vec3<Real>& e2) {
    using Matrix = JonesMatrix<Real>;
    return std::visit(Overloaded{
                          [&](const LinearPolarizer& polarizer) -> Matrix {
                              const Vec3<Real> axis(polarizer.axis);
                              const Vec3<Real> a =
                                  polarizer.model == PolarizerModel::passing
                                      ? transverse_axis(axis, light_direction)
                                      : transverse_axis(cross(light_direction, cross(normal, axis)), light_direction);
                              const Real x = dot(e1, a);
                              const Real y = dot(e2, a);
                              return {{{x * x, x * y}, {x * y, y * y}}};
                          },
                          [&](const Retarder& retarder) -> Matrix {
                              // F = 1 + (exp(i retardance) - 1) g g^T, with g across the fast axis.
                              const Vec3<Real> g = cross(
                                  light_direction, transverse_axis(Vec3<Real>(retarder.fast_axis), light_direction));
                              const Real x = dot(e1, g);
                              const Real y = dot(e2, g);
                              const Complex<Real> one(Real(1));
                              const Complex<Real> turn = unit_phase(Real(retarder.retardance)) - one;
                              return {{{one + turn * (x * x), turn * (x * y)}, {turn * (x * y), one + turn * (y * y)}}};
                          },
                          [&](const CircularPolarizer& polarizer) -> Matrix {
                              // a a^H = 1/2 [[1, i], [-i, 1]] for right in a right-handed frame.
                              const Real half(0.5);
                              const Real hand = dot(cross(e1, e2), light_direction) > Real(0) ? half : -half;
                              const Complex<Real> off(Real(0), polarizer.passes == Handedness::right ? hand : -hand);
                              return {{{Complex<Real>(half), off}, {-off, Complex<Real>(half)}}};
                          },
                      },
                      sheet);
}

}  // namespace pol
