// SPDX-License-Identifier: Apache-2.0
#include "verify/degenerate/degenerate_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "report/html_page.h"

namespace pol::verify {

namespace {

const char* explanation =
    "<p>Every case drives one knob towards a point where formulas degenerate. <b>Error</b>: largest deviation of the "
    "program's results from the same results with 113 bits, or from a closed form. <b>Condition</b>: how far these "
    "results move, with 113 bits, when the inputs move by one ulp, and one ulp of the result: what no program in "
    "doubles "
    "can avoid. <b>Limit</b>: as many times the condition as there are rounded operations on the longest way from an "
    "input to a result, counted by running the formulas over numbers that count, times a loss where the case says one. "
    "A "
    "case is sound if error / condition stays below its limit at every setting and every number is finite. A case of "
    "two "
    "knobs shows the worst setting of the second at each of the first. Hollow markers on an edge are zeros.</p>\n";

/// Of both knobs, where there are two.
std::string settings_text(const DegenerateCase& of) {
    if (of.second_knob.empty()) return range_text(of);
    return fmt::format("{}; {}: {:.4g} .. {:.4g}, 0", range_text(of), xml_text(of.second_knob),
                       of.second_settings.front(), of.second_settings[of.second_settings.size() - 2]);
}

}  // namespace

std::string range_text(const DegenerateCase& degenerate_case) {
    const std::vector<double>& all = degenerate_case.settings;
    const bool ends_at_zero = all.back() == 0.0 && all.size() > 1;
    std::string text = fmt::format("{:.4g} .. {:.4g}", all.front(), ends_at_zero ? all[all.size() - 2] : all.back());
    return ends_at_zero ? text + ", 0" : text;
}

Plot degenerate_plot(const DegenerateResult& result) {
    const DegenerateCase& of = *result.of;
    Plot plot;
    plot.title = of.name;
    plot.subtitle = of.sentence;
    double low = std::numeric_limits<double>::infinity();
    double high = 0.0;
    for (const double setting : of.settings) {
        if (setting > 0.0) low = std::min(low, setting);
        high = std::max(high, setting);
    }
    // Settings of one order of magnitude, or zero among the first, read better on a linear axis.
    const bool linear = high < 100.0 * low || of.settings.front() == 0.0;
    const bool falling = of.settings.front() > of.settings[1];
    plot.x = {of.knob, linear ? AxisScale::linear : AxisScale::logarithmic, low, high, falling};
    if (of.settings.front() == 0.0) plot.x.low = 0.0;
    plot.y = {"error", AxisScale::logarithmic, {}, {}, false};
    PlotSeries error{"error", {}, 0, PlotMarker::circle, true, false};
    PlotSeries condition{"condition (one ulp of the inputs)", {}, 1, PlotMarker::none, true, false};
    PlotSeries limit{"limit", {}, 2, PlotMarker::none, true, true};
    double lowest = 1e-17;
    for (const DegeneratePoint& point : result.points) {
        const Finding& found = point.finding;
        error.points.emplace_back(point.setting, found.error);
        condition.points.emplace_back(point.setting, found.condition);
        limit.points.emplace_back(point.setting, point.limit * found.condition);
        if (found.error > 0.0) lowest = std::min(lowest, found.error);
    }
    plot.y.low = std::pow(10.0, std::floor(std::log10(lowest)));
    plot.series = {limit, condition, error};
    return plot;
}

std::string degenerate_section(const std::vector<DegenerateResult>& results) {
    const auto sound = static_cast<std::size_t>(
        std::count_if(results.begin(), results.end(), [](const DegenerateResult& r) { return r.sound; }));
    std::size_t points = 0;
    for (const DegenerateResult& r : results) points += r.points.size();
    std::string page = fmt::format("<p>{} of {} cases are sound, at {} settings.</p>\n", sound, results.size(), points);
    page += explanation;
    page +=
        "<table><tr><th>group</th><th>case</th><th>knob</th><th>worst error</th><th>condition there</th>"
        "<th>worst error / condition</th><th>limit</th><th>verdict</th></tr>\n";
    for (const DegenerateResult& r : results) {
        page += fmt::format(
            "<tr><td>{}</td><td><a href=\"#{}\">{}</a></td><td>{}: {}</td><td class=\"n\">{:.1e}</td>"
            "<td class=\"n\">{:.1e}</td><td class=\"n\">{:.2g}</td><td class=\"n\">{:g}</td><td{}>{}</td></tr>\n",
            r.of->group, r.of->name, r.of->name, xml_text(r.of->knob), settings_text(*r.of), r.worst.finding.error,
            r.worst.finding.condition, r.ratio, r.limit, r.sound ? "" : " class=\"bad\"",
            r.sound ? "sound" : "UNSOUND");
    }
    page += "</table>\n<h3>Cases without a sweep</h3>\n<ul>\n";
    for (const UntestedCase& one : untested_cases())
        page += fmt::format("<li>{}: {}</li>\n", xml_text(one.subject), xml_text(one.why));
    page += "</ul>\n<h3>Error towards the singular points</h3>\n<div class=\"plots\">\n";
    for (const DegenerateResult& r : results)
        page += fmt::format(
            "<figure id=\"{}\">\n{}<figcaption class=\"soft\">Group {}. Compared: {}. Reference: "
            "{}.</figcaption></figure>\n",
            r.of->name, plot_svg(degenerate_plot(r)), r.of->group, xml_text(r.of->results), xml_text(r.of->reference));
    return page + "</div>\n";
}

std::string degenerate_page(const std::vector<DegenerateResult>& results) {
    return html_page("Numbers near singular points", degenerate_section(results));
}

}  // namespace pol::verify
