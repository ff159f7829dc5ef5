// SPDX-License-Identifier: Apache-2.0
// What the user points at in the picture on screen.
#include <algorithm>
#include <cstddef>

#include "verify/facts/fact.h"
#include "viewer/session/session.h"
#include "viewer/shown/histogram.h"
#include "viewer/shown/picture_place.h"

namespace pol {

/// The picture on screen may be another one, of another size or place, than that which the user pointed at.
void Session::fit_selection() {
    const Document* document = current();
    if (document == nullptr) {
        selection_ = {};
        pins_.clear();
        pin_ = -1;
        return;
    }
    const StokesImage& picture = document->picture();
    fit_band();
    const PixelAddress by{corner_.x - picture.left, corner_.y - picture.top};
    corner_ = corner_of(picture);
    auto& hovered = selection_.hovered;
    if (hovered) hovered = PixelAddress{hovered->x + by.x, hovered->y + by.y};
    if (hovered && !has_pixel(picture, *hovered)) hovered.reset();
    auto& region = selection_.region;
    if (region) region = TileRect{region->x0 + by.x, region->y0 + by.y, region->x1 + by.x, region->y1 + by.y};
    if (region &&
        !(has_pixel(picture, {region->x0, region->y0}) && has_pixel(picture, {region->x1 - 1, region->y1 - 1})))
        region.reset();
    if (selection_.marked.size() != picture.pixel_count() || by != PixelAddress{}) {
        selection_.marked.clear();
        selection_.brushed.reset();
    }
    show_pins();
}

void Session::show_pins() {
    const auto before = selection_.pinned();
    const StokesImage& picture = current()->picture();
    selection_.pins.clear();
    selection_.current = -1;
    for (std::size_t i = 0; i < pins_.size(); ++i) {
        const PixelAddress here{pins_[i].x - picture.left, pins_[i].y - picture.top};
        if (!has_pixel(picture, here)) continue;
        // Without the chosen one, the pin before it.
        if (static_cast<int>(i) <= pin_) selection_.current = static_cast<int>(selection_.pins.size());
        selection_.pins.push_back(here);
    }
    if (selection_.pinned() != before) selection_.node.reset();
}

std::size_t Session::pin_at(PixelAddress pixel) const {
    const PixelAddress corner = corner_of(current()->picture());
    const PixelAddress there{corner.x + pixel.x, corner.y + pixel.y};
    return static_cast<std::size_t>(std::find(pins_.begin(), pins_.end(), there) - pins_.begin());
}

void Session::pin(PixelAddress pixel) {
    const Document* document = current();
    if (document == nullptr || !has_pixel(document->picture(), pixel)) return;
    const std::size_t index = pin_at(pixel);
    if (index == pins_.size()) pins_.push_back({document->picture().left + pixel.x, document->picture().top + pixel.y});
    pin_ = static_cast<int>(index);
    selection_.node.reset();
    show_pins();
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
    const std::size_t index = pin_at(*pinned);
    pins_[index] = {picture.left + std::clamp(pinned->x + dx, 0, picture.width - 1),
                    picture.top + std::clamp(pinned->y + dy, 0, picture.height - 1)};
    pin_ = static_cast<int>(index);
    selection_.node.reset();
    show_pins();
}

void Session::unpin() {
    const auto pinned = selection_.pinned();
    if (!pinned) return;
    pins_.erase(pins_.begin() + static_cast<std::ptrdiff_t>(pin_at(*pinned)));
    pin_ = static_cast<int>(pins_.size()) - 1;
    selection_.node.reset();
    show_pins();
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
