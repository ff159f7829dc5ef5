// SPDX-License-Identifier: Apache-2.0
#include "compare/convention_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/complex.h"
#include "polarization/coherence_matrix.h"

namespace pol::compare {
namespace {

using Linear = Complex<double>;  // S1 + i S2

constexpr std::array<Geometry, 8> all_geometries{Geometry::same,   Geometry::flip_y,       Geometry::flip_x,
                                                 Geometry::rot180, Geometry::transpose,    Geometry::rot90,
                                                 Geometry::rot270, Geometry::antitranspose};
constexpr std::array<std::array<int, 3>, 6> all_orders{
    {{1, 2, 3}, {1, 3, 2}, {2, 1, 3}, {2, 3, 1}, {3, 1, 2}, {3, 2, 1}}};

bool swaps_sides(Geometry geometry) {
    return geometry >= Geometry::transpose;
}

/// Pixel of A, width x height, that B has at (x, y).
std::pair<int, int> source_of(Geometry geometry, int width, int height, int x, int y) {
    switch (geometry) {
        case Geometry::same:
            return {x, y};
        case Geometry::flip_y:
            return {x, height - 1 - y};
        case Geometry::flip_x:
            return {width - 1 - x, y};
        case Geometry::rot180:
            return {width - 1 - x, height - 1 - y};
        case Geometry::transpose:
            return {y, x};
        case Geometry::rot90:
            return {width - 1 - y, x};
        case Geometry::rot270:
            return {y, height - 1 - x};
        case Geometry::antitranspose:
            return {width - 1 - y, height - 1 - x};
    }
    return {x, y};
}

/// Calls visit(light of A, light of B, x, y) for each box that both have light in.
template <class Visit>
void for_each_pair(const StokesPlane& a, const StokesPlane& b, Geometry geometry, const Visit& visit) {
    for (int y = 0; y < b.height; ++y) {
        for (int x = 0; x < b.width; ++x) {
            const auto [ax, ay] = source_of(geometry, a.width, a.height, x, y);
            const std::size_t i =
                static_cast<std::size_t>(ay) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(ax);
            const std::size_t j =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(b.width) + static_cast<std::size_t>(x);
            if (a.counts[i] != 0 && b.counts[j] != 0 && a.light[i].s0 > 0.0 && b.light[j].s0 > 0.0)
                visit(a.light[i], b.light[j], x, y);
        }
    }
}

/// Correlation of S0 and the scale that makes B's of A's.
struct LightFit {
    double boxes = 0.0;
    double correlation = 0.0;
    double scale = 0.0;
    double residual = 0.0;
    double square_b = 0.0;
};

LightFit fit_light(const StokesPlane& a, const StokesPlane& b, Geometry geometry) {
    // Light that is as even as this has no structure to compare.
    constexpr double even = 0.02;
    LightFit fit;
    double sum_a = 0.0, sum_b = 0.0;
    for_each_pair(a, b, geometry, [&](const Stokes<double>& p, const Stokes<double>& q, int, int) {
        fit.boxes += 1.0;
        sum_a += p.s0;
        sum_b += q.s0;
    });
    if (fit.boxes < fewest_boxes) return fit;
    const double mean_a = sum_a / fit.boxes;
    const double mean_b = sum_b / fit.boxes;
    double aa = 0.0, bb = 0.0, ab = 0.0, square_a = 0.0, product = 0.0;
    for_each_pair(a, b, geometry, [&](const Stokes<double>& p, const Stokes<double>& q, int, int) {
        const double u = p.s0 - mean_a;
        const double v = q.s0 - mean_b;
        aa += u * u;
        bb += v * v;
        ab += u * v;
        square_a += p.s0 * p.s0;
        product += p.s0 * q.s0;
        fit.square_b += q.s0 * q.s0;
    });
    const bool is_even = aa <= even * even * square_a && bb <= even * even * fit.square_b;
    if (is_even)
        fit.correlation = 1.0;
    else if (aa > 0.0 && bb > 0.0)
        fit.correlation = ab / std::sqrt(aa * bb);
    fit.scale = square_a > 0.0 ? product / square_a : 0.0;
    fit.residual = std::max(0.0, fit.square_b - fit.scale * product);
    return fit;
}

/// Products of B's components with those of A in some frame.
struct Moments {
    std::array<std::array<double, 3>, 3> cross{};  ///< B_i A_j
    std::array<double, 3> square{};                ///< A_j A_j

