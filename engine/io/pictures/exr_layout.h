// SPDX-License-Identifier: Apache-2.0
// Names and constants that the EXR writer and reader share, and which channels a picture has.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "core/result.h"
#include "polarization/stokes.h"

namespace pol::exr {

inline constexpr const char* attribute_prefix = "polariscope.";
inline constexpr const char* wavelengths_attribute = "polariscope.wavelengths";
inline constexpr const char* brightest_attribute = "polariscope.brightest";
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

/// Wavelength in nm and full channel name of the channels of one layer, ascending.
using Layer = std::map<double, std::string>;

/// The channels of a Stokes picture.
struct Layout {
    std::array<Layer, 4> stokes;
    std::vector<std::string> residual;
    std::vector<std::string> tail;
    std::array<std::vector<std::string>, 4> sampling_error;  ///< by Stokes component
    std::vector<std::string> counts;                         ///< "samples", "failures"
    bool left_handed = false;

    [[nodiscard]] std::vector<std::string> stokes_channels() const {
        std::vector<std::string> channels;
        for (const Layer& layer : stokes)
            for (const auto& [wavelength, name] : layer) channels.push_back(name);
        return channels;
    }
    /// All that is read, those of S0 first.
    [[nodiscard]] std::vector<std::string> channels() const {
        std::vector<std::string> channels = stokes_channels();
        for (const auto* list : {&residual, &tail, &sampling_error[0], &sampling_error[1], &sampling_error[2],
                                 &sampling_error[3], &counts})
            channels.insert(channels.end(), list->begin(), list->end());
        return channels;
    }
};

class Parts;

/// Finds them. Error (kind input, without a place): no Stokes channels, or others than read_exr reads, by name.
Result<Layout> layout_of(const Parts& parts);

}  // namespace pol::exr
