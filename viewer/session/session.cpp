// SPDX-License-Identifier: Apache-2.0
#include "viewer/session/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "io/scenes/scene_hash.h"
#include "verify/facts/fact.h"
#include "viewer/shown/picture_place.h"
#include "viewer/shown/twins.h"

namespace pol {

namespace {
/// Time per frame for taking over finished tiles, and again for evaluating the shown map: while workers trace, the rest
/// of a frame is for drawing; afterwards nothing else is to be done.
constexpr double tracing_s = 0.002;
constexpr double finished_s = 0.010;
}  // namespace

bool Session::show_again(const std::function<bool(const Document&)>& wanted) {
    const auto found = std::find_if(documents_.begin(), documents_.end(),
                                    [&](const auto& document) { return !document->dirty() && wanted(*document); });
    if (found == documents_.end()) return false;
    make_current(static_cast<int>(found - documents_.begin()));
    return true;
}

bool Session::open_fact(const verify::Fact& fact, std::size_t view_index) {
    const auto is_this = [&](const Document& document) {
        return document.fact() && document.fact()->fact == &fact && document.fact()->view == view_index;
    };
    if (!show_again(is_this) && !adopt(Document::of_fact(fact, view_index, wake_))) return false;
    pin_fact();
    ++facts_opened_;
    return true;
}

bool Session::open_isotropic_twin() {
    const Document* document = current();
    if (document == nullptr || !document->has_scene()) return false;
    auto twin = isotropic_twin(document->scene());
    if (!twin) {
        log_.add(Severity::error, to_string(twin.error()));
        return false;
    }
    return open_twin(std::move(twin).value(), "isotropic",
                     "every crystal is a glass of its mean permittivity, n\u00b2 = (2 n_o\u00b2 + n_e\u00b2)/3");
}

bool Session::open_unpolarized_twin() {
    const Document* document = current();
    if (document == nullptr || !document->has_scene()) return false;
    return open_twin(unpolarized_twin(document->scene()), "unpolarized",
                     "light is unpolarized again after every surface, as in a renderer without polarization");
}

bool Session::open_twin(Scene scene, const std::string& kind, const std::string& what_it_is) {
    Document* original = current();
    const std::string name = twin_name(original->name(), kind);
    const std::string hash = scene_hash(scene);
    const auto is_this = [&](const Document& document) {
        return document.has_scene() && document.path().empty() && document.name() == name &&
               scene_hash(document.scene()) == hash;
    };
    if (!show_again(is_this) && !open_scene(std::move(scene), name)) return false;
    reference_ = original;
    if (!view_.difference || view_.quantity == Quantity::color) toggle_difference();
    log_.add(Severity::note, name + ": " + what_it_is + ". Shown minus " + original->name() +
                                 "; X shows the twin itself, PgDn and PgUp switch between the two");
    return true;
}

void Session::make_current(int index) {
    current_ = index;
    flipped_from_ = nullptr;
    // Both are about the document that was on screen.
    if (window_.question == Question::unsaved_at_close || window_.question == Question::rewrite)
        window_.question = Question::none;
    fit_selection();
}

void Session::close_document(const Document* which) {
    const auto found = std::find_if(documents_.begin(), documents_.end(),
                                    [&](const auto& document) { return document.get() == which; });
    if (found == documents_.end()) return;
    if (which == reference_) reference_ = nullptr;
    forget_live(which);
    const auto index = static_cast<int>(found - documents_.begin());
    documents_.erase(found);
    const int shown = index <= current_ ? std::max(0, current_ - 1) : current_;
    make_current(documents_.empty() ? -1 : shown);
}

std::vector<const Document*> Session::documents() const {
    std::vector<const Document*> all;
    for (const auto& document : documents_) all.push_back(document.get());
    return all;
}

const Document* Session::current() const {
    return current_ < 0 ? nullptr : documents_[static_cast<std::size_t>(current_)].get();
}

Document* Session::current() {
    return current_ < 0 ? nullptr : documents_[static_cast<std::size_t>(current_)].get();
}

void Session::step_document(int by) {
    if (documents_.empty()) return;
    const int count = static_cast<int>(documents_.size());
    make_current(((current_ + by) % count + count) % count);
}

void Session::show_document(const Document* which) {
    const auto found = std::find_if(documents_.begin(), documents_.end(),
                                    [&](const auto& document) { return document.get() == which; });
    if (found != documents_.end() && which != current()) make_current(static_cast<int>(found - documents_.begin()));
}

bool Session::logged(const Result<Done>& result) {
    if (!result) log_.add(Severity::error, to_string(result.error()));
    return static_cast<bool>(result);
}

bool Session::edit(const Document* of, Scene scene, const std::string& label) {
    return of != nullptr && of == current() && of->has_scene() &&
           static_cast<bool>(current()->edit(std::move(scene), label));
}

void Session::end_edit(const Document* of) {
    if (of != nullptr && of == current()) current()->end_edit();
}

void Session::refuse_edit(const Document* of, const std::string& label, const Error& error) {
    if (of != nullptr && of == current()) current()->refuse(label, error);
}

bool Session::move_camera(const Document* of, const Camera& camera, const std::string& label) {
    if (of == nullptr || of != current() || !of->has_scene()) return false;
    Scene scene = of->scene();
    scene.camera = camera;
    return logged(current()->edit(std::move(scene), label));
}

void Session::set_stop_rules(const Document* of, const StopRules& rules) {
    if (of != nullptr && of == current()) current()->set_stop_rules(rules);
}

bool Session::undo() {
    return current() != nullptr && logged(current()->undo());
}

bool Session::redo() {
    return current() != nullptr && logged(current()->redo());
}

bool Session::reload() {
    return current() != nullptr && logged(current()->reload());
}

bool Session::save(const std::filesystem::path& path, Document::Rewrite rewrite) {
    if (current() == nullptr || !current()->has_scene()) return false;
    const auto saved = current()->save(path, rewrite);
    if (!saved) {
        log_.add(Severity::error, to_string(saved.error()));
        return false;
    }
    if (saved.value() == Document::Saved::asks) {
        window_.question = Question::rewrite;
        return false;
    }
    if (window_.question == Question::rewrite) window_.question = Question::none;
    log_.add(Severity::note, "scene written: " + path.string());
    if (saved.value() == Document::Saved::without_comments)
        log_.add(Severity::warning,
                 "the comments of the file that the scene was read from are not in " + path.string());
    return true;
}

bool Session::has_unsaved_edits() const {
    return std::any_of(documents_.begin(), documents_.end(), [](const auto& d) { return d->dirty(); });
}

void Session::look_for_shipped_files() {
    shipped_files_ = find_shipped_files();
    looked_for_shipped_files_ = true;
}

void Session::choose_band(std::size_t index) {
    if (current() != nullptr) view_.band = std::min(index, current()->picture().bands.size() - 1);
}

void Session::finish_shown_map() {
    if (current() != nullptr) shown_map_.finish(*current(), view_, polarimeter_, comparison());
}

void Session::start_export(std::string what, std::filesystem::path path,
                           std::function<Result<Done>(ExportProgress&)> work) {
    exports_.start(std::move(what), std::move(path), std::move(work));
}

void Session::update() {
    if (!looked_for_shipped_files_) look_for_shipped_files();
    exports_.report(log_);
    follow_files();
    take_readings();
    take_live();
    const auto compared = comparison();
    const bool is_pair = compared || layout() != CompareLayout::single;
    const auto is_seen = [&](const Document* document) {
        return document == current() || (is_pair && document == reference_);
    };
    bool tracing = false;
    bool behind = false;
    for (const auto& document : documents_) {
        document->set_resting(!is_seen(document.get()));
        if (!is_seen(document.get())) continue;
        document->look_at(pixels_in(transform_, view_size_));
        const bool traces = document->tracing();
        behind = document->update(traces ? tracing_s : finished_s) || behind;
        tracing = tracing || traces;
    }
    Document* document = current();
    fit_selection();
    ask_for_explanation();
    if (document == nullptr) {
        shown_map_.clear();
        return;
    }
    const bool is_painted = document->growing();
    const bool grows = tracing || behind || is_painted;
    shown_map_.update(*document, view_, polarimeter_, tracing ? tracing_s : finished_s, grows, compared);
    // What is left to do when the workers call no more.
    if (!tracing && (behind || (!is_painted && !shown_map_.complete())) && wake_) wake_();
}

void Session::catch_up() {
    const bool compared = comparison().has_value();
    if (current() != nullptr) current()->catch_up();
    if (compared) reference_->catch_up();
}

void Session::ask_for_explanation() {
    const auto& asked = explanation_.request();
    const auto wanted = wanted_explanation();
    if (!asked || !wanted || !same_branches(*asked, *wanted)) selection_.node.reset();
    explanation_.ask(wanted);
}

std::optional<ExplanationRequest> Session::wanted_explanation() const {
    const Document* document = current();
    const auto pinned = selection_.pinned();
    if (document == nullptr || !document->has_scene() || !pinned) return std::nullopt;
    const RenderSettings& settings = document->plan()->settings;
    if (pinned->x >= settings.width || pinned->y >= settings.height) return std::nullopt;
    const auto last_sample = static_cast<std::uint32_t>(settings.last_sample());
    const std::size_t last_wavelength = document->plan()->wavelengths_nm.size() - 1;
    return ExplanationRequest{document->plan(), *pinned, std::min(selection_.sample, last_sample),
                              static_cast<int>(std::min(view_.band, last_wavelength))};
}

std::shared_ptr<const Explanation> Session::explanation() const {
    // What was asked for last may be stale until the next update().
    return explanation_.request() == wanted_explanation() ? explanation_.result() : nullptr;
}

void Session::follow_files() {
    const double now_s = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    for (const auto& document : documents_) {
        if (!document->file_changed(now_s)) continue;
        if (logged(document->reload()))
            log_.add(Severity::note, document->name() + " was saved: " +
                                         (document->reading() != nullptr ? "it is being read" : "read") + " again");
    }
}

/// Another picture may count its bands otherwise: it is shown in the band of the same label, else at the wavelength
/// nearest to the one that was chosen last, or to the default if none was; else in its first band.
void Session::fit_band() {
    if (current() == nullptr) return;
    const std::vector<Band>& known = current()->picture().bands;
    if (known == bands_) return;
    const std::vector<double> before_nm = wavelengths_of(bands_);
    const bool was_chosen = !before_nm.empty() && view_.band != nearest_wavelength(before_nm, wanted_nm_);
    if (was_chosen) wanted_nm_ = before_nm[std::min(view_.band, before_nm.size() - 1)];
    const std::optional<std::size_t> same =
        before_nm.empty() && view_.band < bands_.size() ? matching_band(known, bands_[view_.band]) : std::nullopt;
    bands_ = known;
    const std::vector<double> known_nm = wavelengths_of(known);
    view_.band = known_nm.empty() ? same.value_or(0) : nearest_wavelength(known_nm, wanted_nm_);
}

}  // namespace pol
