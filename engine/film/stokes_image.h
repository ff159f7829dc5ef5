// SPDX-License-Identifier: Apache-2.0
// A finished (or half-finished) picture: mean Stokes vectors and what is known about their error. The common currency
// of the renderer, the files and the maps.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "film/band.h"
#include "polarization/stokes.h"
#include "polarization/stokes_convention.h"

namespace pol {

/// How a picture's Stokes numbers were kept before they were read.
struct StoredNumbers {
    int bits = 32;      ///< of a number: 32, 24 (a float cut short by PXR24) or 16 (a half)
    std::string lossy;  ///< a compression that changes numbers by more than that, by no simple bound: "B44"
    /// Distance of neighbours where numbers were made from whole ones, a camera's counts, so that each is off by at
    /// most half of it, however small it is; 0: from floats.
    double spacing = 0.0;

    /// Largest relative error by rounding to nearest: half a unit in the last of 24, 16 or 11 significant bits.
    [[nodiscard]] double rounding() const { return bits == 32 ? 0x1p-24 : bits == 24 ? 0x1p-16 : 0x1p-11; }
    /// Distance of neighbours among the smallest numbers, which have no relative precision.
    [[nodiscard]] double step() const {
        return std::max(spacing, bits == 32 ? 0x1p-149 : bits == 24 ? 0x1p-141 : 0x1p-24);
    }
};

/// What a reader knows of a picture that it read beside the numbers. A picture made here has an empty one.
struct PictureOrigin {
    std::string layout;  ///< how the file was understood: "Mitsuba 3, mono"
    /// What the numbers of the file were taken to be; they are in ours in memory (read_in).
    StokesConvention convention;
    /// What the file does not say and the reader took for granted: one sentence each, for the user to judge.
    std::vector<std::string> assumed;
    std::vector<std::string> remarks;  ///< what was mended, or is lost: one sentence each
    friend bool operator==(const PictureOrigin&, const PictureOrigin&) = default;
};

/// Mean over the samples of each pixel, in the camera frame: x = image right, y = image up, both made transverse to the
/// pixel's ray, k towards the camera. Row 0 is the top row.
///
/// Planes are indexed by band: stokes[b * pixel_count() + y * width + x]. A plane set that the picture does not have (a
/// foreign file, a scene without it) is empty. `residual` and `tail` have one plane per band, or a single plane if all
/// bands share one tree (plane_value).
struct StokesImage {
    int width = 0;
    int height = 0;
    /// Place of the first column and row in the whole picture, of which a file may hold a part only.
    int left = 0;
    int top = 0;
    /// Size of the whole picture; 0: it is no larger than this.
    int whole_width = 0;
    int whole_height = 0;
    std::vector<Band> bands;  ///< those with a wavelength ascend
    std::vector<Stokes<double>> stokes;
    StoredNumbers stored;  ///< of `stokes`
    /// Share of the pixel's throughput that was not traced, 0 to 1; the missing coherence matrix is positive
    /// semidefinite with trace at most residual * brightest (CUTTING.md 1.2).
    std::vector<double> residual;
    /// Share that was estimated by one random path instead; the estimate and the truth both lie in 0..tail * brightest.
    std::vector<double> tail;
    /// Standard error (68 %) of each Stokes component by the finite number of samples, indexed as `stokes`; estimated
    /// from two halves of the samples, so that a single value is a rough guide and only means over many pixels are
    /// accurate (ErrorSums). Infinite where a pixel has fewer than two samples; empty in pictures of one ray per pixel.
    std::vector<Stokes<double>> sampling_error;
    /// Samples that each pixel has, one plane; samples whose arithmetic failed, one plane.
    std::vector<std::uint32_t> samples;
    std::vector<std::uint32_t> failures;
    /// Trace bound of the light that any path can bring, per band: L_max, or 2 L_max with polarized emitters.
    std::vector<double> brightest;
    /// peak_of each band, kept by whoever changes the picture while it is looked at; empty: to be looked for.
    std::vector<double> peak;
    /// Header attributes as text, without the "polariscope." prefix: scene_hash, frame, settings, ...
    std::map<std::string, std::string> attributes;
    PictureOrigin origin;

    [[nodiscard]] std::size_t pixel_count() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    [[nodiscard]] std::size_t pixel(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] const Stokes<double>& at(std::size_t band, std::size_t pixel_index) const {
        return stokes[band * pixel_count() + pixel_index];
    }
    /// Value of a per-band plane set that may be shared between bands or absent (0).
    [[nodiscard]] double plane_value(const std::vector<double>& planes, std::size_t band,
                                     std::size_t pixel_index) const {
        if (planes.empty()) return 0.0;
        return planes.size() == pixel_count() ? planes[pixel_index] : planes[band * pixel_count() + pixel_index];
    }
};

/// S0 that the brightest pixel of a band has for sure: what a random tail may have too much is taken off. 0 without
/// light.
double peak_of(const StokesImage& image, std::size_t band);
/// Of all bands.
std::vector<double> peaks_of(const StokesImage& image);

/// Takes the numbers of the file to be in another convention than the reader did: turns them from what they were taken
/// for back to the file's, and from `convention` to ours. Undone by the former convention, to the bit for signs and
/// multiples of 45 degrees.
void read_in(StokesImage& image, const StokesConvention& convention);

}  // namespace pol
