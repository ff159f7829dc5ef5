// SPDX-License-Identifier: Apache-2.0
// What the readers of this folder that are no EXR have in common: a picture is opened, judged by its size, and filled.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include "core/result.h"
#include "film/stokes_image.h"
#include "io/pictures/picture_file.h"

namespace pol {

/// A picture of which all but the numbers is known.
struct UnfilledPicture {
    StokesImage image;  ///< size, bands and origin; no plane has memory
    /// Writes the numbers, and what only they tell of the origin, into a copy of `image` whose Stokes vectors are 0.
    /// Errors may have no file in their place: it is the picture's then.
    std::function<Result<Done>(StokesImage&, const ReadProgress&)> fill;
};

inline Error input_error(std::string what, std::string hint, const std::filesystem::path& file = {}) {
    return Error{ErrorKind::input, std::move(what), Place{file.string()}, {}, std::move(hint)};
}
inline Error usage_error(std::string what, std::string hint) {
    return Error{ErrorKind::usage, std::move(what), {}, {}, std::move(hint)};
}
inline Error was_stopped() {
    return input_error("was stopped", "open it again");
}

/// What every reader says of numbers that come without a word on their axes.
inline constexpr const char* assumed_frame =
    "The azimuth counts from image right, counter-clockwise for the receiver, and S3 > 0 is right-handed; the first "
    "row "
    "is the top one: the file says nothing of it.";

Result<UnfilledPicture> open_npy(const std::filesystem::path& path, std::string_view layout);
Result<UnfilledPicture> open_npz(const std::filesystem::path& path, std::string_view layout);
Result<UnfilledPicture> open_fits(const std::filesystem::path& path);
/// One photograph, a mosaic, or one of a set whose others lie beside it (camera_reader.cpp).
Result<UnfilledPicture> open_png(const PictureSource& source);
/// Several photographs behind polarizers at source.angles_deg.
Result<UnfilledPicture> open_angles(const PictureSource& source);
/// One .npy for each component, of rows and columns, or of R, G and B behind them.
Result<UnfilledPicture> open_components(const PictureSource& source);

}  // namespace pol
