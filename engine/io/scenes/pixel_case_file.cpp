// SPDX-License-Identifier: Apache-2.0
#include "io/scenes/pixel_case_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/number_text.h"
#include "core/result.h"
#include "io/files/input_file.h"
#include "io/files/yaml_value.h"
#include "io/scenes/scene_file.h"

namespace pol {

namespace {

/// Into `result`: everything above the line of dashes, checked against the scene below it.
void read_head(const std::string& head, const YamlFile& file, PixelCase& result) {
    const YamlMap map = yaml_document(head, file).map({"pixel", "sample", "wavelength", "expected", "tolerance"});
    const RenderSettings& render = result.scene.render;
    const DVec2 pixel = map.at("pixel").vec2();
    result.x = static_cast<int>(pixel.x);
    result.y = static_cast<int>(pixel.y);
    if (result.x != pixel.x || result.y != pixel.y || result.x < 0 || result.y < 0 || result.x >= render.width ||
        result.y >= render.height)
        map.at("pixel").fail("the picture has no such pixel",
                             fmt::format("[0, 0] (top left) to [{}, {}]", render.width - 1, render.height - 1));
    const int sample = map.has("sample") ? map.at("sample").whole() : 0;
    if (sample < 0 || sample > render.last_sample())
        map.at("sample").fail(fmt::format("there is no sample {}", sample),
                              fmt::format("0 to {}", render.last_sample()));
    result.sample = static_cast<std::uint32_t>(sample);
    result.wavelength_nm = map.at("wavelength").number();
    if (std::find(render.wavelengths_nm.begin(), render.wavelengths_nm.end(), result.wavelength_nm) ==
        render.wavelengths_nm.end())
        map.at("wavelength").fail("not among the wavelengths of the scene", "see render: wavelengths");
    const YamlMap expected = map.at("expected").map({"xx", "yy", "xy"});
    const DVec2 xy = expected.at("xy").vec2();
    result.expected = {expected.at("xx").number(), expected.at("yy").number(), {xy.x, xy.y}};
    if (const auto tolerance = map.find("tolerance")) {
        result.tolerance = tolerance->number();
        if (result.tolerance < 0.0) tolerance->fail("a tolerance is not negative", "0 asks for equal bits");
    }
}

}  // namespace

Result<PixelCase> load_pixel_case(const std::filesystem::path& path) {
    POL_TRY(const auto text, read_input_file(path, std::uintmax_t{16} << 20U));
    std::size_t cut = std::string::npos;
    std::size_t scene_begin = 0;
    for (const std::string_view dashes : {"\n---\n", "\n---\r\n"}) {
        const std::size_t found = text.find(dashes);
        if (found >= cut) continue;
        cut = found;
        scene_begin = found + dashes.size();
    }
    if (cut == std::string::npos)
        return Error{ErrorKind::input,
                     "this is no pixel case: there is no line '---' between the case and its scene",
                     {path.string()},
                     {},
                     "a scene is explained without --case"};
    const std::string head = text.substr(0, cut + 1);
    // Empty lines instead of the head: messages about the scene then have the lines of this file.
    const std::string scene_text =
        std::string(static_cast<std::size_t>(std::count(head.begin(), head.end(), '\n')) + 1, '\n') +
        text.substr(scene_begin);
    POL_TRY(auto scene, parse_scene(scene_text, path.string(), path.parent_path()));
    PixelCase result;
    result.scene = std::move(scene);
    try {
        read_head(head, YamlFile{path.string(), 0, nullptr}, result);
    } catch (const YamlComplaint& complaint) {
        return complaint.error;
    }
    return result;
}

std::string save_pixel_case(const PixelCase& c, const std::filesystem::path& folder) {
    const auto text = [](double value) {
        POL_EXPECTS(std::isfinite(value));
        return number_text(value);
    };
    return fmt::format(
               "# A pixel and the coherence matrix that it must have. polariscope explain --case FILE checks it.\n"
               "pixel: [{}, {}]\nsample: {}\nwavelength: {}\nexpected: {{xx: {}, yy: {}, xy: [{}, {}]}}\ntolerance: "
               "{}\n---\n",
               c.x, c.y, c.sample, text(c.wavelength_nm), text(c.expected.xx), text(c.expected.yy),
               text(c.expected.xy.re), text(c.expected.xy.im), text(c.tolerance)) +
           save_scene(c.scene, folder);
}

}  // namespace pol
