// SPDX-License-Identifier: Apache-2.0
// The state of the window without the window: what is open, how it is shown, what is selected. Panels read it and wish
// (wishes.h); nothing here knows ImGui or GL.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/live/live_listener.h"
#include "spectrum/wavelength_grid.h"
#include "viewer/document/document.h"
#include "viewer/document/picture_reading.h"
#include "viewer/session/explanation.h"
#include "viewer/session/export_queue.h"
#include "viewer/session/log.h"
#include "viewer/session/shipped_files.h"
#include "viewer/session/window_state.h"
#include "viewer/shown/page_settings.h"
#include "viewer/shown/polarimeter.h"
#include "viewer/shown/selection.h"
#include "viewer/shown/shown_map.h"
#include "viewer/shown/view_settings.h"
#include "viewer/shown/view_transform.h"

namespace pol {

/// Of a picture and the reference.
enum class PictureSide : std::uint8_t { current, reference };

/// What is drawn on one side.
struct ShownSide {
    const Document* document = nullptr;
    std::size_t band = 0;        ///< of that document
    bool is_difference = false;  ///< minus the reference (Session::shown_map)
};

/// What the convention doctor (compare/convention_doctor.h) says of a picture and the reference.
struct ConventionAdvice {
    std::string verdict;                    ///< for the user; our picture is the reference
    std::optional<StokesConvention> adopt;  ///< what the numbers have to be taken for instead; none: no change helps
};

/// Main thread only.
class Session {
public:
    /// `wake` is called from worker threads whenever there is something new to draw.
    explicit Session(std::function<void()> wake = {}) : wake_(std::move(wake)), exports_(wake_), explanation_(wake_) {}

    /// Opens a scene or a picture (is_picture) and makes it the current document; on error the log says why and
    /// nothing changes. As the other open() where it is a picture.
    bool open(const std::filesystem::path& path);
    /// What the numbers are to be taken for, from what their reader took them for.
    using ConventionChoice = std::function<StokesConvention(const StokesConvention&)>;
    /// Opens a picture. A large one is read beside the window: update() shows it when it is there (readings()). If
    /// several layouts fit, asks (Question::layout). Without a choice its numbers are taken for what the user chose
    /// when it was open before.
    bool open(const PictureSource& source, const ConventionChoice& choice = {});
    /// Pictures that are on their way.
    [[nodiscard]] std::vector<const PictureReading*> readings() const;
    /// Does nothing if it is there already.
    void cancel_reading(const PictureReading* reading);
    /// Takes pictures that other programs send in the way of the viewer tev, from now on; what was listened to before
    /// is closed. Each is a document, which grows. Error: as LiveListener::start.
    Result<Done> listen(const LiveAddress& address, const LiveRules& rules);
    /// The pictures stay as they are.
    void stop_listening();
    /// Null: off.
    [[nodiscard]] const LiveListener* listener() const { return listener_.get(); }
    /// What Question::layout is about.
    struct LayoutQuestion {
        PictureSource source;
        ConventionChoice choice;
        std::vector<std::string_view> layouts;  ///< that fit
    };
    [[nodiscard]] const std::optional<LayoutQuestion>& layout_question() const { return layout_question_; }
    /// Opens the picture in this layout. Without the question: does nothing.
    void answer_layout(std::string_view layout);
    /// Makes a scene that no file has (a twin) the current document; on error the log says why.
    bool open_scene(Scene scene, const std::string& name);
    /// Makes a picture that no file has the current document.
    void open_picture(StokesImage picture, std::string name);
    /// Makes the scene of a fact the current document, pins its pixel and brings the fact's page to the front; on error
    /// the log says why. One that is open and was not edited is shown again. `fact` must outlive the session, as those
    /// of verify::facts() do.
    bool open_fact(const verify::Fact& fact, std::size_t view_index);
    /// Closes the current document, saved or not; the one before it is shown.
    void close_document() { close_document(current()); }
    /// Closes one of documents(), saved or not; the current one stays on screen if it is another.
    void close_document(const Document* which);

    [[nodiscard]] std::vector<const Document*> documents() const;
    /// The document on screen, or null.
    [[nodiscard]] const Document* current() const;
    [[nodiscard]] Document* current();
    /// Shows the next (+1) or previous (-1) document.
    void step_document(int by);
    /// Shows one of documents(); another one: does nothing.
    void show_document(const Document* which);

