// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/picture_header.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <vector>

#include "viewer/pages/readout_text.h"
#include "viewer/widgets/ink.h"
#include "viewer/widgets/question.h"
#include "viewer/widgets/section.h"
#include "viewer/widgets/theme.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

void fact(const char* name, const std::string& text) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", text.c_str());
}

template <class Rows>
void table(const char* name, const Rows& rows) {
    if (!ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("name");
    ImGui::TableSetupColumn("text", ImGuiTableColumnFlags_WidthStretch);
    rows();
    ImGui::EndTable();
}

void draw_facts(const StokesImage& picture) {
    table("facts", [&] {
        if (!picture.origin.layout.empty()) fact("layout", picture.origin.layout);
        fact("size", size_text(picture));
        std::string bands;
        for (const Band& band : picture.bands) bands += (bands.empty() ? "" : ", ") + measured_text(band);
        fact(wavelengths_of(picture.bands).empty() ? "bands" : "wavelengths", bands);
        fact("numbers", stored_text(picture.stored));
    });
}

/// Two names for a choice that is false or true.
bool choose(const char* label, bool& value, const char* no, const char* yes, const char* help) {
    const std::array<const char*, 2> names{no, yes};
    int index = value ? 1 : 0;
    const bool changed = ImGui::Combo(label, &index, names.data(), 2);
    name_widget(std::string("assumed ") + label);
    tooltip(help);
    value = index == 1;
    return changed;
}

/// Image right, image up, or a number of degrees.
bool choose_zero(double& zero_deg) {
    constexpr std::array<const char*, 3> names{"image right", "image up", "another direction"};
    int index = zero_deg == 0.0 ? 0 : zero_deg == 90.0 ? 1 : 2;
    bool changed = ImGui::Combo("azimuth from", &index, names.data(), 3);
    name_widget("assumed azimuth from");
    tooltip("The direction whose linear light has S1 = S0.");
    constexpr double neither = 45.0;
    if (changed) zero_deg = index == 0 ? 0.0 : index == 1 ? 90.0 : neither;
    if (index != 2) return changed;
    double typed = zero_deg;
    ImGui::InputDouble("degrees", &typed, 0.0, 0.0, "%.6g");
    name_widget("assumed degrees");
    tooltip("From image right, counter-clockwise.");
    if (ImGui::IsItemDeactivatedAfterEdit() && std::abs(typed) <= 360.0) {
        zero_deg = typed;
        changed = true;
    }
    return changed;
}

void draw_convention(const Document& document, Wishes& wishes) {
    StokesConvention convention = document.picture().origin.convention;
    ImGui::PushItemWidth(0.5F * ImGui::GetContentRegionAvail().x);
    const bool handedness =
        choose("S3 > 0 is", convention.left_handed, "right-handed", "left-handed",
               "Right: the field turns clockwise for the receiver, as in optics. Left: radio astronomy, IEEE, and "
               "programs that look along the light.");
    const bool zero = choose_zero(convention.azimuth_zero_deg);
    const bool y = choose("y points", convention.y_down, "up", "down",
                          "Down: +45\u00b0 lies below image right, and S3 has the other sign.");
    ImGui::PopItemWidth();
    if (handedness || zero || y)
        wishes.add([of = &document, convention](Session& s) { s.take_numbers_for(of, convention); });
    if (!document.chosen_convention()) return;
    ImGui::TextWrapped("You chose this. The reader took: %s.", document.readers_convention().text().c_str());
    if (button("As the reader took them"))
        wishes.add([of = &document](Session& s) { s.take_numbers_for(of, std::nullopt); });
}

void draw_sentences(const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) {
        ImGui::Bullet();
        ImGui::TextWrapped("%s", sentence.c_str());
    }
}

}  // namespace

std::string size_text(const StokesImage& picture) {
    std::string text = fmt::format("{} x {} pixels", picture.width, picture.height);
    const bool is_part =
        picture.whole_width > 0 && (picture.left != 0 || picture.top != 0 || picture.whole_width != picture.width ||
                                    picture.whole_height != picture.height);
    if (is_part || picture.left != 0 || picture.top != 0) text += fmt::format(" from {},{}", picture.left, picture.top);
    if (is_part) text += fmt::format(" of {} x {}", picture.whole_width, picture.whole_height);
    return text;
}

std::string stored_text(const StoredNumbers& stored) {
    if (stored.spacing > 0.0)
        return fmt::format("from whole numbers, {} apart: each off by at most half of it",
                           short_number(stored.spacing, 2));
    std::string text =
        fmt::format("{}-bit floats: off by at most {} % each", stored.bits, short_number(100.0 * stored.rounding(), 2));
    if (!stored.lossy.empty()) text += "; " + stored.lossy + " changes them by more, by no simple bound";
    return text;
}

std::string measured_text(const Band& band) {
    const std::string missing = missing_text(StokesComponents::all(), band.known);
    return missing.empty() ? band_text(band) : fmt::format("{} ({})", band_text(band), missing);
}

void draw_picture_header(const Session& session, Wishes& wishes) {
    const Document& document = *session.current();
    const StokesImage& picture = document.picture();
    ImGui::TextWrapped("%s", document.path().empty() ? document.name().c_str() : document.path().c_str());
    if (const auto& problem = document.problem()) {
        ImGui::PushStyleColor(ImGuiCol_Text, colors(session.window().theme).error);
        ImGui::TextWrapped("%s", to_string(*problem).c_str());
        ImGui::PopStyleColor();
    }
    draw_facts(picture);
    section("What the numbers are taken for", [&] { draw_convention(document, wishes); });
    if (!picture.origin.assumed.empty()) section("Taken for granted", [&] { draw_sentences(picture.origin.assumed); });
    if (!picture.origin.remarks.empty()) section("To know about it", [&] { draw_sentences(picture.origin.remarks); });
    if (!picture.attributes.empty())
        section("What it says of itself", [&] {
            table("attributes", [&] {
                for (const auto& [name, text] : picture.attributes) fact(name.c_str(), text);
            });
        });
    ImGui::TextDisabled("Paths, 3-D view and edits need a scene, which a picture has not.");
}

}  // namespace pol
