// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/picture_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <fstream>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "io/pictures/array_file.h"
#include "io/pictures/exr_picture.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

/// A kind of file, told by its content.
struct Format {
    bool (*is_it)(const PictureSource&);
    Result<StokesImage> (*read)(const PictureSource&, const ReadProgress&);
    Result<PictureHeader> (*read_header)(const PictureSource&);
    std::span<const PictureLayout> (*layouts)();
};
constexpr std::array formats{Format{is_exr_picture, read_exr_picture, read_exr_picture_header, exr_layouts},
                             Format{is_array_file, read_array_picture, read_array_header, array_layouts}};

Error usage_error(std::string what, std::string field, std::string hint) {
    return Error{ErrorKind::usage, std::move(what), {}, std::move(field), std::move(hint)};
}

std::string layout_names() {
    std::string names;
    for (const PictureLayout& layout : picture_layouts()) {
        if (!names.empty()) names += ", ";
        names += layout.name;
    }
    return names;
}

std::optional<Error> usage_problem(const PictureSource& source) {
    const auto is_named = [](const fs::path& path) { return !path.empty(); };
    const bool has_stokes = std::any_of(source.stokes_files.begin(), source.stokes_files.end(), is_named);
    if (source.files.empty() && !has_stokes)
        return usage_error("no picture is named", {}, "name a file, or --stokes s0=FILE,s1=FILE,...");
    if (!source.files.empty() && has_stokes)
        return usage_error("a picture and files of its components are named", "--stokes", "leave one of them out");
    const std::vector<PictureLayout>& known = picture_layouts();
    const auto is_it = [&](const PictureLayout& layout) { return layout.name == source.layout; };
    if (!source.layout.empty() && std::none_of(known.begin(), known.end(), is_it))
        return usage_error(fmt::format("there is no layout '{}'", source.layout), "--layout",
                           fmt::format("one of {}", layout_names()));
    return std::nullopt;
}

Result<const Format*> format_of(const PictureSource& source) {
    if (const auto problem = usage_problem(source)) return *problem;
    for (const fs::path& path : source.files)
        if (const auto problem = picture_file_problem(path)) return *problem;
    for (const fs::path& path : source.stokes_files)
        if (const auto problem = path.empty() ? std::nullopt : picture_file_problem(path)) return *problem;
    for (const Format& format : formats)
        if (format.is_it(source)) return &format;
    return Error{ErrorKind::input,
                 "is no picture that is read",
                 Place{source.path().string()},
                 {},
                 "EXR, npy, npz, PNG and FITS are; content decides, not the ending"};
}

}  // namespace

const fs::path& PictureSource::path() const {
    if (!files.empty()) return files.front();
    const auto named =
        std::find_if(stokes_files.begin(), stokes_files.end(), [](const fs::path& file) { return !file.empty(); });
    return named == stokes_files.end() ? stokes_files.front() : *named;
}

const std::vector<PictureLayout>& picture_layouts() {
    static const std::vector<PictureLayout> all = [] {
        std::vector<PictureLayout> layouts;
        for (const Format& format : formats)
            for (const PictureLayout& layout : format.layouts()) layouts.push_back(layout);
        return layouts;
    }();
    return all;
}

bool is_picture_name(const fs::path& path) {
    constexpr std::array<std::string_view, 6> endings{".exr", ".npy", ".npz", ".png", ".fits", ".fit"};
    std::string ending = path.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

bool is_picture(const fs::path& path) {
    if (is_picture_name(path)) return true;
    if (picture_file_problem(path)) return false;
    PictureSource source;
    source.files = {path};
    return std::any_of(formats.begin(), formats.end(), [&](const Format& format) { return format.is_it(source); });
}

std::optional<Error> picture_file_problem(const fs::path& path) {
    const auto problem = [&](std::string what, std::string hint) {
        return Error{ErrorKind::input, std::move(what), Place{path.string()}, {}, std::move(hint)};
    };
    std::error_code status;
    if (!fs::exists(path, status)) return problem("there is no such file", "check the path and its spelling");
    if (fs::is_directory(path, status)) return problem("is a folder, not a picture", "name a picture in it");
    if (!fs::is_regular_file(path, status)) return problem("is not a regular file", "check the path");
    if (!std::ifstream(path, std::ios::binary)) return problem("cannot be read", "check its permissions");
    if (fs::file_size(path, status) == 0) return problem("is empty", "write it again");
    return std::nullopt;
}

Result<PictureHeader> read_picture_header(const PictureSource& source) {
    POL_TRY(const Format* format, format_of(source));
    return format->read_header(source);
}

Result<StokesImage> read_picture(const PictureSource& source, const ReadProgress& progress) {
    POL_TRY(const Format* format, format_of(source));
    return format->read(source, progress);
}

}  // namespace pol
