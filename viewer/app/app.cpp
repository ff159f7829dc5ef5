// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/app.h"

#include <imgui.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "core/result.h"
#include "viewer/app/app_probe.h"
#include "viewer/app/app_window.h"
#include "viewer/app/frame_pacer.h"
#include "viewer/panels/interface.h"
#include "viewer/picture/picture_renderer.h"
#include "viewer/session/exports.h"
#include "viewer/session/preferences.h"

namespace pol {

namespace {

/// Signals that the event loop asks for instead of being interrupted by: no handler, nothing global.
class PendingSignals {
public:
    /// Before any thread starts, so that all inherit it.
    explicit PendingSignals(bool with_probe) {
        sigemptyset(&set_);
        sigaddset(&set_, SIGTERM);
        sigaddset(&set_, SIGINT);
        if (with_probe) sigaddset(&set_, SIGUSR1);
        sigprocmask(SIG_BLOCK, &set_, nullptr);
    }
    /// A signal that has come since the last call, or nothing.
    [[nodiscard]] std::optional<int> next() const {
        constexpr timespec at_once{0, 0};
        const int signal = sigtimedwait(&set_, nullptr, &at_once);
        return signal > 0 ? std::optional(signal) : std::nullopt;
    }

private:
    sigset_t set_{};
};

/// What makes a frame worth drawing when neither the user nor a worker said so (a watched file, an export's end).
struct Shown {
    const Document* document = nullptr;
    std::uint64_t version = 0;
    std::size_t messages = 0;
    friend bool operator==(const Shown&, const Shown&) = default;
};

Shown shown(const Session& session) {
    const Document* document = session.current();
    return {document, document == nullptr ? 0 : document->picture_version(), session.log().lines().size()};
}

bool is_tracing(const Session& session) {
    const Document* document = session.current();
    return document != nullptr && document->tracing();
}

class EventLoop {
public:
    EventLoop(WindowLibrary& library, AppWindow& window, Session& session, PictureRenderer& picture,
              PictureRenderer& reference, AppProbe* probe)
        : library_(library),
          window_(window),
          session_(session),
          picture_(picture),
          reference_(reference),
          probe_(probe) {}

    void run(const PendingSignals& signals) {
        while (!session_.window().ended) {
            library_.wait(pacer_.wait(library_.now()).value_or(longest_sleep_s));
            while (const auto signal = signals.next()) obey(*signal);
            note_what_happened();
            const auto due = pacer_.wait(library_.now());
            if (due && *due <= 0.0) draw();
        }
    }

private:
    /// Signals and watched files are looked at so often while nothing happens.
    static constexpr double longest_sleep_s = 0.25;
    static constexpr double cursor_blink_s = 0.4;
    static constexpr double export_progress_s = 0.2;
    /// Of a frame, for each picture's textures.
    static constexpr double upload_share_s = 0.02;

    void obey(int signal) {
        if (signal != SIGUSR1) {
            session_.change_window().ended = true;
        } else if (probe_ != nullptr) {
            probe_->ask();
            pacer_.animate(library_.now(), 0.0);
        }
    }

    void note_what_happened() {
        const double now = library_.now();
        pacer_.set_tracing(is_tracing(session_));
        if (window_.take_input()) {
            pacer_.input(now);
            if (!input_at_) input_at_ = now;
        }
        if (library_.woken()) {
            pacer_.news();
        } else if (!pacer_.wait(now)) {
            const Shown before = shown(session_);
            session_.update();
            if (shown(session_) != before) pacer_.input(now);
        }
    }

