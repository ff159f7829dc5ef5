// SPDX-License-Identifier: Apache-2.0
// The four standard pictures of Wilkie & Weidlich, "A standardised polarisation visualisation for images", SCCG 2010,
// in the colors and under the names of Mitsuba's polvis: others compare with them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/result.h"
#include "film/stokes_image.h"
#include "maps/colorize.h"

namespace pol {

enum class WilkiePicture : std::uint8_t {
    degree,       ///< red: DoP
    type,         ///< (c, l + c, l) DoP: cyan linear, yellow circular
    orientation,  ///< l times (S1/S0 in green, negative red, plus S2/S0 in yellow, negative blue)
    chirality,    ///< c times S3/S0 in blue, negative (left) yellow
};

struct WilkiePictureInfo {
    WilkiePicture picture{};
    std::string_view name;   ///< as polvis ends its files: "dop", "top", "lin", "cir"
    std::string_view about;  ///< its colors
    StokesComponents needs = StokesComponents::all();
};
inline constexpr std::array<WilkiePictureInfo, 4> wilkie_pictures{{
    {WilkiePicture::degree, "dop", "degree of polarization: black to red"},
    {WilkiePicture::type, "top", "type: cyan linear, yellow circular, times the degree"},
    {WilkiePicture::orientation, "lin",
     "plane of linear light: S1 green, negative red; S2 yellow, negative blue; times its share of the polarized part"},
    {WilkiePicture::chirality, "cir", "chirality: right blue, left yellow, times its share of the polarized part"},
}};

/// l and c are |(S1, S2)| and |S3| over |(S1, S2, S3)|. Of one band, or of the mean of all bands, as polvis has it.
/// Pixels without light and unpolarized ones are black, other states as in state_color. Error (kind input): a band
/// lacks a component that the picture needs. Requires: band < image.bands.size() if there is one.
Result<RgbPicture> wilkie_picture(const StokesImage& image, std::optional<std::size_t> band,
                                  const WilkiePictureInfo& which);

}  // namespace pol
