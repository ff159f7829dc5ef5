// SPDX-License-Identifier: Apache-2.0
// DejaVu in the sizes and weights that panels use, with the Greek, subscripts, arrows and signs that they show.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <string>

namespace pol {

enum class FontRole : std::uint8_t {
    body,
    bold,   ///< headings
    mono,   ///< numbers in columns, matrices, states
    large,  ///< the title of the welcome page
};

/// Fills the font atlas of the current ImGui context for widgets of size `scale`. Returns what to tell the user if a
/// font is missing; ImGui's own font stands in then, without Greek.
std::optional<std::string> load_fonts(double scale);

/// Never null; the default font before load_fonts().
ImFont* font(FontRole role);

}  // namespace pol
