// SPDX-License-Identifier: Apache-2.0
#include "viewer/session.h"

#include <algorithm>

namespace pol {

namespace {
/// Time per frame for taking over finished tiles: the rest of a frame is for drawing.
constexpr double update_s = 0.002;
/// The same for evaluating the shown map, while the picture grows and when nothing else is to be done.
constexpr double evaluate_growing_s = 0.002;
constexpr double evaluate_finished_s = 0.010;
}  // namespace

bool Session::open(const std::filesystem::path& path) {
    auto document = Document::open(path, wake_);
    if (!document) {
        log.add(Severity::error, to_string(document.error()));
        return false;
    }
    documents_.push_back(std::move(document).value());
    current_ = static_cast<int>(documents_.size()) - 1;
    selection = {};
    return true;
}

Document* Session::current() const {
    return current_ < 0 ? nullptr : documents_[static_cast<std::size_t>(current_)].get();
}

void Session::step_document(int by) {
    if (documents_.empty()) return;
    const int count = static_cast<int>(documents_.size());
    current_ = ((current_ + by) % count + count) % count;
}

void Session::update() {
    Document* document = current();
    if (document == nullptr) {
        shown_map.clear();
        return;
    }
    document->update(update_s);
    const std::size_t wavelengths = document->picture().wavelengths_nm.size();
    if (view.wavelength >= wavelengths) view.wavelength = wavelengths - 1;
    const bool grows = !document->paused() && !document->progress().finished;
    shown_map.update(*document, view, bench, grows ? evaluate_growing_s : evaluate_finished_s);
    if (!shown_map.complete() && !grows && wake_) wake_();
}

Stokes<double> Session::shown_stokes(std::size_t wavelength, std::size_t pixel) const {
    const Stokes<double>& s = current()->picture().at(wavelength, pixel);
    return bench.empty() ? s : bench.mueller() * s;
}

void Session::pin(PixelAddress pixel) {
    const Document* document = current();
    if (document == nullptr) return;
    const StokesImage& picture = document->picture();
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= picture.width || pixel.y >= picture.height) return;
    const auto found = std::find(selection.pins.begin(), selection.pins.end(), pixel);
    selection.current = static_cast<int>(found - selection.pins.begin());
    if (found == selection.pins.end()) selection.pins.push_back(pixel);
    selection.node.reset();
}

void Session::nudge(int dx, int dy) {
    const auto pinned = selection.pinned();
    if (!pinned) return;
    const StokesImage& picture = current()->picture();
    selection.pins[static_cast<std::size_t>(selection.current)] = {std::clamp(pinned->x + dx, 0, picture.width - 1),
                                                                   std::clamp(pinned->y + dy, 0, picture.height - 1)};
    selection.node.reset();
}

void Session::unpin() {
    if (!selection.pinned()) return;
    selection.pins.erase(selection.pins.begin() + selection.current);
    selection.current = static_cast<int>(selection.pins.size()) - 1;
    selection.node.reset();
}

}  // namespace pol
