// SPDX-License-Identifier: Apache-2.0
#include "viewer/shown/shown_map.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "maps/color_picture.h"
#include "viewer/shown/shown_picture.h"

namespace pol {

namespace {

/// A grown picture is looked at again after so many times the time that the last look took.
constexpr double rest_after_sweep = 9.0;
/// And not before: nobody reads a histogram faster.
constexpr double least_rest_s = 0.25;

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// 0 .. count - 1 with the bits of their numbers reversed: any beginning is spread evenly.
std::vector<int> spread_order(int count) {
    std::vector<int> order;
    order.reserve(static_cast<std::size_t>(count));
    int bits = 0;
    while ((1 << bits) < count) ++bits;
    for (int i = 0; i < (1 << bits); ++i) {
        int reversed = 0;
        for (int bit = 0; bit < bits; ++bit) {
            if ((i >> bit & 1) != 0) reversed |= 1 << (bits - 1 - bit);
        }
        if (reversed < count) order.push_back(reversed);
    }
    return order;
}

bool is_power_of_two(std::size_t n) {
    return n != 0 && (n & (n - 1)) == 0;
}

}  // namespace

void ShownMap::clear() {
    *this = ShownMap{};
}

void ShownMap::restart(const Document& document, const Key& key) {
    const StokesImage& picture = document.picture();
    key_ = key;
    order_ = spread_order(picture.height);
    known_.assign(static_cast<std::size_t>(picture.height), false);
    values_.assign(picture.pixel_count(), 0.0);
    states_.assign(picture.pixel_count(), PixelState::undetermined);
    weights_.assign(picture.pixel_count(), 0.0F);
    rows_done_ = 0;
    sweep_cost_s_ = 0.0;
    luminance_weights_.clear();
    for (const Rgb& weight : band_colors(picture.bands)) luminance_weights_.push_back(to_xyz(weight)[1]);
}

/// `quantity` is that on screen; none: color.
void ShownMap::evaluate_row(const Document& document, const Polarimeter& polarimeter,
                            const std::optional<ShownQuantity>& quantity, int y) {
    const StokesImage& picture = document.picture();
    const ShownPicture shown(picture, polarimeter);
    for (int x = 0; x < picture.width; ++x) {
        const std::size_t pixel = picture.pixel(x, y);
        MapPixel value;
        if (quantity) {
            value = quantity->at(pixel);
        } else {
            for (std::size_t w = 0; w < luminance_weights_.size(); ++w)
                value.value += luminance_weights_[w] * shown.stokes(w, pixel).s0;
            if (!std::isfinite(value.value)) value.state = PixelState::not_a_number;
        }
        values_[pixel] = value.value;
        states_[pixel] = value.state;
        weights_[pixel] = static_cast<float>(key_.fade_by_bar ? value.weight * value.certainty : value.weight);
    }
    known_[static_cast<std::size_t>(y)] = true;
}

void ShownMap::summarize(int width) {
    MapSummary summary;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t y = 0; y < known_.size(); ++y) {
        if (!known_[y]) continue;
        const std::size_t first = y * static_cast<std::size_t>(width);
        for (std::size_t pixel = first; pixel < first + static_cast<std::size_t>(width); ++pixel) {
            ++summary.state[static_cast<std::size_t>(states_[pixel])];
            if (states_[pixel] != PixelState::defined) continue;
            low = std::min(low, values_[pixel]);
            high = std::max(high, values_[pixel]);
        }
        summary.pixels += static_cast<std::size_t>(width);
    }
    if (low <= high) {
        summary.low = low;
        summary.high = high;
    }
    summary_ = summary;
    ++version_;
}

bool ShownMap::update(const Document& document, const ViewSettings& view, const Polarimeter& polarimeter,
                      double seconds, bool grows, const std::optional<Comparison>& comparison) {
    Key key{document.picture_layout(), view.quantity, view.band, polarimeter, 0, 0, view.convention, view.fade_by_bar};
    const double start = now_s();
    key_version_ = document.picture_version();
    if (comparison) {
        key.reference_layout = comparison->reference->picture_layout();
        key.reference_band = comparison->band;
        key_version_ += comparison->reference->picture_version();  // both only grow
    }
    if (order_.empty() || !(key == key_)) {
        restart(document, key);
        seen_version_ = key_version_;
    } else if (rows_done_ == order_.size() && seen_version_ != key_version_) {
        if (grows && start - last_sweep_end_s_ < std::max(least_rest_s, rest_after_sweep * sweep_cost_s_)) return false;
        rows_done_ = 0;
        sweep_cost_s_ = 0.0;
        seen_version_ = key_version_;
    }
    if (rows_done_ == order_.size()) return false;

    std::optional<ShownQuantity> quantity;
    if (view.quantity != Quantity::color) {
        std::optional<ReferencePicture> reference;
        if (comparison) reference = comparison->picture();
        quantity.emplace(document.picture(), view, polarimeter, reference);
    }
    const std::uint64_t version = version_;
    double now = start;
    do {
        evaluate_row(document, polarimeter, quantity, order_[rows_done_]);
        ++rows_done_;
        now = now_s();
        // A first look is summed up ever more seldom, a repeated one once: its old rows are still good.
        const bool is_first_look = !known_[static_cast<std::size_t>(order_.back())];
        if (rows_done_ == order_.size() || (is_first_look && is_power_of_two(rows_done_)))
            summarize(document.picture().width);
    } while (rows_done_ < order_.size() && now - start < seconds);
    sweep_cost_s_ += now - start;
    last_sweep_end_s_ = now;
    return version_ != version;
}

void ShownMap::finish(const Document& document, const ViewSettings& view, const Polarimeter& polarimeter,
                      const std::optional<Comparison>& comparison) {
    constexpr double as_long_as_it_takes = std::numeric_limits<double>::infinity();
    update(document, view, polarimeter, as_long_as_it_takes, false, comparison);
    update(document, view, polarimeter, as_long_as_it_takes, false, comparison);
}

}  // namespace pol
