// SPDX-License-Identifier: Apache-2.0
#include "compare/convention_doctor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pol::compare {
namespace {

constexpr double alike = 0.9;         // correlation of a component that is explained
constexpr double same_picture = 0.5;  // correlation of S0 of one picture
constexpr double equal_residuals = 1.05;

bool is_plain(const ConventionVerdict& verdict) {
    const ConventionFit& fit = verdict.fit;
    if (fit.frame != FrameChange::signs || fit.geometry != Geometry::same || fit.order != std::array<int, 3>{1, 2, 3})
        return false;
    for (std::size_t i = 0; i < 3; ++i)
        if (fit.decides(i) && fit.signs[i] < 0) return false;
    return true;
}

/// The simplest of the fits that are as good as the best, and the geometries of all those.
void choose(const ConventionFits& found, ConventionVerdict& verdict) {
    double best = found.fits.front().residual;
    for (const ConventionFit& fit : found.fits) best = std::min(best, fit.residual);
    const double noise = 3.0 * found.boxes * found.floor * found.floor;
    const double limit = best * equal_residuals + 1e-6 * found.polarization_of_b + noise;
    const ConventionFit* chosen = nullptr;
    for (const ConventionFit& fit : found.fits) {
        if (fit.residual > limit) continue;
        if (std::find(verdict.tied.begin(), verdict.tied.end(), fit.geometry) == verdict.tied.end())
            verdict.tied.push_back(fit.geometry);
        const bool simpler = chosen == nullptr || fit.simplicity < chosen->simplicity;
        if (simpler) chosen = &fit;
    }
    verdict.fit = *chosen;
}

Finding finding_of(const ConventionFits& found, const ConventionVerdict& verdict) {
    if (found.s0_correlation < same_picture) return Finding::another_picture;
    if (found.judged == StokesComponents()) return Finding::not_measured;
    const double noise = 3.0 * found.boxes * std::pow(decided_z * found.floor, 2);
    const bool a_is_polarized = found.polarization_of_a > noise;
    const bool b_is_polarized = found.polarization_of_b > noise;
    if (!a_is_polarized && !b_is_polarized) return Finding::unpolarized;
    if (!a_is_polarized || !b_is_polarized) return Finding::one_unpolarized;
    bool any = false;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!verdict.fit.decides(i)) continue;
        any = true;
        if (!(verdict.fit.correlation[i] > alike)) return Finding::disagree;
    }
    if (!any) return Finding::disagree;
    return is_plain(verdict) ? Finding::same_convention : Finding::explained;
}

/// The verdict on the numbers as they are.
ConventionVerdict judge(const StokesPlane& a, const StokesPlane& b, std::optional<double> pixel_tangent) {
    const ConventionFits found = fit_conventions(a, b, pixel_tangent);
    ConventionVerdict verdict;
    verdict.judged = found.judged;
    if (found.fits.empty()) return verdict;
    choose(found, verdict);
    for (unsigned i = 1; i < 4; ++i)
        if (found.judged.has(i) && !verdict.fit.decides(i - 1)) verdict.undecided = verdict.undecided.with(i);
    verdict.gamma = s0_gamma(a, b, verdict.fit.geometry);
    verdict.s0_correlation = found.s0_correlation;
    verdict.boxes = static_cast<int>(found.boxes);
    verdict.floor = found.floor / std::sqrt(found.light_of_b / found.boxes);
    if (found.polarization_of_b > 0.0)
        verdict.polarization_residual = std::sqrt(verdict.fit.residual / found.polarization_of_b);
    verdict.difference =
        std::sqrt((verdict.fit.residual + found.s0_residual) / (found.polarization_of_b + found.light_of_b));
    verdict.finding = finding_of(found, verdict);
    return verdict;
}

/// Without the boxes that have a part in the light that is cut off.
StokesPlane without_clipped(StokesPlane plane, double at) {
    for (std::size_t i = 0; i < plane.peaks.size(); ++i) {
        if (plane.peaks[i].s0 < at) continue;
        plane.light[i] = {};
        plane.counts[i] = 0;
    }
    return plane;
}

