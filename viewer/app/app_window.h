// SPDX-License-Identifier: Apache-2.0
// A window with OpenGL 3.3 and ImGui, and what the user does with it.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "maps/colorize.h"
#include "viewer/app/app.h"
#include "viewer/session/session.h"

struct GLFWwindow;

namespace pol {

/// The window library, on from construction to destruction. Main thread only.
class WindowLibrary {
public:
    /// Error (kind usage): there is no display.
    static Result<std::unique_ptr<WindowLibrary>> start();
    ~WindowLibrary();
    WindowLibrary(const WindowLibrary&) = delete;
    WindowLibrary& operator=(const WindowLibrary&) = delete;

    /// Seconds on a steady clock.
    [[nodiscard]] double now() const;

    /// Ends wait() soon. Any thread; many calls between two clear_wake() cost one event.
    void wake();
    /// True if wake() was called since the last time.
    bool clear_wake() { return woken_.exchange(false); }
    [[nodiscard]] bool woken() const { return woken_; }

    /// Handles what the user does, for at most `seconds` if that is nothing.
    void wait(double seconds);

private:
    WindowLibrary() = default;
    std::atomic<bool> woken_{false};
};

/// Owns the window, its GL context (current while it lives) and the ImGui context. Main thread only.
class AppWindow {
public:
    /// Error (kind usage): no OpenGL 3.3. `session` gets keys and dropped files; it must outlive the window.
    static Result<std::unique_ptr<AppWindow>> open(Session& session, const AppOptions& options);
    ~AppWindow();
    AppWindow(const AppWindow&) = delete;
    AppWindow& operator=(const AppWindow&) = delete;

    /// True once after something happened that the picture may depend on: input, resize, exposure.
    bool take_input() { return std::exchange(input_, false); }
    /// True if ImGui keeps input for the next frame, as it does since 1.87: a press and its release take a frame each.
    [[nodiscard]] bool input_waits() const;

    /// Begins a frame of ImGui; fonts fit the screen and the user's scale. Returns the scale of fonts and widgets.
    double begin_frame();
    /// Device pixels per logical point.
    [[nodiscard]] double pixel_ratio() const;
    /// Shows what ImGui has been told since begin_frame(); `take` gets the whole window as it is shown, if it is given.
    void end_frame(const std::function<void(RgbPicture)>& take = {});

    /// Follows the session: title, full screen.
    void follow(const Session& session);

    /// Called by GLFW's callbacks.
    void note_input() { input_ = true; }
    /// Tells ImGui of a key. It looks only once a frame: releases wait until it has seen what was pressed before them,
    /// or short presses, and Ctrl with them, would be lost.
    void tell_key(int key, int scancode, int action, int modifiers);
    Session& session() { return *session_; }

private:
    AppWindow(GLFWwindow* window, Session& session) : window_(window), session_(&session) {}
    void set_full_screen(bool full);

    GLFWwindow* window_;
    Session* session_;
    bool input_ = true;
    struct Release {
        int key;
        int scancode;
        int modifiers;
    };
    bool pressed_ = false;           // something, since the last frame
    std::vector<Release> released_;  // not told yet
    double font_scale_ = 0.0;        // of the fonts that are loaded
    std::string title_;
    bool full_screen_ = false;
    int windowed_[4] = {0, 0, 0, 0};  // place and size before full screen
};

/// What the title bar says: file, mark of unsaved edits, progress.
std::string window_title(const Session& session);

}  // namespace pol
