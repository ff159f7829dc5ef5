// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>
#include <regex>
#include <string>

#include "report/plot_svg.h"

namespace pol::verify {
namespace {

Plot plot_of(std::vector<DVec2> points, AxisScale scale) {
    Plot plot;
    plot.title = "error < 1 & \"small\"";
    plot.x = {"x", scale};
    plot.y = {"y", scale};
    plot.series = {{"curve", std::move(points), 0, PlotMarker::circle, true, false}};
    return plot;
}

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
    return found;
}

TEST(PlotSvg, WritesWordsAsTextAndEscapesThem) {
    const std::string svg = plot_svg(plot_of({{1.0, 2.0}, {3.0, 4.0}}, AxisScale::linear));
    EXPECT_NE(svg.find(">error &lt; 1 &amp; &quot;small&quot;</text>"), std::string::npos);
    EXPECT_NE(svg.find(">curve</text>"), std::string::npos);
    EXPECT_NE(svg.find("prefers-color-scheme:dark"), std::string::npos);
}

TEST(PlotSvg, PutsPointsWhereTheirTicksAre) {
    // 10^-2 is a tick of the x axis and a point; both have the same x on the
    // paper.
    const std::string svg = plot_svg(plot_of({{1e-4, 1e-4}, {1e-2, 1e-3}, {1.0, 1.0}}, AxisScale::logarithmic));
    std::smatch tick;
    ASSERT_TRUE(std::regex_search(svg, tick, std::regex("<text x=\"([0-9.]+)\"[^>]*>10⁻²<")));
    EXPECT_NE(svg.find("<circle cx=\"" + tick[1].str() + "\""), std::string::npos);
}

TEST(PlotSvg, DrawsZerosOnALogarithmicAxisAsHollowMarkers) {
    const std::string svg = plot_svg(plot_of({{1.0, 1e-3}, {2.0, 0.0}, {3.0, 1e-2}}, AxisScale::logarithmic));
    EXPECT_EQ(count(svg, "class=\"plot-hollow\""), 1U);
}

TEST(PlotSvg, BreaksALineAtWhatIsNotANumber) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::string whole = plot_svg(plot_of({{1.0, 1.0}, {2.0, 2.0}, {3.0, 3.0}}, AxisScale::linear));
    const std::string broken = plot_svg(plot_of({{1.0, 1.0}, {2.0, nan}, {3.0, 3.0}}, AxisScale::linear));
    EXPECT_EQ(count(whole, "<circle"), count(broken, "<circle") + 1);
    EXPECT_EQ(broken.find("nan"), std::string::npos);
    EXPECT_TRUE(std::regex_search(broken, std::regex("<path d=\"M[0-9. ]+M[0-9. ]+\" class=\"plot-line\"")));
}

TEST(PlotSvg, DrawsABandBetweenItsCurves) {
    Plot plot = plot_of({{1.0, 2.0}, {2.0, 2.5}}, AxisScale::linear);
    plot.bands = {{"spread", {1.0, 2.0}, {1.0, 2.0}, {3.0, 3.5}, 0}};
    EXPECT_EQ(count(plot_svg(plot), "class=\"plot-band\""),
              2U);  // the legend's and its own
}

TEST(PlotSvg, SurvivesAPlotWithoutData) {
    const std::string svg = plot_svg(plot_of({}, AxisScale::logarithmic));
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
}

}  // namespace
}  // namespace pol::verify
