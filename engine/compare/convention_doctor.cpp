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

ConventionVerdict diagnose(const StokesPlane& a, const StokesPlane& b, std::optional<double> pixel_tangent) {
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

std::optional<StokesConvention> adoptable(const ConventionVerdict& verdict, const StokesConvention& current) {
    const ConventionFit& fit = verdict.fit;
    if (verdict.finding != Finding::explained || fit.geometry != Geometry::same) return std::nullopt;
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
