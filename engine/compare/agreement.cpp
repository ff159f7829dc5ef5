// SPDX-License-Identifier: Apache-2.0
#include "compare/agreement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/contract.h"

namespace pol::compare {
namespace {

using Plane = std::vector<double>;

double component(const Stokes<double>& s, unsigned i) {
    return i == 0 ? s.s0 : i == 1 ? s.s1 : i == 2 ? s.s2 : s.s3;
}

double largest_component(const Stokes<double>& s) {
    return std::max({std::abs(s.s0), std::abs(s.s1), std::abs(s.s2), std::abs(s.s3)});
}

/// How far two numbers of a pixel may be apart and yet be the same.
class Tolerance {
public:
    explicit Tolerance(const CommonPictures& pictures) : pictures_(pictures) {}

    [[nodiscard]] double of(std::size_t value, unsigned i) const {
        return allowed_by(pictures_.a, value, i) + allowed_by(pictures_.b, value, i);
    }

private:
    [[nodiscard]] double allowed_by(const CommonPicture& one, std::size_t value, unsigned i) const {
        const double bound = one.bound.empty() ? 0.0 : one.bound[value];
        if (one.is_color) return bound;
        const Stokes<double>& a = pictures_.a.image.stokes[value];
        const Stokes<double>& b = pictures_.b.image.stokes[value];
        const double size = one.is_plain ? std::max(std::abs(component(a, i)), std::abs(component(b, i)))
                                         : std::max(largest_component(a), largest_component(b));
        const StoredNumbers& stored = one.image.stored;
        // Of the number before it was rounded, which is larger by no more than both roundings.
        const double slack = 1.0 + 2.0 * (pictures_.a.image.stored.rounding() + pictures_.b.image.stored.rounding());
        return stored.rounding() * slack * size + 0.5 * stored.step() + bound;
    }

    const CommonPictures& pictures_;
};

/// Sums over 5 x 5 pixels, cut at the edges.
Plane box_sums(const Plane& plane, int width, int height) {
    constexpr int reach = 2;
    const auto w = static_cast<std::size_t>(width);
    const auto h = static_cast<std::size_t>(height);
    Plane rows(plane.size()), sums(plane.size());
    const auto near = [](std::size_t i, std::size_t count, const auto& visit) {
        const std::size_t first = i < reach ? 0 : i - reach;
        for (std::size_t k = first; k <= std::min(i + reach, count - 1); ++k) visit(k);
    };
    for (std::size_t y = 0; y < h; ++y)
        for (std::size_t x = 0; x < w; ++x) near(x, w, [&](std::size_t k) { rows[y * w + x] += plane[y * w + k]; });
    for (std::size_t y = 0; y < h; ++y)
        for (std::size_t x = 0; x < w; ++x) near(y, h, [&](std::size_t k) { sums[y * w + x] += rows[k * w + x]; });
    return sums;
}

constexpr int most_freedom = 60;  // beyond that Student's distribution is the normal one to a tenth

/// Of each possible number of degrees of freedom, from 1 on.
const std::array<double, most_freedom + 1>& chances() {
    static const std::array<double, most_freedom + 1> all = [] {
        std::array<double, most_freedom + 1> made{};
        for (int n = 1; n <= most_freedom; ++n) made[static_cast<std::size_t>(n)] = beyond_t(significant_t, n);
        return made;
    }();
    return all;
}

/// Adds up one component over the bands.
class SignificanceSums {
public:
    SignificanceSums(const CommonPictures& pictures, unsigned component)
        : a_(pictures.a.image),
          b_(pictures.b.image),
          tolerance_(pictures),
          component_(component),
          by_pixel_(a_.pixel_count(), 0.0) {}

    void add_band(std::size_t band) {
        const std::size_t pixels = a_.pixel_count();
        Plane variance(pixels, 0.0), square(pixels, 0.0), counted(pixels, 0.0), excess(pixels, 0.0);
        for (std::size_t p = 0; p < pixels; ++p) {
            const std::size_t v = band * pixels + p;
            const double of_a = variance_of(a_, v), of_b = variance_of(b_, v);
            const double apart = std::abs(component(a_.stokes[v], component_) - component(b_.stokes[v], component_));
            if (!std::isfinite(apart)) continue;
            excess[p] = std::max(0.0, apart - tolerance_.of(v, component_));
            if (!std::isfinite(of_a + of_b)) {
                if (excess[p] > 0.0) ++result_.unbarred;
                continue;
            }
            counted[p] = 1.0;
            variance[p] = of_a + of_b;
            // The square of a variance of one degree of freedom is three times that of the true one, on average.
            square[p] = (of_a * of_a + of_b * of_b) / 3.0;
            by_pixel_[p] += variance[p];
            differences_ += excess[p] * excess[p];
            variances_ += variance[p];
            ++result_.values;
        }
        const Plane near_variance = box_sums(variance, a_.width, a_.height);
        const Plane near_square = box_sums(square, a_.width, a_.height);
        const Plane near_count = box_sums(counted, a_.width, a_.height);
        for (std::size_t p = 0; p < pixels; ++p) {
            if (counted[p] == 0.0) continue;
            const double mean = std::max(near_variance[p] / near_count[p], variance[p]);
            if (near_square[p] > 0.0) {
                const double freedom = std::round(near_variance[p] * near_variance[p] / near_square[p]);
                const auto row = static_cast<std::size_t>(std::clamp(freedom, 1.0, double{most_freedom}));
                result_.beyond_by_chance += chances()[row];
            }
            if (excess[p] == 0.0) continue;
            const double t = mean > 0.0 ? excess[p] / std::sqrt(mean) : std::numeric_limits<double>::infinity();
            result_.largest = std::max(result_.largest, t);
            if (t > significant_t) ++result_.beyond;
        }
    }

