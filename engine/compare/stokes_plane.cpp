// SPDX-License-Identifier: Apache-2.0
#include "compare/stokes_plane.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/contract.h"

namespace pol::compare {
namespace {

/// How a side is cut: `count` boxes of `size` pixels from pixel `first` on.
struct Cut {
    int first = 0;
    int size = 1;
    int count = 0;
};

/// A side of units of `box` pixels.
Cut cut_of(int side, int box) {
    const int units = side / box;
    const int size = box_side(units);
    int count = units / size;
    // An odd rest cannot be split evenly.
    if (count > 1 && (units - count * size) % 2 != 0) --count;
    return {(units - count * size) / 2 * box, size * box, count};
}

/// What one box has seen.
struct Box {
    Stokes<double> light;
    double square_error = 0.0;  ///< of S1, S2 and S3
    int known = 0;
    double peak = 0.0;
    int at_peak = 0;
};

class Reader {
public:
    Reader(const StokesImage& image, std::span<const double> weights) : image_(image) {
        for (std::size_t b = 0; b < weights.size(); ++b)
            if (weights[b] != 0.0) bands_.push_back({b, weights[b]});
    }

    void read(std::size_t pixel, Box& box) const {
        constexpr double mostly_traced = 0.1;
        Stokes<double> sum;
        Stokes<double> error;  // at most: bands may share their samples
        for (const Term& term : bands_) {
            sum += term.weight * image_.at(term.band, pixel);
            if (image_.plane_value(image_.residual, term.band, pixel) > mostly_traced) return;
            if (!image_.sampling_error.empty())
                error += std::abs(term.weight) * image_.sampling_error[term.band * image_.pixel_count() + pixel];
        }
        if (!std::isfinite(sum.s0 + sum.s1 + sum.s2 + sum.s3) || sum.s0 < 0.0) return;
        box.light += sum;
        box.square_error += error.s1 * error.s1 + error.s2 * error.s2 + error.s3 * error.s3;
        ++box.known;
        if (sum.s0 > box.peak) {
            box.peak = sum.s0;
            box.at_peak = 0;
        }
        if (sum.s0 == box.peak) ++box.at_peak;
    }

    [[nodiscard]] StokesComponents known() const {
        StokesComponents known = StokesComponents::all();
        for (const Term& term : bands_) known = known & image_.bands[term.band].known;
        return known;
    }

private:
    struct Term {
        std::size_t band;
        double weight;
    };
    const StokesImage& image_;
    std::vector<Term> bands_;
};

}  // namespace

int box_side(int side) {
    constexpr int most_boxes = 192;
    const int least = (side + most_boxes - 1) / most_boxes;
    return std::max(1, least % 2 == 0 ? least + 1 : least);
}

StokesPlane plane_of(const StokesImage& image, const Area& area, std::span<const double> weights, int box) {
    POL_EXPECTS(box >= 1 && weights.size() == image.bands.size() && area.x >= 0 && area.y >= 0 && area.width > 0 &&
                area.height > 0 && area.x + area.width <= image.width && area.y + area.height <= image.height);
    const Reader reader(image, weights);
    const Cut across = cut_of(area.width, box);
    const Cut down = cut_of(area.height, box);
    StokesPlane plane;
    plane.width = across.count;
    plane.height = down.count;
    plane.known = reader.known();
    plane.box_width = across.size;
    plane.box_height = down.size;
    const double middle_x = 0.5 * (image.whole_width > 0 ? image.whole_width : image.width) - image.left;
    const double middle_y = 0.5 * (image.whole_height > 0 ? image.whole_height : image.height) - image.top;
    plane.center_x = (middle_x - area.x - across.first) / across.size;
    plane.center_y = (middle_y - area.y - down.first) / down.size;

    const auto boxes = static_cast<std::size_t>(plane.width) * static_cast<std::size_t>(plane.height);
    plane.light.resize(boxes);
    plane.counts.resize(boxes);
    plane.peaks.resize(boxes);
    double square_error = 0.0;
    double with_error = 0.0;
    std::vector<Box> row(static_cast<std::size_t>(plane.width));
    for (int j = 0; j < plane.height; ++j) {
        std::fill(row.begin(), row.end(), Box{});
        for (int y = 0; y < down.size; ++y) {
            std::size_t pixel = image.pixel(area.x + across.first, area.y + down.first + j * down.size + y);
            for (Box& one : row)
                for (int x = 0; x < across.size; ++x) reader.read(pixel++, one);
        }
        for (std::size_t i = 0; i < row.size(); ++i) {
            const Box& one = row[i];
            if (2 * one.known < across.size * down.size) continue;
            const std::size_t at = static_cast<std::size_t>(j) * row.size() + i;
            plane.light[at] = (1.0 / one.known) * one.light;
            plane.counts[at] = 1;
            plane.peaks[at] = {one.peak, static_cast<double>(one.at_peak) / one.known};
            const double variance = one.square_error / (3.0 * one.known * one.known);
            if (!std::isfinite(variance)) continue;
            square_error += variance;
            with_error += 1.0;
        }
    }
    if (with_error > 0.0) plane.noise = std::sqrt(square_error / with_error);
    return plane;
}

}  // namespace pol::compare
