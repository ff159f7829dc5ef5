// SPDX-License-Identifier: Apache-2.0
// What a film holds of one generation, tile by tile: adding passes, measuring their error, copying means.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "film/picture_error.h"
#include "film/stokes_image.h"
#include "film/strata.h"
#include "film/tile.h"
#include "polarization/stokes.h"

namespace pol {

struct FilmLayout {
    int width = 0;
    int height = 0;
    /// Wavelength group that each wavelength belongs to; residual and tail are kept per group.
    std::vector<int> group_of_wavelength;
    int group_count = 1;
    int tile_size = 32;  ///< tiles are numbered row by row from the top left
    /// The samples of a pixel are random (mode area): their spread, random tails included, is an error that two halves
    /// of them tell. Otherwise all are the same ray, and of a tail only the bound is known.
    bool random_samples = false;
    /// Handed on to the pictures.
    std::vector<double> wavelengths_nm{};
    std::vector<double> brightest{};
    std::string title{};
};

/// How good a tile is: as of its last pass that was not to be followed by more at once (TileBuffer::more_follow).
struct TileStatus {
    std::uint32_t fewest_samples = 0;  ///< of a pixel
    double sample_count = 0.0;         ///< of all pixels, as of now
    ErrorSums error{};
};

/// What a viewer gets of one tile.
struct TileSnapshot {
    Generation generation = 0;
    TileRect rect{};    ///< where `image` lies in the picture
    StokesImage image;  ///< of the size of rect
    /// The tile has no samples yet; Stokes vectors, residual and tail are those of the preview, one for each block of
    /// pixels, and `image.samples` is 0.
    bool preview = false;
    TileStatus status{};  ///< of the whole tile
};

/// Sums of one tile. Index: pixel in the tile * count + wavelength or group. Planes are empty until a pass has them.
struct TileSums {
    TileRect rect{};
    Version version = 0;
    std::vector<Stokes<double>> stokes;
    /// Odd samples minus even ones. In float: a number that is known to 70 % needs no more, and doubles would not fit
    /// into 1.5 KiB per pixel at 21 wavelengths.
    std::vector<Stokes<float>> odd_minus_even;
    std::vector<double> residual;
    std::vector<double> tail;
    std::vector<std::uint32_t> samples;
    std::vector<std::uint32_t> failures;
    TileStatus status{};
    std::array<double, most_strata> stratum_error{};  ///< status.error.half_error, by stratum of the pixels
};

/// Plane sets that a picture may lack.
struct FilmPlanes {
    bool tail = false;
    bool failures = false;
    bool halves = false;
};

/// Sums of a whole film and its preview. Thread safety: none, Film locks it.
struct FilmSums {
    FilmLayout layout;
    Generation generation = 0;
    std::vector<TileSums> tiles;
    std::size_t tiles_without_samples = 0;
    std::shared_ptr<const Strata> strata;  ///< of the pixels; null: they are not sorted
    /// The preview, block by block; stride 0: none, or not needed any more.
    int preview_stride = 0;
    std::vector<bool> preview_rows;  // which of them are there
    std::vector<Stokes<double>> preview_stokes;
    std::vector<double> preview_residual;
    std::vector<double> preview_tail;

    [[nodiscard]] std::size_t wavelengths() const { return layout.group_of_wavelength.size(); }
    [[nodiscard]] std::size_t groups() const { return static_cast<std::size_t>(layout.group_count); }
    /// Planes of a picture: those of a single group are shared by all wavelengths.
    [[nodiscard]] std::size_t planes() const { return groups() == 1 ? 1 : wavelengths(); }
    [[nodiscard]] std::size_t group_of_plane(std::size_t plane) const {
        return groups() == 1 ? 0 : static_cast<std::size_t>(layout.group_of_wavelength[plane]);
    }
    [[nodiscard]] double brightest(std::size_t wavelength) const {
        return layout.brightest.empty() ? 0.0 : layout.brightest[wavelength];
    }
    [[nodiscard]] std::size_t tile_at(int x, int y) const {
        const int columns = (layout.width + layout.tile_size - 1) / layout.tile_size;
        return static_cast<std::size_t>(y / layout.tile_size * columns + x / layout.tile_size);
    }
    [[nodiscard]] int preview_columns() const { return (layout.width + preview_stride - 1) / preview_stride; }

    [[nodiscard]] FilmPlanes planes_present() const;
    /// Picture of that size, wholly untraced, with room for the planes that are known to come.
    [[nodiscard]] StokesImage empty_image(int width, int height, const FilmPlanes& present) const;
    /// Adds what `present` says and the image lacks.
    void add_planes(StokesImage& image, const FilmPlanes& present) const;
    void add(TileSums& tile, const TileBuffer& pass) const;
    /// Renews the error of a tile.
    void measure(TileSums& tile) const;
    /// Sorts the pixels by what their neighbors tell. Requires: all have the same number of samples, at least 2.
    [[nodiscard]] Strata stratify() const;
    void show(const PreviewStrip& strip, Version version);
    void forget_preview();
    /// Copies the means of `part` of a tile with samples into a picture, its corner to (left, top).
    void copy(const TileSums& tile, const TileRect& part, StokesImage& image, int left, int top) const;
    /// What there is to see of a part of a tile: means, or the preview.
    [[nodiscard]] std::optional<TileSnapshot> look(const TileSums& tile, const TileRect& part) const;

private:
    /// ||h||_F^2 of ErrorSums, summed over wavelengths. Requires: 2 samples or more, and halves.
    [[nodiscard]] double half_error(const TileSums& tile, std::size_t pixel) const;
    /// Blocks of this stride in place of those of another, which they begin with.
    void divide_preview(int stride);
    [[nodiscard]] bool has_preview(const TileSums& tile) const;
    void copy_preview(const TileRect& part, StokesImage& image) const;
};

}  // namespace pol
