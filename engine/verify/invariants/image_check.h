// SPDX-License-Identifier: Apache-2.0
// What can be said of any Stokes picture without its scene: whether its numbers are light at all, and what looks odd.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "film/stokes_image.h"

namespace pol::verify {

/// Largest |s|/S0 - 1 that rounding S0 to S3 makes of physical light, each by up to `rounding` u of itself: (1 + u)/(1
/// - u) - 1, u up to 2^-11.
constexpr double excess_of(double rounding) {
    return 2.0 * rounding * (1.0 + 4.0 * rounding);
}
/// Of 32-bit and 16-bit floats.
inline constexpr double float_excess = excess_of(0x1p-24);
inline constexpr double half_excess = excess_of(0x1p-11);

/// A number at a pixel of the whole picture; row 0 is its top row.
struct PixelValue {
    int x = 0;
    int y = 0;
    std::size_t band = 0;
    bool is_luminance = false;  ///< `value` is of the luminance of R, G and B, of which `band` is the first
    double value = 0.0;
};

/// A kind of number that no light has.
struct ImageDefect {
    std::string name;                 ///< "not a number or infinite"
    std::string value_name;           ///< what PixelValue::value is: "S0"; empty if the count is 0
    std::size_t count = 0;            ///< pixels times bands that have it
    std::optional<PixelValue> worst;  ///< none if the count is 0
};

/// Degree of polarization over pixels and bands with S0 > 0 whose numbers are finite, where all components are known;
/// of linear polarization if no band has S3.
struct DopStatistics {
    std::size_t lit = 0;
    std::size_t measured = 0;  ///< of them, those that have it
    bool is_linear = false;    ///< of linear polarization
    std::size_t dark = 0;      ///< S0 = 0
    double mean = 0.0;
    double least = 0.0;
    double percentile_1 = 0.0;
    double median = 0.0;
    double percentile_99 = 0.0;
    double most = 0.0;
};

struct ImageReport {
    std::vector<ImageDefect> defects;  ///< every kind that was looked for
    DopStatistics dop;
    std::vector<std::string> remarks;  ///< odd, but not wrong by themselves
    /// True if nothing is wrong.
    [[nodiscard]] bool physical() const;
};

/// Allows what StoredNumbers::rounding and ::step explain.
ImageReport check_image(const StokesImage& image);

}  // namespace pol::verify
