// SPDX-License-Identifier: Apache-2.0
// Which of the named channels of a file, an archive or a message are the Stokes components of which band: the rules by
// which other programs' pictures are recognised, as one table.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "film/band.h"
#include "film/stokes_image.h"

namespace pol {

struct BandChannels {
    Band band;
    std::array<std::string, 4> names;  ///< of S0 to S3; empty where not measured (Band::known)
};

struct StokesChannels {
    std::vector<BandChannels> bands;
    PictureOrigin origin;
    bool may_be_mono = false;  ///< R, G and B may be one number three times: merge_equal_colors
};

/// What find_stokes_channels assumes; for readers whose files say more than names.
inline constexpr std::string_view assumed_axes =
    "azimuth is taken from image right, counter-clockwise: the file does not say";
inline constexpr std::string_view assumed_handedness =
    "S3 > 0 is taken for right-handed as the receiver sees it: the file does not say";

/// `generator` is what the file says of the program that wrote it ("Mitsuba version 3.9.1"), or empty. `layout` is the
/// name of a PictureLayout that the user insists on, or empty. Error (kind input, without a place): no layout fits, or
/// several do: names them.
Result<StokesChannels> find_stokes_channels(const std::vector<std::string>& names, std::string_view generator,
                                            std::string_view layout);

/// The channels of one Stokes component in a file of its own: R, G and B, or a single one, beside A; a byte 01 before a
/// name (wave_tracer) is left out of the band's. Each band has names[0] alone. Error as above: more than that is there.
Result<StokesChannels> find_component_channels(const std::vector<std::string>& names);

/// Makes R, G and B one band "mono" if every number of them is the same to the bit, as Mitsuba's monochrome variants
/// write it; else leaves the picture. Requires: `may_be_mono` was said of it, and no planes but `stokes` are there.
void merge_equal_colors(StokesImage& image);

}  // namespace pol
