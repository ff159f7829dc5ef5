// SPDX-License-Identifier: Apache-2.0
#include "cli/compare_report.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/messages.h"
#include "core/join.h"

namespace pol {
namespace {

using compare::Agreement;
using compare::ComponentSignificance;
using compare::ConventionFit;
using compare::WorstPixel;
using nlohmann::ordered_json;

constexpr std::array<unsigned, 3> polarized{1, 2, 3};

// Text.

std::string text_of(const std::string& letter, const ComparedPicture& picture) {
    std::string text =
        fmt::format("{}: {}, {} x {} pixels", letter, printable(picture.name), picture.width, picture.height);
    if (picture.left != 0 || picture.top != 0) text += fmt::format(" from {},{} on", picture.left, picture.top);
    const std::string bands = picture.bands.size() > 8 ? fmt::format("{} to {} ({} bands)", picture.bands.front(),
                                                                     picture.bands.back(), picture.bands.size())
                                                       : join(picture.bands, ", ");
    text += fmt::format("; {}\n", printable(bands));
    if (!picture.origin.layout.empty()) text += fmt::format("   {}\n", printable(picture.origin.layout));
    text += fmt::format("   {}\n", picture.origin.convention.text());
    for (const std::string& one : picture.origin.assumed) text += fmt::format("   assumed: {}\n", printable(one));
    for (const std::string& one : picture.origin.remarks) text += fmt::format("   note: {}\n", printable(one));
    return text;
}

std::string evidence(const compare::ConventionVerdict& verdict) {
    std::vector<std::string> parts;
    for (const unsigned i : polarized)
        if (verdict.judged.has(i))
            parts.push_back(
                fmt::format("S{} {:.4f} (z {:.0f})", i, verdict.fit.correlation[i - 1], verdict.fit.z[i - 1]));
    return fmt::format("Correlations in {} boxes: S0 {:.4f}{}{}.\n", verdict.boxes, verdict.s0_correlation,
                       parts.empty() ? "" : ", ", join(parts, ", "));
}

std::string metrics_table(const ErrorMetrics& metrics, const ErrorMetrics* with_adoptable) {
    std::string text = fmt::format("{:<14}{:>12}{:>12}{:>12}{}\n", "B against A", "whole", "99 %", "largest",
                                   with_adoptable != nullptr ? "   whole, with that convention" : "");
    for (const NamedMetric& named : named_metrics) {
        const Metric& metric = metrics.*named.metric;
        if (!metric.is_measured()) continue;
        text += fmt::format("{:<14}{:>12.4g}{:>12.4g}{:>12.4g}", named.name, metric.whole, metric.p99, metric.largest);
        if (with_adoptable != nullptr) text += fmt::format("{:>12.4g}", (with_adoptable->*named.metric).whole);
        text += named.unit.empty() ? "\n" : fmt::format("  {}\n", named.unit);
    }
    return text;
}

std::string significance_text(const compare::Significance& significance) {
    std::string text = fmt::format("Against the error bars of {}:\n", significance.a_has_bars && significance.b_has_bars
                                                                          ? "both pictures"
                                                                      : significance.a_has_bars ? "A; B has none"
                                                                                                : "B; A has none");
    for (unsigned i = 0; i < 4; ++i) {
        const auto& found = significance.components[i];
        if (!found) continue;
        text += fmt::format(
            "S{}: differs by up to {:.1f} standard errors; {} of {} values by more than {:.0f} (by chance at most "
            "about "
            "{:.0f}); root mean square {:.3g} of what the bars tell (by chance at most {:.3g}): {}\n",
            i, found->largest, found->beyond, found->values, compare::significant_t, found->beyond_by_chance,
            found->ratio, found->largest_ratio, found->is_chance() ? "chance" : "no chance");
        if (found->unbarred > 0)
            text += fmt::format("    {} values differ without a finite error bar\n", found->unbarred);
    }
    return text;
}

std::string worst_text(const ComparisonReport& report, const WorstPixel& worst) {
    const auto light = [](const Stokes<double>& s) {
        return fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}", s.s0, s.s1, s.s2, s.s3);
    };
    return fmt::format("Worst pixel {},{} at {}: A {}; B {}\n", report.left + worst.x * report.box,
                       report.top + worst.y * report.box, printable(report.compared_bands[worst.band]), light(worst.a),
                       light(worst.b));
}

/// Why noise is a difference, if it is.
std::string about_noise(const std::optional<compare::Significance>& significance) {
    if (!significance) return "Neither picture has error bars: their noise is a difference";
    if (!significance->b_has_bars) return "B has no error bars: its noise is a difference";
    if (!significance->a_has_bars) return "A has no error bars: its noise is a difference";
    return {};
}

std::string agreement_text(const ComparisonReport& report) {
    const Agreement& agreement = report.distance->agreement;
    const std::string alone = report.verdict.judged == StokesComponents() ? " in S0, which both know" : "";
    if (report.is_same()) {
        if (agreement.identical == agreement.values)
            return fmt::format("SAME{}: all {} numbers are equal.\n", alone, agreement.values);
        if (agreement.beyond_rounding == 0)
            return fmt::format("SAME{}: all {} numbers, {} of them within rounding and untraced light.\n", alone,
                               agreement.values, agreement.values - agreement.identical);
        return fmt::format("SAME{}: all differences are chance by the error bars.\n", alone);
    }
    if (agreement.not_finite > 0)
        return fmt::format("DIFFERENT: {} of {} numbers are finite in one picture only, {} others differ.\n",
                           agreement.not_finite, agreement.values, agreement.beyond_rounding);
    const std::string apart = fmt::format("{:.2g} % of the light", 100.0 * agreement.distance);
    if (report.is_within_tolerance())
        return fmt::format("WITHIN TOLERANCE{}: they are apart by {}, {:.6g} % is allowed.\n", alone, apart,
                           100.0 * *report.tolerance);
    std::string text =
        fmt::format("DIFFERENT{}: by {}; {} of {} numbers differ by more than rounding and untraced light.\n", alone,
                    apart, agreement.beyond_rounding, agreement.values);
    if (report.tolerance)
        return text + fmt::format("    {:.6g} % is allowed{}.\n", 100.0 * *report.tolerance,
                                  report.has_our_convention() ? "" : ", but not what the sentence above says");
    if (const std::string noise = about_noise(agreement.significance); !noise.empty())
        text += fmt::format("    {}. --tolerance says how much is allowed.\n", noise);
    return text;
}

// JSON.

ordered_json json_of(const StokesConvention& convention) {
    return {{"handedness", convention.left_handed ? "left" : "right"},
            {"y", convention.y_down ? "down" : "up"},
            {"azimuth_zero_deg", convention.azimuth_zero_deg}};
}

ordered_json json_of(const ComparedPicture& picture) {
    return {{"file", picture.name},
            {"width", picture.width},
            {"height", picture.height},
            {"first_pixel", {picture.left, picture.top}},
            {"bands", picture.bands},
            {"layout", picture.origin.layout},
            {"convention", json_of(picture.origin.convention)},
            {"assumed", picture.origin.assumed},
            {"remarks", picture.origin.remarks}};
}

ordered_json json_of(const compare::ConventionVerdict& verdict, const StokesConvention& current) {
    const ConventionFit& fit = verdict.fit;
    ordered_json out{{"verdict", compare::name_of(verdict.finding)},
                     {"sentence", compare::sentence(verdict, current)},
                     {"kind", compare::name_of(fit.frame)},
                     {"geometry", compare::name_of(fit.geometry)},
                     {"order", fit.order},
                     {"signs", fit.signs}};
    out["turn_deg"] = fit.turn_deg ? ordered_json(*fit.turn_deg) : ordered_json();
    out["scale"] = fit.scale;
    out["degree_of_polarization_scale"] = fit.dop_scale;
    out["gamma"] = verdict.gamma ? ordered_json(*verdict.gamma) : ordered_json();
    out["stored_as"] = compare::name_of(verdict.coding);
    out["clipped"] =
        verdict.clip ? ordered_json{{"at", verdict.clip->at}, {"share", verdict.clip->share}} : ordered_json();
    out["s0_correlation"] = verdict.s0_correlation;
    out["difference"] = verdict.difference;
    out["boxes"] = verdict.boxes;
    out["judged"] = ordered_json::array();
    out["undecided"] = ordered_json::array();
    for (const unsigned i : polarized) {
        const std::string name = fmt::format("S{}", i);
        if (!verdict.judged.has(i)) continue;
        out["judged"].push_back(name);
        if (verdict.undecided.has(i)) out["undecided"].push_back(name);
        out["correlation"][name] = fit.correlation[i - 1];
        out["z"][name] = fit.z[i - 1];
    }
    out["fitting"] = ordered_json::array();
    for (const compare::SignChange& change : compare::fitting_sign_changes(verdict))
        out["fitting"].push_back(change.name);
    out["geometries_tied"] = ordered_json::array();
    for (const compare::Geometry one : verdict.tied) out["geometries_tied"].push_back(compare::name_of(one));
    return out;
}

ordered_json json_of(const ErrorMetrics& metrics) {
    ordered_json out = ordered_json::object();
    for (const NamedMetric& named : named_metrics) {
        const Metric& metric = metrics.*named.metric;
        if (!metric.is_measured()) continue;
        out[std::string(named.name)] = {{"whole", metric.whole}, {"p99", metric.p99}, {"largest", metric.largest}};
    }
    out["not_finite"] = metrics.nan_count;
    return out;
}

ordered_json json_of(const ComparisonReport& report, const Agreement& agreement) {
    ordered_json out{{"numbers", agreement.values},
                     {"equal", agreement.identical},
                     {"beyond_rounding", agreement.beyond_rounding},
                     {"not_finite", agreement.not_finite},
                     {"distance", agreement.distance}};
    if (agreement.significance) {
        ordered_json bars{{"of_a", agreement.significance->a_has_bars}, {"of_b", agreement.significance->b_has_bars}};
        for (unsigned i = 0; i < 4; ++i) {
            const auto& found = agreement.significance->components[i];
            if (!found) continue;
            bars[fmt::format("S{}", i)] = {
                {"values", found->values},        {"largest", found->largest},
                {"beyond_3", found->beyond},      {"beyond_3_by_chance", found->beyond_by_chance},
                {"ratio", found->ratio},          {"ratio_by_chance", found->largest_ratio},
                {"without_bar", found->unbarred}, {"chance", found->is_chance()}};
        }
        out["error_bars"] = bars;
    }
    if (const auto& worst = agreement.worst) {
        const auto light = [](const Stokes<double>& s) { return ordered_json{s.s0, s.s1, s.s2, s.s3}; };
        out["worst"] = {{"pixel", {report.left + worst->x * report.box, report.top + worst->y * report.box}},
                        {"band", report.compared_bands[worst->band]},
                        {"distance", worst->distance},
                        {"a", light(worst->a)},
                        {"b", light(worst->b)}};
    }
    return out;
}

/// The options that make other commands read B so.
std::string options_text(const StokesConvention& convention) {
    std::string text = fmt::format("--from-handedness {} --from-y {}", convention.left_handed ? "left" : "right",
                                   convention.y_down ? "down" : "up");
    if (convention.azimuth_zero_deg == 0.0) return text + " --from-zero right";
    if (convention.azimuth_zero_deg == 90.0) return text + " --from-zero up";
    return {};
}

}  // namespace

