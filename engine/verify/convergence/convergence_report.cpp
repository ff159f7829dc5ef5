// SPDX-License-Identifier: Apache-2.0
#include "verify/convergence/convergence_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/result.h"
#include "io/pictures/exr_file.h"
#include "maps/color_picture.h"
#include "maps/color_scale.h"
#include "plan/compile.h"
#include "polarization/coherence_matrix.h"
#include "render/render_to_end.h"
#include "report/html_page.h"
#include "verify/convergence/convergence_summary.h"

namespace pol::verify {

namespace {

std::string number(double value) {
    return std::isnan(value) ? "" : fmt::format("{:.2e}", value);
}

std::string row_of(const std::vector<std::string>& cells, const char* cell = "td") {
    std::string out = "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i)
        out += fmt::format("<{0}{1}>{2}</{0}>", cell, i == 0 ? "" : " class=\"n\"", cells[i]);
    return out + "</tr>\n";
}

/// Straight line across the plot at the height of the reference's own error.
PlotSeries floor_line(const std::vector<Curve>& all, double error) {
    PlotSeries line{"error of the reference", {}, 5, PlotMarker::none, true, true};
    double first = INFINITY;
    double last = 0.0;
    for (const Curve& curve : all)
        for (const CurvePoint& point : curve.points) {
            first = std::min(first, point.cpu_s);
            last = std::max(last, point.cpu_s);
        }
    line.points = {{first, error}, {last, error}};
    return line;
}

Plot work_precision(const std::vector<Curve>& all, double reference_error) {
    Plot plot;
    plot.title = "Error against run time";
    plot.subtitle = "median over seeds, band from the smallest to the largest; lower left is better";
    plot.x = {"CPU time of the tracing, s", AxisScale::logarithmic};
    plot.y = {"error of the coherence matrix (fro_c)", AxisScale::logarithmic};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const int color = static_cast<int>(i % 5);
        PlotSeries series{all[i].series, {}, color, PlotMarker::circle, true, false};
        PlotBand band{"", {}, {}, {}, color};
        for (const CurvePoint& point : all[i].points) {
            if (point.below_floor) continue;
            series.points.emplace_back(point.cpu_s, point.error);
            band.x.push_back(point.cpu_s);
            band.low.push_back(point.error_low);
            band.high.push_back(point.error_high);
        }
        if (series.points.empty()) continue;
        plot.series.push_back(std::move(series));
        plot.bands.push_back(std::move(band));
    }
    plot.series.push_back(floor_line(all, reference_error));
    return plot;
}

/// The curve that is turned by the residual, or the one with most samples of it.
const Curve* truncation_curve(const std::vector<Curve>& all) {
    const Curve* best = nullptr;
    for (const Curve& curve : all)
        if (curve.series.rfind("residual", 0) == 0 || curve.series.rfind("samples", 0) == 0 ||
            (best == nullptr && curve.series == "branches"))
            best = &curve;
    return best;
}

Plot bound_and_truth(const Curve& curve, const std::vector<ErrorBudget>& budgets) {
    Plot plot;
    plot.title = "What is guaranteed, and what is true";
    plot.subtitle = "series: " + curve.series + ". The bound is rigorous and needs no reference";
    plot.x = {"CPU time of the tracing, s", AxisScale::logarithmic};
    plot.y = {"error of truncation (fro_c)", AxisScale::logarithmic};
    PlotSeries bound{"rigorous bound", {}, 1, PlotMarker::square, true, true};
    PlotSeries truth{"true error of truncation", {}, 0, PlotMarker::circle, true, false};
    for (const CurvePoint& point : curve.points) {
        const auto budget = std::find_if(budgets.begin(), budgets.end(), [&](const ErrorBudget& b) {
            return b.series == curve.series && b.setting == point.setting;
        });
        bound.points.emplace_back(point.cpu_s, point.bound);
        if (budget != budgets.end()) truth.points.emplace_back(point.cpu_s, budget->truncation);
    }
    plot.series = {bound, truth};
    return plot;
}

/// One render from its first tile on; a point below three times the reference's error says nothing.
Plot anytime(const ConvergenceResult& result) {
    Plot plot;
    plot.title = "One render as it grows";
    plot.subtitle = "at the scene's own settings; light of tiles that are not there yet counts as missing";
    plot.x = {"time of the tracing, s", AxisScale::logarithmic};
    plot.y = {"error of the coherence matrix (fro_c)", AxisScale::logarithmic};
    PlotSeries bound{"rigorous bound of what is missing", {}, 1, PlotMarker::none, true, true};
    PlotSeries sampling{"estimate of the sampling error", {}, 2, PlotMarker::none, true, true};
    PlotSeries truth{"true error", {}, 0, PlotMarker::circle, true, false};
    for (const AnytimePoint& point : result.anytime) {
        bound.points.emplace_back(point.seconds, point.bound);
        if (point.sampling > 0.0) sampling.points.emplace_back(point.seconds, point.sampling);
        if (point.error >= 3.0 * result.reference_error) truth.points.emplace_back(point.seconds, point.error);
    }
    plot.series = {bound, truth};
    if (!sampling.points.empty()) plot.series.push_back(sampling);
    return plot;
}

/// Shares of one setting's error as one bar. Truncation and sampling are distances of the same kind; the spectral one
/// is a difference of colors: the bar says what to spend time on, not a sum.
std::string budget_bar(const ErrorBudget& budget) {
    struct Part {
        const char* name;
        double value;
        const char* color;
    };
    // Rounding would be too thin to see.
    const std::vector<Part> parts{{"truncation", budget.truncation, "#3b7dd8"},
                                  {"sampling", budget.sampling, "#d87b3b"},
                                  {"spectral", budget.spectral, "#7a4fc0"}};
    double sum = 0.0;
    for (const Part& part : parts)
        if (!std::isnan(part.value)) sum += part.value;
    std::string out = "<div class=\"bar\">";
    for (const Part& part : parts)
        if (sum > 0.0 && part.value > 0.0)
            out += fmt::format("<span style=\"width:{:.2f}%;background:{}\" title=\"{} {:.2e}\"></span>",
                               100.0 * part.value / sum, part.color, part.name, part.value);
    return out + "</div>";
}

RgbPicture brightness(const StokesImage& image) {
    RgbPicture picture{image.width, image.height, {}};
    for (const Rgb& rgb : color_picture(image))
        picture.pixels.push_back(encode({srgb_encode(rgb[0]), srgb_encode(rgb[1]), srgb_encode(rgb[2])}));
    return picture;
}

/// |dC|_F of each pixel, all wavelengths together, over the root mean square of |C|_F: six decades up to 1.
RgbPicture error_map(const StokesImage& test, const StokesImage& reference) {
    constexpr double decades = 6.0;
    const std::size_t pixels = reference.pixel_count();
    std::vector<double> squares(pixels, 0.0);
    double size = 0.0;
    for (std::size_t w = 0; w < reference.bands.size(); ++w) {
        for (std::size_t p = 0; p < pixels; ++p) {
            squares[p] += frobenius_square(test.at(w, p) - reference.at(w, p));
            size += frobenius_square(reference.at(w, p));
        }
    }
    RgbPicture picture{reference.width, reference.height, {}};
    for (const double square : squares) {
        const double share = size > 0.0 ? std::sqrt(square * static_cast<double>(pixels) / size) : 0.0;
        const double t = share > 0.0 ? 1.0 + std::log10(share) / decades : 0.0;
        picture.pixels.push_back(encode(scale_color(ColorScale::sequential, std::clamp(t, 0.0, 1.0))));
    }
    return picture;
}

/// "; 1e-2 costs 0.12 s of CPU time" for the errors that the curve comes down to.
std::string cost_text(const Curve& curve) {
    std::string text;
    for (const double error : {1e-2, 1e-3})
        if (const auto cost = cost_of(curve, error))
            text += fmt::format("; {:.0e} costs {:.3g} s of CPU time", error, *cost);
    return text;
}

}  // namespace