    void add(const std::array<double, 3>& ours, const std::array<double, 3>& theirs) {
        for (std::size_t j = 0; j < 3; ++j) {
            square[j] += ours[j] * ours[j];
            for (std::size_t i = 0; i < 3; ++i) cross[i][j] += theirs[i] * ours[j];
        }
    }
};

/// A's moments after S1 + i S2 was multiplied by `turn`, or its conjugate was; of what is not judged nothing is known.
Moments turned_moments(const Moments& m, Linear turn, bool mirror) {
    const double flip = mirror ? -1.0 : 1.0;
    const double c = turn.re, s = turn.im;
    Moments t = m;
    for (std::size_t i = 0; i < 3; ++i) {
        t.cross[i][0] = c * m.cross[i][0] - s * flip * m.cross[i][1];
        t.cross[i][1] = s * m.cross[i][0] + c * flip * m.cross[i][1];
    }
    return t;
}

class Fitter {
public:
    Fitter(const StokesPlane& a, const StokesPlane& b, std::optional<double> pixel_tangent, ConventionFits& result)
        : a_(a), b_(b), pixel_tangent_(pixel_tangent), result_(result) {}

    void fit(Geometry geometry, const LightFit& light, double rank) {
        Moments plain, radial, projected, unprojected;
        double own_products = 0.0;  // A1 A2, for squares in a turned frame
        square_b_ = {};
        const bool has_frame = judged(0) && judged(1);
        for_each_pair(a_, b_, geometry, [&](const Stokes<double>& p, const Stokes<double>& q, int x, int y) {
            const std::array<double, 3> ours{p.s1, p.s2, p.s3};
            const std::array<double, 3> theirs{q.s1, q.s2, q.s3};
            plain.add(ours, theirs);
            own_products += p.s1 * p.s2;
            for (std::size_t i = 0; i < 3; ++i) square_b_[i] += theirs[i] * theirs[i];
            if (!has_frame) return;
            const double right = (x + 0.5 - b_.center_x) * b_.box_width;
            const double up = (b_.center_y - y - 0.5) * b_.box_height;
            const auto in_frame = [&](double angle) {
                const Stokes<double> seen = rotate_basis(p, angle);
                return std::array<double, 3>{seen.s1, seen.s2, seen.s3};
            };
            radial.add(in_frame(std::atan2(up, right)), theirs);
            if (!pixel_tangent_) return;
            const double sx = right * *pixel_tangent_, sy = up * *pixel_tangent_;
            const double angle = std::atan2(-sx * sy, std::sqrt(1.0 + sx * sx + sy * sy));
            projected.add(in_frame(angle), theirs);
            unprojected.add(in_frame(-angle), theirs);
        });
        geometry_ = geometry;
        light_ = light;
        for (std::size_t n = 0; n < all_orders.size(); ++n) {
            if (!keeps_to_judged(all_orders[n])) continue;
            ConventionFit one = fit_of(plain, FrameChange::signs, all_orders[n]);
            for (std::size_t i = 0; i < 3; ++i)
                if (!one.decides(i) && one.order[i] == static_cast<int>(i) + 1) one.signs[i] = 1;
            keep(one, 2.0 * rank + 1.5 * static_cast<double>(n));
        }
        if (!has_frame) return;
        for (const bool mirror : {false, true}) {
            const auto& m = plain.cross;
            const Linear c =
                mirror ? Linear(m[0][0] - m[1][1], m[1][0] + m[0][1]) : Linear(m[0][0] + m[1][1], m[1][0] - m[0][1]);
            const double size = abs(c);
            const Linear turn = size > 0.0 ? c / size : Linear(1.0);
            Moments moments = turned_moments(plain, turn, mirror);
            const double cross = 2.0 * turn.re * turn.im * (mirror ? -own_products : own_products);
            const double cc = turn.re * turn.re, ss = turn.im * turn.im;
            moments.square[0] = std::max(0.0, cc * plain.square[0] + ss * plain.square[1] - cross);
            moments.square[1] = std::max(0.0, ss * plain.square[0] + cc * plain.square[1] + cross);
            ConventionFit one = fit_of(moments, mirror ? FrameChange::mirrored : FrameChange::turned, all_orders[0]);
            // By the definition of turn_deg: S1 + i S2 of B is that of A times exp(-2 i turn).
            one.turn_deg = -0.5 * std::atan2(turn.im, turn.re) * degrees_per_radian;
            keep(one, 2.0 * rank + (mirror ? 7.0 : 6.0));
        }
        keep(fit_of(radial, FrameChange::radial, all_orders[0]), 2.0 * rank + 8.0);
        if (!pixel_tangent_) return;
        keep(fit_of(projected, FrameChange::projected, all_orders[0]), 2.0 * rank + 9.0);
        keep(fit_of(unprojected, FrameChange::unprojected, all_orders[0]), 2.0 * rank + 9.5);
    }

private:
    static constexpr double degrees_per_radian = 57.295779513082320877;

