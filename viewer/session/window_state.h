// SPDX-License-Identifier: Apache-2.0
// What the window itself shows besides its panels' contents: questions, theme, layout. All of it lasts until it is
// changed; nothing here waits for somebody to take it.
#pragma once

#include <cstdint>

#include "viewer/shown/appearance.h"

namespace pol {

/// Widths that the user drags, in points at scale 1.
struct Layout {
    double left_width = 250.0;
    double right_width = 400.0;
    double upper_share = 0.5;  ///< of the right side's height, where it is split
    friend bool operator==(const Layout&, const Layout&) = default;
};

/// What the window asks; keys wait for the answer (viewer/commands/unsaved_edits.h).
enum class Question : std::uint8_t {
    none,
    unsaved_at_close,  ///< edits of the current document, which is to be closed
    unsaved_at_end,    ///< edits of any document, before the program ends
    rewrite,           ///< whether to write the current document's file anew, which cannot take an edit as it is
    layout,            ///< in which of several layouts that fit a picture is to be read
};

struct WindowState {
    bool panels_visible = true;
    bool help_visible = false;
    bool log_visible = false;
    bool palette_visible = false;     ///< commands to type
    bool path_entry_visible = false;  ///< a file name to type
    bool save_as_visible = false;     ///< a file name for the scene to type
    bool go_to_visible = false;       ///< a pixel to type
    bool send_visible = false;        ///< an address to type that the picture is sent to
    bool full_screen = false;
    Theme theme = Theme::dark;
    double ui_scale = 0.0;  ///< of fonts and widgets; 0: what the screen says
    Layout layout;
    Question question = Question::none;
    bool popup_open = false;  ///< a menu, a combo; false closes them
    bool ended = false;       ///< the program

    /// A question or an entry is open: keys belong to it.
    [[nodiscard]] bool modal() const {
        return palette_visible || path_entry_visible || save_as_visible || go_to_visible || send_visible ||
               question != Question::none;
    }
};

}  // namespace pol