std::vector<NamedPlot> convergence_plots(const ConvergenceResult& result) {
    const std::vector<Curve> all = curves(result.rows);
    std::vector<NamedPlot> plots{{"work-precision", work_precision(all, result.reference_error)}};
    if (const Curve* curve = truncation_curve(all))
        plots.push_back({"bound-and-truth", bound_and_truth(*curve, error_budgets(result.rows))});
    if (!result.anytime.empty()) plots.push_back({"anytime", anytime(result)});
    return plots;
}

Result<std::vector<BudgetPicture>> budget_pictures(const ConvergenceRequest& request, const ConvergenceResult& result) {
    POL_TRY(auto read, read_exr(request.reference.value_or(request.folder / "reference.exr")));
    const StokesImage& reference = read;
    const std::vector<RunSetting> settings = convergence_settings(request.scene, false);
    std::vector<RunSetting> first;
    for (const RunSetting& setting : settings)
        if (setting.series == settings.front().series) first.push_back(setting);
    const std::vector<Curve> all = curves(result.rows);
    std::vector<BudgetPicture> pictures;
    for (const std::size_t index : {std::size_t{0}, first.size() / 2, first.size() - 1}) {
        Scene scene = request.scene;
        scene.render = first[index].settings;
        POL_TRY(auto plan, compile(scene));
        const StokesImage image = render_to_end(std::move(plan), {}, {.threads = request.threads}).picture;
        const double error = error_metrics(image, reference).fro_c.whole;
        std::string caption = "residual " + fmt::format("{:g}", scene.render.residual_in_force());
        if (scene.render.mode == SampleMode::area)
            caption += fmt::format(", {} samples", scene.render.samples_per_pixel);
        caption += fmt::format(": error {:.2e}", error);
        pictures.push_back({caption, brightness(image), error_map(image, reference)});
    }
    return pictures;
}

