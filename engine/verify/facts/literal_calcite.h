// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pol::verify {

/// Calcite with two literal indices and no dispersion, as facts and sweeps have it (PHYSICS.md 5).
constexpr double calcite_n_o = 1.6584;
constexpr double calcite_n_e = 1.4864;

}  // namespace pol::verify
