// SPDX-License-Identifier: Apache-2.0
#include "verify/convergence/convergence_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/number_text.h"

namespace pol::verify {

namespace {

/// What was turned in this row, in words.
std::string setting_of(const RunRow& row) {
    const auto whole = [](double value) { return number_text(value); };
    std::string text;
    if (!std::isnan(row.depth_limit))
        text = "depth " + whole(row.depth_limit);
    else if (row.series == "branches")
        text = whole(row.node_budget) + " branches";
    else if (row.series == "wavelengths")
        text = whole(row.wavelengths) + " wavelengths";
    else
        text = "residual " + number_text(row.residual_target);
    if (row.mode == "area")
        text += ", " + whole(row.samples_per_pixel) + (row.samples_per_pixel == 1.0 ? " sample" : " samples");
    return text;
}

/// Rows by series and setting, both in order of first appearance.
using Group = std::pair<std::string, std::vector<const RunRow*>>;
struct SeriesRows {
    std::string series;
    std::vector<Group> settings;
};

std::vector<SeriesRows> grouped(const std::vector<RunRow>& rows) {
    std::vector<SeriesRows> all;
    for (const RunRow& row : rows) {
        auto series = std::find_if(all.begin(), all.end(), [&](const SeriesRows& s) { return s.series == row.series; });
        if (series == all.end()) series = all.insert(all.end(), SeriesRows{row.series, {}});
        const std::string name = setting_of(row);
        auto group = std::find_if(series->settings.begin(), series->settings.end(),
                                  [&](const Group& g) { return g.first == name; });
        if (group == series->settings.end()) group = series->settings.insert(series->settings.end(), Group{name, {}});
        group->second.push_back(&row);
    }
    return all;
}

struct Spread {
    double low = not_measured;
    double middle = not_measured;
    double high = not_measured;
};

/// Smallest, median and largest of what was measured.
template <class Get>
Spread spread(const std::vector<const RunRow*>& rows, const Get& get) {
    std::vector<double> values;
    for (const RunRow* row : rows)
        if (!std::isnan(get(*row))) values.push_back(get(*row));
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    const double median = values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
    return {values.front(), median, values.back()};
}

double root_mean_square(const std::vector<const RunRow*>& rows, double RunRow::*member) {
    double sum = 0.0;
    int count = 0;
    for (const RunRow* row : rows) {
        if (std::isnan(row->*member)) continue;
        sum += row->*member * row->*member;
        ++count;
    }
    return count > 0 ? std::sqrt(sum / count) : not_measured;
}

CurvePoint point_of(const Group& group) {
    const std::vector<const RunRow*>& rows = group.second;
    CurvePoint point;
    point.setting = group.first;
    point.samples = rows.front()->samples_per_pixel;
    const Spread error = spread(rows, [](const RunRow& row) { return row.errors[0].whole; });
    point.error = error.middle;
    point.error_low = error.low;
    point.error_high = error.high;
    const Spread cpu = spread(rows, [](const RunRow& row) { return row.render_cpu_s; });
    point.cpu_s = cpu.middle;
    point.cpu_low = cpu.low;
    point.cpu_high = cpu.high;
    point.wall_s = spread(rows, [](const RunRow& row) { return row.render_wall_s; }).middle;
    point.bound = spread(rows, [](const RunRow& row) { return row.bound_fro; }).middle;
    point.seeds = static_cast<int>(rows.size());
    point.reference_error = rows.front()->reference_error;
    point.below_floor = !(point.error >= 3.0 * point.reference_error);
    return point;
}

std::optional<double> slope_of(const std::vector<CurvePoint>& points) {
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const CurvePoint& point : points) {
        if (point.below_floor || !(point.cpu_s > 0.0)) continue;
        const double log_time = std::log(point.cpu_s);
        const double log_error = std::log(point.error);
        n += 1.0;
        x += log_time;
        y += log_error;
        xx += log_time * log_time;
        xy += log_time * log_error;
    }
    const double spread_of_time = n * xx - x * x;
    if (n < 3.0 || !(spread_of_time > 0.0)) return std::nullopt;
    return (n * xy - x * y) / spread_of_time;
}

}  // namespace

