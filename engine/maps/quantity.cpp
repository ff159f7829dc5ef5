// SPDX-License-Identifier: Apache-2.0
#include "maps/quantity.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/contract.h"
#include "core/nearest_word.h"

namespace pol {
namespace {

constexpr double from_data = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<QuantityInfo, 16> table{{
    {Quantity::color, "color", "Color", "", ScaleKind::color, 0.0, 1.0,
     "S0 at all wavelengths as CIE 1931 color in sRGB; gray if there is one wavelength"},
    {Quantity::intensity, "intensity", "Intensity", "\u00d7 D65", ScaleKind::gray, 0.0, 1.0,
     "S0 divided by CIE D65 at that wavelength (D65 is 1 at 560 nm)"},
    {Quantity::dop, "dop", "Degree of polarization", "", ScaleKind::sequential, 0.0, 1.0,
     "P = |(S1, S2, S3)| / S0: 0 unpolarized, 1 fully polarized"},
    {Quantity::dolp, "dolp", "Degree of linear polarization", "", ScaleKind::sequential, 0.0, 1.0, "|(S1, S2)| / S0"},
    {Quantity::docp, "docp", "Degree of circular polarization", "", ScaleKind::sequential, 0.0, 1.0, "|S3| / S0"},
    {Quantity::ellipticity, "ellipticity", "Ellipticity b/a", "", ScaleKind::sequential, 0.0, 1.0,
     "b/a = |S3| / (|(S1, S2, S3)| + |(S1, S2)|), axes of the polarization ellipse: 0 linear, 1 circular"},
    {Quantity::azimuth, "azimuth", "Azimuth", "\u00b0", ScaleKind::cyclic, -90.0, 90.0,
     "atan2(S2, S1) / 2: direction of the major axis, 0 to the right, counter-clockwise as the camera sees it"},
    {Quantity::handedness, "handedness", "Handedness", "", ScaleKind::diverging, -1.0, 1.0,
     "S3 / |(S1, S2, S3)|: -1 left circular, 0 linear, 1 right circular, as the receiver sees it"},
    {Quantity::s1, "s1", "S1 / S0", "", ScaleKind::diverging, -1.0, 1.0, "S1 / S0: 1 horizontal, -1 vertical"},
    {Quantity::s2, "s2", "S2 / S0", "", ScaleKind::diverging, -1.0, 1.0,
     "S2 / S0: 1 along +45 degrees, -1 along -45 degrees"},
    {Quantity::s3, "s3", "S3 / S0", "", ScaleKind::diverging, -1.0, 1.0, "S3 / S0: 1 right circular, -1 left circular"},
    {Quantity::residual, "residual", "Residual", "", ScaleKind::sequential, 0.0, from_data,
     "share of the pixel's throughput that was not traced"},
    {Quantity::dop_error, "dop_error", "Error bar of degree of polarization", "", ScaleKind::sequential, 0.0, from_data,
     "largest distance of the true degree of polarization from the one shown; a rigorous bound from residual and tail"},
    {Quantity::ellipticity_error, "ellipticity_error", "Error bar of ellipticity b/a", "", ScaleKind::sequential, 0.0,
     from_data, "the same for b/a"},
    {Quantity::azimuth_error, "azimuth_error", "Error bar of azimuth", "\u00b0", ScaleKind::sequential, 0.0, from_data,
     "the same for the azimuth; 90 degrees: it may be anything"},
    {Quantity::unphysical, "unphysical", "Unphysical part", "", ScaleKind::sequential, 0.0, from_data,
     "(|(S1, S2, S3)| - S0) / (|(S1, S2, S3)| + |S0|) where that exceeds rounding of the numbers, else 0; "
     "empty if the renderer is right"},
}};

}  // namespace

std::span<const QuantityInfo> quantities() {
    return table;
}

const QuantityInfo& info(Quantity quantity) {
    const QuantityInfo& entry = table[static_cast<std::size_t>(quantity)];
    POL_EXPECTS(entry.quantity == quantity);
    return entry;
}

std::optional<Quantity> quantity_named(std::string_view name) {
    for (const QuantityInfo& entry : table) {
        if (entry.name == name) return entry.quantity;
    }
    return std::nullopt;
}

Quantity nearest_quantity(std::string_view name) {
    return std::min_element(table.begin(), table.end(),
                            [name](const QuantityInfo& a, const QuantityInfo& b) {
                                return edit_distance(name, a.name) < edit_distance(name, b.name);
                            })
        ->quantity;
}

}  // namespace pol
