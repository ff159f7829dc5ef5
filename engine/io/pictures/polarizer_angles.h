// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/result.h"

namespace pol {

/// What S0, S1 and S2 are of the light behind an ideal polarizer at several angles: least squares of
/// I = (S0 + S1 cos 2a + S2 sin 2a) / 2 (exact for multiples of 45 degrees).
struct AngleFit {
    /// weights[i][k]: share of photograph k in component i.
    std::array<std::vector<double>, 3> weights;
    std::vector<double> cosine;  ///< of 2 a
    std::vector<double> sine;
};

/// Error (kind usage): fewer than three angles that differ, modulo 180 degrees, by enough to tell the components apart.
Result<AngleFit> fit_angles(std::span<const double> angles_deg);

}  // namespace pol