constexpr std::array<double Stokes<double>::*, 3> polarized{&Stokes<double>::s1, &Stokes<double>::s2,
                                                            &Stokes<double>::s3};

/// Is there light in the box?
bool is_lit(const StokesPlane& plane, std::size_t box) {
    return plane.counts[box] != 0 && plane.light[box].s0 > 0.0;
}

/// The numbers without their offset; empty if one of them cannot have it. A reader may have changed signs.
std::optional<StokesPlane> decoded(StokesPlane plane, StokesComponents judged, Coding coding) {
    constexpr double slack = 1e-6;
    double squares = 0.0, lit = 0.0;
    for (std::size_t box = 0; box < plane.light.size(); ++box) {
        if (!is_lit(plane, box)) continue;
        squares += plane.light[box].s0 * plane.light[box].s0;
        lit += 1.0;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        if (!judged.has(static_cast<unsigned>(i) + 1)) continue;
        double least = 1.0, most = -1.0;
        for (std::size_t box = 0; box < plane.light.size(); ++box) {
            if (!is_lit(plane, box)) continue;
            least = std::min(least, plane.light[box].*polarized[i]);
            most = std::max(most, plane.light[box].*polarized[i]);
        }
        const bool is_positive = least >= -slack && most <= 1.0 + slack;
        const bool is_negative = most <= slack && least >= -1.0 - slack;
        if (!is_positive && !is_negative) return std::nullopt;
        for (std::size_t box = 0; box < plane.light.size(); ++box) {
            double& s = plane.light[box].*polarized[i];
            const double unit = coding == Coding::offset ? 1.0 : plane.light[box].s0;
            s = is_lit(plane, box) ? unit * (is_positive ? 2.0 * s - 1.0 : 2.0 * s + 1.0) : 0.0;
        }
    }
    plane.noise *= coding == Coding::offset ? 2.0 : 2.0 * std::sqrt(squares / std::max(1.0, lit));
    return plane;
}

/// Sum of squares of the judged components, their means removed.
double variation(const StokesPlane& plane, StokesComponents judged) {
    double total = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!judged.has(static_cast<unsigned>(i) + 1)) continue;
        double count = 0.0, sum = 0.0, squares = 0.0;
        for (std::size_t box = 0; box < plane.light.size(); ++box) {
            if (!is_lit(plane, box)) continue;
            const double s = plane.light[box].*polarized[i];
            count += 1.0;
            sum += s;
            squares += s * s;
        }
        if (count > 0.0) total += std::max(0.0, squares - sum * sum / count);
    }
    return total;
}

/// `plain`, or the verdict on numbers with an offset if that explains B far better.
ConventionVerdict with_coding(const ConventionVerdict& plain, const StokesPlane& a, const StokesPlane& b,
                              std::optional<double> pixel_tangent) {
    constexpr double far_better = 0.5;
    constexpr double left_over = 0.1;  // of the squares: a correlation of 0.95
    constexpr double steepest = 1.25;
    ConventionVerdict best = plain;
    double limit = far_better * plain.polarization_residual;
    if (plain.finding != Finding::same_convention && plain.finding != Finding::explained &&
        plain.finding != Finding::disagree)
        return best;
    for (const Coding coding : {Coding::offset, Coding::ratio_offset}) {
        const std::optional<StokesPlane> mended = decoded(b, plain.judged, coding);
        if (!mended) break;
        ConventionVerdict verdict = judge(a, *mended, pixel_tangent);
        const bool fits = verdict.finding == Finding::same_convention || verdict.finding == Finding::explained;
        const double slope = verdict.fit.dop_scale;
        if (!fits || slope > steepest || slope < 1.0 / steepest || !(verdict.polarization_residual < limit)) continue;
        // Not by its mean alone: light that is the same everywhere has no slope.
        if (verdict.fit.residual > left_over * variation(*mended, plain.judged)) continue;
        limit = verdict.polarization_residual / equal_residuals;
        verdict.coding = coding;
        verdict.finding = Finding::explained;
        best = verdict;
    }
    return best;
}

}  // namespace

