// SPDX-License-Identifier: Apache-2.0
// How the picture is shown. Changing any of it costs a frame, never a render.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "maps/colorize.h"
#include "maps/quantity.h"
#include "viewer/shown/convention.h"

namespace pol {

/// Polarization ellipses drawn over the picture.
enum class GlyphKind : std::uint8_t { none, ellipses, azimuth_strokes, combined };
enum class GlyphLength : std::uint8_t { equal, by_dop, by_intensity };

struct GlyphSettings {
    GlyphKind kind = GlyphKind::none;
    GlyphLength length = GlyphLength::by_dop;
    double spacing = 28.0;  ///< points between glyphs on screen, whatever the zoom
    friend bool operator==(const GlyphSettings&, const GlyphSettings&) = default;
};

/// How a picture and the reference are shown together.
enum class CompareLayout : std::uint8_t {
    single,        ///< the picture alone
    wipe,          ///< left of a line the reference, right of it the picture
    side_by_side,  ///< the reference and the picture, at the same place
};

struct ViewSettings {
    Quantity quantity = Quantity::color;
    std::size_t band = 0;  ///< index into the picture's bands
    MapStyle style = MapStyle::scientific;
    std::optional<ColorScale> scale;  ///< instead of the one that style and quantity choose
    /// By quantity: instead of the range of QuantityInfo.
    std::array<std::optional<MapRange>, quantity_count> range{};
    CompareLayout layout = CompareLayout::single;  ///< as far as the two can be compared (Session::layout)
    double wipe = 0.5;                             ///< place of the line, of the viewport's width
    bool difference = false;  ///< minus the reference, where the two can be compared (Session::comparison)
    std::array<std::optional<MapRange>, quantity_count> difference_range{};  ///< by quantity: instead of what is there
    double exposure = 0.0;                                                   ///< stops; color and intensity
    double offset = 0.0;          ///< added after exposure; color and intensity
    double gamma = 1.0;           ///< value^(1/gamma) after offset, on top of sRGB; color and intensity
    bool over_intensity = false;  ///< the map's color times the picture's lightness
    bool fade_by_bar = false;     ///< the wider the error bar, the weaker the color
    bool numbers_in_pixels = true;
    GlyphSettings glyphs;
    Convention convention{};  ///< labels of everything that shows the picture's light
};

}  // namespace pol
