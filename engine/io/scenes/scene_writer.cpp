// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "core/number_text.h"
#include "core/overloaded.h"
#include "core/units.h"
#include "io/files/assets.h"
#include "io/scenes/index_file.h"
#include "io/scenes/scene_file.h"
#include "scene/medium_fields.h"
#include "scene/setting_table.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

/// Degrees if they read back as the same radians, else radians.
std::string angle_text(double angle_rad) {
    const double angle_deg = degrees(angle_rad);
    if (radians(angle_deg) == angle_rad) return number_text(angle_deg);
    return number_text(angle_rad) + " rad";
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        constexpr std::string_view digits = "0123456789abcdef";
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (code < 0x20 || code == 0x7f) {
            result += "\\x";
            result += digits[code >> 4U];
            result += digits[code & 15U];
        } else {
            result += c;
        }
    }
    return result + "\"";
}

std::string list_text(const std::vector<std::string>& items) {
    std::string text = "[";
    for (const std::string& item : items) text += (text.size() > 1 ? ", " : "") + item;
    return text + "]";
}

std::string list_text(const std::vector<double>& values) {
    std::vector<std::string> items;
    for (const double value : values) items.push_back(number_text(value));
    return list_text(items);
}

std::string vec_text(const DVec2& v) {
    return list_text(std::vector<double>{v.x, v.y});
}

std::string vec_text(const DVec3& v) {
    return list_text(std::vector<double>{v.x, v.y, v.z});
}

std::string table_text(const std::vector<double>& x, const std::vector<double>& y) {
    std::vector<std::string> rows;
    for (std::size_t i = 0; i < x.size(); ++i) rows.push_back(vec_text(DVec2(x[i], y[i])));
    return list_text(rows);
}

std::string spectrum_text(const Spectrum& spectrum) {
    return std::visit(
        Overloaded{
            [](const ConstantSpectrum& s) { return number_text(s.value); },
            [](const D65Spectrum& s) { return "{d65: " + number_text(s.scale) + "}"; },
            [](const TabulatedSpectrum& s) { return "{table: " + table_text(s.wavelength_nm, s.value) + "}"; },
        },
        spectrum);
}

std::string block_text(const IndexBlock& block) {
    return std::visit(Overloaded{
                          [](const DispersionFormula& f) {
                              return "formula: " + std::to_string(f.number) +
                                     ", coefficients: " + list_text(f.coefficients) +
                                     ", range: " + vec_text(DVec2(f.min_nm, f.max_nm));
                          },
                          [](const IndexTable& t) { return "table: " + table_text(t.wavelength_nm, t.value); },
                      },
                      block);
}

std::string extinction_text(const IndexTable& k) {
    return "k: " + table_text(k.wavelength_nm, k.value);
}

std::string index_text(const RefractiveIndex& index) {
    if (const auto* constant = std::get_if<ConstantIndex>(&index)) {
        return vec_text(DVec2(constant->value.n, constant->value.k));
    }
    const auto& dispersive = std::get<DispersiveIndex>(index);
    if (!dispersive.name.empty()) {
        const Result<RefractiveIndex> record = load_index(dispersive.name, assets_dir());
        if (record && record.value() == index) return quoted(dispersive.name);
    }
    std::string text = "{";
    if (!dispersive.name.empty()) text += "name: " + quoted(dispersive.name) + ", ";
    text += block_text(dispersive.n);
    if (!dispersive.k.value.empty()) text += ", " + extinction_text(dispersive.k);
    std::vector<std::string> more;
    for (const IndexBlock& n : dispersive.more_n) more.push_back("{" + block_text(n) + "}");
    for (const IndexTable& k : dispersive.more_k) more.push_back("{" + extinction_text(k) + "}");
    if (!more.empty()) text += ", more: " + list_text(more);
    return text + "}";
}

std::string medium_text(const Medium& medium) {
    std::string text;
    const auto add = [&](const auto& row, const std::string& value) {
        text.append(text.empty() ? "{" : ", ").append(row.key).append(": ").append(value);
    };
    for_each_field(medium.matter,
                   Overloaded{
                       [&](const auto& row, const RefractiveIndex& index) { add(row, index_text(index)); },
                       [&](const auto& row, const Absorption& absorption) { add(row, spectrum_text(absorption)); },
                       [&](const auto& row, const DVec3& axis) { add(row, vec_text(axis)); },
                       [&](const auto& row, AxisSpace space) {
                           add(row, std::string(axis_space_words[static_cast<std::size_t>(space)]));
                       },
                   });
    return text + "}";
}

