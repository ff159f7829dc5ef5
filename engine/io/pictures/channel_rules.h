// SPDX-License-Identifier: Apache-2.0
// The rules of stokes_channels.h, one for each layout. Each gives nothing where the layout does not fit, and an error
// (kind input, without a place) where it fits but the channels are not what it promises.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "io/pictures/stokes_channels.h"

namespace pol::channels {

struct Fit {
    StokesChannels channels;
    bool is_certain = false;  ///< by more than the names: the file says who wrote it
};

using MaybeFit = Result<std::optional<Fit>>;

MaybeFit spectral(const std::vector<std::string>& names, std::string_view generator);
/// S0.R to S3.B of Mitsuba 3's integrator `stokes`; labels that a specfilm shifted are mended.
MaybeFit mitsuba(const std::vector<std::string>& names, std::string_view generator);
/// ch00 to ch11 .. ch15: an array of Mitsuba saved without names, read by position.
MaybeFit mitsuba_array(const std::vector<std::string>& names, std::string_view generator);
/// S0.NAME to S2.NAME or S3.NAME, of other names than R, G and B alone.
MaybeFit named(const std::vector<std::string>& names, std::string_view generator);
/// S0 to S2 or S3, or I, Q, U and perhaps V, in any case and behind any layer.
MaybeFit bare(const std::vector<std::string>& names, std::string_view generator);
/// Pictures without polarization: R, G and B; Y; a single channel; R, G and B of the only layer that has them.
MaybeFit plain(const std::vector<std::string>& names, std::string_view generator);

/// As find_component_channels.
std::optional<StokesChannels> one_component(const std::vector<std::string>& names);

/// Said of Mitsuba's R, G and B.
inline constexpr std::string_view remark_of_colors =
    "R, G and B are linear sRGB of each component, by weights that are partly negative: saturated light may look more "
    "polarized than light can be";

/// The first few names, for a message.
std::string some_of(const std::vector<std::string>& names);

}  // namespace pol::channels
