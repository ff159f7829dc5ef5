// SPDX-License-Identifier: Apache-2.0
// How far a picture is from another one, in numbers that suit polarization (CUTTING.md 3).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "film/stokes_image.h"

namespace pol {

/// One way to measure an error: over the whole picture, and per pixel at the 99th percentile and at worst.
struct Metric {
    double whole = 0.0;
    double p99 = 0.0;
    double largest = 0.0;

    [[nodiscard]] bool is_measured() const { return !std::isnan(whole); }
};

/// Test picture minus reference over all wavelengths and all pixels. dC is the difference of coherence matrices, s the
/// polarized part (S1, S2, S3), p the degree of polarization, l the linear part, all of the reference where they are
/// weights. A metric that needs a component which a band of either picture does not know is not there: NaN
/// (is_measured).
struct ErrorMetrics {
    /// sqrt(mean |dC|_F^2) / sqrt(mean |C|_F^2), |C|_F^2 = (S0^2 + |s|^2)/2: independent of the transverse basis. The
    /// primary metric. Infinite if the reference is black and the test is not, or if no
    /// number is finite. Per pixel: |dC|_F over the same
    /// denominator.
    Metric fro_c;
    /// sqrt(mean dS0^2) / sqrt(mean S0^2). Per pixel: |dS0| over the same denominator.
    Metric rel_rmse_s0;
    /// mean (dS0/(S0 + S0max/100))^2, S0max the largest of the reference: pbrt's MRSE with its 0.01 in units of the
    /// picture, so that it does not depend on the unit of radiance. Per pixel: what is averaged.
    Metric mrse_s0;
    /// (|dS0| + |ds|)/2, the spectral norm of dC: worst error of any intensity behind any polarizer, in units of S0.
    /// `whole` is the largest one.
    Metric analyzer_inf;
    /// sqrt(sum S0 dp^2 / sum S0). Per pixel: |dp| where S0 > 1e-3 of the largest.
    Metric dop_w;
    /// sqrt(sum l d^2 / sum l), d the angle between the azimuths as undirected lines, radians. Per pixel: d where
    /// l > 1e-3 of the largest S0.
    Metric azimuth_w;
    /// sqrt(sum |s| dchi^2 / sum |s|), chi the ellipticity angle, radians. Per pixel: |dchi| where |s| > 1e-3 of the
    /// largest S0.
    Metric ellip_w;
    /// sqrt(sum |s| g^2 / sum |s|), g half the angle between the states on the Poincare sphere, radians, 0 to pi/2:
    /// azimuth and ellipticity in one number. It is the distance of the azimuths of linear states, and of the
    /// ellipticity angles of states of one azimuth. Per pixel: g where |s| > 1e-3 of the largest S0.
    Metric poincare_w;
    std::size_t nan_count = 0;  ///< numbers that are not finite in either picture; they are left out of the sums
};

/// The metrics by name, in the order of the columns of runs.csv.
struct NamedMetric {
    std::string_view name;
    Metric ErrorMetrics::*metric;
    std::string_view unit;  ///< empty: a pure number
    StokesComponents needs = StokesComponents::all();
};
inline constexpr std::array<NamedMetric, 8> named_metrics{
    {{"fro_c", &ErrorMetrics::fro_c, ""},
     {"rel_rmse_s0", &ErrorMetrics::rel_rmse_s0, "", StokesComponents::s0()},
     {"mrse_s0", &ErrorMetrics::mrse_s0, "", StokesComponents::s0()},
     {"analyzer_inf", &ErrorMetrics::analyzer_inf, "S0"},
     {"dop_w", &ErrorMetrics::dop_w, ""},
     {"azimuth_w", &ErrorMetrics::azimuth_w, "rad", StokesComponents::linear()},
     {"ellip_w", &ErrorMetrics::ellip_w, "rad"},
     {"poincare_w", &ErrorMetrics::poincare_w, "rad"}}};

/// Requires: same size and same number of bands.
ErrorMetrics error_metrics(const StokesImage& test, const StokesImage& reference);

/// What in a picture cannot be light.
struct LightDefects {
    std::size_t not_psd = 0;   ///< numbers whose coherence matrix has a negative eigenvalue: |s| > S0
    double s0_over_max = 0.0;  ///< largest S0 over brightest: must not exceed 1
};

/// `rounding`: of S0, relative to brightest; |s| may exceed S0 by it. Requires: `brightest` is known.
LightDefects light_defects(const StokesImage& image, double rounding);

/// Root mean square of |C|_F over pixels and wavelengths: the unit of fro_c.
double matrix_rms(const StokesImage& image);

/// What the picture did not trace, bounded: root mean square of truncation_bound() in the unit of the reference's
/// matrix_rms(), which is never below fro_c of the truncation. Infinite if light is missing and the reference is black.
double relative_bound(const StokesImage& image, const StokesImage& reference);

/// Does the picture's own bound hold the truth, and how tight is it?
struct BoundCoverage {
    double covered = 1.0;  ///< share of pixels whose error their bounds allow, 0 to 1
    double ratio = 0.0;    ///< median of |dS0| / bound over pixels whose reference is known ten times better
    double mean = 0.0;     ///< mean bound relative to brightest
    double largest = 0.0;  ///< largest bound relative to brightest
};

/// Two pictures of the same samples, cut in different ways, can both be right only if |dS0| is at most the sum of both
/// bounds (residual + tail) brightest, and |dC|_F at most the sum of both truncation_bound(), each with `rounding`
/// times brightest on top. A reference without residual or brightest claims no bound. Requires: as error_metrics;
/// `brightest` of the test is known.
BoundCoverage bound_coverage(const StokesImage& test, const StokesImage& reference, double rounding);

/// Rounding of a tree of some 1e4 branches, relative to brightest.
inline constexpr double double_rounding = 1e-11;

/// sqrt(mean |dRGB|^2 / mean |RGB|^2) of the color pictures (CIE 1931 observer, linear sRGB), whose sets of wavelengths
/// may differ. Requires: same size.
double color_difference(const StokesImage& test, const StokesImage& reference);

}  // namespace pol