std::string shape_text(const Shape& shape) {
    return std::visit(
        Overloaded{
            [](const BrilliantShape& s) {
                return "{brilliant: {diameter: " + number_text(s.diameter) +
                       ", table_ratio: " + number_text(s.table_ratio) + ", crown_angle: " + angle_text(s.crown_angle) +
                       ", pavilion_angle: " + angle_text(s.pavilion_angle) +
                       ", girdle_ratio: " + number_text(s.girdle_ratio) +
                       ", star_length: " + number_text(s.star_length) +
                       ", lower_half_length: " + number_text(s.lower_half_length) + "}}";
            },
            [](const BoxShape& s) { return "{box: {size: " + vec_text(s.size) + "}}"; },
            [](const ExtrusionShape& s) {
                std::vector<std::string> corners;
                for (const DVec2& corner : s.polygon) corners.push_back(vec_text(corner));
                return "{extrusion: {polygon: " + list_text(corners) + ", height: " + number_text(s.height) + "}}";
            },
            [](const PrismShape& s) {
                return "{prism: {apex_angle: " + angle_text(s.apex_angle) + ", side: " + number_text(s.side) +
                       ", height: " + number_text(s.height) + "}}";
            },
            [](const RhombShape& s) {
                return "{rhomb: {angle: " + angle_text(s.angle) + ", aperture: " + number_text(s.aperture) +
                       ", height: " + number_text(s.height) + "}}";
            },
            [](const SphereShape& s) { return "{sphere: {radius: " + number_text(s.radius) + "}}"; },
            [](const RectangleShape& s) { return "{rectangle: {size: " + vec_text(s.size) + "}}"; },
            [](const DiskShape& s) { return "{disk: {radius: " + number_text(s.radius) + "}}"; },
            [](const MeshShape& s) { return "{mesh: {file: " + quoted(s.path) + "}}"; },
        },
        shape);
}

std::string sheet_text(const Sheet& sheet) {
    return std::visit(Overloaded{
                          [](const LinearPolarizer& s) {
                              return "{polarizer: {axis: " + vec_text(s.axis) +
                                     (s.model == PolarizerModel::passing ? ", model: passing}}" : "}}");
                          },
                          [](const Retarder& s) {
                              return "{retarder: {fast_axis: " + vec_text(s.fast_axis) +
                                     ", retardance: " + angle_text(s.retardance) + "}}";
                          },
                          [](const CircularPolarizer& s) {
                              return std::string("{circular: {passes: ") +
                                     (s.passes == Handedness::right ? "right" : "left") + "}}";
                          },
                      },
                      sheet);
}

std::string state_text(const EmittedState& state) {
    return std::visit(Overloaded{
                          [](const Unpolarized&) { return std::string("unpolarized"); },
                          [](const FixedState& s) {
                              return "{stokes: " + vec_text(DVec3(s.s1, s.s2, s.s3)) +
                                     ", x_axis: " + vec_text(s.x_axis) + "}";
                          },
                          [](const CrystalPlateState& s) {
                              return "{crystal_plate: {medium: " + quoted(s.medium) + ", axis: " + vec_text(s.axis) +
                                     ", ray: " + (s.passed == CrystalRay::ordinary ? "o" : "e") +
                                     ", fresnel: " + (s.fresnel ? "on" : "off") + "}}";
                          },
                      },
                      state);
}

std::string emission_text(const Emission& emission) {
    const std::string radiance =
        std::visit(Overloaded{
                       [](const Spectrum& s) { return spectrum_text(s); },
                       [](const TexturedRadiance& t) {
                           return "{texture: " + quoted(t.path) + ", scale: " + number_text(t.scale) + "}";
                       },
                   },
                   emission.radiance);
    return "{radiance: " + radiance + ", polarization: " + state_text(emission.state) +
           ", two_sided: " + (emission.two_sided ? "on" : "off") + "}";
}

std::string black_text(const std::vector<DVec3>& faces) {
    std::vector<std::string> directions;
    for (const DVec3& face : faces) directions.push_back(vec_text(face));
    return faces.empty() ? "" : "\n    black: " + list_text(directions);
}

std::string role_text(const Role& role) {
    return std::visit(Overloaded{
                          [](const FilledWith& r) { return "medium: " + quoted(r.medium) + black_text(r.black_faces); },
                          [](const Emission& r) { return "emission: " + emission_text(r); },
                          [](const Sheet& r) { return "sheet: " + sheet_text(r); },
                          [](const Absorber&) { return std::string("absorber: on"); },
                      },
                      role);
}

std::string matrix_text(const DMat4& m) {
    std::vector<std::string> rows;
    for (int row = 0; row < 3; ++row) {
        rows.push_back(list_text(std::vector<double>{m[0][row], m[1][row], m[2][row], m[3][row]}));
    }
    return list_text(rows);
}

