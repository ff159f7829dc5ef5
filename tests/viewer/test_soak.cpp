// SPDX-License-Identifier: Apache-2.0
// Random clicks, drags, keys, edits, resizes and broken files on the whole interface, while workers trace and the
// picture is drawn by EGL: for POL_SOAK_SECONDS (10, twice), from POL_SOAK_SEED (1). What goes wrong is for assertions
// and sanitizers to find.
#include <gtest/gtest.h>
#include <imgui.h>

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "support/egl_context.h"
#include "viewer/commands/commands.h"
#include "viewer/gl/gl.h"
#include "viewer/injected_input.h"
#include "viewer/panels/interface.h"
#include "viewer/picture/picture_renderer.h"
#include "viewer/widgets/fonts.h"
#include "viewer/widgets/widget_map.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

double number_from(const char* variable, double otherwise) {
    const char* text = std::getenv(variable);
    return text == nullptr ? otherwise : std::atof(text);
}

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Memory that the program holds of what it asked for, MiB: not what the heap keeps of what was given back.
double held_mib() {
    const auto heap = ::mallinfo2();
    return static_cast<double>(heap.uordblks + heap.hblkhd) / (1024.0 * 1024.0);
}

constexpr const char* cube = R"(
title: Soak
render: {size: [96, 72], spp: 4, wavelengths: 450:650:100}
camera: {position: [1.6, -3, 2.2], target: [0, 0, -0.1], fov: 28}
media: {glass: 1.5}
objects:
  - name: cube
    shape: {box: {size: 1}}
    medium: glass
  - name: light
    shape: {rectangle: {size: 3}}
    transform: [{translate: [0, 0, -0.6]}]
    emission: {radiance: {d65: 1}}
)";

/// The window without a screen, and somebody who does not know what he does.
class Monkey {
public:
    Monkey(std::uint64_t seed, bool draws) : random_(seed), session_([] {}) {
        folder_ = fs::temp_directory_path() / ("polariscope-soak-" + std::to_string(::getpid()));
        fs::create_directories(folder_);
        // The welcome page offers the shipped scenes, and whoever does anything also saves over them.
        fs::copy(POL_ASSETS, folder_ / "assets", fs::copy_options::recursive);
        ::setenv("POLARISCOPE_ASSETS", (folder_ / "assets").c_str(), 1);
        fs::current_path(folder_);
        write_scene(cube);
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;  // as OpenGL 3.3 has: large lists
        io.DisplaySize = {1280.0F, 800.0F};
        io.DeltaTime = 1.0F / 60.0F;
        load_fonts(1.0);
        io.Fonts->Build();
        if (!draws) return;
        context_.emplace();
        if (context_->problem().empty()) picture_ = PictureRenderer::create().value();
    }
    ~Monkey() {
        picture_.reset();
        ImGui::DestroyContext();
        fs::current_path(fs::temp_directory_path());
        fs::remove_all(folder_);
    }

    void act_once() {
        using Act = void (Monkey::*)();
        constexpr std::array acts{&Monkey::move,   &Monkey::click,          &Monkey::click,   &Monkey::drag,
                                  &Monkey::wheel,  &Monkey::command,        &Monkey::command, &Monkey::type,
                                  &Monkey::press,  &Monkey::edit,           &Monkey::edit,    &Monkey::pin,
                                  &Monkey::resize, &Monkey::save_elsewhere, &Monkey::open,    &Monkey::rest};
        constexpr std::array<double, 16> weights{8, 8, 8, 4, 4, 8, 8, 3, 3, 3, 3, 4, 1, 0.5, 1, 3};
        std::discrete_distribution<std::size_t> which(weights.begin(), weights.end());
        const Act act = acts[which(random_)];
        (this->*act)();
    }

