// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "polarization/stokes_convention.h"

namespace pol {

/// The convention whose text() this is, of those that are written: azimuth from image right or up.
inline std::optional<StokesConvention> convention_of(std::string_view text) {
    for (const bool left_handed : {false, true})
        for (const bool y_down : {false, true})
            for (const double zero : {0.0, 90.0}) {
                const StokesConvention convention{left_handed, y_down, zero};
                if (convention.text() == text) return convention;
            }
    return std::nullopt;
}

}  // namespace pol
