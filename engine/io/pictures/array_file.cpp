// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/array_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <new>
#include <string>
#include <utility>

#include "io/files/png_reader.h"
#include "io/pictures/array_layout.h"
#include "io/pictures/npy_format.h"
#include "io/pictures/picture_reading.h"

namespace pol {

namespace {

enum class ArrayKind { none, npy, npz, png, fits };

ArrayKind kind_of(const std::filesystem::path& path) {
    std::array<char, 10> bytes{};
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), bytes.size());
    const std::string_view begin(bytes.data(), static_cast<std::size_t>(file.gcount()));
    if (begin.starts_with(npy_magic)) return ArrayKind::npy;
    if (begin.starts_with("PK\x03\x04") || begin.starts_with("PK\x05\x06")) return ArrayKind::npz;
    if (is_png(begin)) return ArrayKind::png;
    if (begin.starts_with("SIMPLE  =")) return ArrayKind::fits;
    return ArrayKind::none;
}

std::vector<std::filesystem::path> files_of(const PictureSource& source) {
    std::vector<std::filesystem::path> files = source.files;
    for (const auto& file : source.stokes_files)
        if (!file.empty()) files.push_back(file);
    return files;
}

Result<UnfilledPicture> open(const PictureSource& source) {
    for (const auto& file : source.stokes_files)
        if (!file.empty()) return open_components(source);
    if (!source.angles_deg.empty()) return open_angles(source);
    const bool is_camera_layout = source.layout == "four-angles" || source.layout == "mosaic" ||
                                  source.layout == "color-mosaic" || source.layout == "photograph";
    const ArrayKind kind = kind_of(source.path());
    if (!source.layout.empty() && is_camera_layout != (kind == ArrayKind::png))
        return usage_error(fmt::format("the layout '{}' is not one of {}", source.layout,
                                       kind == ArrayKind::png ? "photographs" : "arrays"),
                           kind == ArrayKind::png ? "of photographs: four-angles, mosaic, color-mosaic, photograph"
                                                  : "of arrays: hwc, chw, tensor, bgr, nhwc, hwnc");
    switch (kind) {
        case ArrayKind::npy:
            return open_npy(source.path(), source.layout);
        case ArrayKind::npz:
            return open_npz(source.path(), source.layout);
        case ArrayKind::png:
            return open_png(source);
        case ArrayKind::fits:
            if (!source.layout.empty())
                return usage_error(fmt::format("the layout '{}' is none of FITS, which has one", source.layout),
                                   "leave --layout out");
            return open_fits(source.path());
        case ArrayKind::none:
            break;
    }
    return input_error("is neither an array nor a photograph", "npy, npz, PNG and FITS are read");
}

/// With the file in it, where the reader did not say which.
Error located(const PictureSource& source, Error error) {
    if (error.place.file.empty() && error.kind == ErrorKind::input) error.place.file = source.path().string();
    return error;
}

}  // namespace

bool is_array_file(const PictureSource& source) {
    const auto files = files_of(source);
    return !files.empty() &&
           std::all_of(files.begin(), files.end(), [](const auto& file) { return kind_of(file) != ArrayKind::none; });
}

std::span<const PictureLayout> array_layouts() {
    static constexpr std::array<PictureLayout, 10> layouts{
        {{"hwc", "array (H, W, 3 or 4): rows, columns, Stokes"},
         {"chw", "array (3 or 4, H, W): Stokes, rows, columns"},
         {"tensor", "array (H, W, 12 to 16): of Mitsuba, the last 12 are S0.R S0.G S0.B S1.R ..."},
         {"bgr", "array (H, W, 3, 3 or 4): blue, green, red, then Stokes, as polanalyser has it"},
         {"nhwc", "array (n, H, W, 3 or 4): bands first"},
         {"hwnc", "array (H, W, n, 3 or 4): bands behind the columns"},
         {"four-angles", "PNG: four photographs, their names end in _0 _45 _90 _135 or _000 _045 _090 _135"},
         {"mosaic", "PNG: raw picture of a sensor with polarizers 90 45 / 135 0, at half its resolution"},
         {"color-mosaic", "PNG: the same under colors R G / G B, at a quarter"},
         {"photograph", "PNG: S0 alone"}}};
    return layouts;
}

Result<PictureHeader> read_array_header(const PictureSource& source) {
    const auto reading = open(source);
    if (!reading) return located(source, reading.error());
    const StokesImage& image = reading.value().image;
    return PictureHeader{image.width, image.height, image.bands, image.origin,
                         image.pixel_count() * image.bands.size() * sizeof(Stokes<double>)};
}

Result<StokesImage> read_array_picture(const PictureSource& source, const ReadProgress& progress) {
    try {
        const auto reading = open(source);
        if (!reading) return located(source, reading.error());
        StokesImage image = reading.value().image;
        image.stokes.resize(image.pixel_count() * image.bands.size());
        const auto filled = reading.value().fill(image, progress);
        if (!filled) return located(source, filled.error());
        return image;
    } catch (const std::bad_alloc&) {
        return located(source,
                       input_error("is too large for the memory of this machine", "look at it on a larger one"));
    }
}

}  // namespace pol
