// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/edit_form.h"

#include <imgui.h>

#include <array>

#include "core/units.h"
#include "viewer/widgets/theme.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

constexpr const char* number_format = "%.6g";

/// What is written beside the field: the label up to "##".
std::string visible(const std::string& label) {
    return label.substr(0, label.find("##"));
}

}  // namespace

bool drag_angle(const std::string& label, double& angle_rad) {
    double angle_deg = degrees(angle_rad);
    if (!ImGui::DragScalar(label.c_str(), ImGuiDataType_Double, &angle_deg, 0.2F, nullptr, nullptr, "%.6g\u00b0"))
        return false;
    angle_rad = radians(angle_deg);
    return true;
}

void EditForm::number(const std::string& label, double& value, double per_point, const char* hint) {
    const bool changed = ImGui::DragScalar(label.c_str(), ImGuiDataType_Double, &value, static_cast<float>(per_point),
                                           nullptr, nullptr, number_format);
    after(label, changed, hint);
}

void EditForm::vector(const std::string& label, DVec3& value, double per_point, const char* hint) {
    const bool changed = ImGui::DragScalarN(label.c_str(), ImGuiDataType_Double, &value.x, 3,
                                            static_cast<float>(per_point), nullptr, nullptr, number_format);
    after(label, changed, hint);
}

void EditForm::angle(const std::string& label, double& angle_rad, const char* hint) {
    const bool changed = drag_angle(label, angle_rad);
    after(label, changed, hint);
}

void EditForm::whole(const std::string& label, int& value, float per_point, const char* hint) {
    after(label, ImGui::DragInt(label.c_str(), &value, per_point), hint);
}

void EditForm::flag(const std::string& label, bool& value, const char* hint) {
    const bool changed = ImGui::Checkbox(label.c_str(), &value);
    after(label, changed, hint);
    if (changed) wish_end();
}

int EditForm::choice(const std::string& label, int current, std::span<const std::string> names, const char* hint) {
    int taken = -1;
    const bool inside = current >= 0 && current < static_cast<int>(names.size());
    const bool open = ImGui::BeginCombo(label.c_str(), inside ? names[static_cast<std::size_t>(current)].c_str() : "");
    name_widget("field " + visible(label));
    if (open) {
        for (int i = 0; i < static_cast<int>(names.size()); ++i)
            if (ImGui::Selectable(names[static_cast<std::size_t>(i)].c_str(), i == current) && i != current) taken = i;
        ImGui::EndCombo();
    } else if (ImGui::IsItemHovered() && hint[0] != '\0') {
        ImGui::SetTooltip("%s", hint);
    }
    complaint(label);
    return taken;
}

void EditForm::apply(const std::string& label) {
    wish_end();
    wish_edit(label);
    wish_end();
}

void EditForm::refuse(const std::string& label, const Error& error) {
    wishes_.add([of = session_.current(), label, error](Session& s) { s.refuse_edit(of, label, error); });
}

void EditForm::wish_edit(const std::string& label) {
    wishes_.add([of = session_.current(), edited = scene, label](Session& s) { s.edit(of, edited, label); });
}

void EditForm::wish_end() {
    wishes_.add([of = session_.current()](Session& s) { s.end_edit(of); });
}

void EditForm::after(const std::string& label, bool changed, const char* hint) {
    name_widget("field " + visible(label));
    if (ImGui::IsItemHovered() && hint[0] != '\0') ImGui::SetTooltip("%s", hint);
    const bool ended = ImGui::IsItemDeactivatedAfterEdit();
    if (changed) wish_edit(label);
    if (ended) wish_end();
    complaint(label);
}

void EditForm::complaint(const std::string& label) const {
    const auto& refused = session_.current()->refused();
    if (!refused || refused->label != label) return;
    ImGui::PushStyleColor(ImGuiCol_Text, colors(session_.window().theme).error);
    std::string text = refused->error.what;
    if (!refused->error.hint.empty()) text += "\n" + refused->error.hint;
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

}  // namespace pol
