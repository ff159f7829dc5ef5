// SPDX-License-Identifier: Apache-2.0
// The parts of the suite of degenerate cases, by subject, and words that they share.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/vec.h"
#include "optics/dielectric.h"
#include "verify/degenerate/degenerate_case.h"
#include "verify/facts/literal_calcite.h"

namespace pol::verify {

std::vector<DegenerateCase> axis_cases();
std::vector<DegenerateCase> incidence_cases();
std::vector<DegenerateCase> index_cases();
std::vector<DegenerateCase> state_cases();
std::vector<DegenerateCase> path_cases();
std::vector<DegenerateCase> scene_cases();
std::vector<DegenerateCase> pair_cases();

/// Orientations that a case of formulas is tried in.
constexpr std::size_t usual_turns = 8;
inline const std::string same_formulas = "the same formulas with 113 bits";
inline const std::string of_waves = "power and ray of each wave";
inline const std::string s0_s1 = "S0 and S1 of one rendered ray";

inline const Dielectric<double> air = make_isotropic(1.0);
inline Dielectric<double> calcite_crystal(const DVec3& axis) {
    return make_uniaxial(calcite_n_o, calcite_n_e, axis);
}
/// Of a face before it is turned.
inline const DVec3 face_normal(0.0, 0.0, 1.0);

/// The same settings and, last, the singular point itself.
inline std::vector<double> and_zero(std::vector<double> settings) {
    settings.push_back(0.0);
    return settings;
}

/// `angle` away from the unit vector `from`, in a plane in general position.
inline DVec3 beside(const DVec3& from, double angle) {
    constexpr double around = 0.7;
    const DVec3 a = any_perpendicular(from);
    return unit(from + std::tan(angle) * (std::cos(around) * a + std::sin(around) * cross(from, a)));
}

/// Unit vector at `polar` from +z, turned by `around` about z.
inline DVec3 polar_direction(double polar, double around = 0.0) {
    return {std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)};
}

}  // namespace pol::verify
