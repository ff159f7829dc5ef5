// SPDX-License-Identifier: Apache-2.0
// What the window itself shows besides its panels' contents: questions, theme, layout, and what it is asked to do next.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "viewer/shown/appearance.h"

namespace pol {

/// Widths that the user drags, in points at scale 1.
struct Layout {
    double left_width = 250.0;
    double right_width = 400.0;
    double upper_share = 0.5;  ///< of the right side's height, where it is split
    friend bool operator==(const Layout&, const Layout&) = default;
};

enum class Quit : std::uint8_t {
    no,
    asked,      ///< the window asks what to do with unsaved edits, if there are any
    confirmed,  ///< ends now
};

struct WindowState {
    bool panels_visible = true;
    bool help_visible = false;
    bool log_visible = false;
    bool palette_visible = false;     ///< commands to type
    bool path_entry_visible = false;  ///< a file name to type
    bool save_as_visible = false;     ///< a file name for the scene to type
    bool rewrite_asked = false;       ///< of the current document's file, which cannot take an edit as it is
    bool full_screen = false;
    Theme theme = Theme::dark;
    double ui_scale = 0.0;  ///< of fonts and widgets; 0: what the screen says
    Layout layout;
    Quit quit = Quit::no;
    bool close_asked = false;    ///< of the current document
    bool popup_open = false;     ///< a menu, a combo: set by the interface
    bool close_popups = false;   ///< taken by the interface
    bool fact_to_front = false;  ///< the page of the document's fact; taken by the interface
    std::string to_clipboard;    ///< taken by the interface; empty: nothing
    /// PNG file that the next frame is wanted as; taken by whoever shows it. Empty: none.
    std::filesystem::path picture_of_window;

    /// A question or an entry is open: keys belong to it.
    [[nodiscard]] bool modal() const {
        return palette_visible || path_entry_visible || save_as_visible || rewrite_asked || close_asked ||
               quit == Quit::asked;
    }
};

}  // namespace pol
