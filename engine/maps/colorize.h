// SPDX-License-Identifier: Apache-2.0
// A map, or the color picture, as pixels for a screen, and what its color bar has to say.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/result.h"
#include "film/stokes_image.h"
#include "maps/color_scale.h"
#include "maps/evaluate.h"
#include "maps/quantity.h"

namespace pol {

enum class MapStyle : std::uint8_t {
    scientific,  ///< scales that need no color vision
    paper,       ///< value x D65: white is 1, black is 0 and everything undefined (Debelov & Kozlov, section 4)
    wilkie,      ///< the colors of Wilkie & Weidlich, "A standardised polarisation visualisation for images", 2010
};

struct MapRange {
    double low = 0.0;
    double high = 1.0;
};

struct MapOptions {
    MapStyle style = MapStyle::scientific;
    std::optional<MapRange> range;      ///< instead of the one of QuantityInfo; low < high
    double exposure = 0.0;              ///< stops, color and intensity only: light is multiplied by 2^exposure
    std::optional<ColorScale> scale{};  ///< instead of the one of the style; not for color
    /// Color and intensity only, after exposure: place in the range becomes (place + offset)^(1/gamma).
    double offset = 0.0;
    double gamma = 1.0;
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
    double wavelength_nm = 0.0;  ///< of no meaning for color
    bool is_difference = false;  ///< as Map
    /// How the scale is to be read.
    [[nodiscard]] ScaleKind kind() const { return is_difference ? ScaleKind::diverging : info(quantity).kind; }
    RgbPicture picture;
    std::vector<PixelState> states;                            ///< of the pixels of `picture`
    std::optional<ColorScale> scale;                           ///< none for color
    MapRange range{};                                          ///< values at the two ends of the scale
    std::array<std::size_t, pixel_state_count> state_count{};  ///< pixels by PixelState
    std::size_t below = 0;                                     ///< pixels under the range
    std::size_t above = 0;                                     ///< pixels over the range
    bool fades = false;                                        ///< some pixels are drawn with less than full weight
};

/// The scale that `style` has for `quantity`; of no meaning for color.
ColorScale scale_for(Quantity quantity, MapStyle style);
/// Values at the two ends of the scale: of the options, else of QuantityInfo, else from 0 to `largest`, the largest
/// defined value of the map (0..1 if that is 0 or there is none).
MapRange range_for(Quantity quantity, const MapOptions& options, double largest);

/// The same for differences from `low` to `high`: as far to both sides of 0, -1..1 if there are none.
MapRange range_of_differences(double low, double high);

/// Colors of pixels without a value. `undetermined` is hatched: `x + y` says where.
Rgb8 state_color(PixelState state, int x, int y);
/// `color` at a weight between 1 (as it is) and 0 (the gray of `undefined`).
Rgb8 faded(const Rgb& color, double weight);

/// Colors a map. A range that comes from the data is that of the defined values; 0..1 if there is none or all are 0.
/// Requires: map.quantity is not `color`.
ColoredMap colorize(const Map& map, const MapOptions& options);

/// The color picture of all wavelengths, or gray if there is one. Only exposure, offset and gamma are used.
ColoredMap colorize_picture(const StokesImage& image, const MapOptions& options);

/// The map or picture of `quantity`; `wavelength` is of no meaning for color. Error as in evaluate.
Result<ColoredMap> draw_map(const StokesImage& image, Quantity quantity, std::size_t wavelength,
                            const MapOptions& options);

}  // namespace pol
