// SPDX-License-Identifier: Apache-2.0
// Mouse and keys that no window sent. Before 1.89 ImGui's input is plain state, since then a queue of events.
#pragma once

#include <imgui.h>

namespace pol::test {

/// In points from the window's top left.
inline void put_mouse(const ImVec2& at) {
#if IMGUI_VERSION_NUM < 18900
    ImGui::GetIO().MousePos = at;
#else
    ImGui::GetIO().AddMousePosEvent(at.x, at.y);
#endif
}

/// 0 left, 1 right, 2 middle.
inline void hold_button(int button, bool down) {
#if IMGUI_VERSION_NUM < 18900
    ImGui::GetIO().MouseDown[button] = down;
#else
    ImGui::GetIO().AddMouseButtonEvent(button, down);
#endif
}

/// Notches, up positive, for the next frame.
inline void turn_wheel(float notches) {
#if IMGUI_VERSION_NUM < 18900
    ImGui::GetIO().MouseWheel = notches;
#else
    ImGui::GetIO().AddMouseWheelEvent(0.0F, notches);
#endif
}

inline void hold_shift(bool down) {
#if IMGUI_VERSION_NUM < 18900
    ImGui::GetIO().KeyShift = down;
#else
    ImGui::GetIO().AddKeyEvent(ImGuiMod_Shift, down);
#endif
}

inline void hold_alt(bool down) {
#if IMGUI_VERSION_NUM < 18900
    ImGui::GetIO().KeyAlt = down;
#else
    ImGui::GetIO().AddKeyEvent(ImGuiMod_Alt, down);
#endif
}

/// A key that is no modifier.
inline void hold_key(ImGuiKey key, bool down) {
#if IMGUI_VERSION_NUM < 18900
    ImGui::GetIO().KeyMap[key] = key;
    ImGui::GetIO().KeysDown[key] = down;
#else
    ImGui::GetIO().AddKeyEvent(key, down);
#endif
}

}  // namespace pol::test
