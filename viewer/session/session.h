// SPDX-License-Identifier: Apache-2.0
// The state of the window without the window: what is open, how it is shown, what is selected. Panels read it and call
// it; nothing here knows ImGui or GL.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "spectrum/wavelength_grid.h"
#include "viewer/document/document.h"
#include "viewer/session/explanation.h"
#include "viewer/session/export_queue.h"
#include "viewer/session/log.h"
#include "viewer/session/window_state.h"
#include "viewer/shown/page_settings.h"
#include "viewer/shown/polarimeter.h"
#include "viewer/shown/selection.h"
#include "viewer/shown/shown_map.h"
#include "viewer/shown/view_settings.h"
#include "viewer/shown/view_transform.h"

namespace pol {

/// Main thread only.
class Session {
public:
    /// `wake` is called from worker threads whenever there is something new to draw.
    explicit Session(std::function<void()> wake = {}) : exports(wake), wake_(std::move(wake)), explanation_(wake_) {}

    /// Opens a file and makes it the current document; on error the log says why and nothing changes.
    bool open(const std::filesystem::path& path);
    /// Makes a scene that no file has (a twin) the current document; on error the log says why.
    bool open_scene(Scene scene, const std::string& name);
    /// Makes the scene of a fact the current document, pins its pixel and brings the fact's page to the front; on error
    /// the log says why. One that is open and was not edited is shown again. `fact` must outlive the session, as those
    /// of verify::facts() do.
    bool open_fact(const verify::Fact& fact, std::size_t view_index);
    /// Closes the current document, saved or not; the one before it is shown.
    void close_document();

    [[nodiscard]] const std::vector<std::unique_ptr<Document>>& documents() const { return documents_; }
    /// The document on screen, or null.
    [[nodiscard]] Document* current() const;
    /// Shows the next (+1) or previous (-1) document.
    void step_document(int by);

    /// The current scene with glass in place of its crystals, or without polarization (shown/twins.h), as a document of
    /// its own, shown as its difference from the current one. One that is open and was not edited is shown again.
    bool open_isotropic_twin();
    bool open_unpolarized_twin();

    // Comparing pictures ---------------------------------------------------------------------------------------------

    /// Makes the current document the one that others are compared with.
    void set_reference();
    /// The document that others are compared with, or null.
    [[nodiscard]] const Document* reference() const { return reference_; }
    /// Whether the current picture can be held against the reference. Error: why not, and what to do.
    [[nodiscard]] Result<Comparison> compare() const;
    /// The comparison on screen; none if no difference is shown: not asked for, not possible, or of color.
    [[nodiscard]] std::optional<Comparison> comparison() const;
    /// The picture on screen, behind the polarimeter and in the shown convention. Requires: a document is shown.
    [[nodiscard]] ShownPicture shown_picture() const { return {current()->picture(), polarimeter, view.convention}; }
    /// The quantity on screen, or its difference. Requires: a document is shown, the quantity is not `color`.
    [[nodiscard]] ShownQuantity shown_quantity() const;
    /// Shows the difference from the reference, or the map itself again. Of color there is none: it shows the
    /// intensity's. If it is not possible the log says why.
    void toggle_difference();
    /// Brings shown_map up to date. Requires: a document is shown.
    void finish_shown_map() { shown_map.finish(*current(), view, polarimeter, comparison()); }

    /// Acts on the current document and puts an error into the log. True if it was done.
    bool undo();
    bool redo();
    bool reload();
    /// If the document's own file cannot take the edit, asks instead (WindowState::rewrite_asked), unless `rewrite` is
    /// the answer.
    bool save(const std::filesystem::path& path, Document::Rewrite rewrite = Document::Rewrite::ask);
    /// An edit named `label` (Document::edit); one step of undo until Document::end_edit(). Requires: a scene is shown.
    bool move_camera(const Camera& camera, const std::string& label);
    /// Edits of scenes that no file has.
    [[nodiscard]] bool has_unsaved_edits() const;

    /// Once per frame, before drawing: takes over what workers, background jobs and other programs have finished.
    void update();
    /// Takes over all that workers have finished of what is on screen: before it leaves the window.
    void catch_up();

    /// Shows another map.
    void show(Quantity quantity) { view.quantity = quantity; }

    /// Pins a pixel of the current picture and makes it the current pin. Outside the picture: does nothing.
    void pin(PixelAddress pixel);
    /// Pins the pixel that the current document's fact is about, and the sample in its middle. Requires: there is one.
    void pin_fact();
    /// Moves the current pin; stays inside the picture.
    void nudge(int dx, int dy);
    /// Releases the current pin; the one pinned before it becomes current.
    void unpin();

    /// The backward tree of the pinned pixel, of Selection::sample, at the shown wavelength; it belongs to the current
    /// document's plan(). Null while it is being found (update() starts that), or if there is none.
    [[nodiscard]] std::shared_ptr<const Explanation> explanation() const;
    /// How far it is. `nothing_asked` if no pixel of a scene is pinned: an EXR file has no scene to trace.
    [[nodiscard]] ExplanationStatus explanation_status() const { return explanation_.status(); }
    void cancel_explanation() { explanation_.cancel(); }
    void restart_explanation() { explanation_.restart(); }

    ViewSettings view;
    ViewTransform transform;
    Selection selection;
    PageSettings page;  ///< how the inspector writes a pixel
    Polarimeter polarimeter;
    ShownMap shown_map;  ///< values behind the picture; update() keeps it
    Log log;
    ExportQueue exports;
    WindowState window;
    std::vector<std::filesystem::path> recent_files;  ///< newest first
    DVec2 view_size{1.0, 1.0};  ///< of the picture's viewport, logical points; set by the interface

private:
    void ask_for_explanation();
    [[nodiscard]] std::optional<ExplanationRequest> wanted_explanation() const;
    bool adopt(Result<std::unique_ptr<Document>> document);
    bool open_twin(Scene scene, const std::string& kind, const std::string& what_it_is);
    bool logged(const Result<Done>& result);
    void follow_files();
    void fit_wavelength();
    void fit_selection();
    /// Makes a document that has no edits and that `wanted` chooses the current one; false if there is none.
    bool show_again(const std::function<bool(const Document&)>& wanted);

    std::function<void()> wake_;
    std::vector<std::unique_ptr<Document>> documents_;
    int current_ = -1;
    Document* reference_ = nullptr;
    std::vector<double> wavelengths_nm_;  ///< that ViewSettings::wavelength counts
    double wanted_nm_ = default_wavelength_nm;
    ExplanationJob explanation_;
};

}  // namespace pol
