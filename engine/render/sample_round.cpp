// SPDX-License-Identifier: Apache-2.0
#include "render/sample_round.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pol {

namespace {

/// Whoever takes half of what is wanted takes all of it.
std::uint32_t doubled(std::uint32_t samples, std::uint32_t wanted) {
    return samples < wanted / 2 ? 2 * samples : wanted;
}

}  // namespace

SampleSpan SampleRound::next_pass(std::uint32_t sample, std::uint32_t strata_bits) const {
    constexpr std::uint32_t longest = 16;
    SampleSpan pass{std::numeric_limits<std::uint32_t>::max(), 0};
    for (std::size_t i = 0; i < spans.size(); ++i) {
        if ((strata_bits >> i & 1U) == 0 || spans[i].end <= sample || spans[i].is_empty()) continue;
        pass.begin = std::min(pass.begin, std::max(spans[i].begin, sample));
        pass.end = std::max(pass.end, spans[i].end);
    }
    if (pass.end == 0) return {};
    pass.end = std::min(pass.end, pass.begin + std::clamp(pass.begin, 1U, longest));
    return pass;
}

std::vector<std::uint32_t> SampleRound::pixels_of(const SampleSpan& pass, const TileRect& rect) const {
    std::vector<std::uint32_t> pixels;
    if (!strata) return pixels;
    for (std::uint32_t pixel = 0; pixel < rect.pixel_count(); ++pixel)
        if (spans[strata->of_pixel(rect, pixel)].holds(pass)) pixels.push_back(pixel);
    if (pixels.size() == rect.pixel_count()) pixels.clear();
    return pixels;
}

double SampleRound::samples_at_end(std::size_t pixels) const {
    if (!strata) return static_cast<double>(pixels) * spans.front().end;
    double sum = 0.0;
    for (std::size_t i = 0; i < spans.size(); ++i) sum += static_cast<double>(strata->pixels[i]) * spans[i].end;
    return sum;
}

std::optional<SampleRound> next_round(const SampleRound& last, const std::array<double, most_strata>& errors,
                                      std::uint32_t wanted) {
    constexpr double growth = 1.25;
    SampleRound next = last;
    for (SampleSpan& span : next.spans) span.begin = span.end;
    const auto is_over = [&](const SampleSpan& span) { return span.end >= wanted; };
    if (std::all_of(next.spans.begin(), next.spans.end(), is_over)) return std::nullopt;
    const double error = std::accumulate(errors.begin(), errors.end(), 0.0);
    if (!next.strata || !(error > 0.0)) {
        for (SampleSpan& span : next.spans) span.end = doubled(span.end, wanted);
        return next;
    }

    const std::size_t strata = next.spans.size();
    const auto samples = [&](std::size_t i) {
        return static_cast<double>(next.strata->pixels[i]) * static_cast<double>(next.spans[i].end);
    };
    double before = 0.0;
    for (std::size_t i = 0; i < strata; ++i) before += samples(i);
    double after = before;
    std::vector<double> left(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(strata));
    while (after < growth * before) {
        std::size_t best = strata;
        double most = -1.0;
        for (std::size_t i = 0; i < strata; ++i) {
            const double worth = left[i] / samples(i);
            if (is_over(next.spans[i]) || !(worth > most)) continue;
            best = i;
            most = worth;
        }
        if (best == strata) break;
        SampleSpan& span = next.spans[best];
        const double old = samples(best);
        span.end = doubled(span.end, wanted);
        left[best] *= old / samples(best);
        after += samples(best) - old;
    }
    return next;
}

}  // namespace pol
