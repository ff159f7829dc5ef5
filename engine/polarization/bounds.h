// SPDX-License-Identifier: Apache-2.0
// Rigorous error bars of every measure, from what is known about the light that a picture lacks or has too much.
//
// truth = estimate + A - B,  A and B positive semidefinite,  tr A <= missing,  tr B <= surplus.
//
// A is light that was not traced; B is a random tail that stands in for it (CUTTING.md 1.2).
// The Stokes vector of a positive semidefinite matrix has |(s1, s2, s3)| <= s0 = trace, so the polarized part of the
// truth lies in a ball of radius missing + surplus about that of the estimate, and S0 in [S0 - surplus, S0 + missing].
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.h"
#include "polarization/measures.h"
#include "polarization/stokes.h"

namespace pol {

/// Closed interval that contains the truth.
template <class Real>
struct Interval {
    Real low{};
    Real high{};
    [[nodiscard]] Real width() const { return high - low; }
    friend bool operator==(const Interval&, const Interval&) = default;
};

/// Bars hold in exact arithmetic; rounding adds a few epsilon of the measure's range (of S0 for the Stokes components).
template <class Real>
struct MeasureBounds {
    Interval<Real> s0{};
    Interval<Real> s1{};
    Interval<Real> s2{};
    Interval<Real> s3{};
    Interval<Real> dop{};
    Interval<Real> dolp{};
    Interval<Real> docp{};
    Interval<Real> ellipticity{};
    Interval<Real> ellipticity_angle{};
    /// Largest angle between the true azimuth and the estimated one, as undirected lines; pi/2: it may be anything.
    Real azimuth{};
};

namespace detail {

/// Bar of part/S0, where `part` moves by at most missing + surplus and is at most S0.
///
/// (part + a + b)/(S0 + a - b) grows with the amount b taken away; it grows with the amount a added as long as it is
/// below 1, and above 1 the bar is cut at 1 anyway. (part - a - b)/(S0 + a - b) falls with both. So both extremes have
/// a = missing, b = surplus. If surplus >= S0 + missing, nothing is known.
template <class Real>
Interval<Real> share_bounds(const Real& part, const Real& s0, const Real& missing, const Real& surplus) {
    const Real total = s0 + missing - surplus;
    if (!(total > Real(0))) return {Real(0), Real(1)};
    const Real radius = missing + surplus;
    // An estimate above 1 (rounding, or a defect that must stay visible) stays inside its own bar.
    const Real ceiling = std::max(Real(1), s0 > Real(0) ? part / s0 : Real(1));
    return {std::max(Real(0), (part - radius) / total), std::min(ceiling, (part + radius) / total)};
}

/// Half the angle under which a ball of radius `radius` at distance `distance` is seen; `unknown` if it covers the
/// origin.
template <class Real>
Real half_viewing_angle(const Real& radius, const Real& distance, const Real& unknown) {
    using std::asin;
    if (radius == Real(0) && distance > Real(0)) return Real(0);
    return radius < distance ? asin(radius / distance) / Real(2) : unknown;
}

}  // namespace detail

/// Bars for all measures of `estimate`. `missing` and `surplus` have the unit of S0.
///
/// The azimuth and the ellipticity angle are half the longitude and latitude on the Poincare sphere: the true vector
/// lies in a ball of radius missing + surplus, whose longitudes and latitudes are bounded by its viewing angle from the
/// origin (seen along the axis for the longitude). Once the ball covers the origin, or the axis, they may be anything.
/// Amounts that are negative or NaN (a damaged file) say nothing, and the bars then are as wide as can be.
template <class Real>
MeasureBounds<Real> measure_bounds(const Stokes<Real>& estimate, const Real& missing, const Real& surplus = Real(0)) {
    using std::abs;
    using std::atan2;
    using std::tan;
    if (!(missing >= Real(0)) || !(surplus >= Real(0))) {
        const Real anything = std::numeric_limits<Real>::infinity();
        return measure_bounds(estimate, anything, anything);
    }
    const Real radius = missing + surplus;
    const Real linear = linear_part(estimate);
    const Real polarized = polarized_part(estimate);
    const Real quarter_pi = Real(pi) / Real(4);

    MeasureBounds<Real> bounds;
    bounds.s0 = {std::max(Real(0), estimate.s0 - surplus), estimate.s0 + missing};
    bounds.s1 = {estimate.s1 - radius, estimate.s1 + radius};
    bounds.s2 = {estimate.s2 - radius, estimate.s2 + radius};
    bounds.s3 = {estimate.s3 - radius, estimate.s3 + radius};
    bounds.dop = detail::share_bounds(polarized, estimate.s0, missing, surplus);
    bounds.dolp = detail::share_bounds(linear, estimate.s0, missing, surplus);
    bounds.docp = detail::share_bounds(Real(abs(estimate.s3)), estimate.s0, missing, surplus);
    bounds.azimuth = detail::half_viewing_angle(radius, linear, Real(2) * quarter_pi);

    const Real chi = atan2(estimate.s3, linear) / Real(2);
    const Real spread = detail::half_viewing_angle(radius, polarized, Real(2) * quarter_pi);
    const Real low = std::max(-quarter_pi, chi - spread);
    const Real high = std::min(quarter_pi, chi + spread);
    bounds.ellipticity_angle = {low, high};

    const bool may_be_linear = low <= Real(0) && high >= Real(0);
    bounds.ellipticity = {may_be_linear ? Real(0) : Real(tan(std::min(abs(low), abs(high)))),
                          tan(std::max(abs(low), abs(high)))};
    return bounds;
}

/// Degree of polarization below which the polarized part is too weak for its state to be asked for.
inline constexpr double weak_polarization = 0.05;
/// Width of a bar, of a quantity between 0 and 1, that counts as determined.
inline constexpr double determined_width = 0.1;

/// Whether the bars of DoP and ellipticity of `estimate` are at most determined_width wide, or that of the DoP is and
/// lies below weak_polarization. `missing` as in measure_bounds, without surplus.
///
/// The bar of the DoP is at most 2 missing/(S0 + missing) wide (share_bounds). That of chi is 2 half_viewing_angle =
/// asin(missing/p) <= pi/2 missing/p wide, and d tan(chi)/d chi <= 2 for |chi| <= pi/4.
inline bool is_determined(const Stokes<double>& estimate, double missing) {
    const double most = estimate.s0 + missing;
    if (2.0 * missing > determined_width * most) return false;
    const double square = estimate.s1 * estimate.s1 + estimate.s2 * estimate.s2 + estimate.s3 * estimate.s3;
    const double weak = weak_polarization * most - missing;
    if (weak > 0.0 && square < weak * weak) return true;
    const double least = pi / determined_width * missing;
    return square >= least * least;
}

}  // namespace pol
