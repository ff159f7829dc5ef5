// SPDX-License-Identifier: Apache-2.0
#include "report/number_words.h"

#include <fmt/format.h>

#include <cmath>

namespace pol {

std::string duration_text(double seconds) {
    if (seconds < 0.9995) return fmt::format("{:.0f} ms", 1e3 * seconds);
    if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
    const double whole = std::round(seconds);
    if (whole < 60.0) return fmt::format("{:.0f} s", whole);
    const double minutes = std::floor(whole / 60.0);
    if (minutes < 60.0) return fmt::format("{:.0f} min {:.0f} s", minutes, whole - 60.0 * minutes);
    const double hours = std::floor(minutes / 60.0);
    return fmt::format("{:.0f} h {:.0f} min", hours, minutes - 60.0 * hours);
}

std::string count_text(std::uint64_t count) {
    const auto number = static_cast<double>(count);
    if (count < 1'000'000) return fmt::format("{}", count);
    if (count < 1'000'000'000) return fmt::format("{:.2f} million", 1e-6 * number);
    return fmt::format("{:.2f} billion", 1e-9 * number);
}

}  // namespace pol