    /// The current scene with glass in place of its crystals, or without polarization (shown/twins.h), as a document of
    /// its own, shown as its difference from the current one. One that is open and was not edited is shown again.
    bool open_isotropic_twin();
    bool open_unpolarized_twin();

    // Comparing pictures (session_comparison.cpp)

    /// Makes the current document the one that others are compared with.
    void set_reference();
    /// The document that others are compared with, or null.
    [[nodiscard]] const Document* reference() const { return reference_; }
    /// Shows the reference until flip_back(), or until another document is shown. Without one, or if it is on screen:
    /// does nothing.
    void flip_to_reference();
    void flip_back();
    /// Whether the current picture can be held against the reference, where both have a pixel (shared_area). Error: why
    /// not, and what to do.
    [[nodiscard]] Result<Comparison> compare() const;
    /// The comparison on screen; none if no difference is shown: not asked for, not possible, or of color.
    [[nodiscard]] std::optional<Comparison> comparison() const;
    /// The picture on screen, behind the polarimeter and in the shown convention. Requires: a document is shown.
    [[nodiscard]] ShownPicture shown_picture() const { return {current()->picture(), polarimeter_, view_.convention}; }
    /// The quantity on screen, or its difference. Requires: a document is shown, the quantity is not `color`.
    [[nodiscard]] ShownQuantity shown_quantity() const;
    /// Shows the difference from the reference, or the map itself again. Of color there is none: it shows the
    /// intensity's. If it is not possible the log says why.
    void toggle_difference();
    /// ViewSettings::layout, or `single` if the two cannot be compared.
    [[nodiscard]] CompareLayout layout() const;
    /// Shows both pictures in the same map, range and place, or the current one alone again. If it is not possible the
    /// log says why.
    void toggle_layout(CompareLayout wanted);
    /// What is drawn on a side; none: nothing.
    [[nodiscard]] std::optional<ShownSide> side(PictureSide side) const;
    /// Pins the pixel where the shown difference is largest, or where without one the light is most unphysical; what is
    /// no number is worse than either. If there is none the log says so.
    void pin_worst();
    /// The convention doctor about the current picture and the reference. Error: they cannot be held against each
    /// other.
    [[nodiscard]] Result<ConventionAdvice> convention_advice() const;
    /// Puts its verdict into the log; if `adopt`, takes the numbers of the current picture for what it says.
    void ask_doctor(bool adopt);
    /// Pins a pixel that was typed, "x,y" in the whole picture, and brings it into view. Error: no such pixel.
    Result<Done> go_to(const std::string& typed);

    // The current document's scene and file

    /// As in Document; they do nothing unless `of` is the document on screen.
    bool edit(const Document* of, Scene scene, const std::string& label);
    void end_edit(const Document* of);
    void refuse_edit(const Document* of, const std::string& label, const Error& error);
    /// An edit whose error goes into the log.
    bool move_camera(const Document* of, const Camera& camera, const std::string& label);
    void set_stop_rules(const Document* of, const StopRules& rules);
    /// As Document::take_numbers_for, and remembers it for that file. Does nothing unless `of` is a picture that is on
    /// screen.
    void take_numbers_for(const Document* of, const std::optional<StokesConvention>& convention);
    /// True if it was done; an error goes into the log.
    bool undo();
    bool redo();
    bool reload();
    /// If the document's own file cannot take the edit, asks instead (Question::rewrite), unless `rewrite` is the
    /// answer.
    bool save(const std::filesystem::path& path, Document::Rewrite rewrite = Document::Rewrite::ask);
    /// Edits of scenes that no file has.
    [[nodiscard]] bool has_unsaved_edits() const;

    /// Once per frame, before drawing: takes over what workers, background jobs and other programs have finished.
    void update();
    /// Takes over all that workers have finished of what is on screen: before it leaves the window.
    void catch_up();

    // What is on screen