std::string_view name_of(Finding finding) {
    switch (finding) {
        case Finding::same_convention:
            return "same convention";
        case Finding::explained:
            return "explained";
        case Finding::disagree:
            return "no convention explains it";
        case Finding::another_picture:
            return "not the same picture";
        case Finding::unpolarized:
            return "unpolarized: nothing to compare";
        case Finding::one_unpolarized:
            return "only one of them is polarized";
        case Finding::not_measured:
            return "polarization not measured: nothing to compare";
        case Finding::nothing_in_common:
            return "nothing in common";
    }
    return "";
}

std::string_view name_of(Coding coding) {
    switch (coding) {
        case Coding::plain:
            return "s";
        case Coding::offset:
            return "0.5 + s/2";
        case Coding::ratio_offset:
            return "0.5 + s/(2 S0)";
    }
    return "";
}

ConventionVerdict diagnose(const StokesPlane& a, const StokesPlane& b, std::optional<double> pixel_tangent) {
    const ConventionVerdict all = judge(a, b, pixel_tangent);
    if (all.finding == Finding::nothing_in_common) return all;
    const std::optional<Clip> clip = s0_clip(a, b, all.fit.geometry);
    if (!clip) return with_coding(all, a, b, pixel_tangent);
    const StokesPlane rest = without_clipped(b, clip->at);
    ConventionVerdict verdict = with_coding(judge(a, rest, pixel_tangent), a, rest, pixel_tangent);
    verdict.clip = clip;
    return verdict;
}

std::optional<StokesConvention> adoptable(const ConventionVerdict& verdict, const StokesConvention& current) {
    const ConventionFit& fit = verdict.fit;
    if (verdict.finding != Finding::explained || verdict.coding != Coding::plain || fit.geometry != Geometry::same)
        return std::nullopt;
    if (fit.order[2] != 3 || fit.frame == FrameChange::radial || fit.frame == FrameChange::projected ||
        fit.frame == FrameChange::unprojected)
        return std::nullopt;

    // B's S1 + i S2 is A's, conjugated if `mirror`, times exp(-2 i turn); its S3 is sign3 A's.
    bool mirror = fit.frame == FrameChange::mirrored;
    double turn_deg = fit.turn_deg.value_or(0.0);
    int sign3 = fit.decides(2) ? fit.signs[2] : mirror ? -1 : 1;
    if (fit.frame == FrameChange::signs) {
        std::array<int, 3> signs = fit.signs;
        if (fit.order[0] == 1) {
            signs = fitting_sign_changes(verdict).front().signs;
            mirror = signs[0] != signs[1];
            turn_deg = signs[0] < 0 ? 90.0 : 0.0;
            sign3 = signs[2];
        } else {
            // (s S2, t S1): a conjugate times s i if s = t, a turn times -s i otherwise.
            mirror = signs[0] == signs[1];
            turn_deg = (signs[0] > 0) == mirror ? -45.0 : 45.0;
            if (!fit.decides(2)) sign3 = mirror ? -1 : 1;
        }
    }
    // A from B is z -> z exp(2 i turn), or conj(z) exp(-2 i turn); B from the file is z -> z exp(2 i zero), or of
    // conj(z) if y points down.
    StokesConvention wanted;
    wanted.y_down = current.y_down != mirror;
    wanted.azimuth_zero_deg = mirror ? -turn_deg - current.azimuth_zero_deg : turn_deg + current.azimuth_zero_deg;
    wanted.azimuth_zero_deg -= 180.0 * std::floor(wanted.azimuth_zero_deg / 180.0);
    if (wanted.azimuth_zero_deg >= 180.0) wanted.azimuth_zero_deg = 0.0;  // what is less than 0 by rounding
    const bool flips_s3 = (current.left_handed != current.y_down) != (sign3 < 0);
    wanted.left_handed = flips_s3 != wanted.y_down;
    if (wanted == current) return std::nullopt;
    return wanted;
}

}  // namespace pol::compare