bool ComparisonReport::has_our_convention() const {
    switch (verdict.finding) {
        case compare::Finding::same_convention:
        case compare::Finding::unpolarized:
        case compare::Finding::not_measured:
        case compare::Finding::nothing_in_common:
            return true;
        case compare::Finding::explained:
            return adopted;
        case compare::Finding::disagree:
        case compare::Finding::another_picture:
        case compare::Finding::one_unpolarized:
            return false;
    }
    return false;
}

bool ComparisonReport::is_within_tolerance() const {
    return distance && tolerance && distance->agreement.not_finite == 0 && distance->agreement.values > 0 &&
           distance->agreement.distance <= *tolerance && has_our_convention();
}

std::string comparison_text(const ComparisonReport& report) {
    std::string text = text_of("A", report.a) + text_of("B", report.b);
    for (const std::string& one : report.remarks) text += fmt::format("note: {}\n", printable(one));
    text += fmt::format("\n{}\n", compare::sentence(report.verdict, report.b.origin.convention));
    text += evidence(report.verdict);
    if (report.adopted && report.adoptable) {
        text += fmt::format("Adopted for B: {}.\n", report.adoptable->text());
        if (const std::string options = options_text(*report.adoptable); !options.empty())
            text += fmt::format("Other commands read it so with {}\n", options);
    }
    if (!report.distance) return text + "\nDIFFERENT: one lies across the other, nothing can be subtracted.\n";
    const Distance& distance = *report.distance;
    text += "\n" + metrics_table(distance.metrics, report.with_adoptable ? &*report.with_adoptable : nullptr);
    if (distance.metrics.nan_count > 0)
        text +=
            fmt::format("{} Stokes vectors are not finite in one of them and left out.\n", distance.metrics.nan_count);
    if (distance.agreement.significance) text += "\n" + significance_text(*distance.agreement.significance);
    text += "\n";
    if (distance.agreement.worst && distance.agreement.worst->distance > 0.0)
        text += worst_text(report, *distance.agreement.worst);
    return text + agreement_text(report);
}

std::string comparison_json(const ComparisonReport& report) {
    ordered_json out{{"a", json_of(report.a)},
                     {"b", json_of(report.b)},
                     {"remarks", report.remarks},
                     {"doctor", json_of(report.verdict, report.b.origin.convention)}};
    out["adoptable"] = report.adoptable ? json_of(*report.adoptable) : ordered_json();
    out["adopted"] = report.adopted && report.adoptable;
    out["bands"] = report.compared_bands;
    if (report.distance) {
        out["metrics"] = json_of(report.distance->metrics);
        if (report.with_adoptable) out["metrics_with_adoptable"] = json_of(*report.with_adoptable);
        out["numbers"] = json_of(report, report.distance->agreement);
    }
    out["same"] = report.is_same();
    if (report.tolerance) {
        out["tolerance"] = *report.tolerance;
        out["within_tolerance"] = report.is_within_tolerance();
    }
    return out.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace pol
