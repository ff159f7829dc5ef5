// SPDX-License-Identifier: Apache-2.0
// From numbers to colors. The scales of the scientific style are closed forms in Oklab (Ottosson, "A perceptual color
// space for image processing", 2020): they can be read without color vision, since lightness alone orders them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace pol {

/// Linear sRGB, 0 to 1 for what a screen can show.
using LinearRgb = std::array<double, 3>;
/// sRGB, 8 bits a channel.
using Rgb8 = std::array<std::uint8_t, 3>;

enum class ColorScale : std::uint8_t {
    gray,        ///< black to white, linear light: what a screen then shows is proportional to the value
    sequential,  ///< dark violet over teal to light yellow; lightness rises linearly
    diverging,   ///< blue, white, orange; lightness falls linearly from the middle
    cyclic,  ///< a circle in Oklab: equal steps look equal, 0 = 1. A plane tilted so that the circle stays open, seen
             ///< without red and green
    wilkie_degree,       ///< black to red (Wilkie & Weidlich 2010: degree of polarization)
    wilkie_type,         ///< cyan linear to yellow circular (type of polarization)
    wilkie_s1,           ///< green, black, red (orientation, horizontal and vertical)
    wilkie_s2,           ///< yellow, black, blue (orientation, diagonals)
    wilkie_chirality,    ///< yellow left, black, blue right
    wilkie_orientation,  ///< red 0, blue 45, green 90, yellow 135 degrees: s1 and s2 in one hue
};

/// Color at `t` in 0..1 from one end of the scale to the other; values outside are taken at the nearer end, which the
/// color bar shows by an arrow. Diverging scales have their zero at 0.5.
LinearRgb scale_color(ColorScale scale, double t);

/// IEC 61966-2-1 encoding. Not finite and negative light is black, light above 1 is 255: a screen has no other.
Rgb8 encode(const LinearRgb& color);

/// Inverse of the encoding of one channel.
double decode(std::uint8_t value);

/// CIE 1976 lightness L*, 0 to 100, of a color of a screen.
double lightness(const LinearRgb& color);

}  // namespace pol