    [[nodiscard]] const ViewSettings& view() const { return view_; }
    ViewSettings& change_view() { return view_; }
    /// Index into the picture's bands; one that it does not have: its last one. Nothing open: does nothing.
    void choose_band(std::size_t index);
    /// Shows another map. One of two pictures shows the difference at once; if there is none the log says why.
    void show(Quantity quantity);
    [[nodiscard]] const ViewTransform& transform() const { return transform_; }
    ViewTransform& change_transform() { return transform_; }
    /// Of the picture's viewport, logical points.
    [[nodiscard]] const DVec2& view_size() const { return view_size_; }
    void set_view_size(const DVec2& size) { view_size_ = size; }
    /// How the inspector writes a pixel.
    [[nodiscard]] const PageSettings& page() const { return page_; }
    void set_page(const PageSettings& page) { page_ = page; }
    [[nodiscard]] const Polarimeter& polarimeter() const { return polarimeter_; }
    void set_polarimeter(Polarimeter polarimeter) { polarimeter_ = std::move(polarimeter); }
    /// Values behind the picture; update() keeps it.
    [[nodiscard]] const ShownMap& shown_map() const { return shown_map_; }
    /// Brings it up to date. Nothing open: does nothing.
    void finish_shown_map();
    [[nodiscard]] const WindowState& window() const { return window_; }
    WindowState& change_window() { return window_; }

    // What the user points at (session_selection.cpp). Pins and region stay where they are in the whole picture when
    // another document is shown, as far as it has those pixels.

    [[nodiscard]] const Selection& selection() const { return selection_; }
    void hover(std::optional<PixelAddress> pixel) { selection_.hovered = pixel; }
    /// Pins a pixel of the current picture and makes it the current pin. Outside the picture: does nothing.
    void pin(PixelAddress pixel);
    /// Pins the pixel that the current document's fact is about, and the sample in its middle. Without one: does
    /// nothing.
    void pin_fact();
    /// Moves the current pin; stays inside the picture.
    void nudge(int dx, int dy);
    /// Releases the current pin; the one pinned before it becomes current.
    void unpin();
    /// A branch of the current pin's tree: index into RayTree::nodes.
    void select_branch(std::optional<int> node) { selection_.node = node; }
    void select_sample(std::uint32_t sample) { selection_.sample = sample; }
    void select_region(const std::optional<TileRect>& region) { selection_.region = region; }
    /// Marks pixels of the current picture; empty: none.
    void mark(std::vector<bool> pixels);
    /// Marks the pixels whose shown quantity is in the range, or without a value for this reason.
    void mark_values(const MapRange& range);
    void mark_state(PixelState state);

    /// The backward tree of the pinned pixel, of Selection::sample, at the shown wavelength; it belongs to the current
    /// document's plan(). Null while it is being found (update() starts that), or if there is none.
    [[nodiscard]] std::shared_ptr<const Explanation> explanation() const;
    /// How far it is. `nothing_asked` if no pixel of a scene is pinned: an EXR file has no scene to trace.
    [[nodiscard]] ExplanationStatus explanation_status() const { return explanation_.status(); }
    void cancel_explanation() { explanation_.cancel(); }
    void restart_explanation() { explanation_.restart(); }

    /// Grows with every open_fact(): the fact's page is what the user wants to see.
    [[nodiscard]] std::uint64_t facts_opened() const { return facts_opened_; }

    // What is told and written

    /// A text that whoever shows the window puts into the clipboard when copies() has grown.
    void copy(std::string text) {
        copied_ = std::move(text);
        ++copies_;
    }
    [[nodiscard]] const std::string& copied() const { return copied_; }
    [[nodiscard]] std::uint64_t copies() const { return copies_; }

