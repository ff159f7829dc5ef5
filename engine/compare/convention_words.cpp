// SPDX-License-Identifier: Apache-2.0
// What the doctor says.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "compare/convention_doctor.h"
#include "core/join.h"

namespace pol::compare {
namespace {

/// "S1", "S1 and S2", "S1, S2 and S3".
std::string list_of(StokesComponents components) {
    std::vector<std::string> names;
    for (unsigned i = 0; i < 4; ++i)
        if (components.has(i)) names.push_back(fmt::format("S{}", i));
    if (names.size() < 2) return join(names, "");
    const std::string last = names.back();
    names.pop_back();
    return join(names, ", ") + " and " + last;
}

StokesComponents flipped_in(const std::array<int, 3>& signs) {
    StokesComponents flipped;
    for (unsigned i = 1; i < 4; ++i)
        if (signs[i - 1] < 0) flipped = flipped.with(i);
    return flipped;
}

/// "agree to 0.4 %"
std::string agreement(double difference) {
    if (difference < 1e-6) return "are the same up to rounding";
    return fmt::format("agree to {:.2g} %", 100.0 * difference);
}

std::string_view words_of(Geometry geometry) {
    switch (geometry) {
        case Geometry::same:
            return "lies as ours";
        case Geometry::flip_y:
            return "is upside down, its rows in the other order";
        case Geometry::flip_x:
            return "is mirrored left to right";
        case Geometry::rot180:
            return "is turned by 180 degrees";
        case Geometry::transpose:
            return "has rows and columns exchanged";
        case Geometry::rot90:
            return "is turned by 90 degrees counter-clockwise";
        case Geometry::rot270:
            return "is turned by 90 degrees clockwise";
        case Geometry::antitranspose:
            return "has rows and columns exchanged, and is turned by 180 degrees";
    }
    return "";
}

/// Clauses on B: "has S3 with the other sign: it uses ...".
std::vector<std::string> changes_of(const ConventionVerdict& verdict) {
    const ConventionFit& fit = verdict.fit;
    std::vector<std::string> changes;
    if (verdict.coding != Coding::plain)
        changes.push_back(
            fmt::format("has {} stored as {}",
                        verdict.judged == StokesComponents::all().without(0) ? "S1 to S3" : list_of(verdict.judged),
                        name_of(verdict.coding)));
    if (fit.geometry != Geometry::same) changes.emplace_back(words_of(fit.geometry));
    const bool is_in_order = fit.order == std::array<int, 3>{1, 2, 3};
    const StokesComponents flipped = flipped_in(fit.signs);
    switch (fit.frame) {
        case FrameChange::signs:
            if (is_in_order) {
                const SignChange change = fitting_sign_changes(verdict).front();
                const StokesComponents told = flipped_in(change.signs);
                StokesComponents sure;
                for (unsigned i = 1; i < 4; ++i)
                    if (told.has(i) && fit.decides(i - 1)) sure = sure.with(i);
                if (sure != StokesComponents())
                    changes.push_back(fmt::format("has {} with the other sign: {}", list_of(sure), change.who));
            } else {
                changes.push_back(fmt::format(
                    "has S{}, S{} and S{} where S1, S2 and S3 belong{}", fit.order[0], fit.order[1], fit.order[2],
                    flipped == StokesComponents() ? "" : ", " + list_of(flipped) + " of them with the other sign"));
                if (fit.order[2] == 3)
                    changes.back() +=
                        ": its azimuth counts from a diagonal, or the arguments of an arc tangent are exchanged";
            }
            return changes;
        case FrameChange::turned:
        case FrameChange::mirrored:
            changes.push_back(
                fmt::format("has its frame turned by {:.2f} degrees counter-clockwise{}: its camera is rolled, or its "
                            "azimuth counts from there",
                            *fit.turn_deg, fit.frame == FrameChange::mirrored ? " and seen from behind" : ""));
            break;
        case FrameChange::radial:
            changes.emplace_back(
                "is written in a frame that points away from the middle of the picture: the last "
                "rotation, from the plane of incidence to the camera, is missing");
            break;
        case FrameChange::projected:
            changes.emplace_back(
                "has the camera's right, projected across the ray, for its x axis; ours is across the ray and "
                "up");
            break;
        case FrameChange::unprojected:
            changes.emplace_back(
                "has its x axis across the ray and up; A has the camera's right, projected across the ray");
            break;
    }
    const bool is_behind = fit.frame == FrameChange::mirrored;
    if (fit.decides(2) && (fit.signs[2] < 0) != is_behind)
        changes.emplace_back("has S3 with the other sign: it uses another handedness");
    return changes;
}

std::string what_to_set(const StokesConvention& wanted, const StokesConvention& current) {
    std::vector<std::string> settings;
    if (wanted.left_handed != current.left_handed)
        settings.emplace_back(wanted.left_handed ? "handedness: left" : "handedness: right");
    if (wanted.y_down != current.y_down) settings.emplace_back(wanted.y_down ? "y: down" : "y: up");
    if (wanted.azimuth_zero_deg != current.azimuth_zero_deg)
        settings.push_back(fmt::format("azimuth zero: {:.6g} degrees", wanted.azimuth_zero_deg));
    return join(settings, ", ");
}

std::string about_undecided(const ConventionVerdict& verdict) {
    if (verdict.undecided == StokesComponents()) return {};
    double noise = 0.0;
    for (unsigned i = 1; i < 4; ++i)
        if (verdict.undecided.has(i)) noise = std::max(noise, verdict.fit.sigma[i - 1]);
    std::string text = fmt::format(" {} cannot be decided, below the noise ({:.2g} % of S0)",
                                   list_of(verdict.undecided), 100.0 * noise);
    std::vector<std::string> names;
    for (const SignChange& change : fitting_sign_changes(verdict)) names.emplace_back(change.name);
    return names.size() < 2 ? text + "." : fmt::format("{}: {} would fit.", text, join(names, ", or "));
}

std::string about_unmeasured(const ConventionVerdict& verdict) {
    StokesComponents missing;
    for (unsigned i = 1; i < 4; ++i)
        if (!verdict.judged.has(i)) missing = missing.with(i);
    if (missing == StokesComponents()) return {};
    return fmt::format(" {} {} not measured in both: nothing is said of {}.", list_of(missing),
                       missing.has(1) + missing.has(2) + missing.has(3) > 1 ? "are" : "is",
                       missing.has(1) + missing.has(2) + missing.has(3) > 1 ? "them" : "it");
}

/// Who is known to write S0 times this.
std::string_view known_scale(double scale) {
    struct Known {
        double scale;
        std::string_view who;
    };
    constexpr std::array<Known, 5> all{{{2.0, "half amplitudes, or sums over polarizers that were not halved"},
                                        {0.5, "half of S0, as behind a polarizer"},
                                        {0.9483, "the green of linear sRGB of an equal-energy spectrum"},
                                        {1.2048, "the red of linear sRGB of an equal-energy spectrum"},
                                        {0.9088, "the blue of linear sRGB of an equal-energy spectrum"}}};
    for (const Known& one : all)
        if (std::abs(scale / one.scale - 1.0) < 0.005) return one.who;
    return {};
}

/// What share S0 of B is of ours.
std::string about_scale(const ConventionVerdict& verdict) {
    if (verdict.gamma && std::abs(*verdict.gamma - 1.0) > 0.05)
        return fmt::format(" S0 of B is not linear: it goes as ours to the power {:.3g}{}.", *verdict.gamma,
                           std::abs(*verdict.gamma - 0.45) < 0.05 ? ", as in a gamma-encoded picture" : "");
    std::string text;
    const double scale = verdict.fit.scale;
    if (std::abs(scale - 1.0) > 0.005) {
        const std::string_view who = known_scale(scale);
        text = fmt::format(" B is {:.4g} times as bright{}{}.", scale, who.empty() ? "" : ": ", who);
    }
    const bool has_match = verdict.finding == Finding::same_convention || verdict.finding == Finding::explained;
    if (has_match && std::abs(verdict.fit.dop_scale - 1.0) > 0.05)
        text += fmt::format(" Its degree of polarization is {:.3g} times ours.", verdict.fit.dop_scale);
    return text;
}

std::string about_light(const ConventionVerdict& verdict) {
    if (!verdict.clip) return about_scale(verdict);
    return fmt::format(" S0 of B is clipped at {:.4g} in {:.2g} % of the pixels, which are left out here.",
                       verdict.clip->at, 100.0 * verdict.clip->share) +
           about_scale(verdict);
}

std::string about_ties(const ConventionVerdict& verdict) {
    std::vector<std::string> others;
    for (const Geometry one : verdict.tied)
        if (one != verdict.fit.geometry) others.emplace_back(name_of(one));
    if (others.empty()) return {};
    return fmt::format(" The scene is symmetric: {} would fit as well.", join(others, ", "));
}

std::string disagreement(const ConventionVerdict& verdict) {
    StokesComponents wrong;
    std::vector<std::string> numbers;
    for (unsigned i = 1; i < 4; ++i) {
        if (!verdict.judged.has(i)) continue;
        numbers.push_back(fmt::format("S{} {:.2f}", i, verdict.fit.correlation[i - 1]));
        if (!verdict.fit.decides(i - 1) || !(verdict.fit.correlation[i - 1] > 0.9)) wrong = wrong.with(i);
    }
    return fmt::format(
        "No convention explains the difference in {}: the renderers disagree (correlations {}); look at the map.",
        list_of(wrong), join(numbers, ", "));
}

}  // namespace

const std::array<SignChange, 8>& sign_changes() {
    static constexpr std::array<SignChange, 8> all{
        {{{1, 1, 1}, "the same convention", "it is as ours"},
         {{1, 1, -1}, "the other handedness", "it uses the source's view, or the handedness of radio and IEEE"},
         {{1, -1, -1}, "y down", "its y axis points down, or its frame is seen from behind"},
         {{-1, -1, 1}, "azimuth from the vertical", "its azimuth counts from the vertical, p and s exchanged"},
         {{-1, -1, -1},
          "azimuth from the vertical and the other handedness",
          "its azimuth counts from the vertical and its handedness is the other one, as IAU on a picture of the sky"},
         {{1, -1, 1}, "S2 alone", "its polarizer angles count clockwise, as theta of Mitsuba's polarizer"},
         {{-1, 1, 1}, "S1 alone", "rarely a convention; are the files at 0 and 90 degrees exchanged?"},
         {{-1, 1, -1}, "S1 and S3", "rarely a convention; are the files at 0 and 90 degrees exchanged?"}}};
    return all;
}

std::vector<SignChange> fitting_sign_changes(const ConventionVerdict& verdict) {
    const ConventionFit& fit = verdict.fit;
    std::vector<SignChange> fitting;
    if (fit.frame != FrameChange::signs || fit.order != std::array<int, 3>{1, 2, 3}) return fitting;
    for (const SignChange& change : sign_changes()) {
        bool fits = true;
        for (std::size_t i = 0; i < 3; ++i) fits = fits && (!fit.decides(i) || change.signs[i] == fit.signs[i]);
        if (fits) fitting.push_back(change);
    }
    return fitting;
}

std::string sentence(const ConventionVerdict& verdict, const StokesConvention& current) {
    const std::string light = about_light(verdict);
    switch (verdict.finding) {
        case Finding::nothing_in_common:
            return "The pictures have nothing in common that could be compared: fewer than 8 places where both have "
                   "light.";
        case Finding::another_picture:
            return fmt::format("These are not pictures of the same view: the correlation of S0 is {:.2f}.",
                               verdict.s0_correlation);
        case Finding::not_measured:
            return "No polarization is measured in both: only S0 can be compared." + light;
        case Finding::unpolarized:
            return "Neither picture is polarized above its noise: there is no convention to compare." + light +
                   about_unmeasured(verdict);
        case Finding::one_unpolarized:
            return "Only one of the pictures is polarized: the other one's renderer loses polarization." + light;
        case Finding::disagree:
            return disagreement(verdict) + light;
        case Finding::same_convention:
            return fmt::format("Both have the same convention; the pictures {}.", agreement(verdict.difference)) +
                   about_undecided(verdict) + about_unmeasured(verdict) + light + about_ties(verdict);
        case Finding::explained:
            break;
    }
    std::string text = fmt::format("B {}; with that the pictures {}.", join(changes_of(verdict), "; and it "),
                                   agreement(verdict.difference));
    if (verdict.coding != Coding::plain)
        text += fmt::format(" Take s = {} of each number b first.",
                            verdict.coding == Coding::offset ? "2 b - 1" : "(2 b - 1) S0");
    if (const auto wanted = adoptable(verdict, current))
        text += fmt::format(" Set {} for B?", what_to_set(*wanted, current));
    return text + about_undecided(verdict) + about_unmeasured(verdict) + light + about_ties(verdict);
}

}  // namespace pol::compare
