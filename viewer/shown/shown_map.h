// SPDX-License-Identifier: Apache-2.0
// The shown quantity of every pixel: what the histogram counts, what the color bar's range and legend are made from.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "maps/evaluate.h"
#include "viewer/document/document.h"
#include "viewer/shown/polarimeter.h"
#include "viewer/shown/shown_quantity.h"
#include "viewer/shown/view_settings.h"

namespace pol {

/// The document that the one on screen is held against, pixel by pixel.
struct Comparison {
    const Document* reference = nullptr;
    std::size_t band = 0;  ///< of the reference, in its own list: the one on screen
    [[nodiscard]] ReferencePicture picture() const { return {&reference->picture(), band}; }
};

/// What a map contains, as far as it is known.
struct MapSummary {
    std::size_t pixels = 0;                              ///< looked at
    std::array<std::size_t, pixel_state_count> state{};  ///< of them, by PixelState
    double low = 0.0;                                    ///< extremes of the defined values; 0 if there are none
    double high = 0.0;
};

/// Values behind the polarimeter, as maps::evaluate has them, or how far they are from those of a reference; of the
/// color picture, the luminance Y (white is 1).
///
/// A million pixels take a good part of a second. So the map is made row by row, spread over frames, and in such an
/// order that the first rows already stand for the whole. When anything but the picture changes it starts over at once;
/// a picture that is still being rendered is looked at again only so often that it costs a tenth of the time.
/// Main thread only.
class ShownMap {
public:
    /// Works for about `seconds`; `grows`: the picture is still being rendered. Returns true if something changed for
    /// the reader.
    bool update(const Document& document, const ViewSettings& view, const Polarimeter& polarimeter, double seconds,
                bool grows, const std::optional<Comparison>& comparison = {});
    /// Brings all pixels up to date.
    void finish(const Document& document, const ViewSettings& view, const Polarimeter& polarimeter,
                const std::optional<Comparison>& comparison = {});
    /// No document is shown.
    void clear();

    /// All pixels stand for the picture that update() saw last.
    [[nodiscard]] bool complete() const { return rows_done_ == order_.size() && seen_version_ == key_version_; }
    /// Grows with every change of summary().
    [[nodiscard]] std::uint64_t version() const { return version_; }
    [[nodiscard]] const MapSummary& summary() const { return summary_; }
    /// By pixel; only the value of a `defined` one means anything. Rows not looked at yet are `undetermined`.
    [[nodiscard]] const std::vector<double>& values() const { return values_; }
    [[nodiscard]] const std::vector<PixelState>& states() const { return states_; }
    /// MapPixel::weight by pixel, times the certainty if the view fades by the bar; 1 for the color picture.
    [[nodiscard]] const std::vector<float>& weights() const { return weights_; }
    [[nodiscard]] bool knows_row(int y) const { return known_[static_cast<std::size_t>(y)]; }

private:
    struct Key {
        std::uint64_t layout = 0;
        Quantity quantity{};
        std::size_t band = 0;
        Polarimeter polarimeter;
        std::uint64_t reference_layout = 0;  // 0: no reference
        std::size_t reference_band = 0;
        Convention convention;
        bool fade_by_bar = false;
        friend bool operator==(const Key&, const Key&) = default;
    };
    void restart(const Document& document, const Key& key);
    void evaluate_row(const Document& document, const Polarimeter& polarimeter,
                      const std::optional<ShownQuantity>& quantity, int y);
    void summarize(int width);

    Key key_;
    std::uint64_t key_version_ = 0;   // of the picture that update() saw last
    std::uint64_t seen_version_ = 0;  // of the picture that the running sweep began with
    std::vector<int> order_;          // rows
    std::size_t rows_done_ = 0;       // of this sweep
    std::vector<bool> known_;         // by row: evaluated in this sweep or an earlier one with the same key
    std::vector<double> values_;
    std::vector<PixelState> states_;
    std::vector<float> weights_;
    std::vector<double> luminance_weights_;  // by band, for color
    MapSummary summary_;
    std::uint64_t version_ = 0;
    double sweep_cost_s_ = 0.0;
    double last_sweep_end_s_ = 0.0;  // on the steady clock
};

}  // namespace pol
