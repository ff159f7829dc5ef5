// SPDX-License-Identifier: Apache-2.0
#include "viewer/shown/glyphs.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "maps/evaluate.h"
#include "polarization/measures.h"

namespace pol {

namespace {

/// Below this weight a glyph would be noise with a direction.
constexpr double least_weight = 0.2;
/// Part of the spacing that the longest glyph takes on each side of its center.
constexpr double fill = 0.46;

}  // namespace

int glyph_cell(const GlyphSettings& settings, double scale) {
    return std::max(1, static_cast<int>(std::lround(settings.spacing / scale)));
}

std::vector<Glyph> glyphs_of(const ShownPicture& shown, std::size_t band, int cell, const TileRect& seen) {
    const StokesImage& picture = shown.picture();
    std::vector<Glyph> glyphs;
    double brightest = 0.0;
    for (int y = seen.y0 / cell * cell; y < seen.y1; y += cell) {
        for (int x = seen.x0 / cell * cell; x < seen.x1; x += cell) {
            const TileRect rect{x, y, std::min(x + cell, picture.width), std::min(y + cell, picture.height)};
            const PixelLight light = shown.mean_light(band, rect);
            const auto value = [&](Quantity quantity) { return evaluate_light(light, quantity, 1.0); };
            const bool is_linear = !light.known.has(3);
            const MapPixel shape = value(is_linear ? Quantity::azimuth : Quantity::handedness);
            const MapPixel dop = value(is_linear ? Quantity::dolp : Quantity::dop);
            if (shape.state != PixelState::defined || dop.state != PixelState::defined) continue;
            if (shape.weight < least_weight) continue;
            const MapPixel azimuth = value(Quantity::azimuth);
            Glyph glyph;
            glyph.center = {0.5 * (rect.x0 + rect.x1), 0.5 * (rect.y0 + rect.y1)};
            glyph.intensity = light.stokes.s0;
            glyph.dop = dop.value;
            if (azimuth.state == PixelState::defined) {
                glyph.azimuth = radians(azimuth.value);
                glyph.azimuth_weight = azimuth.weight;
            }
            glyph.has_ellipticity = !is_linear;
            if (!is_linear) glyph.ellipticity = std::tan(0.5 * std::asin(std::clamp(shape.value, -1.0, 1.0)));
            glyph.weight = shape.weight;
            brightest = std::max(brightest, glyph.intensity);
            glyphs.push_back(glyph);
        }
    }
    for (Glyph& glyph : glyphs) glyph.intensity /= brightest;
    return glyphs;
}

std::string glyph_key(const Convention& convention) {
    const bool mirrored = convention.viewpoint == Viewpoint::source;
    return std::string("Blue: right-handed, turns ") +
           (mirrored ? "counter-clockwise here, clockwise for the source" : "clockwise") +
           "; yellow: left-handed; white: linear.";
}

bool is_right_handed(const Glyph& glyph, const Convention& convention) {
    return (glyph.ellipticity > 0.0) == (convention.viewpoint == Viewpoint::receiver);
}

double glyph_radius(const Glyph& glyph, const GlyphSettings& settings) {
    const double longest = fill * settings.spacing;
    switch (settings.length) {
        case GlyphLength::equal:
            return longest;
        case GlyphLength::by_dop:
            return longest * std::min(1.0, glyph.dop);
        case GlyphLength::by_intensity:
            return longest * glyph.intensity;
    }
    return longest;
}

DVec2 field_tip(const Glyph& glyph, double phase) {
    const double chi = std::atan(glyph.ellipticity);
    const DVec2 tip = field_tip(glyph.azimuth, chi, phase) / std::cos(chi);
    return {tip.x, -tip.y};
}

}  // namespace pol
