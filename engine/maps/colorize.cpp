// SPDX-License-Identifier: Apache-2.0
#include "maps/colorize.h"

#include <algorithm>
#include <cmath>

#include "core/contract.h"
#include "core/result.h"
#include "maps/color_picture.h"

namespace pol {
namespace {

constexpr Rgb8 black_pixel{0, 0, 0};
constexpr Rgb8 middle_gray{96, 96, 96};
constexpr Rgb8 hatch_light{150, 150, 150};
constexpr Rgb8 hatch_dark{64, 64, 64};
constexpr Rgb8 quiet_hatch_light{56, 56, 56};
constexpr Rgb8 quiet_hatch_dark{36, 36, 36};
constexpr Rgb8 slate{52, 70, 96};
constexpr Rgb8 magenta{255, 0, 255};
constexpr Rgb8 dark_magenta{140, 0, 140};

Rgb decoded(const Rgb8& color) {
    return {srgb_decode(color[0] / 255.0), srgb_decode(color[1] / 255.0), srgb_decode(color[2] / 255.0)};
}

/// Least and largest defined value, 0 included.
MapRange extremes(const Map& map) {
    MapRange found{0.0, 0.0};
    for (const MapPixel& pixel : map.pixels) {
        if (pixel.state != PixelState::defined) continue;
        found.low = std::min(found.low, pixel.value);
        found.high = std::max(found.high, pixel.value);
    }
    return found;
}

/// `kind` is how the scale is to be read.
ColorScale color_scale(Quantity quantity, bool is_difference, MapStyle style, ScaleKind kind) {
    if (kind == ScaleKind::gray || (style == MapStyle::paper && kind == ScaleKind::sequential)) return ColorScale::gray;
    const QuantityInfo& about = info(quantity);
    if (style == MapStyle::wilkie && !is_difference && kind == about.kind && about.wilkie) return *about.wilkie;
    if (kind == ScaleKind::cyclic) return ColorScale::cyclic;
    return kind == ScaleKind::diverging ? ColorScale::diverging : ColorScale::sequential;
}

MapRange range_for(Quantity quantity, bool is_difference, const MapOptions& options, double low, double high) {
    if (options.range) return *options.range;
    const QuantityInfo& about = info(quantity);
    if (about.kind == ScaleKind::cyclic || about.of_two) return {about.low, about.high};
    if (is_difference) {
        const double largest = std::max(std::abs(low), std::abs(high));
        const double reach = largest > 0.0 ? largest : 1.0;
        return {-reach, reach};
    }
    if (about.kind == ScaleKind::gray) return {0.0, std::exp2(-options.exposure)};
    if (!std::isnan(about.high)) return {about.low, about.high};
    return {about.low, high > about.low ? high : 1.0};
}

}  // namespace

ScaleKind kind_of(Quantity quantity, bool is_difference, const MapRange& range) {
    const QuantityInfo& about = info(quantity);
    if (about.of_two) return about.kind;
    if (about.kind != ScaleKind::cyclic) return is_difference ? ScaleKind::diverging : about.kind;
    if (range.low == about.low && range.high == about.high) return ScaleKind::cyclic;
    return is_difference ? ScaleKind::diverging : ScaleKind::sequential;
}

MapScale map_scale(Quantity quantity, bool is_difference, const MapOptions& options, double low, double high) {
    MapScale chosen;
    chosen.range = range_for(quantity, is_difference, options, low, high);
    chosen.kind = kind_of(quantity, is_difference, chosen.range);
    chosen.scale = options.scale.value_or(color_scale(quantity, is_difference, options.style, chosen.kind));
    chosen.black_is_none = options.style == MapStyle::paper && chosen.scale == ColorScale::gray;
    return chosen;
}

double developed(double light, const MapOptions& options) {
    const double shifted = light + options.offset;
    return options.gamma == 1.0 ? shifted : std::pow(std::max(shifted, 0.0), 1.0 / options.gamma);
}

Rgb8 state_color(PixelState state, int x, int y, bool black_is_none) {
    const bool is_light_stripe = (x + y) / 2 % 4 < 2;
    switch (state) {
        case PixelState::no_light:
            return black_pixel;
        case PixelState::dark:
            return is_light_stripe ? quiet_hatch_light : quiet_hatch_dark;
        case PixelState::undefined:
            return black_is_none ? black_pixel : middle_gray;
        case PixelState::undetermined:
            return is_light_stripe ? hatch_light : hatch_dark;
        case PixelState::not_a_number:
            return magenta;
        case PixelState::unphysical:
            return dark_magenta;
        case PixelState::not_measured:
            return slate;
        case PixelState::defined:
            break;
    }
    POL_EXPECTS(false);
    return magenta;
}

Rgb8 faded(const Rgb& color, double weight) {
    const Rgb ground = decoded(middle_gray);
    Rgb mixed{};
    for (std::size_t c = 0; c < 3; ++c) mixed[c] = ground[c] + (color[c] - ground[c]) * weight;
    return encode(mixed);
}

ColoredMap colorize(const Map& map, const MapOptions& options) {
    POL_EXPECTS(map.quantity != Quantity::color);
    POL_EXPECTS(!options.range || options.range->low < options.range->high);
    const MapRange found = extremes(map);
    const MapScale chosen = map_scale(map.quantity, map.is_difference, options, found.low, found.high);
    ColoredMap colored;
    colored.quantity = map.quantity;
    colored.is_difference = map.is_difference;
    const bool is_photograph = chosen.kind == ScaleKind::gray;
    colored.style = options.style;
    colored.band = map.band;
    colored.picture.width = map.width;
    colored.picture.height = map.height;
    colored.scale = chosen.scale;
    colored.range = chosen.range;
    colored.black_is_none = chosen.black_is_none;
    colored.words = options.words;
    colored.picture.pixels.reserve(map.pixels.size());
    colored.states.reserve(map.pixels.size());

    const double span = colored.range.high - colored.range.low;
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const MapPixel& pixel = map.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
                                               static_cast<std::size_t>(x)];
            colored.states.push_back(pixel.state);
            ++colored.state_count[static_cast<std::size_t>(pixel.state)];
            if (pixel.state != PixelState::defined) {
                colored.picture.pixels.push_back(state_color(pixel.state, x, y, chosen.black_is_none));
                continue;
            }
            const double t = (pixel.value - colored.range.low) / span;
            // Rounding to the 32-bit floats of a file moves a value by 2^-23 of itself at most.
            constexpr double rounding = 0x1p-22;
            if (t < -rounding) ++colored.below;
            if (t > 1.0 + rounding) ++colored.above;
            const double weight = chosen.can_fade() ? pixel.weight : 1.0;
            const double certainty = chosen.can_fade() && options.fade_by_bar ? pixel.certainty : 1.0;
            if (weight < 1.0) colored.fades = true;
            if (certainty < 1.0) colored.fades_by_bar = true;
            const double place = is_photograph ? developed(t, options) : t;
            colored.picture.pixels.push_back(faded(scale_color(chosen.scale, place), weight * certainty));
        }
    }
    return colored;
}

