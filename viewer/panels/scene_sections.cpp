// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/scene_sections.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>
#include <variant>
#include <vector>

#include "core/number_text.h"
#include "core/overloaded.h"
#include "core/units.h"
#include "io/files/assets.h"
#include "io/scenes/index_file.h"
#include "scene/medium_fields.h"
#include "scene/setting_table.h"
#include "spectrum/wavelength_grid.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

/// A constant that can be dragged, or one of the records.
void record_field(EditForm& form, const std::string& label, RefractiveIndex& index) {
    static const std::string constant = "constant";
    std::vector<std::string> names{constant};
    names.insert(names.end(), form.index_records().begin(), form.index_records().end());
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

void index_field(EditForm& form, const std::string& n, const std::string& k, RefractiveIndex& index,
                 Extinction extinction) {
    record_field(form, n, index);
    if (auto* constant = std::get_if<ConstantIndex>(&index); constant != nullptr && extinction == Extinction::needed)
        form.number(k, constant->value.k, 0.01, "Extinction: how strongly the metal absorbs.");
}

void absorption_field(EditForm& form, const std::string& label, Absorption& absorption) {
    const auto is_table = [&] { ImGui::TextDisabled("%s: a table in the scene", label.c_str()); };
    std::visit(Overloaded{[&](ConstantSpectrum& constant) {
                              form.number(label, constant.value, 0.01,
                                          "Absorption coefficient per scene unit: power falls as exp(-\u03b1 d).");
                          },
                          [&](const TabulatedSpectrum&) { is_table(); }, [&](const D65Spectrum&) { is_table(); }},
               absorption);
}

void axis_space_field(EditForm& form, const std::string& label, AxisSpace& space) {
    static const std::array<std::string, axis_space_words.size()> spaces{"of the object", "of the world"};
    const int taken =
        form.choice(label, static_cast<int>(space), spaces, "Whether the optic axis turns with the object.");
    if (taken < 0) return;
    space = static_cast<AxisSpace>(taken);
    form.apply(label);
}

void medium_fields(EditForm& form, Medium& medium) {
    const std::string in = " of " + medium.name;
    for_each_field(
        medium.matter,
        Overloaded{
            [&](const auto& row, RefractiveIndex& index) {
                index_field(form, std::string(row.label) + in, "k" + in, index, row.extinction);
            },
            [&](const auto& row, Absorption& absorption) {
                absorption_field(form, std::string(row.label) + in, absorption);
            },
            [&](const auto& row, DVec3& axis) {
                form.vector(std::string(row.label) + in, axis, 0.01,
                            "Direction of the optic axis; its length does not matter.");
            },
            [&](const auto& row, AxisSpace& space) { axis_space_field(form, std::string(row.label) + in, space); },
        });
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
        if (crystal_in(medium.matter) == nullptr) continue;
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
        std::visit(Overloaded{[&](ConstantSpectrum& constant) {
                                  form.number("radiance" + in, constant.value, 0.01,
                                              "Spectral radiance, the same at all wavelengths.");
                              },
                              [](const TabulatedSpectrum&) {}, [](const D65Spectrum&) {}},
                   *spectrum);
}

std::string wavelengths_text(const std::vector<double>& wavelengths_nm) {
    std::string text;
    for (const double nm : wavelengths_nm) text += (text.empty() ? "" : ",") + number_text(nm);
    return text;
}

/// `typed` is the text being typed; empty: the scene's own.
void wavelengths_field(EditForm& form, const std::string& label, const std::string& help,
                       std::vector<double>& wavelengths_nm, std::string& typed) {
    std::array<char, 4096> text{};
    const std::string shown = typed.empty() ? wavelengths_text(wavelengths_nm) : typed;
    std::strncpy(text.data(), shown.c_str(), text.size() - 1);
    const bool entered =
        ImGui::InputText(label.c_str(), text.data(), text.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    name_widget("field " + label);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s. Enter renders.", help.c_str());
    if (ImGui::IsItemActive()) typed = text.data();
    if (entered) {
        if (auto grid = parse_wavelengths(text.data())) {
            wavelengths_nm = std::move(grid).value();
            form.apply(label);
            typed.clear();
        } else {
            form.refuse(label, grid.error());
        }
    } else if (ImGui::IsItemDeactivated()) {
        typed.clear();
    }
    form.complaint(label);
}

void choice_field(EditForm& form, const std::string& label, const std::string& help, const ChoiceSetting& kind) {
    const std::vector<std::string> words(kind.words.begin(), kind.words.end());
    const int taken = form.choice(label, kind.get(form.scene.render), words, help.c_str());
    if (taken < 0) return;
    kind.set(form.scene.render, taken);
    form.apply(label);
}

void limit_field(EditForm& form, const std::string& label, const std::string& help, const LimitSetting& kind) {
    RenderSettings& render = form.scene.render;
    const std::string limit = label + " limit";
    bool limited = (render.*kind.value).has_value();
    const bool changed = ImGui::Checkbox(limit.c_str(), &limited);
    name_widget("field " + limit);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help.c_str());
    if (changed) {
        if (limited)
            (render.*kind.impose)(kind.usual);
        else
            (render.*kind.lift)();
        form.apply(limit);
    }
    form.complaint(limit);
    if (render.*kind.value) form.whole(label, *(render.*kind.value), 0.1F, help.c_str());
}

/// Of a number that was set.
template <class Number>
void give_back_button(EditForm& form, const std::string& label, std::optional<Number>& number) {
    if (!number) return;
    ImGui::SameLine();
    if (ImGui::SmallButton(("usual##" + label).c_str())) {
        number.reset();
        form.apply(label);
    }
    name_widget("field usual " + label);
}

/// The number in force; one that was set can be given back.
void usual_field(EditForm& form, const std::string& label, const std::string& help, const UsualSetting& kind) {
    RenderSettings& render = form.scene.render;
    int number = kind.in_force(form.scene);
    const bool changed = ImGui::DragInt(label.c_str(), &number, static_cast<float>(kind.per_point));
    if (changed) render.*kind.value = number;
    form.after(label, changed, help.c_str());
    give_back_button(form, label, render.*kind.value);
}

/// The same; what is more than a number has its words behind it.
void usual_field(EditForm& form, const std::string& label, const std::string& help, const UsualNumberSetting& kind) {
    RenderSettings& render = form.scene.render;
    double number = (render.*kind.in_force)();
    const std::string format = "%.6g " + std::string(kind.words(render));
    const bool changed = ImGui::DragScalar(label.c_str(), ImGuiDataType_Double, &number,
                                           static_cast<float>(kind.per_point), nullptr, nullptr, format.c_str());
    if (changed) render.*kind.value = number;
    form.after(label, changed, help.c_str());
    give_back_button(form, label, render.*kind.value);
}

void setting_field(EditForm& form, const RenderSetting& setting, std::string& wavelengths) {
    RenderSettings& render = form.scene.render;
    const std::string label(setting.label);
    const std::string help(setting.help);
    std::visit(
        Overloaded{
            [&](const SizeSetting& kind) {
                form.whole("width", render.*kind.width, 1.0F, help.c_str());
                form.whole("height", render.*kind.height, 1.0F, help.c_str());
            },
            [&](const WavelengthsSetting& kind) { wavelengths_field(form, label, help, render.*kind.nm, wavelengths); },
            [&](const ChoiceSetting& kind) { choice_field(form, label, help, kind); },
            [&](const WholeSetting& kind) {
                form.whole(label, render.*kind.value, static_cast<float>(kind.per_point), help.c_str());
            },
            [&](const LimitSetting& kind) { limit_field(form, label, help, kind); },
            [&](const UsualSetting& kind) { usual_field(form, label, help, kind); },
            [&](const UsualNumberSetting& kind) { usual_field(form, label, help, kind); },
            [&](const SeedSetting& kind) {
                const bool changed = ImGui::InputScalar(label.c_str(), ImGuiDataType_U64, &(render.*kind.value));
                form.after(label, changed, help.c_str());
            },
            [&](const FlagSetting& kind) { form.flag(label, render.*kind.value, help.c_str()); },
        },
        setting.kind);
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
    for (const RenderSetting& setting : render_settings()) setting_field(form, setting, wavelengths);
}

}  // namespace pol
