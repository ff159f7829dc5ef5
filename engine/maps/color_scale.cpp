// SPDX-License-Identifier: Apache-2.0
#include "maps/color_scale.h"

#include <algorithm>
#include <cmath>

#include "core/contract.h"
#include "core/units.h"

namespace pol {
namespace {

/// Oklab, D65. Ottosson 2020, the matrices of that page to all their digits.
struct Oklab {
    double lightness;
    double a;
    double b;
};

Rgb to_linear(const Oklab& c) {
    const double l_root = c.lightness + 0.3963377774 * c.a + 0.2158037573 * c.b;
    const double m_root = c.lightness - 0.1055613458 * c.a - 0.0638541728 * c.b;
    const double s_root = c.lightness - 0.0894841775 * c.a - 1.2914855480 * c.b;
    const double l = l_root * l_root * l_root;
    const double m = m_root * m_root * m_root;
    const double s = s_root * s_root * s_root;
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

Oklab from_polar(double lightness, double chroma, double hue_degrees) {
    return {lightness, chroma * std::cos(radians(hue_degrees)), chroma * std::sin(radians(hue_degrees))};
}

// The curves below stay inside the sRGB gamut (tested), with chroma close to the most that it allows.

Oklab sequential(double t) {
    return from_polar(0.28 + 0.67 * t, 0.088 + 0.07 * t * t * t, 300.0 - 195.0 * t);
}

Oklab diverging(double t) {
    const double side = 2.0 * t - 1.0;
    const double distance = std::abs(side);
    const double hue = side < 0.0 ? 258.0 : 48.0;
    const double chroma = side < 0.0 ? 0.15 : 0.118;
    return from_polar(0.95 - 0.5 * distance, chroma * distance, hue);
}

Oklab cyclic(double t) {
    constexpr double radius = 0.155;
    const double tilt = radians(30.0);
    const double phase = 2.0 * pi * t;
    return {0.58 - radius * std::cos(tilt) * std::cos(phase), 0.02 + radius * std::sin(tilt) * std::cos(phase),
            -0.04 + radius * std::sin(phase)};
}

Rgb mix(const Rgb& a, const Rgb& b, double share_of_b) {
    Rgb mixed{};
    for (std::size_t c = 0; c < 3; ++c) mixed[c] = a[c] + (b[c] - a[c]) * share_of_b;
    return mixed;
}

constexpr Rgb black{0.0, 0.0, 0.0};
constexpr Rgb white{1.0, 1.0, 1.0};
constexpr Rgb red{1.0, 0.0, 0.0};
constexpr Rgb green{0.0, 1.0, 0.0};
constexpr Rgb blue{0.0, 0.0, 1.0};
constexpr Rgb yellow{1.0, 1.0, 0.0};
constexpr Rgb cyan{0.0, 1.0, 1.0};

Rgb two_sided(const Rgb& negative, const Rgb& positive, double t) {
    return t < 0.5 ? mix(black, negative, 1.0 - 2.0 * t) : mix(black, positive, 2.0 * t - 1.0);
}

/// The azimuth runs from -90 degrees at t = 0 to 90 at t = 1.
Rgb orientation(double t) {
    const std::array<Rgb, 5> corners{red, blue, green, yellow, red};
    const double position = 4.0 * t;
    const auto corner = static_cast<std::size_t>(std::min(3.0, std::floor(position)));
    return mix(corners[corner], corners[corner + 1], position - static_cast<double>(corner));
}

}  // namespace

Rgb scale_color(ColorScale scale, double t) {
    POL_EXPECTS(!std::isnan(t));
    const double inside = std::clamp(t, 0.0, 1.0);
    switch (scale) {
        case ColorScale::gray:
            return mix(black, white, inside);
        case ColorScale::sequential:
            return to_linear(sequential(inside));
        case ColorScale::diverging:
            return to_linear(diverging(inside));
        case ColorScale::cyclic:
            return to_linear(cyclic(inside));
        case ColorScale::wilkie_degree:
            return mix(black, red, inside);
        case ColorScale::wilkie_type:
            return mix(cyan, yellow, inside);
        case ColorScale::wilkie_s1:
            return two_sided(red, green, inside);
        case ColorScale::wilkie_s2:
            return two_sided(blue, yellow, inside);
        case ColorScale::wilkie_chirality:
            return two_sided(yellow, blue, inside);
        case ColorScale::wilkie_orientation:
            return orientation(inside);
    }
    POL_EXPECTS(false);
    return black;
}

Rgb8 encode(const Rgb& color) {
    Rgb8 encoded{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double signal = srgb_encode(color[c]);
        // The comparison is false for NaN.
        encoded[c] =
            signal > 0.0 ? static_cast<std::uint8_t>(std::lround(255.0 * std::min(1.0, signal))) : std::uint8_t{0};
    }
    return encoded;
}

double lightness(const Rgb& color) {
    const double y = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    constexpr double knee = 216.0 / 24389.0;
    return y > knee ? 116.0 * std::cbrt(y) - 16.0 : y * 24389.0 / 27.0;
}

}  // namespace pol
