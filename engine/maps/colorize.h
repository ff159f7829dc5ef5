// SPDX-License-Identifier: Apache-2.0
// A map, or the color picture, as pixels for a screen, and what its color bar has to say.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "film/stokes_image.h"
#include "maps/color_scale.h"
#include "maps/evaluate.h"
#include "maps/quantity.h"

namespace pol {

enum class MapStyle : std::uint8_t {
    scientific,  ///< scales that need no color vision
    paper,       ///< value x D65: white is 1, black is 0 and what has no light or no polarization (Debelov & Kozlov,
                 ///< section 4). They draw nothing that is signed or closed: there it is as `scientific`
    wilkie,      ///< the colors of Wilkie & Weidlich, "A standardised polarisation visualisation for images", 2010
};

struct MapRange {
    double low = 0.0;
    double high = 1.0;
};

/// How a scale over `range` is to be read: signed for differences, and closed only if it spans the whole cycle.
ScaleKind kind_of(Quantity quantity, bool is_difference, const MapRange& range);

/// What a scale says besides numbers.
struct ScaleWords {
    std::string low;         ///< name of what is below 0, written at the low end: "left"; empty: none
    std::string high;        ///< the same above 0
    std::string note;        ///< a line of the legend: "source's view, S3 > 0 left"; empty: none
    bool clockwise = false;  ///< angles are counted clockwise on the picture, from the left
};

struct MapOptions {
    MapStyle style = MapStyle::scientific;
    std::optional<MapRange> range;      ///< instead of the one of QuantityInfo; low < high
    double exposure = 0.0;              ///< stops, color and intensity only: light is multiplied by 2^exposure
    std::optional<ColorScale> scale{};  ///< instead of the one of the style; not for color
    /// Color and intensity only, after exposure: place in the range becomes (place + offset)^(1/gamma).
    double offset = 0.0;
    double gamma = 1.0;
    bool fade_by_bar = false;  ///< MapPixel::certainty counts, too
    ScaleWords words{};
};

/// Offset and gamma of a photograph. `light` is already exposed; 1 is white.
double developed(double light, const MapOptions& options);

/// 8-bit sRGB, row 0 at the top.
struct RgbPicture {
    int width = 0;
    int height = 0;
    std::vector<Rgb8> pixels;
};

/// A picture with all that its legend needs.
struct ColoredMap {
    Quantity quantity{};
    MapStyle style{};
    Band band;                   ///< of no meaning for color
    bool is_difference = false;  ///< as Map
    /// How the scale is to be read.
    [[nodiscard]] ScaleKind kind() const { return kind_of(quantity, is_difference, range); }
    RgbPicture picture;
    std::vector<PixelState> states;                            ///< of the pixels of `picture`
    std::optional<ColorScale> scale;                           ///< none for color
    MapRange range{};                                          ///< values at the two ends of the scale
    std::array<std::size_t, pixel_state_count> state_count{};  ///< pixels by PixelState
    std::size_t below = 0;                                     ///< pixels under the range
    std::size_t above = 0;                                     ///< pixels over the range
    bool fades = false;                                        ///< some pixels are drawn with less than full weight
    bool fades_by_bar = false;   ///< some pixels are drawn weaker because of the width of their error bar
    bool black_is_none = false;  ///< as MapScale
    ScaleWords words;
};

/// Scale of a map: what colorize, the window's picture and every color bar share.
struct MapScale {
    ColorScale scale{};
    MapRange range{};  ///< values at the two ends
    ScaleKind kind{};  ///< how it is to be read
    /// Pixels with less than full weight are mixed with gray. A gray scale has no room for that: there gray is a value.
    [[nodiscard]] bool can_fade() const { return scale != ColorScale::gray; }
    /// What has no light or is undefined is black, as 0: the paper's figures.
    bool black_is_none = false;
};

/// The scale of `quantity`, or of its differences, if its least and largest defined values are `low` and `high` (0 and
/// 0 if there are none). The range is that of the options, else of QuantityInfo, else from 0 to `high`; of differences
/// as far to both sides of 0, but for the azimuth, whose differences are a whole cycle: -90 and 90 degrees are one. Of
/// no meaning for color.
MapScale map_scale(Quantity quantity, bool is_difference, const MapOptions& options, double low, double high);

/// Drawn in stripes of two colors, which no value has.
constexpr bool is_hatched(PixelState state) {
    return state == PixelState::undetermined || state == PixelState::dark;
}

/// Colors of pixels without a value. Of those that are hatched `x + y` says which of both: (0, 0) and (4, 0) have one
/// each. `black_is_none` as in MapScale.
Rgb8 state_color(PixelState state, int x, int y, bool black_is_none = false);
/// `color` at a weight between 1 (as it is) and 0 (the gray of `undefined`).
Rgb8 faded(const Rgb& color, double weight);

/// Colors a map with the scale of map_scale.
/// Requires: map.quantity is not `color`.
ColoredMap colorize(const Map& map, const MapOptions& options);

/// The color picture of all bands (band_colors). Only exposure, offset and gamma are used.
ColoredMap colorize_picture(const StokesImage& image, const MapOptions& options);

/// The map or picture of `quantity`; `band` is of no meaning for color. Error as in evaluate.
Result<ColoredMap> draw_map(const StokesImage& image, Quantity quantity, std::size_t band, const MapOptions& options);

}  // namespace pol
