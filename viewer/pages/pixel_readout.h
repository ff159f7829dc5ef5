// SPDX-License-Identifier: Apache-2.0
// Everything that the picture knows about one pixel, behind the polarimeter: what hover, numbers in pixels and the
// inspector show.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "maps/pixel_light.h"
#include "spectrum/color.h"
#include "viewer/session/session.h"
#include "viewer/shown/selection.h"
#include "viewer/shown/shown_quantity.h"

namespace pol {

struct BandReadout {
    Band band;
    PixelLight light{};         ///< behind the polarimeter, in the convention asked for
    double tail = 0.0;          ///< share of the throughput that random paths stand for
    double brightest = 0.0;     ///< trace bound of the light that any path can bring; 0: not known
    std::optional<double> d65;  ///< white_of the band; none outside the table of D65
};

struct PixelReadout {
    PixelAddress address{};
    std::vector<BandReadout> bands;         ///< as in the picture
    Rgb color{};                            ///< linear sRGB
    std::optional<std::uint32_t> samples;   ///< none: the picture does not say
    std::optional<std::uint32_t> failures;  ///< samples whose arithmetic failed
    bool has_residual = false;              ///< the picture says what was not traced

    /// `quantity` of one band as maps::evaluate_light has it; `undefined` for the intensity where D65 is not
    /// known. Requires: quantity is not `color`, band < bands.size().
    [[nodiscard]] QuantityReadout quantity(Quantity quantity, std::size_t band) const;
};

/// Reads a pixel of the session's current picture. Requires: current() is not null, `address` lies inside the picture.
PixelReadout read_pixel(const Session& session, PixelAddress address, const Convention& convention);
/// The same in the shown convention.
inline PixelReadout read_pixel(const Session& session, PixelAddress address) {
    return read_pixel(session, address, session.view().convention);
}

}  // namespace pol
