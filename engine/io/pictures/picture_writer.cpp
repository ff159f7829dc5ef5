// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/picture_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/contract.h"
#include "io/pictures/exr_file.h"
#include "io/pictures/form_writing.h"

namespace pol {

namespace {

/// Sets of planes that only the spectral form has, and what npz has of them.
void note_missing_planes(OutgoingPicture& picture) {
    const StokesImage& image = picture.image;
    const bool is_npz = picture.options.form == PictureForm::npz;
    std::string names;
    const auto add = [&names](bool is_there, std::string_view name) {
        if (is_there) names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
    };
    add(!is_npz && !image.residual.empty(), "residual");
    add(!is_npz && !image.tail.empty(), "tail");
    add(!is_npz && !image.sampling_error.empty(), "sampling error");
    add(!image.samples.empty(), "number of samples");
    add(std::any_of(image.failures.begin(), image.failures.end(), [](auto count) { return count > 0; }), "failures");
    add(!image.brightest.empty(), "brightest light");
    add(!image.attributes.empty(), "attributes");
    add(image.left != 0 || image.top != 0 || image.whole_width != 0 || image.whole_height != 0,
        "place in the whole picture");
    if (!names.empty()) picture.lost.push_back(fmt::format("There is no place for: {}.", names));
}

std::filesystem::path beside(const std::filesystem::path& path, std::string_view what) {
    return path.parent_path() / (path.stem().string() + "_" + std::string(what) + path.extension().string());
}

}  // namespace

StokesComponents OutgoingPicture::known() const {
    StokesComponents known = StokesComponents::all();
    for (const Band& band : image.bands)
        for (unsigned i = 0; i < 4; ++i)
            if (!band.known.has(i)) known = known.without(i);
    return known;
}

Result<Done> OutgoingPicture::require_linear(std::string_view form) const {
    const StokesComponents common = known();
    const bool all_alike =
        std::all_of(image.bands.begin(), image.bands.end(), [&](const Band& band) { return band.known == common; });
    if (all_alike && (common == StokesComponents::all() || common == StokesComponents::linear())) return Done{};
    return cannot_hold(fmt::format("{} holds S0, S1 and S2, with or without S3, of every band, and this picture has "
                                   "not measured them",
                                   form),
                       "spectral and fits leave components out");
}

void Rounding::note(std::string_view type, std::vector<std::string>& lost) const {
    if (changed > 0) lost.push_back(fmt::format("{} numbers are rounded to {}.", changed, type));
    if (infinite > 0)
        lost.push_back(fmt::format("{} numbers are above the range of {} and infinite now.", infinite, type));
}

std::span<const PictureFormInfo> picture_forms() {
    static constexpr std::array<PictureFormInfo, 7> forms{
        {{PictureForm::spectral, "spectral", ".exr", "EXR in the spectral layout, as render writes it"},
         {PictureForm::mitsuba, "mitsuba", ".exr", "EXR with R G B A and S0.R ... S3.B in linear sRGB, as Mitsuba 3"},
         {PictureForm::npy, "npy", ".npy", "numpy array (n, H, W, 4) of 64-bit floats"},
         {PictureForm::npz, "npz", ".npz", "numpy arrays: stokes, wavelengths_nm or bands, error planes, convention"},
         {PictureForm::four, "four", ".exr", "four EXR, NAME_I, _Q, _U and _V, with channel L, or R G B"},
         {PictureForm::png4, "png4", ".png", "four 16-bit PNG, NAME_000, _045, _090, _135: behind a polarizer"},
         {PictureForm::fits, "fits", ".fits", "FITS cube with an axis STOKES"}}};
    return forms;
}

std::vector<std::filesystem::path> files_of_form(const StokesImage& image, const std::filesystem::path& path,
                                                 PictureForm form) {
    std::vector<std::filesystem::path> files;
    if (form == PictureForm::four) {
        constexpr std::array<std::string_view, 4> names{"I", "Q", "U", "V"};
        const StokesComponents known = OutgoingPicture{image, {}}.known();
        for (unsigned i = 0; i < 4; ++i)
            if (known.has(i)) files.push_back(beside(path, names[i]));
    } else if (form == PictureForm::png4) {
        for (const std::string_view angle : {"000", "045", "090", "135"}) files.push_back(beside(path, angle));
    } else {
        files.push_back(path);
    }
    return files;
}

Result<std::vector<std::string>> write_picture(const StokesImage& image, const std::filesystem::path& path,
                                               const FormOptions& options) {
    if (image.width <= 0 || image.height <= 0 || image.bands.empty())
        return Error{ErrorKind::usage, "a picture without pixels cannot be written", Place{path.string()}};
    POL_EXPECTS(image.stokes.size() == image.pixel_count() * image.bands.size());
    OutgoingPicture picture{image, options};
    if (options.form != PictureForm::spectral) note_missing_planes(picture);
    const auto write = [&]() -> Result<Done> {
        switch (options.form) {
            case PictureForm::mitsuba:
                return write_mitsuba(picture, path);
            case PictureForm::npy:
                return write_npy(picture, path);
            case PictureForm::npz:
                return write_npz(picture, path);
            case PictureForm::four:
                return write_four(picture, path);
            case PictureForm::png4:
                return write_png4(picture, path);
            case PictureForm::fits:
                return write_fits(picture, path);
            case PictureForm::spectral:
                break;
        }
        // Its reader turns handedness alone, and only what the layout itself can say is safe with other programs.
        if (options.convention != StokesConvention{})
            return cannot_hold("the spectral layout is written in polariscope's convention only",
                               "leave --handedness, --zero and --y out, or choose another form");
        Rounding rounding;
        for (const Stokes<double>& s : image.stokes)
            for (const auto component : stokes_components) {
                const auto number = static_cast<double>(static_cast<float>(s.*component));
                if (std::isfinite(s.*component) && std::isinf(number))
                    ++rounding.infinite;
                else if (number != s.*component && !std::isnan(number))
                    ++rounding.changed;
            }
        rounding.note("32-bit floats", picture.lost);
        return write_exr(image, path);
    };
    POL_TRY_DONE(write());
    return picture.lost;
}

}  // namespace pol
