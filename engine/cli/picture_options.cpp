// SPDX-License-Identifier: Apache-2.0
#include "cli/picture_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>
#include <utility>

#include "cli/messages.h"

namespace pol {

namespace {

/// Where the next "s0=" to "s3=" (or "S0=") begins that stands first or behind a comma: file names may have commas.
std::size_t next_component(std::string_view text, std::size_t from) {
    for (std::size_t at = from; at + 3 <= text.size(); ++at) {
        const bool begins = at == 0 || text[at - 1] == ',';
        if (begins && (text[at] == 's' || text[at] == 'S') && text[at + 1] >= '0' && text[at + 1] <= '3' &&
            text[at + 2] == '=')
            return at;
    }
    return std::string_view::npos;
}

Result<std::array<std::filesystem::path, 4>> parse_stokes(std::string_view text) {
    const auto refuse = [](std::string what) {
        return usage_error("--stokes", std::move(what), "for example s0=i.exr,s1=q.exr,s2=u.exr,s3=v.exr");
    };
    std::array<std::filesystem::path, 4> files;
    if (next_component(text, 0) != 0) return refuse(fmt::format("'{}' does not begin with a component", text));
    for (std::size_t at = 0; at != std::string_view::npos;) {
        const std::size_t next = next_component(text, at + 3);
        const std::size_t end = next == std::string_view::npos ? text.size() : next - 1;
        const std::string_view name = text.substr(at + 3, end - at - 3);
        std::filesystem::path& file = files[static_cast<std::size_t>(text[at + 1] - '0')];
        if (name.empty()) return refuse(fmt::format("s{} has no file", text[at + 1]));
        if (!file.empty()) return refuse(fmt::format("s{} is named twice", text[at + 1]));
        file = name;
        at = next;
    }
    if (files[0].empty()) return refuse("s0 is missing: without it no other component means anything");
    return files;
}

Result<std::vector<double>> parse_angles(std::string_view text) {
    std::vector<double> angles;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(',', at), text.size());
        const std::string_view word = text.substr(at, end - at);
        double angle = 0.0;
        const auto [last, status] = std::from_chars(word.data(), word.data() + word.size(), angle);
        if (status != std::errc() || last != word.data() + word.size() || !std::isfinite(angle))
            return usage_error("--angles", fmt::format("'{}' is no angle", word), "degrees, for example 0,60,120");
        angles.push_back(angle);
        at = end + 1;
    }
    return angles;
}

}  // namespace

StokesConvention ConventionOptions::over(StokesConvention convention) const {
    convention.left_handed = left_handed.value_or(convention.left_handed);
    convention.azimuth_zero_deg = azimuth_zero_deg.value_or(convention.azimuth_zero_deg);
    convention.y_down = y_down.value_or(convention.y_down);
    return convention;
}

void add_convention_options(ProgramCommand command, ConventionOptions& options, const std::string& before,
                            const std::string& whose) {
    const auto add = [&](const std::string& name, const std::vector<std::string>& words, const std::string& what,
                         const std::function<void(std::size_t)>& take) {
        command.add_choice("--" + before + name, words, take, whose + ": " + what);
    };
    add("handedness", {"right", "left"}, "S3 > 0 is this, seen by the receiver, where y points up",
        [&options](std::size_t word) { options.left_handed = word == 1; });
    add("zero", {"right", "up"}, "the azimuth counts from image right or up",
        [&options](std::size_t word) { options.azimuth_zero_deg = word == 1 ? 90.0 : 0.0; });
    add("y", {"up", "down"}, "where y points; down: S2 and S3 have the other sign",
        [&options](std::size_t word) { options.y_down = word == 1; });
}

Result<PictureSource> PictureOptions::source() const {
    PictureSource source;
    source.layout = layout;
    source.files.assign(files.begin(), files.end());
    if (!stokes.empty()) {
        if (!files.empty())
            return usage_error("--stokes", fmt::format("names the picture, and so does '{}'", files.front()),
                               "leave one of them out");
        POL_TRY(source.stokes_files, parse_stokes(stokes));
        if (!angles.empty()) return usage_error("--angles", "does not go with --stokes", "leave one of them out");
        return source;
    }
    if (files.empty()) return usage_error({}, "there is no picture to open", "name a file, or several with --stokes");
    if (!angles.empty()) {
        POL_TRY(source.angles_deg, parse_angles(angles));
        if (source.angles_deg.size() != files.size())
            return usage_error("--angles",
                               fmt::format("{} angles for {} files", source.angles_deg.size(), files.size()),
                               "one angle for each file, in their order");
    } else if (files.size() > 1) {
        return usage_error({}, fmt::format("{} files are named, but one picture is opened", files.size()),
                           "--angles says at which polarizer angle each was taken");
    }
    return source;
}

Result<StokesImage> PictureOptions::read(const ReadProgress& progress) const {
    POL_TRY(const auto from_where, source());
    POL_TRY(auto image, read_picture(from_where, progress));
    if (from.given()) read_in(image, from.over(image.origin.convention));
    return image;
}

void add_picture_options(ProgramCommand command, PictureOptions& options, const std::string& before) {
    command.add_option("--" + before + "layout", options.layout, "How the picture is laid out, if that is not plain")
        .type_name("LAYOUT");
    command.add_option("--" + before + "stokes", options.stokes, "s0=F,s1=F,s2=F,s3=F: one file for each component")
        .type_name("FILES");
    command
        .add_option("--" + before + "angles", options.angles,
                    "A,B,C,...: the files are photographs behind a polarizer at these angles, in degrees")
        .type_name("ANGLES");
    add_convention_options(command, options.from, before + "from-", "What the picture is to be taken for");
}

std::string picture_layouts_text() {
    std::string text = "Layouts:\n";
    for (const PictureLayout& layout : picture_layouts())
        text += fmt::format("  {:<18} {}\n", layout.name, layout.about);
    return text;
}

}  // namespace pol
