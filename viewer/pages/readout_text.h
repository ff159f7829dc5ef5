// SPDX-License-Identifier: Apache-2.0
// Readings as a person reads them. No ImGui.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "maps/evaluate.h"
#include "maps/quantity.h"
#include "viewer/pages/pixel_readout.h"

namespace pol {

/// Why there is no number: "no light", "undefined", ... Empty for `defined`.
std::string_view state_text(PixelState state);
/// There is a value, but it is not known.
inline bool may_be_any(PixelState state) {
    return state == PixelState::undetermined || state == PixelState::dark;
}
/// The same in a sentence.
std::string_view state_definition(PixelState state);

/// "S3 was not measured", "S1 and S2 were not measured": what of `needed` is not `known`; empty: nothing.
std::string missing_text(StokesComponents needed, StokesComponents known);

/// A number whose digits end where its bar begins, and that bar.
struct NumberText {
    std::string value;
    std::string
        bar;  ///< "± 0.0021" if it is as far to both sides, else "[0.531, 0.998]"; empty: none, or only rounding
};

/// `bar` contains the truth, and so does what is written: its ends are rounded outwards. A value, an end or a bar of at
/// most `rounding` is written as 0, and such a bar not at all. At most `digits` significant digits of the value; `unit`
/// follows every number, but for the degree sign after a space.
NumberText number_text(double value, const std::optional<Interval<double>>& bar, double rounding, int digits,
                       std::string_view unit);
/// The bar alone, as an interval: "[0.531, 0.998]".
std::string interval_text(const Interval<double>& bar, double rounding, std::string_view unit);

/// "0.8312 ± 0.0021", "0.998 [0.531, 0.998]", "12.5° ± 0.3°", "not determined [0.2, 1]".
std::string readout_text(Quantity quantity, const QuantityReadout& readout);
/// Its number without the bar.
std::string value_text(Quantity quantity, const QuantityReadout& readout, int digits);

/// At most `digits` significant digits, without trailing zeros and without "-0".
std::string short_number(double value, int digits);
/// "580 nm", or the name of a band that has no wavelength.
std::string band_text(const Band& band);
/// The same, but 0 for what is nothing but rounding (pixel_noise) beside `size`.
std::string short_number(double value, int digits, double size);

}  // namespace pol
