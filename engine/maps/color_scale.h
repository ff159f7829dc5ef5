// SPDX-License-Identifier: Apache-2.0
// From numbers to colors. The scales of the scientific style are closed forms in Oklab (Ottosson, "A perceptual color
// space for image processing", 2020): they can be read without color vision, since lightness alone orders them.
#pragma once

#include <array>
#include <cstdint>

#include "spectrum/color.h"

namespace pol {

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
    wilkie_s1,           ///< red S1 < 0 (vertical), black, green S1 > 0, as polvis of Mitsuba 3 has them
    wilkie_s2,           ///< blue S2 < 0, black, yellow S2 > 0, the same
    wilkie_chirality,    ///< yellow S3 < 0 (left), black, blue S3 > 0 (right)
    wilkie_orientation,  ///< green 0, yellow 45, red 90, blue 135 degrees: s1 and s2 in one hue
};

/// Color at `t` in 0..1 from one end of the scale to the other; values outside are taken at the nearer end, which the
/// color bar shows by an arrow. Diverging scales have their zero at 0.5.
Rgb scale_color(ColorScale scale, double t);

/// sRGB for a screen, which cannot show more than 1 (255) or less than 0 (0). NaN is black.
Rgb8 encode(const Rgb& color);

/// CIE 1976 lightness L*, 0 to 100, of a color of a screen.
double lightness(const Rgb& color);

}  // namespace pol
