// SPDX-License-Identifier: Apache-2.0
// What the user points at in the picture on screen.
#include <algorithm>

#include "verify/facts/fact.h"
#include "viewer/session/session.h"
#include "viewer/shown/histogram.h"

namespace pol {

/// The picture on screen may be another one, of another size, than that which the user pointed at.
void Session::fit_selection() {
    const Document* document = current();
    if (document == nullptr) {
        selection_ = {};
        return;
    }
    const StokesImage& picture = document->picture();
    fit_band();
    const auto outside = [&](PixelAddress pixel) { return pixel.x >= picture.width || pixel.y >= picture.height; };
    if (selection_.hovered && outside(*selection_.hovered)) selection_.hovered.reset();
    if (selection_.marked.size() != picture.pixel_count()) {
        selection_.marked.clear();
        selection_.brushed.reset();
    }
    const auto& region = selection_.region;
    if (region && (region->x1 > picture.width || region->y1 > picture.height)) selection_.region.reset();
    const auto pinned = selection_.pinned();
    if (std::erase_if(selection_.pins, outside) == 0) return;
    const auto found =
        pinned ? std::find(selection_.pins.begin(), selection_.pins.end(), *pinned) : selection_.pins.end();
    // Without it, the pin before it.
    const auto index = static_cast<int>(found - selection_.pins.begin());
    selection_.current = found == selection_.pins.end() ? index - 1 : index;
    selection_.node.reset();
}

void Session::pin(PixelAddress pixel) {
    const Document* document = current();
    if (document == nullptr) return;
    const StokesImage& picture = document->picture();
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= picture.width || pixel.y >= picture.height) return;
    const auto found = std::find(selection_.pins.begin(), selection_.pins.end(), pixel);
    selection_.current = static_cast<int>(found - selection_.pins.begin());
    if (found == selection_.pins.end()) selection_.pins.push_back(pixel);
    selection_.node.reset();
}

void Session::pin_fact() {
    if (current() == nullptr || !current()->fact()) return;
    const ShownFact shown = *current()->fact();
    const verify::FactView& fact_view = shown.fact->views[shown.view];
    pin({fact_view.x, fact_view.y});
    selection_.sample = 0;
}

void Session::nudge(int dx, int dy) {
    const auto pinned = selection_.pinned();
    if (!pinned) return;
    const StokesImage& picture = current()->picture();
    selection_.pins[static_cast<std::size_t>(selection_.current)] = {std::clamp(pinned->x + dx, 0, picture.width - 1),
                                                                     std::clamp(pinned->y + dy, 0, picture.height - 1)};
    selection_.node.reset();
}

void Session::unpin() {
    if (!selection_.pinned()) return;
    selection_.pins.erase(selection_.pins.begin() + selection_.current);
    selection_.current = static_cast<int>(selection_.pins.size()) - 1;
    selection_.node.reset();
}

void Session::mark(std::vector<bool> pixels) {
    selection_.marked = std::move(pixels);
    selection_.brushed.reset();
    ++selection_.marked_version;
}

void Session::mark_values(const MapRange& range) {
    finish_shown_map();
    mark(pixels_in(shown_map_, range));
    selection_.brushed = range;
}

void Session::mark_state(PixelState state) {
    finish_shown_map();
    mark(pixels_of(shown_map_, state));
}

}  // namespace pol
