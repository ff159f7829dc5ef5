// SPDX-License-Identifier: Apache-2.0
#include "polarization/stokes_convention.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace pol {
namespace {

/// (S1, S2) with the azimuth `degrees` larger; exact for multiples of 45 degrees.
Stokes<double> turned(const Stokes<double>& s, double degrees) {
    const double eighths = degrees / 45.0;
    if (eighths == std::round(eighths)) {
        switch ((static_cast<int>(std::fmod(eighths, 4.0)) + 4) % 4) {
            case 0:
                return s;
            case 1:
                return {s.s0, -s.s2, s.s1, s.s3};
            case 2:
                return {s.s0, -s.s1, -s.s2, s.s3};
            default:
                return {s.s0, s.s2, -s.s1, s.s3};
        }
    }
    const double angle = 2.0 * degrees * std::numbers::pi / 180.0;
    const double c = std::cos(angle);
    const double n = std::sin(angle);
    return {s.s0, c * s.s1 - n * s.s2, n * s.s1 + c * s.s2, s.s3};
}

std::string shortest(double number) {
    std::array<char, 32> text{};
    const auto [end, status] = std::to_chars(text.data(), text.data() + text.size(), number);
    return {text.data(), end};
}

}  // namespace

Stokes<double> StokesConvention::to_ours(const Stokes<double>& theirs) const {
    Stokes<double> s = theirs;
    if (left_handed) s.s3 = -s.s3;
    if (y_down) s = {s.s0, s.s1, -s.s2, -s.s3};
    return turned(s, azimuth_zero_deg);
}

Stokes<double> StokesConvention::from_ours(const Stokes<double>& ours) const {
    Stokes<double> s = turned(ours, -azimuth_zero_deg);
    if (y_down) s = {s.s0, s.s1, -s.s2, -s.s3};
    if (left_handed) s.s3 = -s.s3;
    return s;
}

std::string StokesConvention::text() const {
    std::string zero = azimuth_zero_deg == 0.0    ? "image right"
                       : azimuth_zero_deg == 90.0 ? "image up"
                                                  : shortest(azimuth_zero_deg) + "\u00b0 from image right";
    if (y_down)
        return std::string("S3 > 0 ") + (left_handed ? "left" : "right") +
               "-handed, y down (S2, S3 turn), azimuth from " + zero;
    return std::string("S3 > 0 is ") + (left_handed ? "left" : "right") + "-handed, y points up, azimuth from " + zero;
}

}  // namespace pol
