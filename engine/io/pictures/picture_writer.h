// SPDX-License-Identifier: Apache-2.0
// Pictures in the forms of other programs.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "film/stokes_image.h"

namespace pol {

enum class PictureForm { spectral, mitsuba, npy, npz, four, png4, fits };

struct PictureFormInfo {
    PictureForm form;
    std::string_view name;    ///< as typed after --as
    std::string_view ending;  ///< of the file: ".exr"
    std::string_view about;   ///< one line for the help
};
std::span<const PictureFormInfo> picture_forms();

struct FormOptions {
    PictureForm form = PictureForm::spectral;
    bool half = false;            ///< mitsuba: 16-bit floats
    StokesConvention convention;  ///< of the numbers in the file
};

/// The files that write_picture makes: `path`, or several beside it (x_I.exr, x_000.png).
std::vector<std::filesystem::path> files_of_form(const StokesImage& image, const std::filesystem::path& path,
                                                 PictureForm form);

/// Writes `image`, and says what of it the file does not hold, a sentence each; none: reading it gives the same numbers
/// to the bit. Every file appears whole or not at all; of several, those before the first error are there. Error: kind
/// output if a file cannot be written; kind usage if the form has no place for the bands, for components that were not
/// measured, or for the convention.
Result<std::vector<std::string>> write_picture(const StokesImage& image, const std::filesystem::path& path,
                                               const FormOptions& options);

}  // namespace pol
