// SPDX-License-Identifier: Apache-2.0
// Names and constants that the EXR writer and reader share, and which channels a picture has.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "io/pictures/stokes_channels.h"
#include "polarization/stokes.h"
#include "polarization/stokes_convention.h"

namespace pol::exr {

inline constexpr const char* attribute_prefix = "polariscope.";
inline constexpr const char* wavelengths_attribute = "polariscope.wavelengths";
inline constexpr const char* brightest_attribute = "polariscope.brightest";
inline constexpr const char* frame_attribute = "polariscope.frame";
/// StokesConvention::text() of the numbers, in files for other programs (write_mitsuba, write_four).
inline constexpr const char* convention_attribute = "polariscope.convention";
inline constexpr const char* part_attribute = "polariscope.part";
inline constexpr const char* sampling_error_layer = "sampling_error";  ///< "sampling_error.S0.580,000000nm"
inline constexpr const char* handedness_attribute = "polarisationHandedness";

/// Lines that PIZ compresses together; files are written and read in bands of this height.
inline constexpr int band_height = 32;

/// One component of a Stokes vector and the layer of the file that has it.
struct StokesLayer {
    const char* name;
    double Stokes<double>::*component;
};
inline constexpr std::array<StokesLayer, 4> stokes_layers{{{"S0", &Stokes<double>::s0},
                                                           {"S1", &Stokes<double>::s1},
                                                           {"S2", &Stokes<double>::s2},
                                                           {"S3", &Stokes<double>::s3}}};

/// The channels of a Stokes picture.
struct Layout {
    StokesChannels stokes;
    std::vector<std::string> residual;
    std::vector<std::string> tail;
    std::vector<std::array<std::string, 4>> sampling_error;  ///< by band, or none
    std::vector<std::string> counts;                         ///< "samples", "failures"
    bool left_handed = false;
    std::optional<StokesConvention> convention;  ///< of the numbers, where the file names one

    [[nodiscard]] std::vector<std::string> stokes_channels() const;
    /// All that is read, those of S0 first.
    [[nodiscard]] std::vector<std::string> channels() const;
};

/// What is wanted of a file.
struct Wish {
    std::string_view layout;        ///< PictureSource::layout
    bool is_one_component = false;  ///< of four files (find_component_channels)
};

class Parts;

/// Finds them. Error (kind input, without a place): no Stokes channels, or others than read_exr reads, by name; a part
/// of a picture that is not merged yet.
Result<Layout> layout_of(const Parts& parts, const Wish& wish);

}  // namespace pol::exr
