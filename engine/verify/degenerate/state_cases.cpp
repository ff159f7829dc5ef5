// SPDX-License-Identifier: Apache-2.0
// Degenerate cases about polarization states: dark, bright, almost fully polarized, almost unpolarized.
#include <array>
#include <cmath>

#include "polarization/coherence_matrix.h"
#include "polarization/measures.h"
#include "verify/degenerate/case_lists.h"

namespace pol::verify {

namespace {

template <class Real>
void append_measures(std::vector<Real>& results, const Stokes<Real>& s) {
    const Measures<Real> m = measure(s);
    results.insert(results.end(),
                   {m.dop, m.dolp, m.docp, m.unpolarized, m.ellipticity, m.ellipticity_angle, m.azimuth});
}

/// Inputs: a Stokes vector. Results: its measures.
struct MeasuresOfStokes {
    template <class Real>
    std::vector<Real> operator()(std::span<const Real> x) const {
        std::vector<Real> results;
        append_measures(results, Stokes<Real>{x[0], x[1], x[2], x[3]});
        return results;
    }
};

template <class Real>
std::array<JonesVector<Real>, 2> two_fields(std::span<const Real> x) {
    return {{{{x[0], x[1]}, {x[2], x[3]}}, {{x[4], x[5]}, {x[6], x[7]}}}};
}

/// Inputs: two fields (re and im of x and y). Results: the measures of their incoherent sum.
struct MeasuresOfSum {
    template <class Real>
    std::vector<Real> operator()(std::span<const Real> x) const {
        const auto fields = two_fields(x);
        const auto sum = CoherenceMatrix<Real>::outer(fields[0]) + CoherenceMatrix<Real>::outer(fields[1]);
        std::vector<Real> results;
        append_measures(results, to_stokes(sum));
        return results;
    }
};

/// As above. Result: 1 - P of the sum.
struct UnpolarizedFractionOfSum {
    template <class Real>
    std::vector<Real> operator()(std::span<const Real> x) const {
        const auto fields = two_fields(x);
        return {unpolarized_fraction(std::span<const JonesVector<Real>>(fields))};
    }
};

/// The elliptic field cos(a) u + sin(a) w of two orthogonal elliptic states, times `size`.
std::array<double, 4> field(double a, double size) {
    constexpr double chi = 0.2;  // ellipticity angle of u
    constexpr double psi = 0.5;  // azimuth of u
    const std::array<double, 4> u = {std::cos(psi) * std::cos(chi), std::sin(psi) * std::sin(chi),
                                     std::sin(psi) * std::cos(chi), -std::cos(psi) * std::sin(chi)};
    // (-conj(u_y), conj(u_x)) is orthogonal to u.
    const std::array<double, 4> w = {-u[2], u[3], u[0], -u[1]};
    std::array<double, 4> result{};
    for (std::size_t i = 0; i < 4; ++i) result[i] = size * (std::cos(a) * u[i] + std::sin(a) * w[i]);
    return result;
}

std::vector<double> both(const std::array<double, 4>& a, const std::array<double, 4>& b) {
    std::vector<double> inputs;
    inputs.reserve(8);
    for (const auto& one : {a, b})
        for (const double part : one) inputs.push_back(part);
    return inputs;
}

}  // namespace

std::vector<DegenerateCase> state_cases() {
    const std::string measures = "degrees of polarization, ellipticity, azimuth";
    std::vector<double> dim;
    for (int exponent = -20; exponent >= -300; exponent -= 20) dim.push_back(std::pow(10.0, exponent));
    std::vector<double> all_sizes;
    for (int exponent = -30; exponent <= 30; exponent += 5) all_sizes.push_back(std::pow(10.0, exponent));
    return {
        {"dark", "Light that fades keeps its state to the last; no light has none and gives no NaN", "S0", measures,
         same_formulas, and_zero(dim),
         [](double s0, const Turn&) {
             return experiment_on(MeasuresOfStokes{}, {s0, 0.3 * s0, -0.2 * s0, 0.4 * s0});
         }},
        {"radiance-of-sums", "All maps are the same for radiances from 1e-30 to 1e30", "radiance of two fields",
         measures, same_formulas, all_sizes,
         [](double radiance, const Turn&) {
             const double size = std::sqrt(radiance);
             return experiment_on(MeasuresOfSum{}, both(field(0.3, size), field(1.1, 0.7 * size)));
         }},
        {"almost-polarized", "The degree of polarization of two almost equal states exceeds 1 by rounding at most",
         "angle between two fields [rad]", measures, same_formulas, and_zero(decades(-1, -16)),
         [](double angle, const Turn&) {
             return experiment_on(MeasuresOfSum{}, both(field(0.3, 1.0), field(0.3 + angle, 0.8)));
         }},
        {"unpolarized-fraction", "1 - P of two almost equal states is known to its own last digits",
         "angle between two fields [rad]", "1 - P to its own size", same_formulas, decades(-1, -16),
         [](double angle, const Turn&) {
             return experiment_on(UnpolarizedFractionOfSum{}, both(field(0.0, 1.0), field(angle, 0.8)),
                                  Accuracy::relative);
         }},
        {"almost-unpolarized", "A weak polarization on unpolarized light keeps the state that its inputs allow",
         "degree of polarization", measures, same_formulas, and_zero(decades(-1, -14)),
         [](double dop, const Turn&) {
             return experiment_on(MeasuresOfSum{}, both(field(0.0, std::sqrt(1.0 + dop)),
                                                        field(1.5707963267948966, std::sqrt(1.0 - dop))));
         }},
    };
}

}  // namespace pol::verify
