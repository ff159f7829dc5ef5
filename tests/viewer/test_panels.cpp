// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <imgui.h>

#include "viewer/interface.h"

namespace pol {
namespace {

// The window is a function of the session: it draws without GL, and without anything open.
TEST(Interface, DrawsWithoutADocument) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1280.0F, 800.0F};
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    Session session;
    Interface interface;
    Frame frame;
    for (int i = 0; i < 3; ++i) {
        ImGui::NewFrame();
        interface.draw(session, frame);
        ImGui::Render();
    }
    EXPECT_GT(frame.viewport.size.x, 600.0);
    ImGui::DestroyContext();
}

}  // namespace
}  // namespace pol