    [[nodiscard]] ComponentSignificance result() const {
        constexpr double deviations = 3.0;
        ComponentSignificance result = result_;
        if (differences_ > 0.0)
            result.ratio =
                variances_ > 0.0 ? std::sqrt(differences_ / variances_) : std::numeric_limits<double>::infinity();
        double squares = 0.0;
        for (const double v : by_pixel_) squares += v * v;
        // Both sums have the relative variance 2 / P, P the number of pixels that have the errors. It is taken three
        // times too small by these squares, which makes three deviations five.
        if (squares > 0.0) {
            const double pixels = variances_ * variances_ / squares;
            result.largest_ratio = std::sqrt(1.0 + deviations * std::sqrt(4.0 / pixels));
        }
        return result;
    }

private:
    [[nodiscard]] double variance_of(const StokesImage& image, std::size_t value) const {
        if (image.sampling_error.empty()) return 0.0;
        const double error = component(image.sampling_error[value], component_);
        return error * error;
    }

    const StokesImage& a_;
    const StokesImage& b_;
    Tolerance tolerance_;
    unsigned component_;
    Plane by_pixel_;
    ComponentSignificance result_;
    double differences_ = 0.0;
    double variances_ = 0.0;
};

StokesComponents known_in_both(const CommonPictures& pictures, std::size_t band) {
    return pictures.a.image.bands[band].known & pictures.b.image.bands[band].known;
}

}  // namespace

bool Significance::is_chance() const {
    return std::all_of(components.begin(), components.end(),
                       [](const auto& component) { return !component || component->is_chance(); });
}

bool Agreement::is_same() const {
    if (not_finite > 0 || values == 0) return false;
    return beyond_rounding == 0 || (significance && significance->is_chance());
}

Agreement agreement(const CommonPictures& pictures) {
    const StokesImage& a = pictures.a.image;
    const StokesImage& b = pictures.b.image;
    POL_EXPECTS(a.width == b.width && a.height == b.height && a.bands.size() == b.bands.size());
    Agreement result;
    const Tolerance tolerance(pictures);
    double differences = 0.0, light = 0.0;
    for (std::size_t band = 0; band < a.bands.size(); ++band) {
        const StokesComponents known = known_in_both(pictures, band);
        for (std::size_t p = 0; p < a.pixel_count(); ++p) {
            const std::size_t v = band * a.pixel_count() + p;
            double square = 0.0, square_a = 0.0;
            for (unsigned i = 0; i < 4; ++i) {
                if (!known.has(i)) continue;
                const double x = component(a.stokes[v], i);
                const double y = component(b.stokes[v], i);
                const double apart = std::abs(x - y);
                square += apart * apart / 2.0;
                square_a += x * x / 2.0;
                ++result.values;
                if (x == y || (std::isnan(x) && std::isnan(y)))
                    ++result.identical;
                else if (!std::isfinite(apart))
                    ++result.not_finite;
                else if (apart > tolerance.of(v, i))
                    ++result.beyond_rounding;
            }
            const double distance = std::sqrt(square);
            if (!std::isfinite(distance)) continue;
            differences += square;
            light += square_a;
            if (result.worst && distance <= result.worst->distance) continue;
            result.worst = WorstPixel{static_cast<int>(p % static_cast<std::size_t>(a.width)),
                                      static_cast<int>(p / static_cast<std::size_t>(a.width)),
                                      band,
                                      distance,
                                      a.stokes[v],
                                      b.stokes[v]};
        }
    }
    if (differences > 0.0)
        result.distance = light > 0.0 ? std::sqrt(differences / light) : std::numeric_limits<double>::infinity();
    if (a.sampling_error.empty() && b.sampling_error.empty()) return result;
    Significance significance;
    significance.a_has_bars = !a.sampling_error.empty();
    significance.b_has_bars = !b.sampling_error.empty();
    for (unsigned i = 0; i < 4; ++i) {
        SignificanceSums sums(pictures, i);
        bool any = false;
        for (std::size_t band = 0; band < a.bands.size(); ++band) {
            if (!known_in_both(pictures, band).has(i)) continue;
            sums.add_band(band);
            any = true;
        }
        if (any) significance.components[i] = sums.result();
    }
    result.significance = significance;
    return result;
}

double beyond_t(double t, int freedom) {
    POL_EXPECTS(freedom >= 1);
    // Abramowitz & Stegun 26.7.3 and 26.7.4.
    const double angle = std::atan(t / std::sqrt(static_cast<double>(freedom)));
    const double c = std::cos(angle);
    const bool is_odd = freedom % 2 != 0;
    double term = is_odd ? c : 1.0;
    double sum = freedom == 1 ? 0.0 : term;
    for (int n = is_odd ? 3 : 2; n < freedom; n += 2) {
        term *= c * c * (n - 1) / n;
        sum += term;
    }
    const double inside = is_odd ? 2.0 / std::numbers::pi * (angle + std::sin(angle) * sum) : std::sin(angle) * sum;
    return 1.0 - inside;
}

}  // namespace pol::compare
