// SPDX-License-Identifier: Apache-2.0
// Stokes pictures with an EXR file for each component.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "io/pictures/convention_text.h"
#include "io/pictures/exr_picture.h"
#include "io/pictures/picture_reading.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

/// The files of S0 to S3; empty where not measured.
struct FourFiles {
    std::array<fs::path, 4> paths;
    std::string layout;  ///< for PictureOrigin
};

constexpr std::array<std::string_view, 4> lettered_ends{"I", "Q", "U", "V"};
constexpr std::array<std::string_view, 4> numbered_ends{"S0", "S1", "S2", "S3"};

std::string lower_case(std::string_view text) {
    std::string lower;
    for (const char c : text) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

/// The four names of which `path` is one: x_I.exr, x_S0.exr or x.s0.exr, in any case; none if it has no such ending.
std::optional<std::array<fs::path, 4>> companions(const fs::path& path) {
    const std::string stem = path.stem().string();
    for (const auto& [marks, separators] : {std::pair{numbered_ends, "_."}, std::pair{lettered_ends, "_"}}) {
        for (const std::string_view mark : marks) {
            if (stem.size() < mark.size() + 2) continue;
            const std::string_view end = std::string_view(stem).substr(stem.size() - mark.size());
            const std::string begin = stem.substr(0, stem.size() - mark.size());
            if (lower_case(end) != lower_case(mark) ||
                std::string_view(separators).find(begin.back()) == std::string_view::npos)
                continue;
            const bool is_lower = std::islower(static_cast<unsigned char>(end[0])) != 0;
            std::array<fs::path, 4> paths;
            for (std::size_t s = 0; s < paths.size(); ++s)
                paths[s] = path.parent_path() / (begin + (is_lower ? lower_case(marks[s]) : std::string(marks[s])) +
                                                 path.extension().string());
            return paths;
        }
    }
    return std::nullopt;
}

/// Of a file with the ending of a component: its companions, or none if it is a picture of its own. Error: some of them
/// are missing, or it is of a program that always writes four.
Result<std::optional<FourFiles>> found_beside(const fs::path& path, bool is_certain) {
    const auto paths = companions(path);
    if (!paths) {
        if (!is_certain) return std::optional<FourFiles>();
        return input_error(
            "is one of four files by --layout, but its name does not end in _I, _Q, _U, _V or _S0 to _S3",
            "name the files: --stokes s0=FILE,s1=FILE,s2=FILE,s3=FILE", path);
    }
    POL_TRY(const exr::Label label, exr::read_label(path));
    if (!find_component_channels(label.channels) && !is_certain) return std::optional<FourFiles>();
    const bool is_wave_tracer = label.renderer.starts_with("wave_tracer");
    std::error_code status;
    const auto is_there = [&](const fs::path& companion) { return fs::is_regular_file(companion, status); };
    const auto count = std::count_if(paths->begin(), paths->end(), is_there);
    if (count == 1 && !is_wave_tracer && !is_certain) return std::optional<FourFiles>();
    if (count < 4) {
        const auto missing = std::find_if_not(paths->begin(), paths->end(), is_there);
        return input_error(fmt::format("is one of four files, of which {} is missing", missing->filename().string()),
                           "put it beside this file, or name those that are there: --stokes s0=FILE,s1=FILE,s2=FILE",
                           path);
    }
    return std::optional(FourFiles{*paths, is_wave_tracer ? "wave_tracer, four files" : "four files"});
}

Result<std::optional<FourFiles>> four_files_of(const PictureSource& source) {
    const auto is_named = [](const fs::path& path) { return !path.empty(); };
    if (std::any_of(source.stokes_files.begin(), source.stokes_files.end(), is_named)) {
        if (source.stokes_files[0].empty())
            return Error{ErrorKind::usage, "S0 has no file", {}, "--stokes", "s0=FILE is needed, the others are not"};
        return std::optional(FourFiles{source.stokes_files, "files named one by one"});
    }
    const bool is_certain = source.layout == "four" || source.layout == "wave_tracer";
    if (!is_certain && !source.layout.empty()) return std::optional<FourFiles>();
    return found_beside(source.files.front(), is_certain);
}

PictureOrigin origin_of(const FourFiles& files) {
    PictureOrigin origin;
    origin.layout = files.layout;
    if (!files.paths[1].empty() || !files.paths[2].empty()) origin.assumed.emplace_back(assumed_axes);
    if (!files.paths[3].empty()) origin.assumed.emplace_back(assumed_handedness);
    return origin;
}

std::vector<std::string> labels_of(const std::vector<Band>& bands) {
    std::vector<std::string> labels;
    for (const Band& band : bands) labels.push_back(band.label());
    return labels;
}

/// A single channel has any name: I in one file and Q in the next.
bool same_bands(const std::vector<Band>& a, const std::vector<Band>& b) {
    return (a.size() == 1 && b.size() == 1) || labels_of(a) == labels_of(b);
}

constexpr exr::Wish one_component{{}, true};

/// The convention that all files name; none if none does. Error: some do, or they name others.
Result<std::optional<StokesConvention>> convention_of_files(const FourFiles& files) {
    std::optional<std::string> text;
    for (const fs::path& path : files.paths) {
        if (path.empty()) continue;
        POL_TRY(const exr::Label label, exr::read_label(path));
        if (text.value_or(label.convention) != label.convention)
            return input_error(
                fmt::format("has its numbers in another convention than {}", files.paths[0].filename().string()),
                "the files of a picture have one convention: convert it again", path);
        text = label.convention;
    }
    return convention_of(text.value_or(""));
}

Result<PictureHeader> header_of(const FourFiles& files) {
    POL_TRY(PictureHeader whole, exr::read_header(files.paths[0], one_component));
    StokesComponents known = StokesComponents::s0();
    bool is_left_handed = false;
    for (unsigned s = 1; s < 4; ++s) {
        const fs::path& path = files.paths[s];
        if (path.empty()) continue;
        POL_TRY(const PictureHeader one, exr::read_header(path, one_component));
        const std::string s0 = files.paths[0].filename().string();
        if (one.width != whole.width || one.height != whole.height)
            return input_error(
                fmt::format("has {} x {} pixels, {} {} x {}", one.width, one.height, s0, whole.width, whole.height),
                "the files of a picture have one size", path);
        if (!same_bands(one.bands, whole.bands))
            return input_error(fmt::format("does not have the channels of {}", s0),
                               "each file has R, G and B, or one channel", path);
        known = known.with(s);
        if (s == 3) is_left_handed = one.origin.convention.left_handed;
    }
    const bool has_no_band_name = whole.bands.size() == 1;
    for (Band& band : whole.bands) {
        band.known = known;
        if (has_no_band_name) band.name = "mono";
    }
    whole.origin = origin_of(files);
    whole.origin.convention.left_handed = is_left_handed;
    if (is_left_handed) std::erase(whole.origin.assumed, assumed_handedness);
    POL_TRY(const auto convention, convention_of_files(files));
    if (convention) {
        whole.origin.convention = *convention;
        whole.origin.assumed.clear();
    }
    return whole;
}

void add_component(StokesImage& whole, const StokesImage& one, std::size_t s) {
    const auto component = exr::stokes_layers[s].component;
    for (std::size_t i = 0; i < whole.stokes.size(); ++i) whole.stokes[i].*component = one.stokes[i].s0;
    whole.stored.bits = std::min(whole.stored.bits, one.stored.bits);
    whole.stored.spacing = std::max(whole.stored.spacing, one.stored.spacing);
    if (whole.stored.lossy.empty()) whole.stored.lossy = one.stored.lossy;
}

Result<StokesImage> read_four(const FourFiles& files, const ReadProgress& progress) {
    POL_TRY(PictureHeader header, header_of(files));
    const auto count = static_cast<double>(
        std::count_if(files.paths.begin(), files.paths.end(), [](const fs::path& path) { return !path.empty(); }));
    double done = 0.0;
    const auto share = [&](double of_file) { return !progress || progress((done + of_file) / count); };
    POL_TRY(StokesImage whole, exr::read_one(files.paths[0], one_component, share));
    for (std::size_t s = 1; s < files.paths.size(); ++s) {
        if (files.paths[s].empty()) continue;
        done += 1.0;
        POL_TRY(const StokesImage one, exr::read_one(files.paths[s], one_component, share));
        if (one.stokes.size() != whole.stokes.size() || one.left != whole.left || one.top != whole.top)
            return input_error(fmt::format("does not lie where {} does", files.paths[0].filename().string()),
                               "the files of a picture have one data window", files.paths[s]);
        add_component(whole, one, s);
    }
    whole.bands = std::move(header.bands);
    whole.origin = std::move(header.origin);
    whole.attributes.clear();
    for (Stokes<double>& s : whole.stokes) s = whole.origin.convention.to_ours(s);
    return whole;
}

/// A lone x_Q.exr may be a picture of that name: it is shown, and that is said.
void doubt_name(const fs::path& path, PictureOrigin& origin, const std::vector<Band>& bands) {
    const auto paths = companions(path);
    const bool has_s0_alone =
        std::all_of(bands.begin(), bands.end(), [](const Band& band) { return band.known == StokesComponents::s0(); });
    if (paths && has_s0_alone && path.filename() != paths->front().filename())
        origin.assumed.push_back(
            fmt::format("this is a picture of S0: {} is not beside it", paths->front().filename().string()));
}

std::optional<Error> set_problem(const PictureSource& source) {
    if (source.angles_deg.empty() && source.files.size() <= 1) return std::nullopt;
    return Error{ErrorKind::usage,
                 "pictures behind polarizers are not read from EXR files",
                 Place{source.path().string()},
                 {},
                 "write them as PNG of 16 bits, or name one picture"};
}

constexpr std::array<PictureLayout, 8> layouts{
    {{"spectral", "EXR: S0.580,000000nm and so on (Fichet, Pacanowski & Wilkie 2021), ours too"},
     {"mitsuba", "EXR: S0.R to S3.B, as Mitsuba 3 writes them"},
     {"mitsuba-array", "EXR: ch00 to ch11 .. ch15, an array of Mitsuba 3 saved without names"},
     {"named", "EXR: S0.NAME to S3.NAME of any bands"},
     {"bare", "EXR: S0 to S3, or I, Q, U, V, behind any layer name"},
     {"wave_tracer", "EXR: x_I.exr, x_Q.exr, x_U.exr and x_V.exr beside each other"},
     {"four", "EXR: x_S0.exr to x_S3.exr, x.s0.exr .., or x_I.exr .., of any program"},
     {"plain", "EXR: R, G and B, Y, or a single channel: a picture without polarization"}}};

}  // namespace

