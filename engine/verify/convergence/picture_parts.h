// SPDX-License-Identifier: Apache-2.0
// Pictures made of others: of fewer wavelengths, or of two halves.
#pragma once

#include <vector>

#include "film/stokes_image.h"

namespace pol::verify {

/// The wavelengths of `picture` that are in `wavelengths_nm`, in that order, with what is known of their error but for
/// the sampling error. Requires: all of them are in the picture.
StokesImage at_wavelengths(const StokesImage& picture, const std::vector<double>& wavelengths_nm);

/// Every second wavelength, first and last included where their number is odd: a nested set.
StokesImage every_second_wavelength(const StokesImage& picture);

/// Mean of two renders of one scene, with the means of their residuals and tails.
/// Requires: same size, wavelengths and plane sets but for the tail, which counts as 0 where only one has it.
StokesImage mean_of(const StokesImage& a, const StokesImage& b);

}  // namespace pol::verify
