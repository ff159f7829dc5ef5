// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "maps/colorize.h"
#include "maps/quantity.h"

namespace pol {

/// Values at which the bar carries numbers: both ends, and round ones between them. Ascending.
/// Requires: range.low < range.high.
std::vector<double> bar_ticks(const MapRange& range, ScaleKind kind);

/// What stands beside the number of one of these ticks: " left" at the low end if that is below 0, " right" at the high
/// end if that is above; else nothing.
std::string end_word(double tick, const MapRange& range, const ScaleWords& words);

}  // namespace pol
