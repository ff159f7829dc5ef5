// SPDX-License-Identifier: Apache-2.0
#include "viewer/picture/shader_constants.h"

#include <string_view>

#include "maps/evaluate.h"

namespace pol {

namespace {

template <class Enumerator>
std::string number(std::string_view name, Enumerator value) {
    return "const int " + std::string(name) + " = " + std::to_string(static_cast<int>(value)) + ";\n";
}

std::string flag(std::string_view name, bool value) {
    return "const bool " + std::string(name) + " = " + (value ? "true" : "false") + ";\n";
}

}  // namespace

std::string shader_constants(Quantity quantity) {
    std::string text;
    for (const auto rows : {quantities(), pair_quantities()})
        for (const QuantityInfo& each : rows) text += number("quantity_" + std::string(each.name), each.quantity);
    text += number("state_defined", PixelState::defined);
    text += number("state_no_light", PixelState::no_light);
    text += number("state_dark", PixelState::dark);
    text += number("state_undefined", PixelState::undefined);
    text += number("state_undetermined", PixelState::undetermined);
    text += number("state_not_a_number", PixelState::not_a_number);
    text += number("state_unphysical", PixelState::unphysical);
    text += number("state_not_measured", PixelState::not_measured);
    text += number("state_count", pixel_state_count);
    text += number("carrier_light", Carrier::light);
    text += number("carrier_polarized_part", Carrier::polarized_part);
    text += number("carrier_linear_part", Carrier::linear_part);
    const QuantityInfo& about = info(quantity);
    text += number("quantity", quantity);
    text += number("carrier", about.carrier);
    text += flag("fades_with_carrier", about.fades());
    text += flag("is_photograph", about.kind == ScaleKind::gray);
    return text;
}

}  // namespace pol
