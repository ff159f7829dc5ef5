// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/scene_sections.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <vector>

#include "core/number_text.h"
#include "core/units.h"
#include "io/files/assets.h"
#include "io/scenes/index_file.h"
#include "spectrum/wavelength_grid.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

/// Names of the index records that ship with the program.
const std::vector<std::string>& index_records() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> found;
        std::error_code none;
        for (const auto& entry : std::filesystem::directory_iterator(assets_dir() / "refractive_index", none))
            if (entry.path().extension() == ".yml") found.push_back(entry.path().stem().string());
        std::sort(found.begin(), found.end());
        return found;
    }();
    return names;
}

/// A constant that can be dragged, or one of the records.
void index_field(EditForm& form, const std::string& label, RefractiveIndex& index) {
    static const std::string constant = "constant";
    std::vector<std::string> names{constant};
    names.insert(names.end(), index_records().begin(), index_records().end());
    int current = 0;
    if (const auto* dispersive = std::get_if<DispersiveIndex>(&index)) {
        const auto stem = std::filesystem::path(dispersive->name).stem().string();
        const auto found = std::find(names.begin(), names.end(), stem);
        if (found == names.end()) names.push_back(dispersive->name.empty() ? "table in the scene" : dispersive->name);
        current = found == names.end() ? static_cast<int>(names.size()) - 1 : static_cast<int>(found - names.begin());
    }
    const int taken =
        form.choice("record##" + label, current, names, "A constant, or a measured index that follows the wavelength.");
    if (taken == 0) {
        const auto at = index_at(index, form.scene.render.wavelengths_nm.front());
        index = ConstantIndex{at ? at.value() : ComplexIndex{1.5, 0.0}};
        form.apply("record##" + label);
        return;
    }
    if (taken > 0) {
        if (auto record = load_index(names[static_cast<std::size_t>(taken)], assets_dir())) {
            index = std::move(record).value();
            form.apply("record##" + label);
        }
        return;
    }
    if (auto* value = std::get_if<ConstantIndex>(&index))
        form.number(label, value->value.n, 0.002, "Refractive index n.");
}

void absorption_field(EditForm& form, const std::string& label, Absorption& absorption) {
    if (auto* constant = std::get_if<ConstantSpectrum>(&absorption))
        form.number(label, constant->value, 0.01,
                    "Absorption coefficient per scene unit: power falls as exp(-\u03b1 d).");
    else
        ImGui::TextDisabled("%s: a table in the scene", label.substr(0, label.find("##")).c_str());
}

void medium_fields(EditForm& form, Medium& medium) {
    const std::string in = " of " + medium.name;
    if (auto* glass = std::get_if<IsotropicMedium>(&medium.matter)) {
        index_field(form, "n" + in, glass->index);
        absorption_field(form, "\u03b1" + in, glass->absorption);
    } else if (auto* crystal = std::get_if<UniaxialMedium>(&medium.matter)) {
        index_field(form, "n_o" + in, crystal->ordinary);
        index_field(form, "n_e" + in, crystal->extraordinary);
        form.vector("optic axis" + in, crystal->axis, 0.01, "Direction of the optic axis; its length does not matter.");
        static const std::array<std::string, 2> spaces{"of the object", "of the world"};
        const int taken = form.choice("axes" + in, static_cast<int>(crystal->axis_space), spaces,
                                      "Whether the optic axis turns with the object.");
        if (taken >= 0) {
            crystal->axis_space = static_cast<AxisSpace>(taken);
            form.apply("axes" + in);
            return;
        }
        absorption_field(form, "\u03b1_o" + in, crystal->absorption_o);
        absorption_field(form, "\u03b1_e" + in, crystal->absorption_e);
    } else if (auto* metal = std::get_if<ConductorMedium>(&medium.matter)) {
        index_field(form, "n" + in, metal->index);
        if (auto* constant = std::get_if<ConstantIndex>(&metal->index))
            form.number("k" + in, constant->value.k, 0.01, "Extinction: how strongly the metal absorbs.");
    }
}

/// What a lamp's polarization can be set to.
enum class State : int { unpolarized, linear, right, left, elliptical, plate_o, plate_e };
const std::array<std::string, 7> state_names{"unpolarized",
                                             "linear",
                                             "right circular",
                                             "left circular",
                                             "elliptical",
                                             "o ray of a crystal plate",
                                             "e ray of a crystal plate"};