    [[nodiscard]] bool judged(std::size_t component) const {
        return result_.judged.has(static_cast<unsigned>(component) + 1);
    }
    [[nodiscard]] bool keeps_to_judged(const std::array<int, 3>& order) const {
        for (std::size_t i = 0; i < 3; ++i) {
            const bool moved = order[i] != static_cast<int>(i) + 1;
            if (moved && (!judged(i) || !judged(static_cast<std::size_t>(order[i]) - 1))) return false;
        }
        return true;
    }

    [[nodiscard]] ConventionFit fit_of(const Moments& m, FrameChange frame, const std::array<int, 3>& order) const {
        const double k = light_.scale;
        ConventionFit fit;
        fit.geometry = geometry_;
        fit.frame = frame;
        fit.order = order;
        fit.scale = k;
        const double light = std::sqrt(light_.square_b / light_.boxes);
        double products = 0.0, squares = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            if (!judged(i)) continue;
            const auto j = static_cast<std::size_t>(order[i]) - 1;
            const double product = k * std::abs(m.cross[i][j]);
            const double ours = k * k * m.square[j];
            const double theirs = square_b_[i];
            const double left = std::max(0.0, ours + theirs - 2.0 * product);
            const double sigma = std::max(std::sqrt(left / light_.boxes), result_.floor);
            fit.signs[i] = m.cross[i][j] < 0.0 ? -1 : 1;
            fit.correlation[i] = ours > 0.0 && theirs > 0.0 ? product / std::sqrt(ours * theirs) : 0.0;
            fit.z[i] = ours > 0.0 && sigma > 0.0 ? product / (std::sqrt(ours) * sigma) : 0.0;
            fit.sigma[i] = light > 0.0 ? sigma / light : 0.0;
            fit.residual += left;
            products += product;
            squares += ours;
        }
        if (squares > 0.0) fit.dop_scale = products / squares;
        return fit;
    }

    void keep(ConventionFit fit, double simplicity) {
        fit.simplicity = simplicity;
        result_.fits.push_back(fit);
    }

    const StokesPlane& a_;
    const StokesPlane& b_;
    std::optional<double> pixel_tangent_;
    ConventionFits& result_;
    Geometry geometry_ = Geometry::same;
    LightFit light_;
    std::array<double, 3> square_b_{};
};

double polarization(const StokesPlane& plane, StokesComponents judged) {
    double sum = 0.0;
    for (const Stokes<double>& s : plane.light) {
        if (judged.has(1)) sum += s.s1 * s.s1;
        if (judged.has(2)) sum += s.s2 * s.s2;
        if (judged.has(3)) sum += s.s3 * s.s3;
    }
    return sum;
}

}  // namespace

std::string_view name_of(Geometry geometry) {
    constexpr std::array<std::string_view, 8> names{"same",      "flip_y", "flip_x", "rot180",
                                                    "transpose", "rot90",  "rot270", "antitranspose"};
    return names[static_cast<std::size_t>(geometry)];
}

std::string_view name_of(FrameChange change) {
    constexpr std::array<std::string_view, 6> names{"signs",        "turned frame",    "turned frame, mirrored",
                                                    "radial frame", "projected frame", "unprojected frame"};
    return names[static_cast<std::size_t>(change)];
}

