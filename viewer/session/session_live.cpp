// SPDX-License-Identifier: Apache-2.0
// Pictures that other programs send while they make them.
#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

#include "viewer/session/session.h"

namespace pol {

namespace {

/// Of a frame, for what has come: the rest waits for the next one.
constexpr double taking_s = 0.010;
/// Taken at a time, so that the clock is looked at between.
constexpr std::size_t bytes_at_a_time = std::size_t{1} << 20U;

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A stranger's name as one that can be shown: a line without control characters.
std::string shown_name(const std::string& name) {
    std::string shown = name;
    std::replace_if(
        shown.begin(), shown.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20U || static_cast<unsigned char>(c) == 0x7fU; }, '?');
    return shown.empty() ? "picture" : shown;
}

}  // namespace

Result<Done> Session::listen(const LiveAddress& address, const LiveRules& rules) {
    POL_TRY(auto listener, LiveListener::start(address, rules, wake_));
    stop_listening();
    listener_ = std::move(listener);
    log_.add(Severity::note, "listening on " + listener_->address().text() + ": programs can send pictures there");
    return Done{};
}

void Session::stop_listening() {
    if (!listener_) return;
    log_.add(Severity::note, "no longer listening on " + listener_->address().text());
    listener_.reset();
    live_.clear();  // the pictures stay
}

void Session::take_live() {
    if (!listener_) return;
    const double end = now_s() + taking_s;
    do {
        auto events = listener_->take(bytes_at_a_time);
        if (events.empty()) return;
        for (LiveEvent& event : events) std::visit([this](auto& what) { take_event(what); }, event);
    } while (now_s() < end);
    if (wake_) wake_();  // there may be more
}

Document* Session::live_document(LivePictureId id) {
    const auto found = live_.find(id);
    return found == live_.end() ? nullptr : found->second.document;
}

void Session::take_event(LiveCreated& created) {
    Document* document = created.replaces ? live_document(*created.replaces) : nullptr;
    if (created.replaces) live_.erase(*created.replaces);
    try {
        StokesImage blank = created.picture->blank();
        if (document != nullptr) {
            document->replace_picture(std::move(blank));
        } else {
            const int before = current_;
            adopt(Document::of_picture(std::move(blank), shown_name(created.picture->name())));
            document = current();
            take_numbers_as_before();
            if (before >= 0) make_current(before);
        }
    } catch (const std::bad_alloc&) {
        log_.add(Severity::error, shown_name(created.picture->name()) +
                                      " was sent, but there is no memory for it\n  hint: close other documents");
        listener_->forget(created.id);
        return;
    }
    live_[created.id] = {document, created.picture};
    if (created.grab_focus) show_document(document);
}

void Session::take_event(LiveUpdated& updated) {
    Document* document = live_document(updated.id());
    if (document == nullptr) return;
    const LivePicture& picture = *live_.at(updated.id()).picture;
    document->paint(updated.update().rect, [&](StokesImage& image) { picture.apply(updated.update(), image); });
    if (updated.update().grab_focus) show_document(document);
}

void Session::take_event(LiveDescribed& described) {
    Document* document = live_document(described.id);
    if (document == nullptr) return;
    const LivePicture& picture = *live_.at(described.id).picture;
    document->describe([&](StokesImage& image) { picture.apply(described.attributes, image); });
}

void Session::take_event(LiveClosed& closed) {
    Document* document = live_document(closed.id);
    if (document == nullptr) return;
    live_.erase(closed.id);
    log_.add(Severity::note, document->name() + " was closed by the program that sent it");
    close_document(document);
}

void Session::take_event(LiveOpened& opened) {
    const Document* before = current();
    const auto is_there = std::find_if(documents_.begin(), documents_.end(),
                                       [&](const auto& document) { return document->path() == opened.path; });
    if (is_there == documents_.end()) {
        open(opened.path);
    } else if (opened.again) {
        logged((*is_there)->reload());
    }
    if (opened.grab_focus && is_there != documents_.end()) show_document(is_there->get());
    if (!opened.grab_focus && before != nullptr) show_document(before);
}

void Session::take_event(LiveLine& line) {
    log_.add(Severity::note, std::move(line.text));
}

void Session::forget_live(const Document* document) {
    std::erase_if(live_, [&](const auto& live) {
        if (live.second.document != document) return false;
        listener_->forget(live.first);
        return true;
    });
}

}  // namespace pol
