// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/pictures_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <set>
#include <string>

#include "viewer/commands/unsaved_edits.h"
#include "viewer/pages/readout_text.h"
#include "viewer/panels/picture_header.h"
#include "viewer/widgets/ink.h"
#include "viewer/widgets/widget_map.h"

namespace pol {

namespace {

constexpr int thumbnail_side = 36;
/// A picture that is being rendered is looked at again so often.
constexpr double renewed_after_s = 1.0;

/// "256 x 256 pixels, 21 bands"; of a part, what it is a part of.
std::string about_text(const StokesImage& picture) {
    const std::string size = size_text(picture);
    if (picture.bands.size() == 1) return size + ", " + band_text(picture.bands.front());
    return size + fmt::format(", {} bands", picture.bands.size());
}

std::string bands_text(const StokesImage& picture) {
    constexpr std::size_t most = 8;
    std::string text;
    for (std::size_t b = 0; b < std::min(most, picture.bands.size()); ++b)
        text += (b == 0 ? "" : ", ") + band_text(picture.bands[b]);
    return picture.bands.size() > most ? text + ", ..." : text;
}

void draw_thumbnail(const Thumbnail& small, ImVec2 at, float side) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float cell = side / static_cast<float>(std::max(small.width, small.height));
    const float left = at.x + 0.5F * (side - cell * static_cast<float>(small.width));
    const float top = at.y + 0.5F * (side - cell * static_cast<float>(small.height));
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            const ImVec2 low(left + cell * static_cast<float>(x), top + cell * static_cast<float>(y));
            const auto index =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(small.width) + static_cast<std::size_t>(x);
            list.AddRectFilled(low, {low.x + cell, low.y + cell}, ink(small.pixels[index]));
        }
    }
}

/// At once if nothing would be lost, else shows it and asks.
void wish_closed(Wishes& wishes, const Document& document) {
    wishes.add([which = &document](Session& s) {
        const auto open = s.documents();
        if (std::find(open.begin(), open.end(), which) == open.end()) return;
        if (!which->dirty()) return s.close_document(which);
        s.show_document(which);
        close_or_ask(s);
    });
}

}  // namespace

const Thumbnail& PicturesPanel::thumbnail(const Document& document) {
    Kept& kept = kept_[document.picture_layout()];
    const bool is_old = kept.version != document.picture_version() && ImGui::GetTime() - kept.made_s > renewed_after_s;
    if (kept.thumbnail.pixels.empty() || is_old)
        kept = {thumbnail_of(document.picture(), thumbnail_side), document.picture_version(), ImGui::GetTime()};
    return kept.thumbnail;
}

void PicturesPanel::draw(const Session& session, Wishes& wishes) {
    const auto documents = session.documents();
    std::set<std::uint64_t> open;
    for (const Document* document : documents) open.insert(document->picture_layout());
    std::erase_if(kept_, [&](const auto& entry) { return !open.contains(entry.first); });
    const float line = ImGui::GetTextLineHeight();
    const float side = 2.0F * line + ImGui::GetStyle().ItemSpacing.y;
    const float width = ImGui::GetContentRegionAvail().x;
    for (std::size_t i = 0; i < documents.size(); ++i) {
        const Document& document = *documents[i];
        const StokesImage& picture = document.picture();
        ImGui::PushID(static_cast<int>(i));
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const ImVec2 cursor = ImGui::GetCursorPos();
        if (ImGui::Selectable("##show", &document == session.current(), ImGuiSelectableFlags_AllowItemOverlap,
                              {0.0F, side}) &&
            &document != session.current())
            wishes.add([which = &document](Session& s) { s.show_document(which); });
        name_widget("picture " + std::to_string(i + 1));
        tooltip(fmt::format("{}\n{}\n{}", document.path().empty() ? document.name() : document.path().string(),
                            about_text(picture), bands_text(picture))
                    .c_str());
        if (picture.pixel_count() > 0 && !picture.bands.empty()) draw_thumbnail(thumbnail(document), at, side);
        const ImVec2 text(at.x + side + ImGui::GetStyle().ItemSpacing.x, at.y);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        ImGui::PushClipRect(at, {at.x + width - 1.5F * line, at.y + side}, true);
        const std::string number = i < 9 ? std::to_string(i + 1) + "  " : "";
        const std::string name = number + document.name() + (document.dirty() ? " *" : "");
        list.AddText(text, ImGui::GetColorU32(ImGuiCol_Text), name.c_str());
        std::string about = about_text(picture);
        if (&document == session.reference()) about.insert(0, "reference, ");
        list.AddText({text.x, text.y + line}, ImGui::GetColorU32(ImGuiCol_TextDisabled), about.c_str());
        ImGui::PopClipRect();
        ImGui::LogText("%s\n%s\n", name.c_str(), about.c_str());
        const ImVec2 after = ImGui::GetCursorPos();
        ImGui::SetCursorPos({cursor.x + width - 1.4F * line, cursor.y});
        if (ImGui::SmallButton("x")) wish_closed(wishes, document);
        name_widget("close picture " + std::to_string(i + 1));
        tooltip("Closes it; asks first if its edits are not saved.");
        ImGui::SetCursorPos(after);
        ImGui::PopID();
    }
}

}  // namespace pol