std::string convergence_section(const ConvergenceRequest& request, const ConvergenceResult& result,
                                const std::vector<BudgetPicture>& pictures, const std::string& command) {
    const std::vector<Curve> all = curves(result.rows);
    const RunRow& any = result.rows.front();
    std::string body = "<p><code>" + xml_text(command) + "</code></p>\n";
    body += fmt::format(
        "<p>{} at {}x{} pixels, {} wavelength{}, mode {}, polariscope {}, {} thread{} of {}, {}, load {:.2g} when it "
        "began. Reference: {}; <span class=\"{}\">{}</span>. No point below three times {:.1e} is drawn. Times are "
        "those "
        "of "
        "the tracing alone, the shortest of up to {} runs; scene hash {}.</p>\n",
        xml_text(request.scene_name), any.width, any.height, request.scene.render.wavelengths_nm.size(),
        request.scene.render.wavelengths_nm.size() == 1 ? "" : "s", any.mode, xml_text(any.tool_version), any.threads,
        any.threads == 1.0 ? "" : "s", xml_text(any.cpu), any.timestamp, any.host_load, xml_text(result.reference_id),
        result.reference_check && result.reference_check->contradicts() ? "bad" : "soft",
        xml_text(text_about_reference(result)), result.reference_error, request.most_repeats, any.scene_hash);
    if (!result.complete) body += "<p class=\"bad\">Stopped before the last run: the curves are not complete.</p>\n";

    body += "<div class=\"plots\">\n";
    for (const NamedPlot& named : convergence_plots(result)) body += "<figure>" + plot_svg(named.plot) + "</figure>\n";
    body += "</div>\n";

    body += "<h3>The cheapest way to an error</h3>\n<table>" +
            row_of({"error (fro_c)", "setting", "reached", "CPU s", "wall s"}, "th");
    for (const Cheapest& best : cheapest(all, {1e-1, 1e-2, 1e-3}))
        body += best.point ? row_of({fmt::format("{:g}", best.error), best.point->setting + " (" + best.series + ")",
                                     number(best.point->error), fmt::format("{:.3g}", best.point->cpu_s),
                                     fmt::format("{:.3g}", best.point->wall_s)})
                           : row_of({fmt::format("{:g}", best.error), "no setting reached it", "", "", ""});
    body += "</table>\n";

    body += "<h3>Every setting</h3>\n<table>" +
            row_of({"setting", "samples per pixel", "error", "smallest", "largest", "bound", "CPU s", "wall s"}, "th");
    for (const Curve& curve : all) {
        body += fmt::format("<tr><td colspan=\"8\"><b>{}</b>{}{}</td></tr>\n", xml_text(curve.series),
                            curve.slope ? fmt::format(": error falls as time<sup>{:.2f}</sup>", *curve.slope) : "",
                            cost_text(curve));
        for (const CurvePoint& p : curve.points)
            body += row_of({p.setting + (p.below_floor ? " <span class=\"soft\">(below the floor)</span>" : ""),
                            fmt::format("{:g}", p.samples), number(p.error), number(p.error_low), number(p.error_high),
                            number(p.bound), fmt::format("{:.3g}", p.cpu_s), fmt::format("{:.3g}", p.wall_s)});
    }
    body += "</table>\n";

    body +=
        "<h3>The error taken apart</h3>\n<p><span style=\"color:#3b7dd8\">truncation</span>: against a deeper render "
        "of the same samples; <span style=\"color:#d87b3b\">sampling</span>: scatter of independent seeds, unknown "
        "where nothing scattered; <span "
        "style=\"color:#7a4fc0\">spectral</span>: color against every second wavelength; floating point: of the scene "
        "at "
        "its own settings. Empty: does not apply.</p>\n"
        "<table>" +
        row_of({"setting", "truncation", "its bound", "sampling", "spectral", "floating point", "shares"}, "th");
    for (const ErrorBudget& budget : error_budgets(result.rows))
        body += row_of({budget.setting, number(budget.truncation), number(budget.truncation_bound),
                        std::isnan(budget.sampling) ? "unknown" : number(budget.sampling), number(budget.spectral),
                        number(budget.floating_point), budget_bar(budget)});
    body += "</table>\n";
    if (result.rounding) body += "<p>Floating point: " + text_of(*result.rounding) + ".</p>\n";
    body += fmt::format("<p>Of our own pictures: <span class=\"{}\">{}</span> (must be 100.00).</p>\n",
                        worst_bound_coverage(result.rows) == 1.0 ? "good" : "bad", text_about_bounds(result));

    body +=
        "<h3>Pictures at three budgets</h3>\n<p>Above the picture, below its error on a logarithmic scale: dark 1e-6, "
        "bright 1 (|dC| of the pixel over the root mean square of |C|).</p>\n<div class=\"pictures\">\n";
    for (const BudgetPicture& picture : pictures)
        body += "<figure>" + html_image(picture.picture, picture.caption) + html_image(picture.error, "error of it") +
                "<figcaption>" + xml_text(picture.caption) + "</figcaption></figure>\n";
    body += "</div>\n";
    return body;
}

}  // namespace pol::verify
