// SPDX-License-Identifier: Apache-2.0
// Readings as a person reads them. No ImGui.
#pragma once

#include <string>
#include <string_view>

#include "maps/evaluate.h"
#include "maps/quantity.h"
#include "viewer/pixel_reading.h"

namespace pol {

/// Why there is no number: "no light", "undefined", ... Empty for `defined`.
std::string_view state_text(PixelState state);

/// "0.83124 \u00b1 0.0021", "12.5\u00b0 \u00b1 0.3\u00b0", "not determined". A bar of width 0 is not printed.
std::string reading_text(Quantity quantity, const QuantityReading& reading);

/// At most `digits` significant digits, without trailing zeros and without "-0".
std::string short_number(double value, int digits);

}  // namespace pol