bool is_exr_picture(const PictureSource& source) {
    const auto is_exr = [](const fs::path& path) { return is_exr_file(path); };
    return std::any_of(source.files.begin(), source.files.end(), is_exr) ||
           std::any_of(source.stokes_files.begin(), source.stokes_files.end(), is_exr);
}

Result<StokesImage> read_exr_picture(const PictureSource& source, const ReadProgress& progress) {
    if (const auto problem = set_problem(source)) return *problem;
    POL_TRY(const auto four, four_files_of(source));
    if (four) return read_four(*four, progress);
    POL_TRY(StokesImage image, exr::read_one(source.files.front(), {source.layout}, progress));
    if (source.layout.empty()) doubt_name(source.files.front(), image.origin, image.bands);
    return image;
}

Result<PictureHeader> read_exr_picture_header(const PictureSource& source) {
    if (const auto problem = set_problem(source)) return *problem;
    POL_TRY(const auto four, four_files_of(source));
    if (four) return header_of(*four);
    POL_TRY(PictureHeader header, exr::read_header(source.files.front(), {source.layout}));
    if (source.layout.empty()) doubt_name(source.files.front(), header.origin, header.bands);
    return header;
}

std::span<const PictureLayout> exr_layouts() {
    return layouts;
}

}  // namespace pol
