// SPDX-License-Identifier: Apache-2.0
// A picture made small, as the convention doctor looks at it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "film/stokes_image.h"
#include "polarization/stokes.h"

namespace pol::compare {

/// A part of a picture, in its pixels from the top left one that it holds.
struct Area {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    friend bool operator==(const Area&, const Area&) = default;
};

/// The brightest light of a box.
struct Peak {
    double s0 = 0.0;
    double share = 0.0;  ///< of the pixels that are known, those that have exactly this S0
};

/// Means over boxes of pixels, row 0 at the top, in the frame of the picture (StokesImage).
struct StokesPlane {
    int width = 0;
    int height = 0;
    std::vector<Stokes<double>> light;  ///< 0 in a box that does not count
    std::vector<std::uint8_t> counts;   ///< 1: at least half of the box is light that is known
    std::vector<Peak> peaks;            ///< of each box
    StokesComponents known;             ///< those that every band in it has
    double noise = 0.0;                 ///< rms standard error of S1, S2 and S3 in a box; 0: not known
    /// Where the camera's axis meets the plane, in boxes from the top left corner.
    double center_x = 0.0;
    double center_y = 0.0;
    /// Pixels of the picture in a box.
    int box_width = 1;
    int box_height = 1;
};

/// Number of pixels along a side of a box: odd, so that a picture and its mirror image fall into the same boxes, and
/// such that at most 192 boxes fit into `side` (at least 64 if it is that long).
int box_side(int side);

/// The sum of weights[b] times band b in the boxes of `area`, `box` pixels finer than box_side says: a box is box *
/// box_side(width / box) wide. What is left over at the edges is left out, as much on either side. A pixel is not known
/// if a number of it is not finite, S0 < 0, or more than a tenth of its light was not traced. Requires: the area lies
/// in the picture, a weight for each band, box >= 1.
StokesPlane plane_of(const StokesImage& image, const Area& area, std::span<const double> weights, int box = 1);

}  // namespace pol::compare
