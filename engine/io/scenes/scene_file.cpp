// SPDX-License-Identifier: Apache-2.0
#include "io/scenes/scene_file.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "core/overloaded.h"
#include "core/result.h"
#include "io/files/assets.h"
#include "io/files/input_file.h"
#include "io/files/yaml_value.h"
#include "io/scenes/scene_reader.h"
#include "scene/check.h"
#include "scene/setting_table.h"
#include "spectrum/wavelength_grid.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

/// A scene is written by hand; more than this is another kind of file.
constexpr std::uintmax_t max_scene_bytes = 16 << 20;

Error file_error(const fs::path& path, std::string what, std::string hint) {
    return {ErrorKind::input, std::move(what), {path.string(), 0, 0}, {}, std::move(hint)};
}

/// Everything that reading one scene and its includes shares.
struct OpenScene {
    Scene scene;
    std::map<std::string, Place> places;
    fs::path assets;
    std::vector<fs::path> chain;  ///< canonical paths of the files being read, outermost first
};

Camera read_camera(const YamlValue& value) {
    const YamlMap map = value.map({"type", "position", "target", "up", "fov", "width"});
    Camera camera;
    camera.place = value.place();
    camera.position = map.at("position").vec3();
    camera.target = map.at("target").vec3();
    const auto up = map.find("up");
    camera.up = up ? up->vec3() : DVec3(0.0, 0.0, 1.0);
    const auto type = map.find("type");
    if (type && type->choice({"perspective", "orthographic"}) == "orthographic") {
        camera.projection = Projection::orthographic;
        if (map.has("fov")) map.at("fov").fail("an orthographic camera has no field of view", "write width instead");
        camera.width = map.at("width").number();
    } else {
        if (map.has("width")) map.at("width").fail("a perspective camera has no width", "write fov instead");
        camera.horizontal_fov = map.at("fov").angle();
    }
    return camera;
}

std::vector<double> read_wavelengths(const YamlValue& value) {
    if (value.is_list()) return value.numbers();
    if (value.looks_like_number()) return {value.number()};
    Result<std::vector<double>> grid = parse_wavelengths(value.is_scalar() ? value.text() : std::string());
    if (!grid) value.fail(grid.error().what, grid.error().hint);
    return std::move(grid).value();
}

void read_size(const SizeSetting& kind, const YamlValue& value, RenderSettings& render) {
    const std::vector<YamlValue> sides = value.list();
    if (sides.size() != 2) value.fail("expected two whole numbers", "write [width, height] in pixels");
    render.*kind.width = sides[0].whole();
    render.*kind.height = sides[1].whole();
}

void read_setting(const RenderSetting& setting, const YamlValue& value, RenderSettings& render) {
    std::visit(Overloaded{
                   [&](const SizeSetting& kind) { read_size(kind, value, render); },
                   [&](const WavelengthsSetting& kind) { render.*kind.nm = read_wavelengths(value); },
                   [&](const ChoiceSetting& kind) { kind.set(render, value.choice_of(kind.words)); },
                   [&](const WholeSetting& kind) { render.*kind.value = value.whole(); },
                   [&](const LimitSetting& kind) { (render.*kind.impose)(value.whole()); },
                   [&](const UsualSetting& kind) { render.*kind.value = value.whole(); },
                   [&](const UsualNumberSetting& kind) { render.*kind.value = value.number(); },
                   [&](const SeedSetting& kind) { render.*kind.value = value.natural64(); },
                   [&](const FlagSetting& kind) { render.*kind.value = value.truth(); },
               },
               setting.kind);
}

RenderSettings read_render(const YamlValue& value) {
    std::vector<std::string_view> keys;
    for (const RenderSetting& setting : render_settings()) keys.push_back(setting.key);
    const YamlMap map = value.map(keys);
    RenderSettings render;
    for (const RenderSetting* setting : settings_in_order_of_effect()) {
        if (const auto found = map.find(std::string(setting->key))) read_setting(*setting, *found, render);
    }
    return render;
}

double read_unit(const YamlValue& value) {
    if (value.looks_like_number()) return value.number();
    const std::string unit = value.choice({"nm", "um", "mm", "cm", "m"});
    return unit == "nm" ? 1.0 : unit == "um" ? 1e3 : unit == "mm" ? 1e6 : unit == "cm" ? 1e7 : 1e9;
}

