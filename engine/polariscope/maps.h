// SPDX-License-Identifier: Apache-2.0
// Pictures as maps of one number per pixel: degree of polarization, azimuth, ellipticity ...
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "polariscope/picture.h"
#include "polariscope/result.h"

namespace polariscope {

struct MapInfo {
    std::string name;   ///< by which it is asked for: "dop"
    std::string title;  ///< "Degree of polarization"
    std::string unit;   ///< empty: a pure number
    double low = 0.0;
    double high = 0.0;       ///< NaN: as far as the picture goes
    std::string definition;  ///< the formula
};

/// All of them. "color" is a picture of all wavelengths, not a number: for draw() only.
std::vector<MapInfo> maps();

/// Why a pixel of a map can be empty.
enum class PixelState : std::uint8_t {
    defined,
    no_light,      ///< nothing but rounding, what was left out included
    dark,          ///< as `undetermined`, where S0 surely is below a thousandth of that of the brightest pixel
    undefined,     ///< light, but without the property: azimuth of unpolarized or circular light
    undetermined,  ///< so much light was left out that the value may lie anywhere in half of its range or more
    not_a_number,  ///< NaN or infinite numbers in the picture
    unphysical,    ///< numbers that no light has: S0 < 0, or less than its polarized part
    not_measured,  ///< a component that it needs was never measured: S3 of a camera with linear polarizers
};

/// Row 0 is the top row: pixel (x, y) is entry y * width + x.
struct Map {
    MapInfo info;
    double wavelength_nm = 0.0;  ///< NaN: the band has none
    int width = 0;
    int height = 0;
    std::vector<double> values;  ///< in the unit of `info`; NaN unless the state is `defined`
    std::vector<PixelState> states;
};

/// Error (usage): no map of that name, or "color"; no such wavelength. Error (input): "intensity" outside of the
/// wavelengths where CIE D65 is known (300 to 830 nm).
Result<Map> evaluate(const Picture& picture, const std::string& map, int wavelength = 0);

/// 8-bit sRGB, three bytes a pixel, row 0 at the top.
struct RgbPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

enum class MapStyle {
    scientific,  ///< scales that can be read without color vision
    paper,       ///< value times D65 (Debelov & Kozlov, section 4)
    wilkie,      ///< Wilkie & Weidlich, "A standardised polarisation visualisation for images", 2010
};

struct DrawOptions {
    MapStyle style = MapStyle::scientific;
    std::optional<double> low;  ///< ends of the scale, both or none: those of MapInfo
    std::optional<double> high;
    double exposure = 0.0;  ///< stops; color and intensity only
    bool legend = true;     ///< title, color bar, and what empty pixels mean; small pictures are enlarged
    std::string caption;    ///< second line of the legend
};

/// Errors as evaluate(), and (usage) for a scale without extent.
Result<RgbPicture> draw(const Picture& picture, const std::string& map, int wavelength = 0,
                        const DrawOptions& options = {});

/// Error (output): it cannot be written; (usage): its sizes do not fit.
Result<Done> write_png(const RgbPicture& picture, const std::filesystem::path& file);

}  // namespace polariscope
