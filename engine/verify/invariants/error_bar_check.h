// SPDX-License-Identifier: Apache-2.0
// Whether two pictures of one scene, cut in different ways, can both be right about their errors.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "film/stokes_image.h"

namespace pol::verify {

/// What the two pictures say of the pixel that cannot both be true: "DoP in [0.1, 0.2] and in [0.3, 0.4]". Empty if
/// some truth lies within the error bars of both, for S0 to S3 and all measures.
std::optional<std::string> contradiction(const StokesImage& a, const StokesImage& b, std::size_t wavelength,
                                         std::size_t pixel);

}  // namespace pol::verify
