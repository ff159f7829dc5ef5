// SPDX-License-Identifier: Apache-2.0
// The accumulator: per pixel and wavelength the summed Stokes vector, and what is known about its error.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>

#include "film/film_sums.h"
#include "film/picture_error.h"
#include "film/stokes_image.h"
#include "film/strata.h"
#include "film/tile.h"

namespace pol {

/// How far a film is, and how good what it holds.
struct FilmStatus {
    Generation generation = 0;
    std::uint32_t fewest_samples = 0;  ///< of a pixel
    double mean_samples = 0.0;         ///< per pixel
    PictureError error{};
};

/// The status of a film, or of a picture of it, tile by tile.
class FilmStatusSum {
public:
    void add(const TileStatus& tile);
    /// `pixels` of all tiles; `random_samples` as in FilmLayout. Requires: a tile was added.
    [[nodiscard]] FilmStatus status(std::size_t pixels, bool random_samples) const;

private:
    std::uint32_t fewest_samples_ = std::numeric_limits<std::uint32_t>::max();
    double samples_ = 0.0;
    ErrorSums error_{};
};

/// Sums over samples in the camera frame.
///
/// The sum of a pixel is formed pass by pass, in the order in which merge() is called for its tile: callers deliver the
/// passes of a tile in order, and the picture does not depend on threads or tile sizes.
/// Thread safety: any member from any thread. No member holds the lock for longer than it takes to add or copy one
/// tile; a snapshot() of a large picture hinders nobody, and goes on undisturbed if the film is reset meanwhile.
class Film {
public:
    Film();

    /// Empties the film for a new job.
    void reset(FilmLayout layout, Generation generation);

    /// Adds one finished pass over a tile or a part of it. Returns false, and drops it, if it belongs to another
    /// generation. Requires: the rectangle lies in one tile.
    bool merge(const TileBuffer& pass);

    /// Shows a strip of the preview in the tiles that have no samples. It never enters the sums. Returns false, and
    /// drops it, if it belongs to another generation.
    bool show(const PreviewStrip& strip);

    /// Number of the job that the film belongs to.
    [[nodiscard]] Generation generation() const;

    /// Grows with every change of any tile, also over generations: while it stays, there is nothing to fetch.
    [[nodiscard]] Version version() const;

    [[nodiscard]] int tile_count() const;

    /// Copies tile `index` if it changed after `seen` (0: never seen), and moves `seen` up to it. Empty also if the
    /// tile has nothing to show yet, or if there is no such tile (any more).
    [[nodiscard]] std::optional<TileSnapshot> tile_if_newer(int index, Version& seen) const;

    /// All that is known of one pixel, as a picture of 1 x 1 pixels; the preview where there is no sample yet. Empty if
    /// the film has no such pixel.
    [[nodiscard]] std::optional<TileSnapshot> pixel(int x, int y) const;

    /// Means of what is there now; without preview.
    [[nodiscard]] StokesImage snapshot() const;

    /// The picture before anything of it is there, in the film's layout.
    [[nodiscard]] StokesImage blank() const;

    [[nodiscard]] FilmStatus status() const;

    /// Sorts the pixels into strata by what they hold now, and keeps that until reset(). Null if the film belongs to
    /// another generation. Requires: all pixels have the same number of samples, at least 2, and nobody merges.
    std::shared_ptr<const Strata> stratify(Generation generation);

    /// What each stratum adds to the error of the picture, ErrorSums::half_error. Requires: stratify() of this
    /// generation, or another generation; then all are 0.
    [[nodiscard]] std::array<double, most_strata> stratum_errors(Generation generation) const;

    /// Bytes held per pixel.
    [[nodiscard]] double bytes_per_pixel() const;

private:
    mutable std::mutex mutex_;  // guards the members below and what they point to
    Version newest_ = 0;
    std::shared_ptr<FilmSums> sums_;  // never changed again once it is replaced
};

}  // namespace pol
