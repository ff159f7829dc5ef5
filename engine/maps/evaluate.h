// SPDX-License-Identifier: Apache-2.0
// A map: one number per pixel, and whether that number means anything.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "film/stokes_image.h"
#include "maps/pixel_light.h"
#include "maps/quantity.h"
#include "polarization/bounds.h"
#include "polarization/measures.h"

namespace pol {

/// Why a pixel of a map can be empty.
enum class PixelState : std::uint8_t {
    defined,
    no_light,      ///< S0, what was left out included, is nothing but rounding: black
    dark,          ///< as `undetermined`, where S0 surely is below dark_share of that of the brightest pixel
    undefined,     ///< light, but without the property: azimuth of unpolarized or circular light
    undetermined,  ///< so much light was left out that the value may lie anywhere in half of its range or more
    not_a_number,  ///< NaN or infinite: a defect of the renderer
    unphysical,    ///< numbers that no light has: S0 < 0, S0 = 0 beside a polarized part, or a residual below 0
    not_measured,  ///< a Stokes component that it needs was never measured: nobody knows
};
inline constexpr std::size_t pixel_state_count = 8;

struct MapPixel {
    double value = 0.0;  ///< in the unit of QuantityInfo; meaningless unless the state is `defined`
    /// 1: fully meant; towards 0 for a property of the polarized part as that part vanishes. For fading only.
    double weight = 1.0;
    PixelState state = PixelState::defined;
    /// 1: the error bar has no width; falls linearly with it, to 0 where the bar covers half of the range and nothing
    /// is determined any more. 1 for what has no bar or no range. For fading only.
    double certainty = 1.0;
};

/// Row 0 is the top row, as in StokesImage.
struct Map {
    Quantity quantity{};
    Band band;
    bool is_difference = false;  ///< values minus those of a reference (difference.h): signed, whatever the quantity
    int width = 0;
    int height = 0;
    std::vector<MapPixel> pixels;
};

/// Degree of polarization (for the azimuth: of linear polarization) from which azimuth, ellipticity and handedness
/// are shown at full weight. Below it the weight falls linearly to 0.
inline constexpr double full_weight_polarization = weak_polarization;

/// Where S0, what was left out included, is below this part of what the picture's brightest pixel surely has, a value
/// that is not determined is missing because it is dark.
inline constexpr double dark_share = 1e-3;

/// Part of S0 up to which a component of a pixel is rounding noise: the pixel is the sum of up to a thousand leaves and
/// samples that weigh anything (PHYSICS.md 1).
inline constexpr double pixel_noise = noise_threshold(1000.0);

/// How far light is from being some, 0 if it is; NaN unless finite. A picture file rounds S0 and the polarized part by
/// at most PixelLight::rounding each, which changes the quotient by at most as much, and whole numbers are off by at
/// most half of PixelLight::step each, which adds up to less than two of them: less than both is 0.
double unphysical_part(const PixelLight& light);

/// What amounts of light are divided by: CIE D65 at the band's wavelength, 1 if it has none. Error (kind input): D65 is
/// not known there.
Result<double> white_of(const Band& band);
/// QuantityInfo::unit, but for amounts of a band without a wavelength, which are as the file has them.
std::string_view unit_of(Quantity quantity, const Band& band);

/// The value of `quantity` of some light. `d65` is white_of its band, used where QuantityInfo::is_over_d65.
/// Requires: quantity is not `color` (see color_picture.h).
MapPixel evaluate_light(const PixelLight& light, Quantity quantity, double d65);
MapPixel evaluate_pixel(const StokesImage& image, Quantity quantity, std::size_t band, std::size_t pixel, double d65);

/// The bar of one quantity, in its unit. Empty: the bar is not a number, there is no S0 to divide by, or the quantity
/// has no bar (QuantityInfo::has_bar). The bar of the azimuth may reach beyond +-90 degrees: it is one of directions.
/// `d65` as in evaluate_light. Requires: quantity is not `color`.
std::optional<Interval<double>> error_bar(const PixelLight& light, Quantity quantity, double d65);

/// The whole map; the brightest pixel is looked for if the picture does not tell. Error (kind input): an amount over
/// D65 at a wavelength where that is not known. Requires: quantity is not `color`, band < image.bands.size().
Result<Map> evaluate(const StokesImage& image, Quantity quantity, std::size_t band);

}  // namespace pol