void read_include(OpenScene& open, const YamlValue& value, const AssetFolders& folders);

/// Media and objects of one file, then those of its includes.
void read_contents(OpenScene& open, const YamlMap& map, const fs::path& folder) {
    const AssetFolders folders{folder, open.assets};
    if (const auto media = map.find("media")) {
        for (const auto& [name, value] : media->entries()) {
            open.scene.media.push_back(read_medium(name, value, folders));
        }
    }
    if (const auto objects = map.find("objects")) {
        const std::size_t first = open.scene.objects.size();
        for (const YamlValue& value : objects->list(first)) {
            open.scene.objects.push_back(read_object(value, folders));
        }
    }
    if (const auto include = map.find("include")) {
        for (const YamlValue& file : include->list()) read_include(open, file, folders);
    }
}

std::string chain_text(const std::vector<fs::path>& chain, const fs::path& last) {
    std::string text;
    for (const fs::path& path : chain) text += path.filename().string() + " -> ";
    return text + last.filename().string();
}

void read_include(OpenScene& open, const YamlValue& value, const AssetFolders& folders) {
    const fs::path path = find_asset(value, folders, "scenes");
    const fs::path canonical = fs::canonical(path);
    if (std::find(open.chain.begin(), open.chain.end(), canonical) != open.chain.end()) {
        value.fail("the file includes itself: " + chain_text(open.chain, canonical), "remove this include");
    }
    const Result<std::string> text = read_scene_text(path);
    if (!text) value.fail(text.error().what, text.error().hint);

    const YamlFile file{path.string(), static_cast<int>(open.scene.files.size()), &open.places};
    open.scene.files.push_back(file.name);
    open.chain.push_back(canonical);
    read_contents(open, yaml_document(text.value(), file).map({"include", "media", "objects"}), path.parent_path());
    open.chain.pop_back();
}

/// Place of the value that `field` names, or of the nearest value that contains it.
Place place_of_field(const std::map<std::string, Place>& places, std::string field) {
    while (true) {
        const auto found = places.find(field);
        if (found != places.end()) return found->second;
        const std::size_t end = field.find_last_of(".[");
        if (end == std::string::npos) return {};
        field.resize(end);
    }
}

Scene read_scene(OpenScene& open, const std::string& text, const std::string& file_name, const fs::path& base_dir) {
    const YamlFile file{file_name, 0, &open.places};
    open.scene.files = {file_name};
    std::error_code error;
    const fs::path canonical = fs::canonical(file_name, error);
    open.chain = {error ? fs::path(file_name) : canonical};

    const YamlMap map =
        yaml_document(text, file)
            .map({"title", "unit", "include", "camera", "render", "background", "ambient", "media", "objects"});
    Scene& scene = open.scene;
    if (const auto title = map.find("title")) scene.title = title->text();
    if (const auto unit = map.find("unit")) scene.unit_nm = read_unit(*unit);
    scene.camera = read_camera(map.at("camera"));
    if (const auto render = map.find("render")) scene.render = read_render(*render);
    if (const auto background = map.find("background")) {
        scene.background = {read_spectrum(*background), background->place()};
    }
    if (const auto ambient = map.find("ambient")) scene.ambient = ambient->text();
    static_cast<void>(map.at("objects"));
    read_contents(open, map, base_dir);

    if (std::optional<Error> problem = first_problem(scene)) {
        const Place place = place_of_field(open.places, problem->field);
        if (place.line > 0) problem->place = place;
        if (problem->place.file.empty()) problem->place.file = file_name;
        throw YamlComplaint{*problem};
    }
    return std::move(scene);
}

}  // namespace

Result<std::string> read_scene_text(const fs::path& path) {
    return read_input_file(path, max_scene_bytes);
}

Result<Scene> parse_scene(const std::string& text, const std::string& file_name, const fs::path& base_dir) {
    OpenScene open;
    try {
        open.assets = assets_dir();
        return read_scene(open, text, file_name, base_dir);
    } catch (const YamlComplaint& complaint) {
        return complaint.error;
    } catch (const std::exception& error) {
        return file_error(file_name, std::string("cannot be read as a scene: ") + error.what(),
                          "assets/scenes/README.md shows the format");
    }
}

Result<Scene> load_scene(const fs::path& path) {
    POL_TRY(const auto text, read_scene_text(path));
    return parse_scene(text, path.string(), path.parent_path());
}

}  // namespace pol