    void draw() {
        const double start = library_.now();
        library_.clear_wake();
        session_.update();
        // Asked for in a frame before this one, whose menu was still open.
        const bool is_wanted = !session_.wanted_window_picture().empty();
        // A picture of the window shows all.
        const double upload_s = is_wanted ? std::numeric_limits<double>::infinity() : upload_share_s;
        bool is_behind = picture_.upload(session_, upload_s);
        is_behind = reference_.upload(session_, upload_s) || is_behind;
        Frame frame;
        frame.ui_scale = window_.begin_frame();
        frame.picture_texture = texture_;
        frame.reference_texture = reference_texture_;
        // A test asks for what follows from all that it has done.
        AppProbe* asked = window_.input_waits() ? nullptr : probe_;
        if (asked != nullptr) asked->begin();
        Wishes wishes = interface_.draw(session_, frame);
        ImGui::Render();
        const bool is_final = wishes.empty() && !is_behind;
        wishes.fulfil(session_);
        if (asked != nullptr) asked->end(session_, frame.viewport, is_final);
        const double ratio = window_.pixel_ratio();
        const auto pixels = [ratio](double points) { return std::max(1, static_cast<int>(points * ratio)); };
        texture_ = picture_.render(session_, pixels(frame.viewport.size.x), pixels(frame.viewport.size.y), ratio);
        const DVec2& beside = frame.reference_viewport.size;
        if (beside.x > 0.0) reference_texture_ = reference_.render(session_, pixels(beside.x), pixels(beside.y), ratio);
        window_.follow(session_);
        if (is_wanted)
            window_.end_frame([&](RgbPicture picture) { write_window(session_, std::move(picture)); });
        else
            window_.end_frame();
        const double end = library_.now();
        pacer_.drawn(start, end);
        if (window_.input_waits()) pacer_.input(end);
        if (ImGui::GetIO().WantTextInput) frame.again(cursor_blink_s);
        if (!session_.exports().idle()) frame.again(export_progress_s);
        if (is_behind) frame.again(0.0);
        if (frame.redraw_in < 1e9) pacer_.animate(end, frame.redraw_in);
        if (probe_ != nullptr) probe_->note_frame(end - start, input_at_ ? end - *input_at_ : 0.0);
        input_at_.reset();
    }

    WindowLibrary& library_;
    AppWindow& window_;
    Session& session_;
    PictureRenderer& picture_;
    PictureRenderer& reference_;
    AppProbe* probe_;
    Interface interface_;
    FramePacer pacer_;
    std::uint32_t texture_ = 0;
    std::uint32_t reference_texture_ = 0;
    std::optional<double> input_at_;  // first input that no frame has answered yet
};

/// Opens what can be opened and says on stderr what cannot. Error: nothing could.
Result<Done> open_all(Session& session, const std::vector<FileToOpen>& files) {
    const auto open = [&](const FileToOpen& file) {
        if (!file.is_picture) return session.open(file.source.path());
        if (!file.from.given()) return session.open(file.source);
        return session.open(file.source,
                            [from = file.from](const StokesConvention& readers) { return from.over(readers); });
    };
    for (const FileToOpen& file : files)
        if (!open(file)) std::fprintf(stderr, "polariscope: %s\n", session.log().lines().back().text.c_str());
    const bool is_anything_there =
        !session.documents().empty() || !session.readings().empty() || session.window().question == Question::layout;
    if (!files.empty() && !is_anything_there)
        return Error{ErrorKind::input, "there is nothing to show", {}, {}, "see the messages above"};
    return Done{};
}

}  // namespace

Result<Done> run_app(const std::vector<FileToOpen>& files, const AppOptions& options) {
    const PendingSignals signals(!options.probe.empty());
    auto library = WindowLibrary::start();
    if (!library) return library.error();
    Session session([&library] { library.value()->wake(); });
    // A run that is watched by a test starts and leaves things as they are.
    const std::filesystem::path remembered = options.probe.empty() ? preferences_path() : std::filesystem::path();
    if (const auto preferences = read_preferences(remembered))
        apply(preferences.value(), session);
    else
        session.say(Severity::warning, to_string(preferences.error()));
    WindowState& state = session.change_window();
    state.theme = options.theme.value_or(state.theme);
    state.ui_scale = options.ui_scale.value_or(state.ui_scale);
    if (options.listen) POL_TRY_DONE(session.listen(*options.listen, options.live_rules));
    POL_TRY_DONE(open_all(session, files));
    POL_TRY(auto window, AppWindow::open(session, options));
    POL_TRY(auto picture, PictureRenderer::create());
    POL_TRY(auto reference, PictureRenderer::create(PictureSide::reference));
    std::optional<AppProbe> probe;
    if (!options.probe.empty()) probe.emplace(options.probe);
    EventLoop(*library.value(), *window, session, *picture, *reference, probe ? &*probe : nullptr).run(signals);
    if (remembered.empty()) return Done{};
    // Nothing of the user's work: no reason to fail.
    if (const auto written = write_preferences(preferences_of(session), remembered); !written)
        std::fprintf(stderr, "polariscope: the window's settings are not remembered: %s\n",
                     to_string(written.error()).c_str());
    return Done{};
}

}  // namespace pol
