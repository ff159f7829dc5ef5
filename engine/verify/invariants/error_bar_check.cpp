// SPDX-License-Identifier: Apache-2.0
#include "verify/invariants/error_bar_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "polarization/bounds.h"
#include "polarization/measures.h"

namespace pol::verify {

namespace {

/// Rounding of a Stokes vector, relative to the brightest light: up to 20000 additions of 1.1e-16, and 40 surfaces of
/// 60 operations on the way of each leaf, 2.5e-12. An error of that size is a difference of two states of light of that
/// trace, so it is taken into account as light that may be missing and as light that may be too much.
constexpr double bar_rounding = 5e-12;

/// Rounding of the ends of a bar.
constexpr double slack = 1e-14;

MeasureBounds<double> bars_with_rounding(const StokesImage& image, std::size_t wavelength, std::size_t pixel) {
    const double brightest = image.brightest[wavelength];
    const double surplus = (image.plane_value(image.tail, wavelength, pixel) + bar_rounding) * brightest;
    const double missing = image.plane_value(image.residual, wavelength, pixel) * brightest + surplus;
    return measure_bounds(image.at(wavelength, pixel), missing, surplus);
}

}  // namespace

std::optional<std::string> contradiction(const StokesImage& a, const StokesImage& b, std::size_t wavelength,
                                         std::size_t pixel) {
    const MeasureBounds<double> bar_a = bars_with_rounding(a, wavelength, pixel);
    const MeasureBounds<double> bar_b = bars_with_rounding(b, wavelength, pixel);
    const struct {
        const char* name;
        Interval<double> MeasureBounds<double>::*bar;
    } bars[] = {{"S0", &MeasureBounds<double>::s0},
                {"S1", &MeasureBounds<double>::s1},
                {"S2", &MeasureBounds<double>::s2},
                {"S3", &MeasureBounds<double>::s3},
                {"DoP", &MeasureBounds<double>::dop},
                {"DoLP", &MeasureBounds<double>::dolp},
                {"DoCP", &MeasureBounds<double>::docp},
                {"ellipticity", &MeasureBounds<double>::ellipticity},
                {"ellipticity angle", &MeasureBounds<double>::ellipticity_angle}};
    for (const auto& [name, bar] : bars) {
        const Interval<double>& x = bar_a.*bar;
        const Interval<double>& y = bar_b.*bar;
        if (!(x.low <= y.high + slack && y.low <= x.high + slack))
            return fmt::format("{} in [{}, {}] and in [{}, {}]", name, x.low, x.high, y.low, y.high);
    }
    const Measures<double> measures_a = measure(a.at(wavelength, pixel));
    const Measures<double> measures_b = measure(b.at(wavelength, pixel));
    if (measures_a.has_azimuth && measures_b.has_azimuth) {
        const double apart = line_angle(measures_a.azimuth, measures_b.azimuth);
        if (!(apart <= bar_a.azimuth + bar_b.azimuth + slack))
            return fmt::format("azimuths {} rad apart, with bars of {} and {}", apart, bar_a.azimuth, bar_b.azimuth);
    }
    return std::nullopt;
}

}  // namespace pol::verify