State state_of(const EmittedState& emitted) {
    if (const auto* fixed = std::get_if<FixedState>(&emitted)) {
        if (fixed->s3 == 0.0) return State::linear;
        if (fixed->s1 == 0.0 && fixed->s2 == 0.0 && std::abs(fixed->s3) == 1.0)
            return fixed->s3 > 0.0 ? State::right : State::left;
        return State::elliptical;
    }
    if (const auto* plate = std::get_if<CrystalPlateState>(&emitted))
        return plate->passed == CrystalRay::ordinary ? State::plate_o : State::plate_e;
    return State::unpolarized;
}

/// Empty if the scene has no crystal for a plate.
std::optional<EmittedState> state_from(State state, const EmittedState& old, const Scene& scene) {
    const auto* fixed = std::get_if<FixedState>(&old);
    const DVec3 x_axis = fixed != nullptr ? fixed->x_axis : DVec3(1.0, 0.0, 0.0);
    switch (state) {
        case State::unpolarized:
            return Unpolarized{};
        case State::linear:
            return FixedState{1.0, 0.0, 0.0, x_axis};
        case State::right:
            return FixedState{0.0, 0.0, 1.0, x_axis};
        case State::left:
            return FixedState{0.0, 0.0, -1.0, x_axis};
        case State::elliptical:
            return FixedState{0.6, 0.0, 0.8, x_axis};
        case State::plate_o:
        case State::plate_e:
            break;
    }
    CrystalPlateState plate;
    if (const auto* before = std::get_if<CrystalPlateState>(&old)) plate = *before;
    plate.passed = state == State::plate_o ? CrystalRay::ordinary : CrystalRay::extraordinary;
    if (!plate.medium.empty()) return plate;
    for (const Medium& medium : scene.media) {
        if (!std::holds_alternative<UniaxialMedium>(medium.matter)) continue;
        plate.medium = medium.name;
        return plate;
    }
    return std::nullopt;
}

void lamp_fields(EditForm& form, const std::string& name, Emission& lamp) {
    const std::string in = " of " + name;
    const int taken = form.choice(
        "polarization" + in, static_cast<int>(state_of(lamp.state)), state_names,
        "State of the light that the lamp sends out, named as scene files do: right and left for the receiver.");
    if (taken >= 0) {
        if (auto state = state_from(static_cast<State>(taken), lamp.state, form.scene)) {
            lamp.state = std::move(*state);
            form.apply("polarization" + in);
        }
        return;
    }
    if (auto* fixed = std::get_if<FixedState>(&lamp.state)) {
        if (fixed->s3 == 0.0) {
            const double degree = std::hypot(fixed->s1, fixed->s2);
            double azimuth = 0.5 * std::atan2(fixed->s2, fixed->s1);
            const bool changed = drag_angle("angle" + in, azimuth);
            if (changed) {
                fixed->s1 = degree * std::cos(2.0 * azimuth);
                fixed->s2 = degree * std::sin(2.0 * azimuth);
            }
            form.after("angle" + in, changed, "From the lamp's x axis; the light is linear along it.");
        } else {
            DVec3 s(fixed->s1, fixed->s2, fixed->s3);
            const std::string label = "S1 S2 S3" + in;
            const bool changed =
                ImGui::DragScalarN(label.c_str(), ImGuiDataType_Double, &s.x, 3, 0.005F, nullptr, nullptr, "%.6g");
            if (changed) *fixed = FixedState{s.x, s.y, s.z, fixed->x_axis};
            form.after(label, changed,
                       "Stokes vector by S0, S3 > 0 right for the receiver; its length is the degree of polarization.");
        }
        form.vector("x axis" + in, fixed->x_axis, 0.01,
                    "From where the state's angles count, in the lamp's own space.");
    } else if (auto* plate = std::get_if<CrystalPlateState>(&lamp.state)) {
        form.vector("plate axis" + in, plate->axis, 0.01, "Optic axis of the virtual plate, in the lamp's own space.");
        form.flag("Fresnel" + in, plate->fresnel, "The exit face of the plate reflects a part of the light.");
    }
    if (auto* spectrum = std::get_if<Spectrum>(&lamp.radiance))
        if (auto* constant = std::get_if<ConstantSpectrum>(spectrum))
            form.number("radiance" + in, constant->value, 0.01, "Spectral radiance, the same at all wavelengths.");
}

std::string wavelengths_text(const std::vector<double>& wavelengths_nm) {
    std::string text;
    for (const double nm : wavelengths_nm) text += (text.empty() ? "" : ",") + number_text(nm);
    return text;
}

}  // namespace

