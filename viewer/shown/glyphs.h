// SPDX-License-Identifier: Apache-2.0
// Polarization ellipses over the picture: which ones, and their shape. Drawing them is panels/glyph_overlay.h.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/vec.h"
#include "film/film.h"
#include "viewer/shown/shown_picture.h"
#include "viewer/shown/view_settings.h"

namespace pol {

/// The state of the mean light of one cell.
struct Glyph {
    DVec2 center{0.0, 0.0};  ///< picture coordinates
    double intensity = 0.0;  ///< S0 of the cell, relative to the brightest glyph
    double dop = 0.0;
    double azimuth = 0.0;         ///< radians from the right, counter-clockwise on the picture
    double ellipticity = 0.0;     ///< b/a, positive if the field turns clockwise on the picture
    double azimuth_weight = 0.0;  ///< as MapPixel::weight; 0: there is no azimuth
    double weight = 1.0;          ///< of the polarization: 1 fully meant
    bool has_ellipticity =
        true;  ///< false: S3 was not measured, only the azimuth is known; `dop` is that of linear light
};

/// Side of the cell of one glyph, whole pixels. `scale`: points per pixel.
int glyph_cell(const GlyphSettings& settings, double scale);

/// `shown` in the engine's own convention: a glyph is drawn on the picture, which the receiver sees. One glyph per cell
/// that touches `seen` and whose mean light has a polarization that stands above what was not traced and above
/// rounding; cells are counted from the picture's corner, so glyphs go with the picture when it is panned.
std::vector<Glyph> glyphs_of(const ShownPicture& shown, std::size_t band, int cell, const TileRect& seen);

/// What the colors of the ellipses say: blue for what this convention calls right-handed, yellow left-handed, as Wilkie
/// & Weidlich have chirality.
std::string glyph_key(const Convention& convention);
/// Requires: the light is not linear.
bool is_right_handed(const Glyph& glyph, const Convention& convention);

/// Half the major axis in points.
double glyph_radius(const Glyph& glyph, const GlyphSettings& settings);

/// Tip of the field at `phase` (radians, growing with time) relative to the center, y down as on screen, for a major
/// half axis of 1: right-handed light turns clockwise for the receiver, who is the viewer.
DVec2 field_tip(const Glyph& glyph, double phase);

}  // namespace pol
