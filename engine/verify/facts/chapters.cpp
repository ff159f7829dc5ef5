// SPDX-License-Identifier: Apache-2.0
#include "verify/facts/chapters.h"

#include <fmt/format.h>

#include <cmath>

#include "core/units.h"
#include "polarization/measures.h"
#include "verify/facts/scene_text.h"
#include "verify/facts/tree_paths.h"

namespace pol::verify {

std::size_t add_view(Fact& fact, std::string name, std::string yaml, double wavelength_nm) {
    constexpr int middle = picture_side / 2;
    fact.views.push_back({std::move(name), std::move(yaml), middle, middle, wavelength_nm});
    return fact.views.size() - 1;
}

void expect(Fact& fact, std::size_t view, std::string what, double expected, Tolerance tolerance, Measurement measure,
            std::string unit) {
    fact.readings.push_back(
        {view, std::move(what), std::move(unit), expected, std::move(tolerance), std::move(measure)});
}

Measurement of_pixel(StokesMeasure measure) {
    return [measure = std::move(measure)](const Explanation& e) { return measure(e.sample_light); };
}

Measurement along(std::string route, StokesMeasure measure) {
    return [route = std::move(route), measure = std::move(measure)](const Explanation& e) {
        return measure(light_along(e, route));
    };
}

double s0(const Stokes<double>& s) {
    return s.s0;
}
double s1(const Stokes<double>& s) {
    return s.s1;
}
double s2(const Stokes<double>& s) {
    return s.s2;
}
double s3(const Stokes<double>& s) {
    return s.s3;
}
double s_share(const Stokes<double>& s) {
    return s.s0 + s.s1;
}
double p_share(const Stokes<double>& s) {
    return s.s0 - s.s1;
}
double dop(const Stokes<double>& s) {
    return measure(s).dop;
}
double ellipticity(const Stokes<double>& s) {
    return measure(s).ellipticity;
}
double handedness(const Stokes<double>& s) {
    return measure(s).handedness;
}
double azimuth_degrees(const Stokes<double>& s) {
    return degrees(measure(s).azimuth);
}

Tolerance rounding(double epsilons, std::string_view of) {
    return {epsilons * epsilon, fmt::format("rounding of {}: {} epsilon", of, epsilons)};
}

Tolerance one_crystal_surface() {
    return rounding(60.0, "one surface of a crystal");
}

Tolerance residual_bound(double residual, double slope, const Tolerance& otherwise) {
    return {slope * residual + otherwise.value, fmt::format("{} x residual {} + {}", slope, residual, otherwise.from)};
}

Tolerance last_printed_digit(int decimals, std::string_view source) {
    return {0.5000001 * std::pow(10.0, -decimals),
            fmt::format("half of the last of {} decimals of {}", decimals, source)};
}

Tolerance exact() {
    return {0.0, "none: a count"};
}

}  // namespace pol::verify
