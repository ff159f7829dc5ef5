// SPDX-License-Identifier: Apache-2.0
// A pixel as a test case: a scene, one sample of one of its pixels, and the coherence matrix that it must have. The
// format: assets/cases/README.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/result.h"
#include "polarization/coherence_matrix.h"
#include "scene/scene.h"

namespace pol {

struct PixelCase {
    int x = 0;
    int y = 0;
    std::uint32_t sample = 0;
    double wavelength_nm = 0.0;
    CoherenceMatrix<double> expected{};  ///< in the camera's frame, engine's conventions
    double tolerance = 0.0;              ///< largest |difference| of an element as a share of S0; 0: equal bits
    Scene scene{};
};

/// Reads a case and checks that its scene has the pixel, the sample and the wavelength. Error (kind input): as
/// load_scene, with lines of the case file.
Result<PixelCase> load_pixel_case(const std::filesystem::path& path);

/// Text that loads back to the same case, bit for bit, from a file in `folder`, which names its meshes and textures as
/// save_scene does. Requires: finite numbers.
std::string save_pixel_case(const PixelCase& pixel_case, const std::filesystem::path& folder);

}  // namespace pol
