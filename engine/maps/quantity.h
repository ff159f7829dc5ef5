// SPDX-License-Identifier: Apache-2.0
// The maps that a Stokes picture can be seen as. One table feeds the command line, the picture titles and the window.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace pol {

enum class Quantity : std::uint8_t {
    color,
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
};

/// What kind of color scale does a quantity justice.
enum class ScaleKind : std::uint8_t {
    color,       ///< shown as it looks, no scale
    gray,        ///< a photograph: brightness for brightness
    sequential,  ///< from none to much
    diverging,   ///< signed, zero in the middle
    cyclic,      ///< both ends are the same thing
};

struct QuantityInfo {
    Quantity quantity;
    std::string_view name;   ///< as typed on the command line
    std::string_view title;  ///< as printed over a picture
    std::string_view unit;   ///< empty: a pure number
    ScaleKind kind;
    double low;
    double high;  ///< NaN: up to the largest value of the picture
    std::string_view definition;
};

/// All quantities, in the order of the enumeration.
std::span<const QuantityInfo> quantities();

const QuantityInfo& info(Quantity quantity);

std::optional<Quantity> quantity_named(std::string_view name);

/// The quantity whose name takes the fewest edits to get from `name` (Levenshtein); the first one if several do.
Quantity nearest_quantity(std::string_view name);

}  // namespace pol
