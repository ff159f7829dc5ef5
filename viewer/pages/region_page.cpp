// SPDX-License-Identifier: Apache-2.0
#include "viewer/pages/region_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "compare/error_metrics.h"
#include "compare/pairing.h"
#include "viewer/pages/readout_text.h"
#include "viewer/shown/region_statistics.h"

namespace pol {

namespace {

constexpr int digits = 6;

PageRow number_row(std::string name, double value, std::string_view unit, std::string_view help) {
    if (!std::isfinite(value)) return {std::move(name), std::isnan(value) ? "not a number" : "infinite", {}, {}, help};
    const std::string behind = unit.empty() ? "" : fmt::format(" {}", unit);
    return {std::move(name), short_number(value, digits) + behind, {}, fmt::format("{:.17g}{}", value, behind), help};
}

/// A component's mean, and how much it varies.
PageRow component_row(std::string name, double mean, double deviation, bool is_known) {
    constexpr std::string_view help = "Mean over the region; behind it the standard deviation from pixel to pixel";
    if (!is_known) return {std::move(name), std::string(state_text(PixelState::not_measured)), {}, {}, help};
    PageRow row = number_row(std::move(name), mean, "", help);
    row.bar = "std. dev. " + short_number(deviation, 3);
    row.exact_bar = fmt::format("std. dev. {:.17g}", deviation);
    return row;
}

PageGroup light_of(const Session& session, const TileRect& region) {
    const ShownPicture shown = session.shown_picture();
    const std::size_t band = session.view().band;
    const RegionStatistics found = region_statistics(shown, band, region);
    PageGroup group{"Mean light, " + band_text(shown.picture().bands[band]), {}};
    group.rows.push_back({"pixels",
                          fmt::format("{}", found.count),
                          {},
                          fmt::format("{}", found.count),
                          "That count: their numbers are finite, and they have a sample"});
    if (found.left_out > 0)
        group.rows.push_back({"left out",
                              fmt::format("{}", found.left_out),
                              {},
                              fmt::format("{}", found.left_out),
                              "Without a sample yet, or with a number that is not finite"});
    if (found.count == 0) return group;
    const Stokes<double>& s = found.mean.stokes;
    const Stokes<double>& d = found.deviation;
    group.rows.push_back(component_row("S0", s.s0, d.s0, found.mean.known.has(0)));
    group.rows.push_back(component_row("S1", s.s1, d.s1, found.mean.known.has(1)));
    group.rows.push_back(component_row("S2", s.s2, d.s2, found.mean.known.has(2)));
    group.rows.push_back(component_row("S3", s.s3, d.s3, found.mean.known.has(3)));
    for (const QuantityInfo& about : quantities()) {
        if (about.group != MapGroup::polarization) continue;
        const QuantityReadout readout = read_light(found.mean, about.quantity, 1.0);
        PageRow row{std::string(about.row_name),
                    readout_text(about.quantity, readout),
                    {},
                    {},
                    "Of the mean light: maps of pixels do not average"};
        if (readout.pixel.state == PixelState::defined) row.exact = fmt::format("{:.17g}", readout.pixel.value);
        group.rows.push_back(std::move(row));
    }
    return group;
}

std::string_view help_of_metric(std::string_view name) {
    if (name == "fro_c") return "Root mean square difference of the coherence matrices, over that of the reference's";
    if (name == "rel_rmse_s0") return "Root mean square difference of S0, over that of the reference's";
    if (name == "mrse_s0") return "Mean of the squared relative differences of S0, pbrt's MRSE";
    if (name == "analyzer_inf") return "Largest difference of any intensity behind any polarizer";
    if (name == "dop_w") return "Root mean square difference of the degree of polarization, weighed by S0";
    if (name == "azimuth_w") return "Root mean square angle between the azimuths, weighed by the linear part";
    if (name == "ellip_w")
        return "Root mean square difference of the ellipticity angles, weighed by the polarized part";
    return "Root mean square of half the angle on the Poincar\u00e9 sphere, weighed by the polarized part";
}

/// The region as far as both pictures have it.
std::optional<TileRect> in_both(const TileRect& region, const compare::Area& area) {
    const TileRect shared{area.x, area.y, area.x + area.width, area.y + area.height};
    const TileRect both{std::max(region.x0, shared.x0), std::max(region.y0, shared.y0), std::min(region.x1, shared.x1),
                        std::min(region.y1, shared.y1)};
    if (both.x0 >= both.x1 || both.y0 >= both.y1) return std::nullopt;
    return both;
}

void add_metrics(const Session& session, const TileRect& region, RegionPage& page) {
    const auto comparison = session.compare();
    if (!comparison) {
        page.why_not = comparison.error().what + "; " + comparison.error().hint;
        return;
    }
    const StokesImage& a = session.current()->picture();
    const StokesImage& b = comparison.value().reference->picture();
    // Session::compare() has found one.
    const compare::SharedArea shared = *compare::shared_area(a, b);
    const auto both = in_both(region, shared.in_a);
    if (!both) {
        page.why_not = "the reference has none of these pixels";
        return;
    }
    const int by_x = shared.in_b.x - shared.in_a.x;
    const int by_y = shared.in_b.y - shared.in_a.y;
    const TileRect there{both->x0 + by_x, both->y0 + by_y, both->x1 + by_x, both->y1 + by_y};
    const ErrorMetrics found =
        error_metrics(cut_out(a, session.view().band, *both), cut_out(b, comparison.value().band, there));
    page.metrics.title = "Against " + comparison.value().reference->name();
    page.metrics.rows.push_back({"pixels",
                                 fmt::format("{}", both->pixel_count()),
                                 {},
                                 fmt::format("{}", both->pixel_count()),
                                 "Of the region, that the reference has, too"});
    for (const auto& named : named_metrics) {
        const Metric& metric = found.*named.metric;
        PageRow row = number_row(std::string(named.name), metric.whole, named.unit, help_of_metric(named.name));
        row.bar = "largest " + short_number(metric.largest, 3);
        page.metrics.rows.push_back(std::move(row));
    }
    if (found.nan_count > 0)
        page.metrics.rows.push_back({"not finite",
                                     fmt::format("{}", found.nan_count),
                                     {},
                                     fmt::format("{}", found.nan_count),
                                     "Pixels that are left out"});
}

}  // namespace

bool operator==(const RegionPageKey& a, const RegionPageKey& b) {
    const auto rest = [](const RegionPageKey& k) {
        return std::tie(k.layout, k.version, k.band, k.polarimeter, k.convention, k.reference, k.reference_layout,
                        k.reference_version);
    };
    const auto corners = [](const TileRect& r) { return std::tie(r.x0, r.y0, r.x1, r.y1); };
    return corners(a.region) == corners(b.region) && rest(a) == rest(b);
}

RegionPageKey region_page_key(const Session& session) {
    RegionPageKey key{*session.selection().region,
                      session.current()->picture_layout(),
                      session.current()->picture_version(),
                      session.view().band,
                      session.polarimeter(),
                      session.view().convention,
                      session.reference()};
    if (key.reference != nullptr) {
        key.reference_layout = key.reference->picture_layout();
        key.reference_version = key.reference->picture_version();
    }
    return key;
}

RegionPage make_region_page(const Session& session) {
    const TileRect& region = *session.selection().region;
    const StokesImage& picture = session.current()->picture();
    RegionPage page;
    page.title = fmt::format("{} x {} pixels from {},{}", region.x1 - region.x0, region.y1 - region.y0,
                             picture.left + region.x0, picture.top + region.y0);
    page.light = light_of(session, region);
    add_metrics(session, region, page);
    return page;
}

std::string text_of(const RegionPage& page) {
    std::string text = page.title + "\n";
    for (const PageGroup* group : {&page.light, &page.metrics}) {
        if (group->rows.empty()) continue;
        text += group->title + "\n";
        for (const PageRow& row : group->rows) {
            text += row.name + " " + (row.exact.empty() ? row.value : row.exact);
            text += row.exact_bar.empty() ? "\n" : " " + row.exact_bar + "\n";
        }
    }
    return page.why_not.empty() ? text : text + page.why_not + "\n";
}

}  // namespace pol
