// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "maps/colorize.h"
#include "maps/quantity.h"

namespace pol {

/// Values at which the bar carries numbers: both ends, and round ones between them. Ascending.
/// Requires: range.low < range.high.
std::vector<double> bar_ticks(const MapRange& range, ScaleKind kind);

}  // namespace pol
