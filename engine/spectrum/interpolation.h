// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/contract.h"

namespace pol {

/// Linear interpolation; on a node, its value to the bit.
/// Requires: as many values as nodes, nodes ascending (strictly around `at`), `at` between the first and the last.
inline double interpolate(const std::vector<double>& nodes, const std::vector<double>& values, double at) {
    POL_EXPECTS(nodes.size() == values.size() && !nodes.empty());
    POL_EXPECTS(at >= nodes.front() && at <= nodes.back());
    const auto upper = static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), at) - nodes.begin());
    if (nodes[upper] == at) return values[upper];
    const double t = (at - nodes[upper - 1]) / (nodes[upper] - nodes[upper - 1]);
    return (1.0 - t) * values[upper - 1] + t * values[upper];
}

}  // namespace pol
