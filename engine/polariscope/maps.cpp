// SPDX-License-Identifier: Apache-2.0
#include "polariscope/maps.h"

#include <cmath>
#include <cstddef>
#include <limits>

#include "io/pictures/png_file.h"
#include "maps/colorize.h"
#include "maps/evaluate.h"
#include "polariscope/inside.h"
#include "report/map_picture.h"

namespace polariscope {

using detail::guarded;
using detail::inner;
using detail::usage;

namespace {

MapInfo outer_info(const pol::QuantityInfo& q) {
    return {std::string(q.name), std::string(q.title), std::string(q.unit), q.low, q.high, std::string(q.definition)};
}

Result<pol::Quantity> quantity(const std::string& name) {
    if (const auto found = pol::quantity_named(name)) return *found;
    return usage("map", "there is no map called '" + name + "'",
                 "did you mean '" + std::string(pol::info(pol::nearest_quantity(name)).name) + "'?");
}

Result<std::size_t> index_of(const pol::StokesImage& image, int wavelength) {
    if (wavelength >= 0 && static_cast<std::size_t>(wavelength) < image.bands.size())
        return static_cast<std::size_t>(wavelength);
    return usage("wavelength", "there is no wavelength " + std::to_string(wavelength),
                 "0 to " + std::to_string(image.bands.size() - 1));
}

PixelState outer_state(pol::PixelState state) {
    switch (state) {
        case pol::PixelState::defined:
            return PixelState::defined;
        case pol::PixelState::no_light:
            return PixelState::no_light;
        case pol::PixelState::dark:
            return PixelState::dark;
        case pol::PixelState::undefined:
            return PixelState::undefined;
        case pol::PixelState::undetermined:
            return PixelState::undetermined;
        case pol::PixelState::not_a_number:
            return PixelState::not_a_number;
        case pol::PixelState::not_measured:
            return PixelState::not_measured;
        case pol::PixelState::unphysical:
            break;
    }
    return PixelState::unphysical;
}

pol::MapStyle inner_style(MapStyle style) {
    return style == MapStyle::paper    ? pol::MapStyle::paper
           : style == MapStyle::wilkie ? pol::MapStyle::wilkie
                                       : pol::MapStyle::scientific;
}

}  // namespace

std::vector<MapInfo> maps() {
    std::vector<MapInfo> all;
    for (const pol::QuantityInfo& q : pol::quantities()) all.push_back(outer_info(q));
    return all;
}

Result<Map> evaluate(const Picture& picture, const std::string& map, int wavelength) {
    return guarded([&]() -> Result<Map> {
        const auto asked = quantity(map);
        if (!asked) return asked.error();
        if (asked.value() == pol::Quantity::color)
            return usage("map", "'color' is no number", "draw() gives the picture");
        const auto index = index_of(inner(picture), wavelength);
        if (!index) return index.error();
        const auto evaluated = pol::evaluate(inner(picture), asked.value(), index.value());
        if (!evaluated) return detail::outer(evaluated.error());
        const pol::Map& from = evaluated.value();
        Map out{outer_info(pol::info(from.quantity)),
                from.band.wavelength_nm.value_or(std::numeric_limits<double>::quiet_NaN()),
                from.width,
                from.height,
                {},
                {}};
        out.values.reserve(from.pixels.size());
        out.states.reserve(from.pixels.size());
        for (const pol::MapPixel& pixel : from.pixels) {
            const bool defined = pixel.state == pol::PixelState::defined;
            out.values.push_back(defined ? pixel.value : std::numeric_limits<double>::quiet_NaN());
            out.states.push_back(outer_state(pixel.state));
        }
        return out;
    });
}

Result<RgbPicture> draw(const Picture& picture, const std::string& map, int wavelength, const DrawOptions& options) {
    return guarded([&]() -> Result<RgbPicture> {
        const auto asked = quantity(map);
        if (!asked) return asked.error();
        const auto index = index_of(inner(picture), wavelength);
        if (!index) return index.error();
        pol::MapOptions how;
        how.style = inner_style(options.style);
        how.exposure = options.exposure;
        if (options.low || options.high) {
            const bool sound = options.low && options.high && *options.low < *options.high &&
                               std::isfinite(*options.high - *options.low);
            if (!sound) return usage("options.low, options.high", "are no scale", "two numbers, low < high");
            how.range = pol::MapRange{*options.low, *options.high};
        }
        if (!std::isfinite(options.exposure)) return usage("options.exposure", "is not finite", "stops, 0 for none");
        const auto drawn = pol::draw_map(inner(picture), asked.value(), index.value(), how);
        if (!drawn) return detail::outer(drawn.error());
        pol::RgbPicture pixels = drawn.value().picture;
        if (options.legend) {
            auto with_legend = pol::map_picture(drawn.value(), options.caption);
            if (!with_legend) return detail::outer(with_legend.error());
            pixels = std::move(with_legend).value();
        }
        RgbPicture out{pixels.width, pixels.height, {}};
        out.rgb.reserve(3 * pixels.pixels.size());
        for (const pol::Rgb8& pixel : pixels.pixels) out.rgb.insert(out.rgb.end(), pixel.begin(), pixel.end());
        return out;
    });
}

Result<Done> write_png(const RgbPicture& picture, const std::filesystem::path& file) {
    return guarded([&]() -> Result<Done> {
        if (picture.width < 1 || picture.height < 1 ||
            picture.rgb.size() !=
                std::size_t{3} * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height))
            return usage("picture", "its sizes do not fit", "three bytes for each of width x height pixels");
        pol::RgbPicture pixels{picture.width, picture.height, {}};
        pixels.pixels.resize(picture.rgb.size() / 3);
        for (std::size_t i = 0; i < picture.rgb.size(); ++i) pixels.pixels[i / 3][i % 3] = picture.rgb[i];
        const auto written = pol::write_png(pixels, file);
        if (!written) return detail::outer(written.error());
        return Done{};
    });
}

}  // namespace polariscope
