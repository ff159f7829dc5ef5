// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/app_window.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "viewer/commands/commands.h"
#include "viewer/commands/unsaved_edits.h"
#include "viewer/gl/gl.h"
#include "viewer/widgets/fonts.h"

namespace pol {

namespace {

Error usage(std::string what, std::string hint) {
    const char* reason = nullptr;
    if (glfwGetError(&reason) != GLFW_NO_ERROR && reason != nullptr) what += std::string(": ") + reason;
    return {ErrorKind::usage, std::move(what), {}, {}, std::move(hint)};
}

/// Keys that have no ASCII code.
constexpr std::array named_keys{
    std::pair{GLFW_KEY_ESCAPE, Key::escape},   std::pair{GLFW_KEY_ENTER, Key::enter},
    std::pair{GLFW_KEY_KP_ENTER, Key::enter},  std::pair{GLFW_KEY_TAB, Key::tab},
    std::pair{GLFW_KEY_DELETE, Key::del},      std::pair{GLFW_KEY_BACKSPACE, Key::backspace},
    std::pair{GLFW_KEY_HOME, Key::home},       std::pair{GLFW_KEY_END, Key::end},
    std::pair{GLFW_KEY_PAGE_UP, Key::page_up}, std::pair{GLFW_KEY_PAGE_DOWN, Key::page_down},
    std::pair{GLFW_KEY_LEFT, Key::left},       std::pair{GLFW_KEY_RIGHT, Key::right},
    std::pair{GLFW_KEY_UP, Key::up},           std::pair{GLFW_KEY_DOWN, Key::down},
    std::pair{GLFW_KEY_KP_ADD, letter('=')},   std::pair{GLFW_KEY_KP_SUBTRACT, letter('-')},
};

Key key_of(int glfw_key) {
    for (const auto& [number, key] : named_keys)
        if (number == glfw_key) return key;
    const auto nth_after = [glfw_key](Key first, int number_of_first) {
        return static_cast<Key>(static_cast<int>(first) + glfw_key - number_of_first);
    };
    if (glfw_key >= GLFW_KEY_F1 && glfw_key <= GLFW_KEY_F12) return nth_after(Key::f1, GLFW_KEY_F1);
    if (glfw_key >= GLFW_KEY_KP_0 && glfw_key <= GLFW_KEY_KP_9) return nth_after(letter('0'), GLFW_KEY_KP_0);
    return glfw_key >= GLFW_KEY_SPACE && glfw_key < 127 ? static_cast<Key>(glfw_key) : Key::none;
}

AppWindow& self(GLFWwindow* window) {
    return *static_cast<AppWindow*>(glfwGetWindowUserPointer(window));
}

/// Keys come from the window's own callback: ImGui 1.86 misses a press and release within one frame.
void on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
    self(window).note_input();
    self(window).tell_key(key, scancode, action, modifiers);
    constexpr int foreign = GLFW_MOD_ALT | GLFW_MOD_SUPER;
    Session& session = self(window).session();
    if (action == GLFW_RELEASE) release_key(session, key_of(key));
    if (action == GLFW_RELEASE || (modifiers & foreign) != 0 || session.window().modal()) return;
    const KeyChord chord{key_of(key), (modifiers & GLFW_MOD_CONTROL) != 0, (modifiers & GLFW_MOD_SHIFT) != 0};
    if (ImGui::GetIO().WantTextInput && edits_text(chord)) return;
    run_command(session, chord, action == GLFW_REPEAT);
}

void on_drop(GLFWwindow* window, int count, const char** paths) {
    self(window).note_input();
    for (int i = 0; i < count; ++i) self(window).session().open(paths[i]);
}

void on_close(GLFWwindow* window) {
    glfwSetWindowShouldClose(window, GLFW_FALSE);
    self(window).note_input();
    end_or_ask(self(window).session());
}

/// Before ImGui's back end puts its own callbacks in front, which call these in turn.
void set_callbacks(GLFWwindow* window) {
    glfwSetDropCallback(window, on_drop);
    glfwSetWindowCloseCallback(window, on_close);
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double, double) { self(w).note_input(); });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int, int, int) { self(w).note_input(); });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double) { self(w).note_input(); });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned int) { self(w).note_input(); });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int) { self(w).note_input(); });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int) { self(w).note_input(); });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { self(w).note_input(); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { self(w).note_input(); });
    glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float, float) { self(w).note_input(); });
}

}  // namespace

Result<std::unique_ptr<WindowLibrary>> WindowLibrary::start() {
#ifdef GLFW_PLATFORM
    // GLFW 3.4 asks for a Wayland display first, whose library complains on stderr where there is none.
    if (std::getenv("WAYLAND_DISPLAY") == nullptr) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
    if (glfwInit() == GLFW_FALSE)
        return usage("there is no display to open a window on",
                     "render to a file instead: polariscope render SCENE -o OUT.exr");
    return std::unique_ptr<WindowLibrary>(new WindowLibrary);
}

WindowLibrary::~WindowLibrary() {
    glfwTerminate();
}

double WindowLibrary::now() const {
    return glfwGetTime();
}

