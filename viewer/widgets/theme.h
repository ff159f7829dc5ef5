// SPDX-License-Identifier: Apache-2.0
// The two looks of the window: colors with enough contrast to read, and one spacing for all panels.
#pragma once

#include <imgui.h>

#include "viewer/shown/appearance.h"

namespace pol {

/// sRGB, 0 to 1. Texts reach a contrast of 4.5 (WCAG 2.1, AA) on every ground they stand on.
struct ThemeColors {
    ImVec4 window;       ///< ground of panels
    ImVec4 popup;        ///< ground of menus, tooltips and overlays
    ImVec4 field;        ///< ground of entries, sliders, buttons
    ImVec4 field_hover;  ///< under the cursor
    ImVec4 field_active;
    ImVec4 selected;  ///< ground of the chosen row or tab
    ImVec4 border;
    ImVec4 text;
    ImVec4 dim;  ///< what matters less
    ImVec4 accent;
    ImVec4 good;
    ImVec4 warning;
    ImVec4 error;
};

const ThemeColors& colors(Theme theme);

/// Color of a message.
ImVec4 color_of(Theme theme, Severity severity);

/// Sets colors and spacing of the current ImGui context; sizes are those of `scale` 1 times `scale`.
void apply_theme(Theme theme, double scale);

}  // namespace pol
