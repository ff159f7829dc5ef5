// SPDX-License-Identifier: Apache-2.0
// The one door for pictures from files, whoever wrote them: content decides what they are, the ending only where
// content does not. What each layout is, what it leaves unknown and what has to be assumed: README.md of this folder.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "film/stokes_image.h"

namespace pol {

/// Where a picture is, and what the user says of it.
struct PictureSource {
    /// One file, whose companions (x_I.exr: x_Q.exr, x_U.exr, x_V.exr; x_000.png: x_045.png, ...) are found beside it;
    /// or, with `angles_deg`, one for each angle.
    std::vector<std::filesystem::path> files;
    /// Instead of `files`: one file for each Stokes component, of one channel or of R, G and B; empty: not measured.
    std::array<std::filesystem::path, 4> stokes_files;
    /// Of the polarizers before the camera, counter-clockwise from image right; at least three. Empty: by the names.
    std::vector<double> angles_deg;
    /// Name of a PictureLayout; empty: by content.
    std::string layout;

    /// The file that messages and captions name.
    [[nodiscard]] const std::filesystem::path& path() const;
    friend bool operator==(const PictureSource&, const PictureSource&) = default;
};

struct PictureLayout {
    std::string_view name;   ///< as typed after --layout: "mitsuba"
    std::string_view about;  ///< one line for the help
};
/// Every layout that is read, in the order in which they are looked for.
const std::vector<PictureLayout>& picture_layouts();

/// What a picture is, known before its numbers are.
struct PictureHeader {
    int width = 0;
    int height = 0;
    std::vector<Band> bands;
    PictureOrigin origin;
    std::uintmax_t bytes = 0;  ///< in memory, once it is read
};

/// Hears from time to time which share is read; false: stop. Called on the reader's thread.
using ReadProgress = std::function<bool(double)>;

/// True if the ending is one of a picture: exr, npy, npz, png, fits, fit (any case). Scenes have others.
bool is_picture_name(const std::filesystem::path& path);

/// True if the name is one of a picture, or a file is there whose first bytes are.
bool is_picture(const std::filesystem::path& path);

/// What keeps any file from being looked into (kind input, with its place): it is missing, a folder, no regular file,
/// unreadable or empty.
std::optional<Error> picture_file_problem(const std::filesystem::path& path);

/// Error (kind input) as read_picture, as far as the header tells. Cheap: no pixel is read where that can be avoided.
Result<PictureHeader> read_picture_header(const PictureSource& source);

/// Error (kind input), at the file: not a picture, damaged, larger than the file can hold or than max_picture_bytes, or
/// sound but not read, by its name (subsampled, deep, pickled, ...); no layout fits, or several do (the message names
/// them and --layout). Error (kind usage): a layout that does not exist; too few angles. Stopped by `progress`: error
/// (kind input) "was stopped".
Result<StokesImage> read_picture(const PictureSource& source, const ReadProgress& progress = {});

/// Largest picture taken into memory, counted as the doubles of StokesImage.
inline constexpr double max_picture_bytes = 16.0 * 1024.0 * 1024.0 * 1024.0;

}  // namespace pol
