// SPDX-License-Identifier: Apache-2.0
#include "maps/difference.h"

#include <algorithm>
#include <cmath>

#include "core/contract.h"
#include "core/units.h"
#include "polarization/measures.h"

namespace pol {

MapPixel difference(Quantity quantity, const MapPixel& a, const MapPixel& b) {
    POL_EXPECTS(quantity != Quantity::color);
    const auto either = [&](PixelState state) { return a.state == state || b.state == state; };
    for (const PixelState state : {PixelState::not_measured, PixelState::not_a_number, PixelState::unphysical,
                                   PixelState::undetermined, PixelState::dark})
        if (either(state)) return {0.0, 0.0, state};
    if (a.state != PixelState::defined || b.state != PixelState::defined)
        return {0.0, 0.0, a.state == b.state ? a.state : PixelState::undefined};
    const QuantityInfo& about = info(quantity);
    double by = a.value - b.value;
    if (about.kind == ScaleKind::cyclic) by = std::remainder(by, about.high - about.low);
    const double range = std::isfinite(about.high) ? about.high - about.low : 0.0;
    if (std::abs(by) <= pixel_noise * std::max({std::abs(a.value), std::abs(b.value), range})) by = 0.0;
    // The bar of a difference is as wide as both bars together.
    return {by, std::min(a.weight, b.weight), PixelState::defined, std::max(0.0, a.certainty + b.certainty - 1.0)};
}

MapPixel poincare_distance(const PixelLight& a, const PixelLight& b) {
    constexpr Quantity any_of_the_state = Quantity::ellipticity;
    const MapPixel both = difference(any_of_the_state, evaluate_light(a, any_of_the_state, 1.0),
                                     evaluate_light(b, any_of_the_state, 1.0));
    if (both.state != PixelState::defined) return both;
    const double apart = degrees(half_poincare_angle(a.stokes, b.stokes));
    const double noise = pixel_noise * info(Quantity::poincare).rounding_size;
    return {apart <= noise ? 0.0 : apart, both.weight, PixelState::defined, both.certainty};
}

}  // namespace pol