std::optional<double> cost_of(const Curve& curve, double error) {
    std::optional<double> cost;
    const CurvePoint* before = nullptr;
    for (const CurvePoint& point : curve.points) {
        if (point.below_floor || !(point.cpu_s > 0.0)) continue;
        if (point.error > error) {
            cost.reset();
        } else if (before != nullptr && before->error > error) {
            const double share = std::log(before->error / error) / std::log(before->error / point.error);
            cost = before->cpu_s * std::pow(point.cpu_s / before->cpu_s, share);
        }
        before = &point;
    }
    return cost;
}

std::vector<Curve> curves(const std::vector<RunRow>& rows) {
    std::vector<Curve> result;
    for (const SeriesRows& series : grouped(rows)) {
        Curve curve;
        curve.series = series.series;
        for (const Group& group : series.settings) curve.points.push_back(point_of(group));
        std::sort(curve.points.begin(), curve.points.end(),
                  [](const CurvePoint& a, const CurvePoint& b) { return a.cpu_s < b.cpu_s; });
        curve.slope = slope_of(curve.points);
        result.push_back(std::move(curve));
    }
    return result;
}

std::vector<Cheapest> cheapest(const std::vector<Curve>& curves, const std::vector<double>& errors) {
    std::vector<Cheapest> result;
    for (const double error : errors) {
        Cheapest best;
        best.error = error;
        for (const Curve& curve : curves) {
            for (const CurvePoint& point : curve.points) {
                if (!(point.error + point.reference_error <= error) || (best.point && best.point->cpu_s <= point.cpu_s))
                    continue;
                best.point = point;
                best.series = curve.series;
            }
        }
        result.push_back(std::move(best));
    }
    return result;
}

std::vector<ErrorBudget> error_budgets(const std::vector<RunRow>& rows) {
    std::vector<ErrorBudget> result;
    for (const SeriesRows& series : grouped(rows)) {
        for (const Group& group : series.settings) {
            ErrorBudget budget;
            budget.series = series.series;
            budget.setting = group.first;
            budget.truncation = spread(group.second, [](const RunRow& row) { return row.truncation; }).middle;
            budget.truncation_bound = spread(group.second, [](const RunRow& row) { return row.bound_fro; }).middle;
            budget.sampling = root_mean_square(group.second, &RunRow::sampling);
            budget.spectral = spread(group.second, [](const RunRow& row) { return row.spectral; }).middle;
            budget.floating_point = spread(group.second, [](const RunRow& row) { return row.floating_point; }).middle;
            result.push_back(std::move(budget));
        }
    }
    return result;
}

std::string text_about_reference(const ConvergenceResult& result) {
    if (!result.reference_check) return fmt::format("its own error {:.1e}", result.reference_error);
    const ReferenceCheck& check = *result.reference_check;
    if (!check.contradicts())
        return fmt::format(
            "its own error is not known, but it agrees with our own deepest picture: {:.1e} apart, {:.1e} allowed",
            check.difference, check.allowed);
    return fmt::format(
        "it is WRONG, or of another scene: {:.1e} from our own deepest picture, {:.1e} allowed{}; "
        "at least {:.1e} of every error is its own",
        check.difference, check.allowed,
        check.covered < 1.0 ? fmt::format(", outside the bounds in {:.2f} % of the pixels",
                                          std::ceil(1e4 * (1.0 - check.covered)) / 100.0)
                            : "",
        result.reference_error);
}

bool bounds_hold(const ConvergenceResult& result) {
    return worst_bound_coverage(result.rows) == 1.0 &&
           !(result.reference_check && result.reference_check->contradicts());
}

std::string text_about_bounds(const ConvergenceResult& result) {
    const double coverage = worst_bound_coverage(result.rows);
    if (std::isnan(coverage)) return "bounds were not measured";
    return fmt::format("bounds hold in {:.2f} % of the pixels", std::floor(1e4 * coverage) / 100.0);
}

double worst_bound_coverage(const std::vector<RunRow>& rows) {
    double worst = not_measured;
    for (const RunRow& row : rows)
        if (!std::isnan(row.bound_cover) && !(row.bound_cover >= worst)) worst = row.bound_cover;
    return worst;
}

}  // namespace pol::verify