ConventionFits fit_conventions(const StokesPlane& a, const StokesPlane& b, std::optional<double> pixel_tangent) {
    constexpr double nearly_best = 0.02;
    ConventionFits result;
    result.judged = (a.known & b.known).without(0);

    std::vector<std::pair<Geometry, LightFit>> lights;
    LightFit best;
    best.correlation = -2.0;
    for (const Geometry geometry : all_geometries) {
        const bool swapped = swaps_sides(geometry);
        if ((swapped ? a.height : a.width) != b.width || (swapped ? a.width : a.height) != b.height) continue;
        const LightFit light = fit_light(a, b, geometry);
        if (light.boxes < fewest_boxes) continue;
        lights.emplace_back(geometry, light);
        if (light.correlation > best.correlation) best = light;
    }
    if (lights.empty()) return result;
    result.s0_correlation = best.correlation;
    result.boxes = best.boxes;
    result.light_of_b = best.square_b;
    result.s0_residual = best.residual;
    result.floor = std::max(std::hypot(best.scale * a.noise, b.noise), 1e-6 * std::sqrt(best.square_b / best.boxes));
    result.polarization_of_a = best.scale * best.scale * polarization(a, result.judged);
    result.polarization_of_b = polarization(b, result.judged);
    Fitter fitter(a, b, pixel_tangent, result);
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lights[i].second.correlation >= best.correlation - nearly_best)
            fitter.fit(lights[i].first, lights[i].second, static_cast<double>(i));
    return result;
}

std::optional<double> s0_gamma(const StokesPlane& a, const StokesPlane& b, Geometry geometry) {
    constexpr double faint = 1e-3;
    constexpr double least_spread = 0.05;
    double brightest_a = 0.0, brightest_b = 0.0;
    for_each_pair(a, b, geometry, [&](const Stokes<double>& p, const Stokes<double>& q, int, int) {
        brightest_a = std::max(brightest_a, p.s0);
        brightest_b = std::max(brightest_b, q.s0);
    });
    double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for_each_pair(a, b, geometry, [&](const Stokes<double>& p, const Stokes<double>& q, int, int) {
        if (!(p.s0 > faint * brightest_a) || !(q.s0 > faint * brightest_b)) return;
        // Relative to the largest: logarithms of any unit of radiance are small then.
        const double u = std::log(p.s0 / brightest_a);
        const double v = std::log(q.s0 / brightest_b);
        count += 1.0;
        x += u;
        y += v;
        xx += u * u;
        xy += u * v;
    });
    if (count < fewest_boxes) return std::nullopt;
    const double spread = xx - x * x / count;
    if (!(spread > least_spread * least_spread * count)) return std::nullopt;
    return (xy - x * y / count) / spread;
}

std::optional<Clip> s0_clip(const StokesPlane& a, const StokesPlane& b, Geometry geometry) {
    constexpr double least_spread = 0.05;
    constexpr double deviations = 3.0;
    Clip clip;
    for (const Peak& peak : b.peaks) clip.at = std::max(clip.at, peak.s0);
    double boxes = 0.0, count = 0.0, sum = 0.0, squares = 0.0;       // of A where B is cut off
    double others = 0.0, other_squares = 0.0, other_products = 0.0;  // where it is not
    for_each_pair(a, b, geometry, [&](const Stokes<double>& p, const Stokes<double>& q, int x, int y) {
        const Peak& peak =
            b.peaks[static_cast<std::size_t>(y) * static_cast<std::size_t>(b.width) + static_cast<std::size_t>(x)];
        boxes += 1.0;
        if (peak.s0 < clip.at) {
            others += 1.0;
            other_squares += p.s0 * p.s0;
            other_products += p.s0 * q.s0;
            return;
        }
        clip.share += peak.share;
        if (peak.share < 0.5) return;
        count += 1.0;
        sum += p.s0;
        squares += p.s0 * p.s0;
    });
    if (count < fewest_boxes || others < fewest_boxes) return std::nullopt;
    const double mean = sum / count;
    const double variance = squares / count - mean * mean;
    const double even = least_spread * mean;
    const double noise = deviations * a.noise;
    if (!(variance > even * even + noise * noise) || !(other_products * mean > clip.at * other_squares))
        return std::nullopt;
    clip.share /= boxes;
    return clip;
}

}  // namespace pol::compare
