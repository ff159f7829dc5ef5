// SPDX-License-Identifier: Apache-2.0
#include "render/sample_round.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pol {
namespace {

using Spans = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// All passes of a round over pixels of the given strata.
Spans passes(const SampleRound& round, std::uint32_t strata_bits) {
    Spans all;
    for (SampleSpan pass = round.next_pass(0, strata_bits); !pass.is_empty();
         pass = round.next_pass(pass.end, strata_bits))
        all.emplace_back(pass.begin, pass.end);
    return all;
}

Spans spans_of(const SampleRound& round) {
    Spans spans;
    for (const SampleSpan& span : round.spans) spans.emplace_back(span.begin, span.end);
    return spans;
}

/// Strata of so many pixels, all with four samples.
SampleRound sorted(std::vector<std::size_t> pixels) {
    SampleRound round;
    round.spans.assign(pixels.size(), {0, 4});
    auto strata = std::make_shared<Strata>();
    strata->pixels = std::move(pixels);
    round.strata = std::move(strata);
    return round;
}

TEST(SampleRound, PassesDoubleUpToSixteenSamples) {
    SampleRound round;
    round.spans.front().end = 50;
    EXPECT_EQ(passes(round, 1), (Spans{{0, 1}, {1, 2}, {2, 4}, {4, 8}, {8, 16}, {16, 32}, {32, 48}, {48, 50}}));
}

// A pixel's sum is formed pass by pass: the same passes, whichever rounds they belong to.
TEST(SampleRound, LimitsOfPassesDoNotDependOnRounds) {
    SampleRound round = sorted({100, 100, 100});
    round.spans = {{4, 4}, {8, 16}, {4, 64}};
    EXPECT_EQ(passes(round, 0b111), (Spans{{4, 8}, {8, 16}, {16, 32}, {32, 48}, {48, 64}}));
    EXPECT_EQ(passes(round, 0b011), (Spans{{8, 16}}));
    EXPECT_EQ(passes(round, 0b001), Spans{});
}

TEST(SampleRound, APassIsForThePixelsWhoseRoundHoldsIt) {
    SampleRound round;
    auto strata = std::make_shared<Strata>();
    strata->width = 4;
    strata->of_picture = {0, 0, 0, 0,  //
                          0, 1, 2, 1};
    strata->pixels = {5, 2, 1};
    round.strata = strata;
    round.spans = {{4, 4}, {4, 8}, {4, 16}};
    const TileRect rect{1, 0, 4, 2};
    EXPECT_EQ(round.pixels_of({4, 8}, rect), (std::vector<std::uint32_t>{3, 4, 5}));
    EXPECT_EQ(round.pixels_of({8, 16}, rect), (std::vector<std::uint32_t>{4}));
    EXPECT_TRUE(round.pixels_of({4, 8}, {1, 1, 4, 2}).empty()) << "all of them";
}

// Error per sample: 100 pixels with 16 times the squared error of 1600 others in all are worth 256 times as much, and
// still 1/2 of that at twice the samples, which takes half of the error away at least.
TEST(SampleRound, SamplesGoWhereTheyTakeMostOfTheErrorAway) {
    const SampleRound last = sorted({1600, 100});
    const auto next = next_round(last, {1.0, 16.0}, 1024);
    ASSERT_TRUE(next);
    // 6800 samples; a quarter more are 8500: 400 + 800 + 1600 are not 1700 before the third doubling.
    EXPECT_EQ(spans_of(*next), (Spans{{4, 4}, {4, 32}}));
    EXPECT_EQ(next->samples_at_end(1700), 1600.0 * 4.0 + 100.0 * 32.0);
}

TEST(SampleRound, EqualErrorsPerSampleAreServedAlike) {
    const auto next = next_round(sorted({100, 100, 100, 100}), {1.0, 1.0, 1.0, 1.0}, 1024);
    ASSERT_TRUE(next);
    EXPECT_EQ(next->samples_at_end(400), 5.0 * 400.0) << "a quarter more, from one of four";
    SampleRound round = *next;
    for (int i = 0; i < 10; ++i) {
        std::array<double, most_strata> errors{};
        for (std::size_t s = 0; s < 4; ++s) errors[s] = 1.0 / round.spans[s].end;
        round = next_round(round, errors, 1U << 20U).value();
        const auto [fewest, most] = std::minmax_element(round.spans.begin(), round.spans.end(),
                                                        [](const auto& a, const auto& b) { return a.end < b.end; });
        EXPECT_LE(most->end, 2 * fewest->end);
    }
}

TEST(SampleRound, NoPixelGetsMoreThanAreWanted) {
    SampleRound round = sorted({100, 100});
    const std::array<double, most_strata> errors{1e-9, 1.0};
    for (int i = 0; i < 20; ++i) {
        const auto next = next_round(round, errors, 20);
        if (!next) break;
        for (const SampleSpan& span : next->spans) {
            EXPECT_LE(span.end, 20U);
            EXPECT_LE(span.begin, span.end);
        }
        round = *next;
    }
    for (const SampleSpan& span : round.spans) EXPECT_EQ(span.end, 20U);
    EXPECT_FALSE(next_round(round, errors, 20));
}

TEST(SampleRound, WithoutErrorOrStrataEveryPixelGetsTwiceAsMany) {
    EXPECT_EQ(spans_of(next_round(sorted({1000, 100}), {}, 1024).value()), (Spans{{4, 8}, {4, 8}}));
    SampleRound plain;
    plain.spans.front().end = 1;
    EXPECT_EQ(spans_of(next_round(plain, {}, 1024).value()), (Spans{{1, 2}}));
    plain.spans.front().end = 8;
    EXPECT_EQ(spans_of(next_round(plain, {}, 15).value()), (Spans{{8, 15}}));
}

}  // namespace
}  // namespace pol
