// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace pol {

constexpr double pi = std::numbers::pi;
constexpr double radians(double degrees) {
    return degrees * (pi / 180.0);
}
constexpr double degrees(double radians) {
    return radians * (180.0 / pi);
}

}  // namespace pol
