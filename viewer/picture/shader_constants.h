// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "maps/quantity.h"

namespace pol {

/// The enumerations as shaders/evaluate.glsl and map.frag name them (quantity_dop, state_defined, carrier_light ...),
/// and the row of `quantity`, which the program is for, as constants: a compiler of shaders drops all other formulas.
std::string shader_constants(Quantity quantity);

}  // namespace pol
