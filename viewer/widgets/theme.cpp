// SPDX-License-Identifier: Apache-2.0
#include "viewer/widgets/theme.h"

#include <cstdint>
#include <initializer_list>

namespace pol {

namespace {

ImVec4 hex(std::uint32_t rgb) {
    const auto channel = [rgb](int shift) { return static_cast<float>((rgb >> shift) & 0xffU) / 255.0F; };
    return {channel(16), channel(8), channel(0), 1.0F};
}

ImVec4 with_alpha(ImVec4 color, float alpha) {
    return {color.x, color.y, color.z, alpha};
}

const ThemeColors dark_colors{
    .window = hex(0x1b1e23),
    .popup = hex(0x22262c),
    .field = hex(0x2b3038),
    .field_hover = hex(0x363d47),
    .field_active = hex(0x424b57),
    .selected = hex(0x274460),
    .border = hex(0x383f49),
    .text = hex(0xe4e7eb),
    .dim = hex(0xaab2bc),
    .accent = hex(0x5aabe8),
    .good = hex(0x74c790),
    .warning = hex(0xecb755),
    .error = hex(0xff8f87),
};

const ThemeColors light_colors{
    .window = hex(0xf5f6f8),
    .popup = hex(0xffffff),
    .field = hex(0xe3e7ec),
    .field_hover = hex(0xd5dce4),
    .field_active = hex(0xc6d0db),
    .selected = hex(0xc9dff4),
    .border = hex(0xc3cbd4),
    .text = hex(0x1c2228),
    .dim = hex(0x4b545e),
    .accent = hex(0x15609c),
    .good = hex(0x17602f),
    .warning = hex(0x744a00),
    .error = hex(0xa51d16),
};

}  // namespace

const ThemeColors& colors(Theme theme) {
    return theme == Theme::dark ? dark_colors : light_colors;
}

ImVec4 color_of(Theme theme, Severity severity) {
    const ThemeColors& c = colors(theme);
    return severity == Severity::error ? c.error : severity == Severity::warning ? c.warning : c.text;
}

void apply_theme(Theme theme, double scale) {
    const ThemeColors& c = colors(theme);
    ImGuiStyle style;
    theme == Theme::dark ? ImGui::StyleColorsDark(&style) : ImGui::StyleColorsLight(&style);
    style.WindowPadding = {8.0F, 8.0F};
    style.FramePadding = {6.0F, 3.0F};
    style.ItemSpacing = {8.0F, 5.0F};
    style.ItemInnerSpacing = {6.0F, 4.0F};
    style.CellPadding = {5.0F, 2.0F};
    style.IndentSpacing = 16.0F;
    style.ScrollbarSize = 12.0F;
    style.FrameRounding = 3.0F;
    style.GrabRounding = 3.0F;
    style.TabRounding = 3.0F;
    style.PopupRounding = 4.0F;
    style.WindowBorderSize = 1.0F;
    style.WindowRounding = 0.0F;
    style.ScaleAllSizes(static_cast<float>(scale));

    const auto set = [&style](std::initializer_list<ImGuiCol> which, ImVec4 color) {
        for (const ImGuiCol one : which) style.Colors[one] = color;
    };
    set({ImGuiCol_WindowBg, ImGuiCol_MenuBarBg, ImGuiCol_TitleBg, ImGuiCol_TitleBgCollapsed, ImGuiCol_ScrollbarBg},
        c.window);
    set({ImGuiCol_PopupBg}, c.popup);
    set({ImGuiCol_ChildBg, ImGuiCol_TableRowBg, ImGuiCol_BorderShadow}, with_alpha(c.window, 0.0F));
    set({ImGuiCol_TableRowBgAlt}, with_alpha(c.field, 0.4F));
    set({ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_Tab, ImGuiCol_TabUnfocused, ImGuiCol_TableHeaderBg,
         ImGuiCol_ScrollbarGrab},
        c.field);
    set({ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_TabHovered, ImGuiCol_HeaderHovered,
         ImGuiCol_ScrollbarGrabHovered},
        c.field_hover);
    set({ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive, ImGuiCol_ScrollbarGrabActive},
        c.field_active);
    set({ImGuiCol_Header, ImGuiCol_TabActive, ImGuiCol_TabUnfocusedActive, ImGuiCol_TitleBgActive}, c.selected);
    set({ImGuiCol_Border, ImGuiCol_Separator, ImGuiCol_TableBorderLight, ImGuiCol_TableBorderStrong}, c.border);
    set({ImGuiCol_Text}, c.text);
    set({ImGuiCol_TextDisabled}, c.dim);
    set({ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_PlotLines, ImGuiCol_PlotHistogram,
         ImGuiCol_SeparatorHovered, ImGuiCol_SeparatorActive, ImGuiCol_DragDropTarget, ImGuiCol_NavHighlight},
        c.accent);
    set({ImGuiCol_TextSelectedBg}, with_alpha(c.accent, 0.4F));
    ImGui::GetStyle() = style;
}

}  // namespace pol
