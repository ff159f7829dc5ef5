// SPDX-License-Identifier: Apache-2.0
// Pictures for the convention doctor.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "compare/convention_doctor.h"

namespace pol::compare::test {

inline StokesImage picture(int width, int height) {
    StokesImage image;
    image.width = width;
    image.height = height;
    image.bands = {named_band("")};
    image.stokes.resize(image.pixel_count());
    return image;
}

inline StokesPlane whole(const StokesImage& image) {
    return plane_of(image, {0, 0, image.width, image.height}, std::vector<double>(image.bands.size(), 1.0));
}

/// A picture without any symmetry: waves of several directions and some noise, |s| < S0. Fixed seed.
inline StokesImage scenery(int width, int height, unsigned seed = 1) {
    std::mt19937 random(seed);
    const auto draw = [&random] { return static_cast<double>(random()) / 4294967296.0; };
    StokesImage image = picture(width, height);
    std::array<std::array<double, 3>, 4> waves{};
    for (auto& wave : waves) wave = {8.0 * draw() - 4.0, 8.0 * draw() - 4.0, 6.3 * draw()};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::array<double, 4> s{};
            for (std::size_t i = 0; i < 4; ++i)
                s[i] = std::sin(waves[i][0] * x / width + waves[i][1] * y / height + waves[i][2]) + 0.2 * draw();
            image.stokes[image.pixel(x, y)] = {1.5 + s[0], 0.25 * s[1], 0.2 * s[2], 0.15 * s[3]};
        }
    }
    return image;
}

template <class Change>
StokesImage changed(const StokesImage& image, const Change& change) {
    StokesImage other = image;
    for (Stokes<double>& s : other.stokes) s = change(s);
    return other;
}

inline ConventionVerdict verdict_of(const StokesImage& a, const StokesImage& b) {
    return diagnose(whole(a), whole(b));
}

}  // namespace pol::compare::test
