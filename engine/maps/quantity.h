// SPDX-License-Identifier: Apache-2.0
// The maps that a Stokes picture can be seen as: one table. A map is a row of it, its formula in evaluate.cpp and the
// same formula in shaders/evaluate.glsl; everything else (command line, keys, menus, help, titles, lists, pages, color
// scales) reads the row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "film/band.h"
#include "maps/color_scale.h"

namespace pol {

enum class Quantity : std::uint8_t {
    color,  ///< the picture itself: the only one that is not a number per pixel and wavelength
    intensity,
    dop,
    dolp,
    docp,
    ellipticity,
    azimuth,
    handedness,
    s1,
    s2,
    s3,
    residual,
    dop_error,
    ellipticity_error,
    azimuth_error,
    unphysical,
    samples,
    poincare,  ///< of two pictures, as the next ones would be
};
inline constexpr std::size_t quantity_count = static_cast<std::size_t>(Quantity::poincare) + 1;

/// What kind of color scale does a quantity justice.
enum class ScaleKind : std::uint8_t {
    color,       ///< shown as it looks, no scale
    gray,        ///< a photograph: brightness for brightness
    sequential,  ///< from none to much
    diverging,   ///< signed, zero in the middle
    cyclic,      ///< both ends are the same thing
};

/// What stands together in lists of maps.
enum class MapGroup : std::uint8_t {
    light,         ///< how much, and of which color
    polarization,  ///< measures of its state: rows of the window's page of a pixel, too
    stokes,        ///< components
    trust,         ///< how well all that is known
    pair,          ///< how far two pictures are apart
};

/// The part of the light that has the property. Where it is missing the map is undefined.
enum class Carrier : std::uint8_t { light, polarized_part, linear_part };

/// A key of the window.
struct MapKey {
    char letter = '\0';  ///< upper case, or a digit; 0: none
    bool shift = false;
    friend bool operator==(const MapKey&, const MapKey&) = default;
};

struct QuantityInfo {
    Quantity quantity{};
    std::string_view name;           ///< as typed on the command line
    std::string_view title;          ///< as printed over a picture, in menus and in the help
    std::string_view list_title{};   ///< for a narrow list; empty: as `title`
    std::string_view row_name{};     ///< on the page of a pixel; group `polarization` only
    std::string_view definition;     ///< in the engine's convention (CONVENTIONS.md), in the camera's frame
    std::string_view from_source{};  ///< as the source of the light sees it; empty: the same
    std::string_view in_a_frame{};   ///< in any frame of axes x and y, and any convention; empty: the same
    MapGroup group{};
    MapKey key{};
    std::string_view unit{};  ///< empty: a pure number
    ScaleKind kind{};
    double low = 0.0;
    double high = 1.0;                   ///< NaN: up to the largest value of the picture
    std::string_view low_word{};         ///< what is below 0, "left"; empty: nothing with a name
    std::string_view high_word{};        ///< what is above 0
    std::optional<ColorScale> wilkie{};  ///< in the style of Wilkie & Weidlich 2010; none: as in the scientific one
    Carrier carrier = Carrier::light;
    /// Components without which it is not known.
    StokesComponents needs = StokesComponents::all();
    bool has_bar = true;         ///< false: exact, or a bound itself
    bool is_over_d65 = false;    ///< an amount of light, in units of CIE D65 at the wavelength (unit_of)
    bool of_two = false;         ///< how far two pictures are apart; of a single one it is undefined
    double rounding_size = 1.0;  ///< beside what a value can be nothing but rounding; 0: every digit counts

    /// A bound, or how much was not traced: of a picture that does not tell, nobody knows.
    [[nodiscard]] constexpr bool is_of_bounds() const {
        return group == MapGroup::trust && quantity != Quantity::unphysical && quantity != Quantity::samples;
    }
    /// Fades as the part of the light that has the property vanishes.
    [[nodiscard]] constexpr bool fades() const { return carrier != Carrier::light && has_bar; }
    [[nodiscard]] constexpr std::string_view title_in_list() const { return list_title.empty() ? title : list_title; }
};

/// All quantities of one picture, in the order of the enumeration; those of a group follow each other.
std::span<const QuantityInfo> quantities();
/// Those that need two (difference.h).
std::span<const QuantityInfo> pair_quantities();

const QuantityInfo& info(Quantity quantity);

/// One of quantities().
std::optional<Quantity> quantity_named(std::string_view name);

/// The quantity whose name takes the fewest edits to get from `name` (Levenshtein); the first one if several do.
Quantity nearest_quantity(std::string_view name);

}  // namespace pol