void WindowLibrary::wake() {
    if (!woken_.exchange(true)) glfwPostEmptyEvent();
}

void WindowLibrary::wait(double seconds) {
    seconds > 0.0 ? glfwWaitEventsTimeout(seconds) : glfwPollEvents();
}

Result<std::unique_ptr<AppWindow>> AppWindow::open(Session& session, const AppOptions& options) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    // By which the desktop finds name and icon of the window: the desktop entry is called so.
    constexpr const char* desktop_entry = "io.github.polariscope.Polariscope";
    glfwWindowHintString(GLFW_X11_CLASS_NAME, desktop_entry);
#ifdef GLFW_WAYLAND_APP_ID
    glfwWindowHintString(GLFW_WAYLAND_APP_ID, desktop_entry);
#endif
    GLFWwindow* window =
        glfwCreateWindow(options.width, options.height, window_title(session).c_str(), nullptr, nullptr);
    if (window == nullptr)
        return usage("no window with OpenGL 3.3", "install a driver for OpenGL, such as libgl1-mesa-dri");
    std::unique_ptr<AppWindow> opened(new AppWindow(window, session));
    glfwSetWindowUserPointer(window, opened.get());
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().ConfigWindowsMoveFromTitleBarOnly = true;
    set_callbacks(window);
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    glfwSetKeyCallback(window, on_key);  // in place of ImGui's, which it calls
    ImGui_ImplOpenGL3_Init("#version 330 core");
    return opened;
}

AppWindow::~AppWindow() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
}

double AppWindow::begin_frame() {
    float x_scale = 1.0F;
    float y_scale = 1.0F;
    glfwGetWindowContentScale(window_, &x_scale, &y_scale);
    const double wanted = session_->window().ui_scale;
    // Where points are larger than pixels, the system already scales what is drawn in points.
    const double scale = wanted > 0.0 ? wanted : std::max(1.0, x_scale / pixel_ratio());
    if (scale != font_scale_) {
        if (const auto missing = load_fonts(scale)) session_->say(Severity::warning, *missing);
        if (font_scale_ != 0.0) ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
        font_scale_ = scale;
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    return scale;
}

bool AppWindow::input_waits() const {
#if IMGUI_VERSION_NUM < 18700
    return false;
#else
    return !ImGui::GetCurrentContext()->InputEventsQueue.empty();
#endif
}

double AppWindow::pixel_ratio() const {
    int points = 0;
    int pixels = 0;
    int height = 0;
    glfwGetWindowSize(window_, &points, &height);
    glfwGetFramebufferSize(window_, &pixels, &height);
    return points > 0 ? static_cast<double>(pixels) / points : 1.0;
}

namespace {

/// The frame that is about to be shown, rows from the top.
RgbPicture read_frame(int width, int height) {
    RgbPicture picture{width, height, {}};
    picture.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, picture.pixels.data());
    for (int y = 0; y < height / 2; ++y) {  // GL's rows go up
        const auto row = picture.pixels.begin() + static_cast<std::ptrdiff_t>(y) * width;
        std::swap_ranges(row, row + width,
                         picture.pixels.begin() + static_cast<std::ptrdiff_t>(height - 1 - y) * width);
    }
    return picture;
}

}  // namespace

void AppWindow::end_frame(const std::function<void(RgbPicture)>& take) {
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    glViewport(0, 0, width, height);
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (take && width > 0 && height > 0) take(read_frame(width, height));
    glfwSwapBuffers(window_);
    pressed_ = false;
    for (const Release& release : std::exchange(released_, {}))
        ImGui_ImplGlfw_KeyCallback(window_, release.key, release.scancode, GLFW_RELEASE, release.modifiers);
}

void AppWindow::tell_key(int key, int scancode, int action, int modifiers) {
    if (action == GLFW_PRESS) pressed_ = true;
    if (action == GLFW_RELEASE && pressed_)
        released_.push_back({key, scancode, modifiers});
    else
        ImGui_ImplGlfw_KeyCallback(window_, key, scancode, action, modifiers);
}

void AppWindow::follow(const Session& session) {
    if (std::string title = window_title(session); title != title_) {
        glfwSetWindowTitle(window_, title.c_str());
        title_ = std::move(title);
    }
    if (session.window().full_screen != full_screen_) set_full_screen(session.window().full_screen);
}

void AppWindow::set_full_screen(bool full) {
    auto& [x, y, width, height] = windowed_;
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    if (full && mode != nullptr) {
        glfwGetWindowPos(window_, &x, &y);
        glfwGetWindowSize(window_, &width, &height);
        glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    } else if (!full) {
        glfwSetWindowMonitor(window_, nullptr, x, y, width, height, GLFW_DONT_CARE);
    }
    full_screen_ = full;
}

std::string window_title(const Session& session) {
    const Document* document = session.current();
    if (document == nullptr) return "polariscope";
    std::string title = document->name() + (document->dirty() ? " *" : "");
    if (const RenderProgress progress = document->progress(); document->has_scene() && !progress.finished)
        title += " - " + std::to_string(static_cast<int>(100.0 * progress.done)) + " %";
    return title + " - polariscope";
}

}  // namespace pol