ColoredMap colorize_picture(const StokesImage& image, const MapOptions& options) {
    ColoredMap colored;
    colored.quantity = Quantity::color;
    colored.style = options.style;
    colored.picture.width = image.width;
    colored.picture.height = image.height;
    const std::vector<Rgb> colors = color_picture(image);
    const double gain = std::exp2(options.exposure);
    colored.picture.pixels.reserve(colors.size());
    colored.states.reserve(colors.size());
    for (const Rgb& color : colors) {
        const bool is_number = std::isfinite(color[0]) && std::isfinite(color[1]) && std::isfinite(color[2]);
        const PixelState state = is_number ? PixelState::defined : PixelState::not_a_number;
        colored.states.push_back(state);
        ++colored.state_count[static_cast<std::size_t>(state)];
        const auto shown = [&](double light) { return developed(gain * light, options); };
        colored.picture.pixels.push_back(is_number ? encode({shown(color[0]), shown(color[1]), shown(color[2])})
                                                   : state_color(state, 0, 0));
    }
    return colored;
}

Result<ColoredMap> draw_map(const StokesImage& image, Quantity quantity, std::size_t band, const MapOptions& options) {
    if (quantity == Quantity::color) return colorize_picture(image, options);
    POL_TRY(const auto map, evaluate(image, quantity, band));
    return colorize(map, options);
}

}  // namespace pol
