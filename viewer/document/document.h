// SPDX-License-Identifier: Apache-2.0
// One opened file: a scene with the picture that is being made of it, or a picture from an EXR file.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "film/film.h"
#include "film/stokes_image.h"
#include "io/pictures/picture_file.h"
#include "plan/plan.h"
#include "render/renderer.h"
#include "scene/scene.h"
#include "viewer/document/edit_history.h"
#include "viewer/document/file_watch.h"
#include "viewer/document/picture_reading.h"

namespace pol {

namespace verify {
struct Fact;
}

/// A fact of polarization optics, and which of its views a document shows.
struct ShownFact {
    const verify::Fact* fact = nullptr;
    std::size_t view = 0;  ///< index into Fact::views
};

/// Thread safety: main thread only. `wake`, given at opening, is called from workers.
class Document {
public:
    /// Opens a picture (is_picture), or a scene and starts its render. Error: as the reader or the compiler has
    /// it.
    static Result<std::unique_ptr<Document>> open(const std::filesystem::path& path, std::function<void()> wake);
    /// A scene that no file has yet, by the name that Save will suggest ("calcite-twin.yaml"). It can be made again: it
    /// is not dirty until it is edited. Error: it cannot be rendered.
    static Result<std::unique_ptr<Document>> make(Scene scene, std::string name, std::function<void()> wake);
    /// The scene of a fact (verify/facts/fact.h), which no file has: "T9-3.yaml" for its third view. Error: it cannot
    /// be rendered.
    static Result<std::unique_ptr<Document>> of_fact(const verify::Fact& fact, std::size_t view,
                                                     std::function<void()> wake);
    /// A picture that was read from there. Large ones are read again beside the window, and `wake` is called then.
    static std::unique_ptr<Document> of_file(const PictureSource& source, StokesImage picture,
                                             std::function<void()> wake);
    /// A picture that no file has, by the name that is shown.
    static std::unique_ptr<Document> of_picture(StokesImage picture, std::string name);
    ~Document();
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    /// The file; empty if there is none yet.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// File name, or the name that Save will suggest.
    [[nodiscard]] const std::string& name() const { return name_; }
    /// The fact that the document was made for, whatever was edited since.
    [[nodiscard]] const std::optional<ShownFact>& fact() const { return fact_; }
    [[nodiscard]] bool has_scene() const { return plan_ != nullptr; }
    /// Requires: has_scene().
    [[nodiscard]] const Scene& scene() const { return history_.scene(); }
    /// What is being rendered. Requires: has_scene().
    [[nodiscard]] const std::shared_ptr<const Plan>& plan() const { return plan_; }

    /// The picture as far as it is known here: brought up to date by update() only, so that one frame sees one picture.
    [[nodiscard]] const StokesImage& picture() const { return *picture_; }
    /// Grows whenever the picture changes; a new size, set of wavelengths or document is a new `picture_layout`, which
    /// no other document has.
    [[nodiscard]] std::uint64_t picture_version() const { return version_; }
    [[nodiscard]] std::uint64_t picture_layout() const { return layout_; }
    /// Parts that changed since the picture was of `version`, for whoever keeps a copy of it (the textures).
    [[nodiscard]] std::vector<TileRect> changes_since(std::uint64_t version) const;

    /// Fetches tiles that the workers have finished, for about `seconds`; each in its turn, so that none starves. True
    /// if that was too short: the picture still lacks something that could be fetched at once.
    bool update(double seconds);
    /// Fetches all of them, also while the picture is lent: the borrower keeps the old one.
    void catch_up();

    /// What the reader took the numbers of a picture for, and what the user chose instead.
    [[nodiscard]] const StokesConvention& readers_convention() const { return read_origin_.convention; }
    [[nodiscard]] const std::optional<StokesConvention>& chosen_convention() const { return chosen_convention_; }
    /// Takes them for that; empty: for what the reader did. It holds when the file is read again, and goes with the
    /// picture (StokesImage::origin). A borrower of the picture keeps the old one. Requires: !has_scene().
    void take_numbers_for(const std::optional<StokesConvention>& convention);

    /// Changes a picture that no file has, as the program wants that makes it: what lies in `rect` is new then. A
    /// borrower keeps the old one. Requires: !has_scene(), and the rectangle lies inside.
    void paint(const TileRect& rect, const std::function<void(StokesImage&)>& change);
    /// The same of what it says of its picture; what the user took the numbers for stays.
    void describe(const std::function<void(StokesImage&)>& change);
    /// Another picture in its place, as above. Requires: !has_scene().
    void replace_picture(StokesImage picture) { show_read(std::move(picture)); }
    /// It was painted within the last half second.
    [[nodiscard]] bool growing() const;

    /// The picture for another thread. While it is lent, update() leaves it as it is; edits do not wait.
    [[nodiscard]] std::shared_ptr<const StokesImage> lend_picture() const;

    /// How far the picture is, not the film: what update() has not fetched yet does not count.
    [[nodiscard]] RenderProgress progress() const;
    /// Workers are at it, or will be.
    [[nodiscard]] bool tracing() const;
    [[nodiscard]] bool paused() const { return paused_; }
    void set_paused(bool paused);
    /// A document that is not on screen rests, whether or not the user has paused it.
    void set_resting(bool resting);
    /// The part of the picture that is on screen: it is rendered first.
    void look_at(const TileRect& seen);
    /// When the render ends before all its samples are there. Setting them starts it over.
    [[nodiscard]] const StopRules& stop_rules() const { return stop_rules_; }
    void set_stop_rules(const StopRules& rules);