std::string camera_text(const Camera& camera) {
    const bool perspective = camera.projection == Projection::perspective;
    return std::string("camera:\n") + "  type: " + (perspective ? "perspective" : "orthographic") +
           "\n  position: " + vec_text(camera.position) + "\n  target: " + vec_text(camera.target) +
           "\n  up: " + vec_text(camera.up) +
           (perspective ? "\n  fov: " + angle_text(camera.horizontal_fov) : "\n  width: " + number_text(camera.width)) +
           "\n";
}

std::string text_if_set(const std::optional<int>& number) {
    return number ? std::to_string(*number) : std::string();
}

/// Empty: it is not written, which means the same.
std::string setting_text(const RenderSetting& setting, const RenderSettings& render) {
    return std::visit(Overloaded{
                          [&](const SizeSetting& kind) {
                              return "[" + std::to_string(render.*kind.width) + ", " +
                                     std::to_string(render.*kind.height) + "]";
                          },
                          [&](const WavelengthsSetting& kind) { return list_text(render.*kind.nm); },
                          [&](const ChoiceSetting& kind) {
                              return std::string(kind.words[static_cast<std::size_t>(kind.get(render))]);
                          },
                          [&](const WholeSetting& kind) { return std::to_string(render.*kind.value); },
                          [&](const LimitSetting& kind) { return text_if_set(render.*kind.value); },
                          [&](const UsualSetting& kind) { return text_if_set(render.*kind.value); },
                          [&](const UsualNumberSetting& kind) {
                              const std::optional<double>& number = render.*kind.value;
                              return number ? number_text(*number) : std::string();
                          },
                          [&](const SeedSetting& kind) { return std::to_string(render.*kind.value); },
                          [&](const FlagSetting& kind) { return std::string(render.*kind.value ? "on" : ""); },
                      },
                      setting.kind);
}

std::string render_text(const RenderSettings& render) {
    std::string text = "render:\n";
    for (const RenderSetting& setting : render_settings()) {
        const std::string value = setting_text(setting, render);
        if (!value.empty()) text.append("  ").append(setting.key).append(": ").append(value).append("\n");
    }
    return text;
}

/// How a scene file in `folder` names `file` so that find_asset() finds it there: `kind` as there.
std::string name_from(const fs::path& folder, const std::string& file, const std::string& kind) {
    std::error_code failed;
    for (const fs::path& shipped : {assets_dir() / kind, assets_dir()}) {
        const fs::path name = fs::relative(file, shipped, failed);
        const bool inside = !failed && !name.empty() && *name.begin() != "..";
        if (inside && !fs::exists(folder / name, failed)) return name.generic_string();
    }
    const fs::path name = fs::relative(file, folder, failed);
    return failed || name.empty() ? file : name.generic_string();
}

}  // namespace

std::string save_scene(Scene scene, const fs::path& folder) {
    for (Object& object : scene.objects) {
        if (auto* mesh = std::get_if<MeshShape>(&object.shape)) mesh->path = name_from(folder, mesh->path, "scenes");
        auto* emission = std::get_if<Emission>(&object.role);
        auto* textured = emission != nullptr ? std::get_if<TexturedRadiance>(&emission->radiance) : nullptr;
        if (textured != nullptr) textured->path = name_from(folder, textured->path, "textures");
    }
    return save_scene(scene);
}

std::string save_scene(const Scene& scene) {
    std::string text;
    if (!scene.title.empty()) text += "title: " + quoted(scene.title) + "\n";
    text += "unit: " + number_text(scene.unit_nm) + "  # nm\n";
    text += camera_text(scene.camera);
    text += render_text(scene.render);
    text += "background: " + spectrum_text(scene.background.radiance) + "\n";
    if (!scene.ambient.empty()) text += "ambient: " + quoted(scene.ambient) + "\n";
    if (!scene.media.empty()) text += "media:\n";
    for (const Medium& medium : scene.media) text += "  " + quoted(medium.name) + ": " + medium_text(medium) + "\n";
    text += scene.objects.empty() ? "objects: []\n" : "objects:\n";
    for (const Object& object : scene.objects) {
        text += "  - name: " + quoted(object.name) + "\n    shape: " + shape_text(object.shape) + "\n";
        if (object.to_world != DMat4(1.0)) text += "    transform: [{matrix: " + matrix_text(object.to_world) + "}]\n";
        text += "    " + role_text(object.role) + "\n";
        if (object.priority) text += "    priority: " + std::to_string(*object.priority) + "\n";
    }
    return text;
}

}  // namespace pol
