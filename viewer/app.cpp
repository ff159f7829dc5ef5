// SPDX-License-Identifier: Apache-2.0
#include "viewer/app.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <csignal>
#include <cstring>
#include <string>

#include "viewer/commands.h"
#include "viewer/gl/gl.h"
#include "viewer/interface.h"
#include "viewer/picture_renderer.h"

namespace pol {

namespace {

volatile std::sig_atomic_t end_requested = 0;

void remember_signal(int /*signal*/) {
    end_requested = 1;
}

std::string last_glfw_error;

Key key_of(int glfw_key) {
    switch (glfw_key) {
        case GLFW_KEY_ESCAPE:
            return Key::escape;
        case GLFW_KEY_ENTER:
            return Key::enter;
        case GLFW_KEY_TAB:
            return Key::tab;
        case GLFW_KEY_DELETE:
            return Key::del;
        case GLFW_KEY_LEFT:
            return Key::left;
        case GLFW_KEY_RIGHT:
            return Key::right;
        case GLFW_KEY_UP:
            return Key::up;
        case GLFW_KEY_DOWN:
            return Key::down;
        default:
            break;
    }
    if (glfw_key >= GLFW_KEY_F1 && glfw_key <= GLFW_KEY_F12)
        return static_cast<Key>(static_cast<int>(Key::f1) + glfw_key - GLFW_KEY_F1);
    return glfw_key < 128 ? static_cast<Key>(glfw_key) : Key::none;
}

/// Keys come from the window's own callback: ImGui 1.86 misses a press and release within one frame.
void on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
    ImGui_ImplGlfw_KeyCallback(window, key, scancode, action, modifiers);
    if (action == GLFW_RELEASE || ImGui::GetIO().WantTextInput) return;
    auto& session = *static_cast<Session*>(glfwGetWindowUserPointer(window));
    run_command(session, {key_of(key), (modifiers & GLFW_MOD_CONTROL) != 0, (modifiers & GLFW_MOD_SHIFT) != 0});
}

void on_drop(GLFWwindow* window, int count, const char** paths) {
    auto& session = *static_cast<Session*>(glfwGetWindowUserPointer(window));
    for (int i = 0; i < count; ++i) session.open(paths[i]);
}

void run_loop(GLFWwindow* window, Session& session, PictureRenderer& picture) {
    Interface interface;
    while (glfwWindowShouldClose(window) == 0 && end_requested == 0 && !session.quit_requested) {
        glfwWaitEventsTimeout(0.25);
        session.update();
        picture.upload(session);
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        int width = 0;
        int height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        Frame frame;
        const double ratio = ImGui::GetIO().DisplayFramebufferScale.x;
        static std::uint32_t texture = 0;
        frame.picture_texture = texture;
        interface.draw(session, frame);
        ImGui::Render();
        texture = picture.render(session, std::max(1, static_cast<int>(frame.viewport.size.x * ratio)),
                                 std::max(1, static_cast<int>(frame.viewport.size.y * ratio)), ratio);
        glViewport(0, 0, width, height);
        glClear(GL_COLOR_BUFFER_BIT);
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        glfwSwapBuffers(window);
    }
}

}  // namespace

Result<Done> run_app(const std::vector<std::filesystem::path>& files) {
    glfwSetErrorCallback([](int /*code*/, const char* text) { last_glfw_error = text; });
    if (glfwInit() == 0)
        return Error{ErrorKind::usage,
                     "there is no display: " + last_glfw_error,
                     {},
                     {},
                     "render to a file instead: polariscope render SCENE -o OUT.exr"};
    std::signal(SIGTERM, remember_signal);
    std::signal(SIGINT, remember_signal);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    GLFWwindow* window = glfwCreateWindow(1280, 800, "polariscope", nullptr, nullptr);
    if (window == nullptr) {
        glfwTerminate();
        return Error{ErrorKind::usage,
                     "no window with OpenGL 3.3: " + last_glfw_error,
                     {},
                     {},
                     "install a GL driver such as libgl1-mesa-dri"};
    }
    glfwMakeContextCurrent(window);
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    Result<Done> result = Done{};
    {
        Session session(glfwPostEmptyEvent);
        glfwSetWindowUserPointer(window, &session);
        ImGui_ImplGlfw_InitForOpenGL(window, true);
        ImGui_ImplOpenGL3_Init("#version 330 core");
        glfwSetKeyCallback(window, on_key);
        glfwSetDropCallback(window, on_drop);
        for (const auto& file : files) session.open(file);
        auto picture = PictureRenderer::create();
        if (picture)
            run_loop(window, session, *picture.value());
        else
            result = picture.error();
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
    }
    ImGui::DestroyContext();
    glfwDestroyWindow(window);
    glfwTerminate();
    return result;
}

}  // namespace pol
