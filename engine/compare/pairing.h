// SPDX-License-Identifier: Apache-2.0
// Which pixels and bands of two pictures are held against each other. A is ours, B another's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/convention_doctor.h"
#include "compare/stokes_plane.h"
#include "core/result.h"
#include "film/stokes_image.h"

namespace pol::compare {

/// The same pixels of the same whole picture.
struct SharedArea {
    Area in_a;
    Area in_b;
};

/// What both hold of one picture: of a crop and its whole, or of two crops. Empty if the whole pictures differ in size,
/// or if no pixel is in both.
std::optional<SharedArea> shared_area(const StokesImage& a, const StokesImage& b);

/// Which of `theirs` can be subtracted from band `band` of `ours`: the same one (matching_band); or, where a picture
/// has a single band and that has no wavelength, the one that pair_up takes for it. Empty: none.
std::optional<std::size_t> comparable_band(const std::vector<Band>& ours, std::size_t band,
                                           const std::vector<Band>& theirs);

/// A sum of bands of A against a sum of bands of B.
struct BandPair {
    std::string label;
    std::vector<double> of_a;  ///< a factor for each band
    std::vector<double> of_b;
    double share = 1.0;  ///< of it in the mean of all that the doctor looks at
};

struct Pairing {
    Area in_a;
    Area in_b;
    /// A pixel of the one stands for a box of so many pixels a side of the other. One of them is 1.
    int box_a = 1;
    int box_b = 1;
    bool lies_across = false;  ///< B is as wide as A is high: a question for the doctor, nothing can be subtracted
    std::vector<BandPair> bands;
    std::vector<std::string> remarks;  ///< what was taken for granted: one sentence each
};

/// Bands of one wavelength or one name are compared. Else R, G and B are compared with the colors of wavelengths, two
/// lists of wavelengths by their colors, and a single band without a wavelength with the one nearest to 580 nm.
///
/// Error (kind usage): sizes of which neither is a whole multiple of the other, bands that do not fit, or no band
/// `band`, a label or a wavelength; empty: all.
Result<Pairing> pair_up(const StokesImage& a, const StokesImage& b, const std::string& band = {});

/// The doctor on all pairs of bands at once: a convention is one of the whole picture. `pixel_tangent`: of a pixel of
/// A, as in fit_conventions.
ConventionVerdict diagnose(const StokesImage& a, const StokesImage& b, const Pairing& pairing,
                           std::optional<double> pixel_tangent = std::nullopt);

/// What one picture has of a pairing: means over the boxes, a band for each pair.
struct CommonPicture {
    StokesImage image;  ///< stokes and, where known, sampling_error; left and top are those of A
    /// Most error of a component by light that was not traced, indexed as image.stokes; empty: nothing is known.
    std::vector<double> bound;
    /// A number of it is one of the file but for signs and place: it is as exact as the file keeps it.
    bool is_plain = true;
    bool is_color = false;  ///< a number is of several bands
};
struct CommonPictures {
    CommonPicture a;
    CommonPicture b;
};
/// Requires: !pairing.lies_across.
CommonPictures common_pictures(const StokesImage& a, const StokesImage& b, const Pairing& pairing);

}  // namespace pol::compare
