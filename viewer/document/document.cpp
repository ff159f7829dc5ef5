// SPDX-License-Identifier: Apache-2.0
#include "viewer/document/document.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "core/contract.h"
#include "core/result.h"
#include "io/files/assets.h"
#include "io/files/output_file.h"
#include "io/pictures/picture_file.h"
#include "io/scenes/scene_file.h"
#include "io/scenes/scene_hash.h"
#include "io/scenes/scene_patch.h"
#include "plan/compile.h"
#include "verify/facts/fact.h"
#include "viewer/document/give_way.h"

namespace pol {

namespace {

/// Small tiles: the first ones of an edited scene are there soon.
constexpr int tile_size = 16;

/// Number that no other picture of this program has.
std::uint64_t next_layout() {
    static std::uint64_t last = 0;  // main thread only
    return ++last;
}

std::unique_ptr<Renderer> start_workers(std::function<void()> wake) {
    return std::make_unique<Renderer>(hardware_threads(), tile_size, std::move(wake), give_way);
}

/// The files that a scene was read from.
std::vector<std::filesystem::path> files_of(const Scene& scene) {
    std::vector<std::filesystem::path> files(scene.files.begin(), scene.files.end());
    for (const Object& object : scene.objects) {
        if (const auto* mesh = std::get_if<MeshShape>(&object.shape)) files.emplace_back(mesh->path);
        const auto* emission = std::get_if<Emission>(&object.role);
        const auto* texture = emission != nullptr ? std::get_if<TexturedRadiance>(&emission->radiance) : nullptr;
        if (texture != nullptr) files.emplace_back(texture->path);
    }
    return files;
}

/// Another program has written the file since.
bool is_other_text(const std::filesystem::path& path, const std::string& known) {
    const auto there = read_scene_text(path);
    return !there || there.value() != known;
}

/// Copies NAME to NAME.bak, or NAME.bak2 and so on: no backup is overwritten.
Result<Done> keep_backup(const std::filesystem::path& path) {
    std::error_code failed;
    std::filesystem::path backup = path.string() + ".bak";
    for (int number = 2; std::filesystem::exists(backup, failed); ++number)
        backup = path.string() + ".bak" + std::to_string(number);
    if (std::filesystem::copy_file(path, backup, failed)) return Done{};
    return Error{
        ErrorKind::output, "cannot be written: " + failed.message(), {backup.string()}, {}, "nothing was saved"};
}

}  // namespace

Result<std::unique_ptr<Document>> Document::open(const std::filesystem::path& path, std::function<void()> wake) {
    if (is_picture(path)) {
        PictureSource source;
        source.files = {path};
        POL_TRY(auto picture, read_picture(source));
        return of_file(source, std::move(picture), std::move(wake));
    }
    std::unique_ptr<Document> document(new Document);
    std::error_code unknown_folder;
    document->path_ = std::filesystem::absolute(path, unknown_folder).lexically_normal();
    document->name_ = path.filename().string();
    document->watch_ = FileWatch({document->path_});
    POL_TRY(auto text, read_scene_text(path));
    POL_TRY(auto scene, parse_scene(text, path.string(), path.parent_path()));
    document->source_ = Source{std::move(text), scene, document->path_};
    document->renderer_ = start_workers(std::move(wake));
    POL_TRY_DONE(document->render(scene));
    document->history_ = EditHistory(std::move(scene));
    document->watch_files();
    return document;
}

Result<std::unique_ptr<Document>> Document::make(Scene scene, std::string name, std::function<void()> wake) {
    std::unique_ptr<Document> document(new Document);
    document->name_ = std::move(name);
    document->renderer_ = start_workers(std::move(wake));
    POL_TRY_DONE(document->render(scene));
    document->history_ = EditHistory(std::move(scene));
    return document;
}

Result<std::unique_ptr<Document>> Document::of_fact(const verify::Fact& fact, std::size_t view,
                                                    std::function<void()> wake) {
    const std::string name = fact.id + "-" + std::to_string(view + 1) + ".yaml";
    auto scene = parse_scene(fact.views[view].yaml, name, assets_dir());
    if (!scene) return scene.error();
    auto document = make(std::move(scene).value(), name, std::move(wake));
    if (!document) return document;
    document.value()->fact_ = ShownFact{&fact, view};
    document.value()->source_ = Source{fact.views[view].yaml, document.value()->scene(), assets_dir() / name};
    return document;
}

Document::~Document() = default;

Result<Done> Document::render(const Scene& scene) {
    POL_TRY(auto plan, compile(scene));
    plan_ = std::move(plan);
    start();
    return Done{};
}

void Document::start() {
    renderer_->start(plan_, {Watch::live, stop_rules_});
    paused_ = false;
    if (resting_) renderer_->pause();
    tiles_seen_.assign(static_cast<std::size_t>(renderer_->film().tile_count()), 0);
    tiles_shown_.assign(tiles_seen_.size(), {});
    tile_peaks_.assign(tiles_seen_.size(), {});
    next_tile_ = 0;
    film_seen_ = 0;
    // Not a snapshot: what the workers have done since is for update() to fetch.
    show(std::make_shared<StokesImage>(renderer_->film().blank()));
}

void Document::set_stop_rules(const StopRules& rules) {
    stop_rules_ = rules;
    if (renderer_) start();
}

void Document::show(std::shared_ptr<StokesImage> picture) {
    const bool same_layout = picture_ && picture_->width == picture->width && picture_->height == picture->height &&
                             picture_->bands == picture->bands;
    if (!same_layout) layout_ = next_layout();
    picture_ = std::move(picture);
    lent_ = std::make_shared<std::atomic<int>>(0);
    changes_ = {whole_picture()};
    ++version_;
}

std::vector<TileRect> Document::changes_since(std::uint64_t version) const {
    const std::uint64_t count = version_ - std::min(version, version_);
    if (count > changes_.size()) return {whole_picture()};
    return {changes_.end() - static_cast<std::ptrdiff_t>(count), changes_.end()};
}

bool Document::update(double seconds) {
    using Clock = std::chrono::steady_clock;
    take_reading();
    if (!renderer_ || lent_->load(std::memory_order_acquire) > 0) return false;
    const Film& film = renderer_->film();
    const Version newest = film.version();
    if (newest == film_seen_) return false;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    bool is_behind = false;
    for (std::size_t looked_at = 0; looked_at < tiles_seen_.size(); ++looked_at) {
        const std::size_t index = next_tile_;
        next_tile_ = (next_tile_ + 1) % tiles_seen_.size();
        const auto tile = film.tile_if_newer(static_cast<int>(index), tiles_seen_[index]);
        if (!tile) continue;
        paste(*tile);
        tiles_shown_[index] = tile->status;
        tile_peaks_[index] = peaks_of(tile->image);
        is_behind = Clock::now() > end;
        if (is_behind) break;
    }
    if (!is_behind) film_seen_ = newest;
    picture_->peak.assign(picture_->bands.size(), 0.0);
    for (const std::vector<double>& peaks : tile_peaks_)
        for (std::size_t band = 0; band < peaks.size(); ++band)
            picture_->peak[band] = std::max(picture_->peak[band], peaks[band]);
    return is_behind;
}

void Document::catch_up() {
    if (!renderer_) return;
    if (renderer_->film().version() != film_seen_) keep_for_borrowers();
    update(std::numeric_limits<double>::infinity());
}

void Document::paste(const TileSnapshot& tile) {
    const StokesImage& from = tile.image;
    StokesImage& to = *picture_;
    const std::size_t from_pixels = from.pixel_count();
    const std::size_t to_pixels = to.pixel_count();
    const auto width = static_cast<std::size_t>(from.width);
    // A plane set that no tile had so far is that of a picture without it.
    const auto planes = [&](const auto& source, auto& target, const auto& nothing) {
        if (source.empty()) return;
        const std::size_t count = source.size() / from_pixels;
        if (target.empty()) target.assign(count * to_pixels, nothing);
        for (std::size_t plane = 0; plane < count; ++plane) {
            for (int y = 0; y < from.height; ++y) {
                const auto line = source.begin() + static_cast<std::ptrdiff_t>(plane * from_pixels + from.pixel(0, y));
                std::copy_n(line, width,
                            target.begin() + static_cast<std::ptrdiff_t>(plane * to_pixels +
                                                                         to.pixel(tile.rect.x0, tile.rect.y0 + y)));
            }
        }
    };
    constexpr double unknown = std::numeric_limits<double>::infinity();
    planes(from.stokes, to.stokes, Stokes<double>{});
    planes(from.residual, to.residual, 1.0);
    planes(from.samples, to.samples, 0U);
    planes(from.failures, to.failures, 0U);
    planes(from.tail, to.tail, 0.0);
    planes(from.sampling_error, to.sampling_error, Stokes<double>{unknown, unknown, unknown, unknown});
    // A preview had a tail where the samples have none.
    if (from.tail.empty() && !to.tail.empty()) {
        const std::vector<double> none(from_pixels * (to.tail.size() / to_pixels), 0.0);
        planes(none, to.tail, 0.0);
    }
    note_change(tile.rect);
}

void Document::note_change(const TileRect& rect) {
    changes_.push_back(rect);
    ++version_;
    constexpr std::ptrdiff_t many = 4096;  // whoever lags further behind looks at the whole picture
    if (changes_.size() > 2 * many) changes_.erase(changes_.begin(), changes_.end() - many);
}

std::shared_ptr<const StokesImage> Document::lend_picture() const {
    lent_->fetch_add(1, std::memory_order_relaxed);
    return {picture_.get(), [picture = picture_, lent = lent_](const StokesImage* /*lent*/) mutable {
                picture.reset();
                lent->fetch_sub(1, std::memory_order_release);
            }};
}

RenderProgress Document::progress() const {
    if (!renderer_) return {.done = 1.0, .finished = true};
    RenderProgress progress = renderer_->progress();
    FilmStatusSum shown;
    for (const TileStatus& tile : tiles_shown_) shown.add(tile);
    progress.film = shown.status(picture_->pixel_count(), progress.film.error.random_samples);
    progress.film.generation = progress.generation;
    progress.done = progress.film.mean_samples / plan_->settings.samples_per_pixel;
    // A finished film changes no more: its last version was seen, or something is missing here.
    progress.finished = progress.finished && renderer_->film().version() == film_seen_;
    return progress;
}

bool Document::tracing() const {
    return renderer_ && !paused_ && !resting_ && !renderer_->progress().finished;
}

void Document::set_paused(bool paused) {
    paused_ = paused;
    if (renderer_) paused_ || resting_ ? renderer_->pause() : renderer_->resume();
}

void Document::look_at(const TileRect& seen) {
    if (seen == seen_) return;
    seen_ = seen;
    if (renderer_) renderer_->look_at(seen);
}

void Document::set_resting(bool resting) {
    if (resting == resting_) return;
    resting_ = resting;
    set_paused(paused_);
}

Result<Done> Document::edit(Scene scene, const std::string& label) {
    POL_EXPECTS(has_scene());
    if (auto started = render(scene); !started) {
        refused_ = Refusal{label, started.error()};
        return started;
    }
    refused_.reset();
    history_.push(std::move(scene), label);
    return Done{};
}

Result<Done> Document::undo() {
    if (!has_scene() || !history_.can_undo()) return Done{};
    auto started = render(history_.scene_before());
    if (started) history_.undo();
    refused_.reset();
    return started;
}

Result<Done> Document::redo() {
    if (!has_scene() || !history_.can_redo()) return Done{};
    auto started = render(history_.scene_after());
    if (started) history_.redo();
    refused_.reset();
    return started;
}

Result<Document::Saved> Document::save(const std::filesystem::path& path, Rewrite rewrite) {
    POL_EXPECTS(has_scene());
    std::error_code unknown;
    const std::filesystem::path target = std::filesystem::absolute(path, unknown).lexically_normal();
    std::optional<std::string> text;
    if (source_) text = patch_scene(source_->text, source_->scene, scene(), source_->path, target);
    // What save_scene() wrote has nothing of the user's own.
    const bool loses_text =
        !text && source_ && source_->text != save_scene(source_->scene, source_->path.parent_path());
    const bool is_own = target == path_ && std::filesystem::exists(target, unknown);
    if (is_own && (loses_text || is_other_text(target, source_->text))) {
        if (rewrite == Rewrite::ask) return Saved::asks;
        POL_TRY_DONE(keep_backup(target));
    }
    if (!text) text = save_scene(scene(), target.parent_path());
    const auto read = parse_scene(*text, target.string(), target.parent_path());
    if (!read || scene_hash(read.value()) != scene_hash(scene()))
        return Error{ErrorKind::output,
                     "the scene would not be the same one when it is read there" +
                         (read ? std::string() : ": " + read.error().what),
                     {target.string()},
                     {},
                     "choose another folder: files beside it may have the names of files that the scene needs"};
    POL_TRY_DONE(write_file(target, *text));
    source_ = Source{std::move(*text), scene(), target};
    path_ = target;
    name_ = path_.filename().string();
    problem_.reset();
    history_.mark_saved();
    watch_ = {};
    watch_files();
    return loses_text && !is_own ? Saved::without_comments : Saved::written;
}

Result<Done> Document::reload() {
    if (path_.empty()) return Done{};
    problem_.reset();
    const auto failed = [&](const Error& error) {
        problem_ = error;
        return error;
    };
    if (!has_scene()) {
        if (auto read = reload_picture(); !read) return failed(read.error());
        return Done{};
    }
    auto text = read_scene_text(path_);
    if (!text) return failed(text.error());
    auto scene = parse_scene(text.value(), path_.string(), path_.parent_path());
    if (!scene) return failed(scene.error());
    if (scene_hash(scene.value()) != scene_hash(history_.scene())) {
        if (auto started = render(scene.value()); !started) return failed(started.error());
        history_.seal();
        history_.push(scene.value(), "reload");
    }
    source_ = Source{std::move(text).value(), std::move(scene).value(), path_};
    refused_.reset();
    history_.mark_saved();
    watch_files();
    return Done{};
}

void Document::watch_files() {
    std::vector<std::filesystem::path> files = files_of(scene());
    // A saved scene is one file, whatever it was read from.
    if (std::find(files.begin(), files.end(), path_) == files.end()) files.push_back(path_);
    watch_.watch(files);
}

}  // namespace pol