void draw_camera_section(EditForm& form) {
    Camera& camera = form.scene.camera;
    form.vector("position", camera.position, 0.02,
                "Where the camera stands, scene units. In the picture: Alt and drag orbits, Alt and wheel dollies.");
    form.vector("target", camera.target, 0.02,
                "What it looks at, scene units. In the picture: Alt, Shift and drag pans.");
    form.vector("up", camera.up, 0.01, "Direction that is up in the picture.");
    if (camera.projection == Projection::perspective)
        form.angle("field of view", camera.horizontal_fov, "Horizontal angle of the picture.");
    else
        form.number("picture width", camera.width, 0.02, "Width of the picture, scene units.");
}

void draw_media_section(EditForm& form) {
    for (std::size_t i = 0; i < form.scene.media.size(); ++i) {
        Medium& medium = form.scene.media[i];
        const bool open = ImGui::TreeNodeEx(medium.name.c_str(), ImGuiTreeNodeFlags_DefaultOpen);
        name_widget("medium " + medium.name);
        if (!open) continue;
        medium_fields(form, medium);
        ImGui::TreePop();
    }
    if (form.scene.media.empty()) ImGui::TextDisabled("no medium but vacuum");
}

void draw_light_section(EditForm& form) {
    for (std::size_t i = 0; i < form.scene.objects.size(); ++i) {
        auto* lamp = std::get_if<Emission>(&form.scene.objects[i].role);
        if (lamp == nullptr) continue;
        const std::string name = form.scene.objects[i].name;
        const bool open = ImGui::TreeNodeEx(name.c_str(), ImGuiTreeNodeFlags_DefaultOpen);
        name_widget("lamp " + name);
        if (!open) continue;
        lamp_fields(form, name, *lamp);
        ImGui::TreePop();
    }
}

void draw_render_section(EditForm& form, std::string& wavelengths) {
    RenderSettings& render = form.scene.render;
    form.whole("width", render.width, 1.0F, "Pixels.");
    form.whole("height", render.height, 1.0F, "Pixels.");

    std::array<char, 4096> text{};
    const std::string shown = wavelengths.empty() ? wavelengths_text(render.wavelengths_nm) : wavelengths;
    std::strncpy(text.data(), shown.c_str(), text.size() - 1);
    const bool entered =
        ImGui::InputText("wavelengths", text.data(), text.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    name_widget("field wavelengths");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("nm: one, a list 450,550,650 or a range 380:780:20. Enter renders.");
    if (ImGui::IsItemActive()) wavelengths = text.data();
    if (entered) {
        if (auto grid = parse_wavelengths(text.data())) {
            render.wavelengths_nm = std::move(grid).value();
            form.apply("wavelengths");
            wavelengths.clear();
        } else {
            form.refuse("wavelengths", grid.error());
        }
    } else if (ImGui::IsItemDeactivated()) {
        wavelengths.clear();
    }
    form.complaint("wavelengths");

    static const std::array<std::string, 2> modes{"point: one ray through the center", "area: samples over the pixel"};
    const int taken = form.choice("mode", static_cast<int>(render.mode), modes, "What a pixel stands for.");
    if (taken >= 0) {
        render.mode = static_cast<SampleMode>(taken);
        form.apply("mode");
        return;
    }
    form.whole("samples per pixel", render.samples_per_pixel, 0.2F, "In mode area. More of them mean less noise.");
    form.number("residual", render.residual, 1e-5, "Largest share of a pixel that may stay untraced.");
    bool limited = render.depth.has_value();
    if (ImGui::Checkbox("depth limit", &limited)) {
        if (limited) {
            render.cut_by_depth_alone(9);
        } else {
            const RenderSettings usual;
            render.depth.reset();
            render.residual = usual.residual;
            render.node_budget = usual.node_budget;
        }
        form.apply("depth limit");
        return;
    }
    name_widget("field depth limit");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("The paper's mode: the tree is cut after so many surfaces, and nowhere else.");
    form.complaint("depth limit");
    if (render.depth) form.whole("depth", *render.depth, 0.1F, "Surfaces that a ray may meet.");
    form.whole("branch budget", render.node_budget, 10.0F, "Branches that a sample may follow before its random tail.");
    form.flag("forget polarization", render.unpolarized,
              "Light is unpolarized again after every surface: what a renderer without polarization shows.");
}

}  // namespace pol
