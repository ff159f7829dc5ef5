// SPDX-License-Identifier: Apache-2.0
// Which pixels get samples next, and how many.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "film/picture_error.h"
#include "film/strata.h"

namespace pol {

/// Sample numbers begin <= s < end, counted from 0 at RenderSettings::first_sample().
struct SampleSpan {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    [[nodiscard]] bool is_empty() const { return begin >= end; }
    [[nodiscard]] bool holds(const SampleSpan& part) const { return begin <= part.begin && part.end <= end; }
};

/// Samples after which a picture's pixels are sorted into strata: the fewest that every pixel has.
inline constexpr std::uint32_t samples_to_sort = 4;

/// Whether enough pixels make the error that sums over strata of them tell it. Where three pixels have nearly all of it
/// (a small lamp behind a cube), the stratum that is left alone is the one whose pixels look quiet by luck: true errors
/// 1.7 times as large as their estimate were seen. The spread of P equal pixels is sqrt(3/P): 470 of them are enough
/// that true and estimated error differ by 5 % (tests/bench/error_stop_seeds.cpp).
inline bool can_be_sorted(const PictureError& error) {
    constexpr double largest_spread = 0.08;
    return error.random_samples && error.sampling && error.sampling_spread <= largest_spread;
}

/// Between two looks at the error each stratum of pixels goes from one number of samples to another.
struct SampleRound {
    std::shared_ptr<const Strata> strata;  ///< null: one stratum, all pixels
    std::vector<SampleSpan> spans{{}};     ///< by stratum

    /// The next pass after `sample` over pixels of the given strata, a bit for each. Empty: the round is over for them.
    /// Passes double in length, so that a picture is there early and the overhead of a pass vanishes later. Their
    /// limits depend on nothing but the sample number: the sum of a pixel is formed in the same order whatever the
    /// rounds.
    [[nodiscard]] SampleSpan next_pass(std::uint32_t sample, std::uint32_t strata_bits) const;

    /// The pixels of a rectangle, counted row by row in it, that a pass is for; empty: all.
    [[nodiscard]] std::vector<std::uint32_t> pixels_of(const SampleSpan& pass, const TileRect& rect) const;

    /// Samples of all pixels, of which there are so many, at the end of the round.
    [[nodiscard]] double samples_at_end(std::size_t pixels) const;
};

/// The round after one that has ended, or empty if every pixel has the samples that are `wanted`. `errors`: what each
/// stratum adds to the error of the picture (ErrorSums::half_error).
///
/// Strata double their samples one after another, always the one where a sample takes most of the error away, which
/// falls at least like 1/N, until the picture has a quarter more of them: enough for a look at the error, few enough
/// for the next look to know better. A picture without error or without strata doubles its samples everywhere.
std::optional<SampleRound> next_round(const SampleRound& last, const std::array<double, most_strata>& errors,
                                      std::uint32_t wanted);

}  // namespace pol