    /// MiB that the program holds without any document: those differ in size and come and go.
    double empty_mib() {
        while (session_.current() != nullptr) session_.close_document();
        for (int i = 0; i < 3; ++i) frame();
        while (!session_.exports().idle()) rest();
        double held = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 20; ++i) {  // what works in the background ends a little later
            rest();
            held = std::min(held, held_mib());
        }
        open();
        return held;
    }

    [[nodiscard]] std::uint64_t frames() const { return frames_; }
    /// Why the picture cannot be drawn; empty: it can.
    [[nodiscard]] std::string problem() const { return context_ ? context_->problem() : "nothing is drawn"; }

private:
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }

    void frame() {
        ImGuiIO& io = ImGui::GetIO();
        io.UserData = &widgets_;
        widgets_.rects.clear();
        session_.update();
        if (picture_) picture_->upload(session_);
        ImGui::NewFrame();
        Frame frame;
        Wishes wishes = interface_.draw(session_, frame);
        ImGui::Render();
        wishes.fulfil(session_);
        if (picture_) {
            picture_->render(session_, std::max(1, static_cast<int>(frame.viewport.size.x)),
                             std::max(1, static_cast<int>(frame.viewport.size.y)), 1.0);
            ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        }
        ++frames_;
        if (session_.current() != nullptr && session_.window().panels_visible) {
            ASSERT_TRUE(std::isfinite(session_.transform().scale));
            ASSERT_TRUE(std::isfinite(session_.transform().offset.x) && std::isfinite(session_.transform().offset.y));
        }
        // The monkey may not leave.
        session_.change_window().ended = false;
        session_.change_window().ui_scale = 0.0;
    }

    /// A named widget, or anywhere.
    ImVec2 somewhere() {
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        if (widgets_.rects.empty() || uniform(0, 1) < 0.4)
            return {static_cast<float>(uniform(0, size.x)), static_cast<float>(uniform(0, size.y))};
        auto widget = widgets_.rects.begin();
        std::advance(widget, below(widgets_.rects.size()));
        const ViewRect& rect = widget->second;
        return {static_cast<float>(rect.origin.x + uniform(0, 1) * rect.size.x),
                static_cast<float>(rect.origin.y + uniform(0, 1) * rect.size.y)};
    }

    void move() {
        test::put_mouse(somewhere());
        frame();
    }
    void click() {
        move();
        const int button = uniform(0, 1) < 0.85 ? 0 : 1;
        test::hold_button(button, true);
        frame();
        test::hold_button(button, false);
        frame();
    }
    void drag() {
        move();
        test::hold_button(0, true);
        frame();
        for (int i = 0; i < 4; ++i) move();
        test::hold_button(0, false);
        frame();
    }
    void wheel() {
        move();
        test::turn_wheel(static_cast<float>(uniform(-3, 3)));
        frame();
    }
    /// A key as the window passes it on.
    void command() {
        const Command& any = commands()[below(commands().size())];
        if (!session_.window().modal()) run_command(session_, any.chord);
        frame();
    }
    void type() {
        for (int i = 0; i < 3; ++i) ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(uniform(32, 127)));
        frame();
    }
    void press() {
        constexpr std::array keys{ImGuiKey_Enter,     ImGuiKey_Escape, ImGuiKey_UpArrow,   ImGuiKey_DownArrow,
                                  ImGuiKey_Backspace, ImGuiKey_Tab,    ImGuiKey_LeftArrow, ImGuiKey_RightArrow};
        const ImGuiKey key = keys[below(keys.size())];
        test::hold_key(key, true);
        frame();
        test::hold_key(key, false);
        frame();
    }
    void rest() {
        std::this_thread::sleep_for(std::chrono::milliseconds(static_cast<int>(uniform(1, 30))));
        for (int i = 0; i < 3; ++i) frame();
    }
    void resize() {
        ImGui::GetIO().DisplaySize = {std::floor(static_cast<float>(uniform(320, 2600))),
                                      std::floor(static_cast<float>(uniform(240, 1600)))};
        frame();
    }
    void pin() {
        if (session_.current() == nullptr) return;
        const StokesImage& picture = session_.current()->picture();
        session_.pin(
            {static_cast<int>(uniform(-2, picture.width + 2)), static_cast<int>(uniform(-2, picture.height + 2))});
        frame();
    }
    void edit() {
        Document* document = session_.current();
        if (document == nullptr || !document->has_scene()) return;
        Scene scene = document->scene();
        if (uniform(0, 1) < 0.5) {
            scene.camera.position =
                scene.camera.position + DVec3(uniform(-0.1, 0.1), uniform(-0.1, 0.1), uniform(0, 0.1));
        } else if (!scene.media.empty()) {
            scene.media[below(scene.media.size())].matter = IsotropicMedium{ConstantIndex{{uniform(0.5, 2.5), 0.0}}};
        }
        if (uniform(0, 1) < 0.1) scene.camera.target = scene.camera.position;  // cannot be rendered
        (void)document->edit(std::move(scene), "soak");
        if (uniform(0, 1) < 0.5) document->end_edit();
        frame();
    }
    /// Another program saves the file, sometimes half of it.
    void save_elsewhere() {
        const std::string text = cube;
        write_scene(uniform(0, 1) < 0.3 ? text.substr(0, below(text.size())) : text);
        rest();
    }
    void open() {
        for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
            if (entry.is_regular_file() && entry.path() != scene_ && uniform(0, 1) < 0.7) fs::remove(entry.path());
        while (session_.documents().size() > 2) session_.close_document();
        session_.open(scene_);
        frame();
    }
    void write_scene(const std::string& text) { std::ofstream(scene_ = folder_ / "soak.yaml") << text; }

    std::optional<EglContext> context_;
    std::unique_ptr<PictureRenderer> picture_;
    std::mt19937_64 random_;
    fs::path folder_;
    fs::path scene_;
    WidgetMap widgets_;
    Session session_;
    Interface interface_;
    std::uint64_t frames_ = 0;
};

