// SPDX-License-Identifier: Apache-2.0
// Which wavelengths a picture is made at.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace pol {

constexpr std::size_t max_wavelength_count = 4096;

/// Which of a picture's wavelengths is shown unless another one is asked for: the one nearest to this, the paper's.
constexpr double default_wavelength_nm = 580.0;

/// Index of the wavelength nearest to `nm`, the first of two that are equally near. Requires: there is one.
std::size_t nearest_wavelength(const std::vector<double>& wavelengths_nm, double nm);

/// Below this is no light but X-rays, and where a number is smaller, micrometres are meant.
constexpr double shortest_light_nm = 10.0;

/// What is wrong with a vacuum wavelength in nm (kind usage): not finite, or below shortest_light_nm. None: nothing.
std::optional<Error> wavelength_problem(double wavelength_nm);

/// `wavelengths_nm` itself if it is a list to render at: not empty, at most max_wavelength_count, each without
/// wavelength_problem, strictly ascending. Error (kind usage) otherwise.
Result<std::vector<double>> checked_wavelengths(std::vector<double> wavelengths_nm);

/// Vacuum wavelengths in nm, ascending, from "580", a list "450,550,650", or a range "380:780:20" (first, last, step;
/// the last is included where the steps reach it within 1e-9 of a step). Error (kind usage) for anything else.
Result<std::vector<double>> parse_wavelengths(std::string_view text);

}  // namespace pol
