// SPDX-License-Identifier: Apache-2.0
#include "maps/quantity.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "core/contract.h"
#include "core/nearest_word.h"

namespace pol {
namespace {

constexpr double from_data = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<QuantityInfo, quantity_count> table{{
    {.quantity = Quantity::color,
     .name = "color",
     .title = "Color",
     .definition = "S0 at all wavelengths as CIE 1931 color in sRGB; gray if there is one wavelength",
     .group = MapGroup::light,
     .key = {'1'},
     .kind = ScaleKind::color,
     .needs = StokesComponents::s0(),
     .has_bar = false},
    {.quantity = Quantity::intensity,
     .name = "intensity",
     .title = "Intensity",
     .definition = "S0 divided by CIE D65 at that wavelength (D65 is 1 at 560 nm)",
     .group = MapGroup::light,
     .key = {'2'},
     .unit = "\u00d7 D65",
     .kind = ScaleKind::gray,
     .needs = StokesComponents::s0(),
     .is_over_d65 = true},
    {.quantity = Quantity::dop,
     .name = "dop",
     .title = "Degree of polarization",
     .row_name = "DoP",
     .definition = "DoP = |(S1, S2, S3)| / S0: 0 unpolarized, 1 fully polarized",
     .group = MapGroup::polarization,
     .key = {'3'},
     .kind = ScaleKind::sequential,
     .wilkie = ColorScale::wilkie_degree},
    {.quantity = Quantity::dolp,
     .name = "dolp",
     .title = "Degree of linear polarization",
     .list_title = "Linear degree, DoLP",
     .row_name = "DoLP",
     .definition = "DoLP = |(S1, S2)| / S0",
     .group = MapGroup::polarization,
     .key = {'D'},
     .kind = ScaleKind::sequential,
     .wilkie = ColorScale::wilkie_degree,
     .needs = StokesComponents::linear()},
    {.quantity = Quantity::docp,
     .name = "docp",
     .title = "Degree of circular polarization",
     .list_title = "Circular degree, DoCP",
     .row_name = "DoCP",
     .definition = "DoCP = |S3| / S0",
     .group = MapGroup::polarization,
     .key = {'D', true},
     .kind = ScaleKind::sequential,
     .wilkie = ColorScale::wilkie_degree,
     .needs = StokesComponents::s0().with(3)},
    {.quantity = Quantity::ellipticity,
     .name = "ellipticity",
     .title = "Ellipticity b/a",
     .row_name = "ellipticity b/a",
     .definition = "b/a = |S3| / (|(S1, S2, S3)| + |(S1, S2)|), axes of the polarization ellipse: 0 linear, 1 circular",
     .group = MapGroup::polarization,
     .key = {'4'},
     .kind = ScaleKind::sequential,
     .wilkie = ColorScale::wilkie_type,
     .carrier = Carrier::polarized_part},
    {.quantity = Quantity::azimuth,
     .name = "azimuth",
     .title = "Azimuth",
     .row_name = "azimuth",
     .definition =
         "atan2(S2, S1) / 2: direction of the major axis, 0 to the right, counter-clockwise as the camera sees it",
     .from_source = "atan2(S2, S1) / 2: direction of the major axis, 0 to the left, clockwise as the camera sees it: "
                    "counter-clockwise for the source",
     .in_a_frame = "atan2(S2, S1) / 2: major axis of the ellipse, from x towards y",
     .group = MapGroup::polarization,
     .key = {'5'},
     .unit = "\u00b0",
     .kind = ScaleKind::cyclic,
     .low = -90.0,
     .high = 90.0,
     .wilkie = ColorScale::wilkie_orientation,
     .carrier = Carrier::linear_part,
     .needs = StokesComponents::linear(),
     .rounding_size = 90.0},
    {.quantity = Quantity::handedness,
     .name = "handedness",
     .title = "Handedness",
     .row_name = "handedness",
     .definition = "S3 / |(S1, S2, S3)|: -1 left circular, 0 linear, 1 right circular, as the receiver sees it",
     .from_source = "S3 / |(S1, S2, S3)|: -1 left circular, 0 linear, 1 right circular, as the source sees it",
     .in_a_frame = "Clockwise for who looks: right",
     .group = MapGroup::polarization,
     .key = {'6'},
     .kind = ScaleKind::diverging,
     .low = -1.0,
     .low_word = "left",
     .high_word = "right",
     .wilkie = ColorScale::wilkie_chirality,
     .carrier = Carrier::polarized_part},
    {.quantity = Quantity::s1,
     .name = "s1",
     .title = "S1 / S0",
     .definition = "S1 / S0: 1 horizontal, -1 vertical",
     .group = MapGroup::stokes,
     .key = {'7'},
     .kind = ScaleKind::diverging,
     .low = -1.0,
     .wilkie = ColorScale::wilkie_s1,
     .needs = StokesComponents::s0().with(1)},
    {.quantity = Quantity::s2,
     .name = "s2",
     .title = "S2 / S0",
     .definition = "S2 / S0: 1 along +45 degrees, -1 along -45 degrees",
     .from_source = "S2 / S0: 1 along +45 degrees, -1 along -45 degrees, as the source sees it",
     .group = MapGroup::stokes,
     .key = {'8'},
     .kind = ScaleKind::diverging,
     .low = -1.0,
     .wilkie = ColorScale::wilkie_s2,
     .needs = StokesComponents::s0().with(2)},
    {.quantity = Quantity::s3,
     .name = "s3",
     .title = "S3 / S0",
     .definition = "S3 / S0: 1 right circular, -1 left circular",
     .from_source = "S3 / S0: 1 right circular, -1 left circular, as the source sees it",
     .group = MapGroup::stokes,
     .key = {'9'},
     .kind = ScaleKind::diverging,
     .low = -1.0,
     .low_word = "left",
     .high_word = "right",
     .wilkie = ColorScale::wilkie_chirality,
     .needs = StokesComponents::s0().with(3)},
    {.quantity = Quantity::residual,
     .name = "residual",
     .title = "Residual",
     .definition = "share of the pixel's throughput that was not traced",
     .group = MapGroup::trust,
     .key = {'0'},
     .kind = ScaleKind::sequential,
     .high = from_data,
     .needs = StokesComponents(),
     .has_bar = false,
     .rounding_size = 0.0},
    {.quantity = Quantity::dop_error,
     .name = "dop_error",
     .title = "Error bar of degree of polarization",
     .list_title = "Error bar of DoP",
     .definition = "largest distance of the true DoP from the one shown; a rigorous bound from residual and tail",
     .group = MapGroup::trust,
     .key = {'3', true},
     .kind = ScaleKind::sequential,
     .high = from_data,
     .has_bar = false},
    {.quantity = Quantity::ellipticity_error,
     .name = "ellipticity_error",
     .title = "Error bar of ellipticity b/a",
     .list_title = "Error bar of b/a",
     .definition = "largest distance of the true b/a from the one shown; a rigorous bound from residual and tail",
     .group = MapGroup::trust,
     .key = {'4', true},
     .kind = ScaleKind::sequential,
     .high = from_data,
     .carrier = Carrier::polarized_part,
     .has_bar = false},
    {.quantity = Quantity::azimuth_error,
     .name = "azimuth_error",
     .title = "Error bar of azimuth",
     .definition = "largest distance of the true azimuth from the one shown, a rigorous bound from residual and tail; "
                   "90 degrees: it may be anything",
     .group = MapGroup::trust,
     .key = {'5', true},
     .unit = "\u00b0",
     .kind = ScaleKind::sequential,
     .high = from_data,
     .carrier = Carrier::linear_part,
     .needs = StokesComponents::linear(),
     .has_bar = false,
     .rounding_size = 90.0},
    {.quantity = Quantity::unphysical,
     .name = "unphysical",
     .title = "Unphysical part",
     .definition = "(|(S1, S2, S3)| - S0) / (|(S1, S2, S3)| + |S0|) where that exceeds rounding of the numbers, else "
                   "0; empty if the renderer is right",
     .group = MapGroup::trust,
     .key = {'U'},
     .kind = ScaleKind::sequential,
     .high = from_data,
     .needs = StokesComponents::s0(),
     .has_bar = false,
     .rounding_size = 0.0},
    {.quantity = Quantity::samples,
     .name = "samples",
     .title = "Samples per pixel",
     .definition = "camera samples of the pixel: where a render that stops at an error has spent them",
     .group = MapGroup::trust,
     .key = {'N', true},
     .kind = ScaleKind::sequential,
     .high = from_data,
     .needs = StokesComponents(),
     .has_bar = false,
     .rounding_size = 0.0},
    {.quantity = Quantity::poincare,
     .name = "poincare",
     .title = "Poincar\u00e9 distance",
     .definition =
         "half the angle between the two states on the Poincar\u00e9 sphere: the angle between the lines of two "
         "linear states, 90 degrees for opposite ones; azimuth and ellipticity in one number",
     .group = MapGroup::pair,
     .unit = "\u00b0",
     .kind = ScaleKind::sequential,
     .high = 90.0,
     .carrier = Carrier::polarized_part,
     .has_bar = false,
     .of_two = true,
     .rounding_size = 90.0},
}};
/// Of two pictures are the last ones.
constexpr std::size_t of_one = static_cast<std::size_t>(Quantity::poincare);

constexpr bool rows_follow_the_enumeration() {
    for (std::size_t i = 0; i < table.size(); ++i)
        if (table[i].quantity != static_cast<Quantity>(i)) return false;
    return true;
}
static_assert(rows_follow_the_enumeration());

}  // namespace

std::span<const QuantityInfo> quantities() {
    return std::span(table).first(of_one);
}

std::span<const QuantityInfo> pair_quantities() {
    return std::span(table).subspan(of_one);
}

const QuantityInfo& info(Quantity quantity) {
    POL_EXPECTS(static_cast<std::size_t>(quantity) < quantity_count);
    return table[static_cast<std::size_t>(quantity)];
}

std::optional<Quantity> quantity_named(std::string_view name) {
    for (const QuantityInfo& entry : quantities()) {
        if (entry.name == name) return entry.quantity;
    }
    return std::nullopt;
}

Quantity nearest_quantity(std::string_view name) {
    const auto all = quantities();
    return std::min_element(all.begin(), all.end(),
                            [name](const QuantityInfo& a, const QuantityInfo& b) {
                                return edit_distance(name, a.name) < edit_distance(name, b.name);
                            })
        ->quantity;
}

}  // namespace pol
