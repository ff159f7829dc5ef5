// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "film/stokes_image.h"

namespace pol::verify {

/// Floating-point error of whole pictures: against the scene turned in space, which is the same picture in exact
/// arithmetic. Trees are cut by depth, so that no tie of weights is broken otherwise.
struct RoundingError {
    double fro_c = 0.0;           ///< over the pixels of equal paths
    std::size_t other_paths = 0;  ///< pixels that differ by more than 1e-9: a ray near an edge met the other facet
    std::size_t pixels = 0;
};

/// Requires: same size and number of wavelengths.
RoundingError rounding_error(const StokesImage& picture, const StokesImage& turned);

}  // namespace pol::verify