double soak_seconds() {
    return number_from("POL_SOAK_SECONDS", 10.0);
}

std::uint64_t soak_seed() {
    return static_cast<std::uint64_t>(number_from("POL_SOAK_SEED", 1.0));
}

TEST(Soak, SurvivesAUserWhoDoesAnything) {
    Monkey monkey(soak_seed(), true);
    ASSERT_EQ(monkey.problem(), "");
    for (const double begin = seconds(); seconds() - begin < soak_seconds() && !HasFailure();) monkey.act_once();
    // The lowest free name comes next: what is not deleted drives it up. Memory says little here, since drivers compile
    // a shader for every new combination of states and keep it.
    std::array<GLuint, 4> next{};
    glGenTextures(1, next.data());
    glGenFramebuffers(1, &next[1]);
    glGenBuffers(1, &next[2]);
    glGenVertexArrays(1, &next[3]);
    for (const GLuint name : next) EXPECT_LT(name, 40u);
}

TEST(Soak, LeavesNoMemoryBehind) {
    const double length = soak_seconds();
    Monkey monkey(soak_seed(), false);
    double settled_mib = 0.0;  // after a third, when caches and buffers have their size
    std::uint64_t settled_frames = 0;
    for (const double begin = seconds(); seconds() - begin < length && !HasFailure();) {
        monkey.act_once();
        if (settled_mib == 0.0 && seconds() - begin > length / 3.0) {
            settled_mib = monkey.empty_mib();
            settled_frames = monkey.frames();
        }
    }
    const double growth = monkey.empty_mib() - settled_mib;
    const auto frames = static_cast<double>(monkey.frames() - settled_frames);
    std::printf("seed %llu: %.0f frames; memory %.0f MiB after a third, %+.1f MiB since\n",
                static_cast<unsigned long long>(soak_seed()), frames, settled_mib, growth);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    // Half of what a leak of 4 kB a frame would hold, and the capacity of what grew with the largest scene so far.
    EXPECT_LT(growth, 8.0 + 0.002 * frames);
#endif
}

}  // namespace
}  // namespace pol
