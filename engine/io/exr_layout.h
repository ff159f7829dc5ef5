// SPDX-License-Identifier: Apache-2.0
// Names and constants that the EXR writer and reader share.
#pragma once

#include <array>

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

}  // namespace pol::exr
