// SPDX-License-Identifier: Apache-2.0
// Plots as SVG text: curves, bands and markers over linear or logarithmic axes, for reports. Words are <text>; colors
// follow the reader's light or dark preference.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/vec.h"

namespace pol {

enum class AxisScale { linear, logarithmic };

/// Points below the range are drawn on its edge, as hollow markers: on a logarithmic axis that is where zero is.
struct PlotAxis {
    std::string label;
    AxisScale scale = AxisScale::linear;
    std::optional<double> low{};  ///< none: from the data
    std::optional<double> high{};
    bool falling = false;  ///< large values first (left or bottom)
};

enum class PlotMarker { none, circle, square, triangle };

struct PlotSeries {
    std::string name;  ///< empty: not in the legend
    std::vector<DVec2> points;
    int color = 0;  ///< of the palette, 0 to 5
    PlotMarker marker = PlotMarker::none;
    bool line = true;
    bool dashed = false;
};

/// The area between two curves.
struct PlotBand {
    std::string name;
    std::vector<double> x;
    std::vector<double> low;
    std::vector<double> high;
    int color = 0;
};

struct Plot {
    std::string title;
    std::string subtitle;
    PlotAxis x;
    PlotAxis y;
    std::vector<PlotSeries> series;
    std::vector<PlotBand> bands{};
    int width = 640;  ///< pixels
    int height = 420;
};

/// A whole SVG document; also good inside HTML. Points that are not finite break a line. A band without room or a plot
/// without data is an empty frame.
std::string plot_svg(const Plot& plot);

/// `text` with the five characters that mean something to XML escaped.
std::string xml_text(const std::string& text);

}  // namespace pol
