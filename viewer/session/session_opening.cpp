// SPDX-License-Identifier: Apache-2.0
// How documents come into the window.
#include <algorithm>
#include <utility>

#include "viewer/session/session.h"

namespace pol {

namespace {
/// That the window remembers: files opened before, and what the numbers of pictures were taken for.
constexpr std::size_t most_recent_files = 12;
constexpr std::size_t most_remembered_conventions = 100;
}  // namespace

bool Session::open(const std::filesystem::path& path) {
    if (is_picture(path)) {
        PictureSource source;
        source.files = {path};
        return open(source);
    }
    if (!adopt(Document::open(path, wake_))) return false;
    remember_file();
    return true;
}

bool Session::open(const PictureSource& source, const ConventionChoice& choice) {
    const auto is_this = [&](const PendingPicture& pending) { return pending.reading->source() == source; };
    if (std::any_of(pending_.begin(), pending_.end(), is_this)) return true;
    auto header = read_picture_header(source);
    if (!header) {
        const auto layouts = source.layout.empty() ? fitting_layouts(source) : std::vector<std::string_view>();
        if (layouts.size() < 2) {
            log_.add(Severity::error, to_string(header.error()));
            return false;
        }
        layout_question_ = LayoutQuestion{source, choice, layouts};
        window_.question = Question::layout;
        return true;
    }
    if (header.value().bytes > read_at_once_bytes) {
        pending_.push_back({std::make_unique<PictureReading>(source, std::move(header).value(), wake_), choice});
        return true;
    }
    return show_read(source, read_picture(source), choice);
}

bool Session::show_read(const PictureSource& source, Result<StokesImage> picture, const ConventionChoice& choice) {
    if (!picture) {
        log_.add(Severity::error, to_string(picture.error()));
        return false;
    }
    adopt(Document::of_file(source, std::move(picture).value(), wake_));
    remember_file();
    if (choice)
        take_numbers_for(current(), choice(current()->readers_convention()));
    else
        take_numbers_as_before();
    return true;
}

void Session::answer_layout(std::string_view layout) {
    if (window_.question != Question::layout || !layout_question_) return;
    window_.question = Question::none;
    LayoutQuestion asked = *std::exchange(layout_question_, std::nullopt);
    asked.source.layout = layout;
    open(asked.source, asked.choice);
}

std::vector<const PictureReading*> Session::readings() const {
    std::vector<const PictureReading*> all;
    for (const PendingPicture& pending : pending_) all.push_back(pending.reading.get());
    for (const auto& document : documents_)
        if (document->reading() != nullptr) all.push_back(document->reading());
    return all;
}

void Session::cancel_reading(const PictureReading* reading) {
    for (const PendingPicture& pending : pending_)
        if (pending.reading.get() == reading) pending.reading->cancel();
    for (const auto& document : documents_)
        if (document->reading() != nullptr && document->reading() == reading) document->cancel_reading();
}

void Session::take_readings() {
    for (std::size_t i = 0; i < pending_.size();) {
        auto read = pending_[i].reading->take();
        if (!read) {
            ++i;
            continue;
        }
        const PendingPicture ended = std::move(pending_[i]);
        pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(i));
        if (!*read && ended.reading->cancelled())
            log_.add(Severity::note, ended.reading->source().path().filename().string() + " was not opened: cancelled");
        else
            show_read(ended.reading->source(), std::move(*read), ended.choice);
    }
}

bool Session::open_scene(Scene scene, const std::string& name) {
    return adopt(Document::make(std::move(scene), name, wake_));
}

void Session::open_picture(StokesImage picture, std::string name) {
    adopt(Document::of_picture(std::move(picture), std::move(name)));
}

bool Session::adopt(Result<std::unique_ptr<Document>> document) {
    if (!document) {
        log_.add(Severity::error, to_string(document.error()));
        return false;
    }
    documents_.push_back(std::move(document).value());
    make_current(static_cast<int>(documents_.size()) - 1);
    look_for_shipped_files();
    return true;
}

void Session::remember_file() {
    const std::filesystem::path opened = current()->path();
    std::erase(recent_files_, opened);
    recent_files_.insert(recent_files_.begin(), opened);
    if (recent_files_.size() > most_recent_files) recent_files_.resize(most_recent_files);
}

void Session::take_numbers_for(const Document* of, const std::optional<StokesConvention>& convention) {
    if (of == nullptr || of != current() || of->has_scene()) return;
    current()->take_numbers_for(convention);
    log_.add(Severity::note, of->name() + ": its numbers are taken for " + of->picture().origin.convention.text());
    const std::string key = remembered_by(*of);
    std::erase_if(chosen_conventions_, [&](const ChosenConvention& chosen) { return chosen.key == key; });
    if (!of->chosen_convention()) return;
    chosen_conventions_.insert(chosen_conventions_.begin(), {key, *of->chosen_convention()});
    if (chosen_conventions_.size() > most_remembered_conventions)
        chosen_conventions_.resize(most_remembered_conventions);
}

void Session::take_numbers_as_before() {
    const std::string key = remembered_by(*current());
    const auto found = std::find_if(chosen_conventions_.begin(), chosen_conventions_.end(),
                                    [&](const ChosenConvention& chosen) { return chosen.key == key; });
    if (found == chosen_conventions_.end()) return;
    current()->take_numbers_for(found->convention);
    if (current()->chosen_convention())
        log_.add(Severity::note,
                 current()->name() + ": its numbers are taken for what you chose before: " + found->convention.text());
}

std::string Session::remembered_by(const Document& document) {
    return document.path().empty() ? "sent: " + document.name() : document.path().string();
}

}  // namespace pol