    [[nodiscard]] const Log& log() const { return log_; }
    void say(Severity severity, std::string text) { log_.add(severity, std::move(text)); }
    [[nodiscard]] const ExportQueue& exports() const { return exports_; }
    /// As ExportQueue::start.
    void start_export(std::string what, std::filesystem::path path, std::function<Result<Done>(ExportProgress&)> work);
    /// PNG file that the whole window is wanted as, once whoever shows the window can give it (exports.h); else empty.
    [[nodiscard]] const std::filesystem::path& wanted_window_picture() const { return wanted_window_picture_; }
    void want_window_picture(std::filesystem::path path) { wanted_window_picture_ = std::move(path); }
    /// Newest first.
    [[nodiscard]] const std::vector<std::filesystem::path>& recent_files() const { return recent_files_; }
    void set_recent_files(std::vector<std::filesystem::path> files) { recent_files_ = std::move(files); }
    /// What the user took the numbers of a picture for, by the path of its file, or its name. Newest first.
    struct ChosenConvention {
        std::string key;
        StokesConvention convention;
        friend bool operator==(const ChosenConvention&, const ChosenConvention&) = default;
    };
    [[nodiscard]] const std::vector<ChosenConvention>& chosen_conventions() const { return chosen_conventions_; }
    void set_chosen_conventions(std::vector<ChosenConvention> chosen) { chosen_conventions_ = std::move(chosen); }
    /// As they were when the first frame was due, or a document was opened last.
    [[nodiscard]] const ShippedFiles& shipped_files() const { return shipped_files_; }

private:
    void ask_for_explanation();
    [[nodiscard]] std::optional<ExplanationRequest> wanted_explanation() const;
    bool adopt(Result<std::unique_ptr<Document>> document);
    bool show_read(const PictureSource& source, Result<StokesImage> picture, const ConventionChoice& choice);
    void take_readings();
    void take_live();
    [[nodiscard]] Document* live_document(LivePictureId id);
    void take_event(LiveCreated& created);
    void take_event(LiveUpdated& updated);
    void take_event(LiveDescribed& described);
    void take_event(LiveClosed& closed);
    void take_event(LiveOpened& opened);
    void take_event(LiveLine& line);
    void forget_live(const Document* document);
    void remember_file();
    void take_numbers_as_before();
    static std::string remembered_by(const Document& document);
    bool open_twin(Scene scene, const std::string& kind, const std::string& what_it_is);
    bool logged(const Result<Done>& result);
    void follow_files();
    void fit_band();
    void fit_selection();
    void show_pins();
    void reveal(PixelAddress pixel);
    /// Index into pins_ of a pixel of the current picture; pins_.size(): it is not pinned.
    [[nodiscard]] std::size_t pin_at(PixelAddress pixel) const;
    void look_for_shipped_files();
    /// Index into documents_; -1: none.
    void make_current(int index);
    /// Makes a document that has no edits and that `wanted` chooses the current one; false if there is none.
    bool show_again(const std::function<bool(const Document&)>& wanted);

    std::function<void()> wake_;
    std::vector<std::unique_ptr<Document>> documents_;
    int current_ = -1;
    Document* reference_ = nullptr;
    const Document* flipped_from_ = nullptr;  ///< comes back by flip_back()
    std::vector<Band> bands_;                 ///< that ViewSettings::band counts
    double wanted_nm_ = default_wavelength_nm;
    ViewSettings view_;
    ViewTransform transform_;
    DVec2 view_size_{1.0, 1.0};
    Selection selection_;
    PixelAddress corner_;             ///< of the picture whose pixels selection_ counts
    std::vector<PixelAddress> pins_;  ///< in the whole picture; those that the picture on screen has are selection_'s
    int pin_ = -1;                    ///< index into pins_ of the one that was pinned or chosen last; -1: none
    PageSettings page_;
    Polarimeter polarimeter_;
    ShownMap shown_map_;
    WindowState window_;
    std::uint64_t facts_opened_ = 0;
    Log log_;
    ExportQueue exports_;
    std::filesystem::path wanted_window_picture_;
    std::string copied_;
    std::uint64_t copies_ = 0;
    std::vector<std::filesystem::path> recent_files_;
    bool looked_for_shipped_files_ = false;
    ShippedFiles shipped_files_;
    ExplanationJob explanation_;
    struct PendingPicture {
        std::unique_ptr<PictureReading> reading;
        ConventionChoice choice;
    };
    std::vector<PendingPicture> pending_;
    std::optional<LayoutQuestion> layout_question_;
    std::vector<ChosenConvention> chosen_conventions_;
    struct LiveShown {
        Document* document = nullptr;
        std::shared_ptr<const LivePicture> picture;
    };
    std::map<LivePictureId, LiveShown> live_;
    std::unique_ptr<LiveListener> listener_;  // null: live_ is empty
};

}  // namespace pol
