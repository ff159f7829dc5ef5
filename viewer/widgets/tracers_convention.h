// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <imgui.h>

#include "viewer/shown/convention.h"

namespace pol {

/// A line for panels that show the light as the tracer has it, if the rest of the window is labeled otherwise.
inline void say_tracers_convention(const Convention& shown) {
    if (shown == Convention{}) return;
    ImGui::TextDisabled("in the tracer's convention: %s", Convention{}.text().c_str());
}

}  // namespace pol