    // Edits -----------------------------------------------------------------------------------------------------------

    /// Renders an edited scene instead. Error: the scene cannot be rendered; the old render goes on and refused() says
    /// why. Edits with the same label are one step of undo until end_edit(). Requires: has_scene().
    Result<Done> edit(Scene scene, const std::string& label);
    void end_edit() { history_.seal(); }
    [[nodiscard]] const EditHistory& history() const { return history_; }
    /// Do nothing if there is nothing to undo or redo.
    Result<Done> undo();
    Result<Done> redo();

    struct Refusal {
        std::string label;  ///< of the edit
        Error error;
    };
    /// The last edit, if it was refused.
    [[nodiscard]] const std::optional<Refusal>& refused() const { return refused_; }
    /// Something that was typed is not even a scene.
    void refuse(std::string label, Error error) { refused_ = Refusal{std::move(label), std::move(error)}; }

    // The file --------------------------------------------------------------------------------------------------------

    /// The scene was edited since it was read, made or saved.
    [[nodiscard]] bool dirty() const { return has_scene() && history_.dirty(); }
    /// What becomes of text in the document's file that save() cannot keep.
    enum class Rewrite : std::uint8_t {
        ask,          ///< nothing is written
        keep_backup,  ///< the old file stays as NAME.bak
    };
    enum class Saved : std::uint8_t {
        written,
        without_comments,  ///< into another file than the one that has them
        asks,              ///< see Rewrite::ask
    };
    /// Writes the scene as YAML that loads back to the same scene hash; from now on `path` is the document's file. Of
    /// the text that the scene was read from only what was edited is changed (io/scenes/scene_patch.h). Where that is
    /// not possible the text is written anew; if that, or what another program wrote meanwhile, would be lost from the
    /// document's own file, `rewrite` decides. Error: the file cannot be written, or would read back as another scene.
    /// Requires: has_scene().
    Result<Saved> save(const std::filesystem::path& path, Rewrite rewrite = Rewrite::ask);
    /// Reads the file again; a scene's, as a step that can be undone. Error: the file is broken; the old picture stays
    /// and problem() says why. A large picture is read beside the window (reading()): update() shows it, or the
    /// problem. Without a file: does nothing.
    Result<Done> reload();
    /// The picture that is on its way to take the place of this one, or null.
    [[nodiscard]] const PictureReading* reading() const { return reading_.get(); }
    void cancel_reading() {
        if (reading_) reading_->cancel();
    }
    /// True if the file was changed by another program. `now_s` as in FileWatch.
    bool file_changed(double now_s) { return watch_.changed(now_s); }
    /// Why the file cannot be shown as it is now: to be read over the picture.
    [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

private:
    Document() = default;
    Result<Done> render(const Scene& scene);
    void start();
    void paste(const TileSnapshot& tile);
    void show(std::shared_ptr<StokesImage> picture);
    void note_change(const TileRect& rect);
    Result<Done> reload_picture();
    void take_reading();
    void show_read(StokesImage picture);
    /// Who has borrowed the picture keeps it as it is, and it can be changed.
    void keep_for_borrowers();
    [[nodiscard]] TileRect whole_picture() const { return {0, 0, picture_->width, picture_->height}; }
    void watch_files();

    std::filesystem::path path_;
    std::string name_;
    /// What the scene was read from, or written into last.
    struct Source {
        std::string text;
        Scene scene;
        std::filesystem::path path;
    };
    std::optional<Source> source_;
    EditHistory history_;
    std::optional<Refusal> refused_;
    std::optional<Error> problem_;
    FileWatch watch_;

    std::shared_ptr<const Plan> plan_;
    std::unique_ptr<Renderer> renderer_;
    std::shared_ptr<StokesImage> picture_;
    std::shared_ptr<std::atomic<int>> lent_;  // how often picture_ is lent
    std::vector<TileRect> changes_;  // by the newest versions, the last one being version_; before them, all changed
    std::uint64_t version_ = 0;
    std::uint64_t layout_ = 0;
    StopRules stop_rules_;
    std::vector<Version> tiles_seen_;              // by tile of the film
    std::vector<TileStatus> tiles_shown_;          // the same: how good they are in the picture
    std::vector<std::vector<double>> tile_peaks_;  // the same: StokesImage::peak
    std::size_t next_tile_ = 0;                    // the round of update() goes on here
    Version film_seen_ = 0;                        // all tiles are at least of this version
    bool paused_ = false;
    bool resting_ = false;
    TileRect seen_{};
    std::optional<ShownFact> fact_;
    PictureSource picture_source_;
    PictureOrigin read_origin_;  // of picture_, as the reader had it
    std::optional<StokesConvention> chosen_convention_;
    std::unique_ptr<PictureReading> reading_;
    std::function<void()> wake_;  // of a picture from a file
    std::optional<std::chrono::steady_clock::time_point> painted_;
};

}  // namespace pol
