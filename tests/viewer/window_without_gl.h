// SPDX-License-Identifier: Apache-2.0
// The whole interface without a window: frames, injected mouse, and what is written on the panels.
#pragma once

#include <imgui.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "viewer/injected_input.h"
#include "viewer/panels/interface.h"
#include "viewer/shown/picture_place.h"

namespace pol {

class WindowWithoutGl {
public:
    explicit WindowWithoutGl(float width = 1280.0F, float height = 800.0F) {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;  // as OpenGL 3.3 has: large lists
        io.DisplaySize = {width, height};
        io.DeltaTime = 1.0F / 60.0F;
        test::put_mouse({-1.0F, -1.0F});
        unsigned char* pixels = nullptr;
        int w = 0;
        int h = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &w, &h);
    }
    ~WindowWithoutGl() { ImGui::DestroyContext(); }
    WindowWithoutGl(const WindowWithoutGl&) = delete;
    WindowWithoutGl& operator=(const WindowWithoutGl&) = delete;

    void draw(int frames = 2) {
        for (int i = 0; i < frames; ++i) {
            session.update();
            ImGui::NewFrame();
            Wishes wanted = interface.draw(session, frame);
            ImGui::Render();
            wanted.fulfil(session);
        }
    }

    /// What `draw` writes; it may leave something in `wishes`. ImGui ends its log with the window, so this is a window
    /// of its own.
    template <class Draw>
    std::string text_of(const Draw& draw_panel) {
        const auto path =
            std::filesystem::temp_directory_path() / ("polariscope_log_" + std::to_string(getpid()) + ".txt");
        ImGui::NewFrame();
        ImGui::SetNextWindowSize({400.0F, 4000.0F});
        ImGui::Begin("log");
        ImGui::LogToFile(-1, path.c_str());
        draw_panel();
        ImGui::LogFinish();
        ImGui::End();
        ImGui::Render();
        wishes.fulfil(session);
        std::ifstream file(path);
        std::string all{std::istreambuf_iterator<char>(file), {}};
        std::filesystem::remove(path);
        return all;
    }

    void move(const DVec2& at) {
        test::put_mouse({static_cast<float>(std::floor(at.x)), static_cast<float>(std::floor(at.y))});
        draw();
    }
    void press() {
        test::hold_button(0, true);
        draw();
    }
    void release() {
        test::hold_button(0, false);
        draw();
    }
    void click(const DVec2& at) {
        move(at);
        press();
        release();
    }
    void drag(const DVec2& from, const DVec2& to) {
        move(from);
        press();
        move(0.5 * (from + to));
        move(to);
        release();
    }
    void turn_wheel(float notches) {
        test::turn_wheel(notches);
        draw();
    }

    /// Where the center of a pixel lies in the window.
    [[nodiscard]] DVec2 place_of(PixelAddress pixel) const {
        const ViewTransform placed = of_part(session.transform(), corner_of(session.current()->picture()));
        return frame.viewport.origin + placed.view_from_picture({pixel.x + 0.5, pixel.y + 0.5});
    }

    Session session;
    Interface interface;
    Frame frame;
    Wishes wishes;  ///< of panels that are drawn without the interface
};

}  // namespace pol
