// SPDX-License-Identifier: Apache-2.0
// Bands that the spectral layout has no names for, and where a picture came from, as string attributes of our files.
//
// `polariscope.bands`: a line for each band, in order: measured components, suffix of its channels ("S0." and so on
// come before it), and `n NAME` or `w WAVELENGTH_NM`: "012 R n R". `polariscope.origin.layout`, `.convention`
// ("left_handed y_down 90"), `.assumed` and `.remarks` (a line for each sentence), `polariscope.stored` ("16 B44").
// Line feeds and backslashes in names and sentences have a backslash before them.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "film/stokes_image.h"
#include "io/pictures/exr_parts.h"
#include "io/pictures/stokes_channels.h"

namespace pol::exr {

inline constexpr const char* bands_attribute = "polariscope.bands";
inline constexpr const char* stored_attribute = "polariscope.stored";
inline constexpr const char* spacing_attribute = "polariscope.stored.spacing";

/// What comes behind the dot in the channel names of each band: "580,000000nm", a plain name as it is, else "band3".
std::vector<std::string> band_suffixes(const std::vector<Band>& bands);

/// The attributes above of a picture, those that it needs: none for wavelengths of which all is measured and made here.
std::map<std::string, std::string> own_attributes(const StokesImage& image);

/// True for the names of own_attributes, and for convention_attribute: it is of the numbers of one file.
bool is_own_attribute(std::string_view name);

/// The channels that `polariscope.bands` tells of. Error (kind input, without a place): not of that form, or a channel
/// is not among `names`, which ascend.
Result<StokesChannels> own_channels(std::string_view bands, const std::vector<std::string>& names);

/// Adds where the picture came from before it became a file of ours. Error: not of that form.
Result<Done> take_own_origin(const Parts& parts, PictureOrigin& origin);

/// The coarser of `stored` and what the file says of an earlier one.
StoredNumbers with_earlier(StoredNumbers stored, const Parts& parts);

/// "1, 2.5, 3": empty if any part is not a number.
std::vector<double> parse_numbers(std::string_view text);
/// Shortest text that gives each number back to the bit.
std::string number_list(const std::vector<double>& numbers);

}  // namespace pol::exr
