// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/pixel_panel.h"

#include <imgui.h>

#include <string>

#include "core/units.h"
#include "viewer/pages/pixel_page.h"
#include "viewer/pages/readout_text.h"
#include "viewer/panels/spectrum_plot.h"
#include "viewer/session/pixel_export.h"
#include "viewer/widgets/copyable.h"
#include "viewer/widgets/polarization_ellipse.h"

namespace pol {

namespace {

template <class Value>
void choose(const char* label, Value& value, const char* const* names, int count, const char* help) {
    int index = static_cast<int>(value);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 13.0F);
    if (ImGui::Combo(label, &index, names, count)) value = static_cast<Value>(index);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
}

/// The pixels that were pinned, the last one at the end: a click goes back.
void draw_pins(const Session& session, Wishes& wishes) {
    const Selection& selection = session.selection();
    const StokesImage& picture = session.current()->picture();
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    std::optional<PixelAddress> chosen;
    for (std::size_t i = 0; i < selection.pins.size(); ++i) {
        const PixelAddress pin = selection.pins[i];
        const std::string name = std::to_string(picture.left + pin.x) + "," + std::to_string(picture.top + pin.y);
        const bool is_current = static_cast<int>(i) == selection.current;
        const float width = ImGui::CalcTextSize(name.c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x;
        if (i > 0 && ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width < right) ImGui::SameLine();
        ImGui::PushID(static_cast<int>(i));
        if (is_current) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        if (ImGui::SmallButton(name.c_str())) chosen = pin;
        if (is_current) ImGui::PopStyleColor();
        ImGui::PopID();
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip(is_current ? "The pinned pixel: arrow keys move it, Esc releases it"
                                         : "Back to this pixel");
    }
    if (chosen) wishes.add([pin = *chosen](Session& s) { s.pin(pin); });
}

void draw_frame_choice(PageSettings settings, Wishes& wishes) {
    const PageSettings before = settings;
    constexpr const char* frames[] = {"camera", "scene x axis", "scene y axis", "scene z axis", "own angle"};
    choose("Frame", settings.frame, frames, 5, "Axes that matrix, Stokes vector and azimuth are written in");
    if (settings.frame == FrameChoice::own_angle) {
        auto angle = static_cast<float>(degrees(settings.own_angle));
        ImGui::SetNextItemWidth(ImGui::GetFontSize() * 13.0F);
        if (ImGui::SliderFloat("Angle", &angle, -90.0F, 90.0F, "%.2f\u00b0"))
            settings.own_angle = radians(static_cast<double>(angle));
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("From the camera's x towards its y, for the receiver; Ctrl+click to type");
    }
    if (settings != before) wishes.add([settings](Session& s) { s.set_page(settings); });
}

void draw_convention_choice(Convention convention, Wishes& wishes) {
    const Convention before = convention;
    constexpr const char* views[] = {"receiver: against the light", "source: along the light"};
    constexpr const char* signs[] = {"right-handed", "left-handed"};
    constexpr const char* times[] = {"exp(-i\u03c9t)", "exp(+i\u03c9t)"};
    choose("Who looks", convention.viewpoint, views, 2,
           "Exchanges right and left, turns x, S2, S3 and azimuth round; in all panels, maps and exports");
    choose("S3 > 0 is", convention.positive_s3, signs, 2, "Sign of S3 and of the ellipticity angle");
    choose("Time", convention.time_sign, times, 2, "The other sign conjugates the matrix; Stokes vectors stay");
    if (convention != before) wishes.set(&ViewSettings::convention, convention);
}

void draw_matrix(const PixelPage& page) {
    const MatrixTexts& texts = page.matrix_texts;
    const auto& rows = page.groups.front().rows;
    if (!ImGui::BeginTable("matrix", 3, ImGuiTableFlags_BordersOuter | ImGuiTableFlags_BordersInner)) return;
    ImGui::TableSetupColumn("J", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("x", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("y", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableHeadersRow();
    const auto cell = [](const char* id, const std::string& text, const std::string& exact, const std::string& help) {
        ImGui::TableNextColumn();
        copyable(id, text.empty() ? "not a number" : text, text.empty() ? "" : exact, help);
    };
    const std::string parts = ": " + rows[1].bar + " in the real part, " + rows[2].bar + " in the imaginary";
    const std::string bars = rows[1].bar.empty() ? "" : parts;
    const auto bar_of = [](const PageRow& row) { return row.bar.empty() ? "" : ": " + row.bar; };
    ImGui::TableNextColumn();
    ImGui::TextUnformatted("x");
    cell("xx", texts.xx, rows[0].exact, "J_xx = <E_x E_x*>" + bar_of(rows[0]));
    cell("xy", texts.xy, texts.exact_xy, "J_xy = <E_x E_y*>" + bars);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted("y");
    cell("yx", texts.yx, texts.exact_yx, "J_yx, the conjugate of J_xy" + bars);
    cell("yy", texts.yy, rows[3].exact, "J_yy = <E_y E_y*>" + bar_of(rows[3]));
    ImGui::EndTable();
}

void draw_ellipse(const PixelPage& page) {
    const float side = ImGui::GetFontSize() * 10.0F;
    if (page.known == StokesComponents::all()) {
        draw_polarization_ellipse(page.seen, side);
        return;
    }
    if (page.known.has(StokesComponents::linear())) draw_azimuth(page.seen, side);
    ImGui::TextWrapped("%s: the ellipse is not known.", missing_text(StokesComponents::all(), page.known).c_str());
}

void draw_group(const PageGroup& group, bool doubted) {
    if (!ImGui::CollapsingHeader(group.title.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (!ImGui::BeginTable(group.title.c_str(), 3)) return;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("bar", ImGuiTableColumnFlags_WidthFixed);
    for (const PageRow& row : group.rows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(row.name.c_str());
        ImGui::TableNextColumn();
        copyable(row.name.c_str(), row.value, row.exact, row.help);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(row.bar.c_str());
        if (!row.bar.empty() && ImGui::IsItemHovered())
            ImGui::SetTooltip("%s\n%s",
                              doubted ? "Range from residual and tail; what the status line doubts comes on top"
                                      : "The truth lies in this range: a rigorous bound from residual and tail",
                              row.exact_bar.c_str());
    }
    ImGui::EndTable();
}

void draw_curves(const Session& session, Wishes& wishes) {
    const std::vector<Band>& bands = session.current()->picture().bands;
    const char* title = wavelengths_of(bands).empty() ? "Over the bands" : "Over wavelength";
    if (bands.size() < 2 || !ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen)) return;
    for (const PageCurve& curve : spectrum_curves(session))
        if (const auto clicked = draw_spectrum_plot(curve, bands, session.view().band, ImGui::GetFontSize() * 4.0F))
            wishes.add([index = *clicked](Session& s) { s.choose_band(index); });
}

}  // namespace

void PixelPanel::draw(const Session& session, Wishes& wishes) {
    if (session.current() == nullptr || !session.selection().pinned()) {
        ImGui::TextWrapped(
            "Click a pixel of the picture: its coherence matrix and all that follows from it appear here.");
        return;
    }
    draw_pins(session, wishes);
    const PixelPage page = make_pixel_page(session);
    ImGui::Text("Pixel %d,%d at %s%s", page.pixel.x, page.pixel.y, band_text(page.band).c_str(),
                session.polarimeter().empty() ? "" : ", behind the polarimeter");
    if (page.from_tree) ImGui::TextDisabled("not rendered yet: one sample, from its tree");
    if (ImGui::SmallButton("Copy all")) ImGui::SetClipboardText(text_of(page).c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("All numbers of this page at full precision, as text");
    ImGui::SameLine();
    const bool can_be_case = session.explanation() != nullptr;
    if (!can_be_case) ImGui::BeginDisabled();
    if (ImGui::SmallButton("Save as test case")) wishes.add(save_pixel_case);
    if (!can_be_case) ImGui::EndDisabled();
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip("Scene, pixel and matrix as a file that polariscope explain --case checks again");

    draw_matrix(page);
    draw_frame_choice(session.page(), wishes);
    if (!page.trouble.empty()) ImGui::TextWrapped("%s", page.trouble.c_str());
    ImGui::TextDisabled("%s", page.convention.c_str());
    if (ImGui::TreeNode("Convention")) {
        draw_convention_choice(session.view().convention, wishes);
        ImGui::TreePop();
    }
    draw_ellipse(page);
    const bool doubted = session.current()->has_scene() && !session.current()->plan()->features.doubts.empty();
    for (std::size_t i = 1; i < page.groups.size(); ++i) draw_group(page.groups[i], doubted);
    draw_curves(session, wishes);
}

}  // namespace pol
