// SPDX-License-Identifier: Apache-2.0
#include "report/plot_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string_view>

#include "report/round_step.h"

namespace pol {

namespace {

constexpr double left_margin = 76.0;
constexpr double right_margin = 18.0;
constexpr double top_margin = 84.0;
constexpr double bottom_margin = 56.0;

/// Okabe and Ito's palette, safe for every color vision, and lighter twins for dark pages.
constexpr std::string_view plot_style = R"(<style>
.plot-paper{fill:#fff}.plot-text{fill:#222;font-family:sans-serif}.plot-soft{fill:#555;font-family:sans-serif}
.plot-grid{stroke:#ddd;stroke-width:1}.plot-frame{stroke:#888;stroke-width:1;fill:none}
.plot-s0{stroke:#0072b2;color:#0072b2}.plot-s1{stroke:#009e73;color:#009e73}.plot-s2{stroke:#d55e00;color:#d55e00}
.plot-s3{stroke:#cc79a7;color:#cc79a7}.plot-s4{stroke:#b8860b;color:#b8860b}.plot-s5{stroke:#555;color:#555}
.plot-line{fill:none;stroke-width:2;stroke-linejoin:round}.plot-dash{stroke-dasharray:7 5}
.plot-full{fill:currentColor}.plot-hollow{fill:none;stroke-width:1.5}.plot-band{fill:currentColor;opacity:.2;stroke:none}
@media (prefers-color-scheme:dark){.plot-paper{fill:#181a1f}.plot-text{fill:#e6e6e6}.plot-soft{fill:#aaa}
.plot-grid{stroke:#333}.plot-frame{stroke:#777}.plot-s0{stroke:#56b4e9;color:#56b4e9}.plot-s1{stroke:#2fd3a5;color:#2fd3a5}
.plot-s2{stroke:#ff8a3d;color:#ff8a3d}.plot-s3{stroke:#e7a7cb;color:#e7a7cb}.plot-s4{stroke:#f0e442;color:#f0e442}
.plot-s5{stroke:#bbb;color:#bbb}}
</style>
)";

/// An axis with its range, ticks, and place on the paper.
struct Scale {
    AxisScale kind = AxisScale::linear;
    double low = 0.0;  // in axis measure: log10 of a logarithmic value
    double high = 1.0;
    double first_pixel = 0.0;  // of `low`
    double last_pixel = 1.0;

    [[nodiscard]] bool is_off(double value) const { return measure(value) < low; }
    [[nodiscard]] double measure(double value) const {
        if (kind == AxisScale::linear) return value;
        return value > 0.0 ? std::log10(value) : low - 1.0;
    }
    [[nodiscard]] double pixel(double value) const {
        const double t = (std::clamp(measure(value), low, high) - low) / (high - low);
        return first_pixel + t * (last_pixel - first_pixel);
    }
};

using EachValue = std::function<void(const std::function<void(double)>&)>;

Scale make_scale(const PlotAxis& axis, const EachValue& values, double first_pixel, double last_pixel) {
    Scale scale{axis.scale, 0.0, 1.0, first_pixel, last_pixel};
    if (axis.falling) std::swap(scale.first_pixel, scale.last_pixel);
    const bool logarithmic = axis.scale == AxisScale::logarithmic;
    double low = 1e308;
    double high = -1e308;
    values([&](double v) {
        if (!std::isfinite(v) || (logarithmic && v <= 0.0)) return;
        low = std::min(low, logarithmic ? std::log10(v) : v);
        high = std::max(high, logarithmic ? std::log10(v) : v);
    });
    if (low > high) low = 0.0, high = 1.0;
    if (logarithmic) low = std::floor(low + 1e-9), high = std::ceil(high - 1e-9);
    if (axis.low) low = logarithmic ? std::log10(*axis.low) : *axis.low;
    if (axis.high) high = logarithmic ? std::log10(*axis.high) : *axis.high;
    if (!(high > low)) high = low + 1.0;
    scale.low = low;
    scale.high = high;
    return scale;
}

/// Round steps: 1, 2 or 5 times a power of ten; whole decades on a logarithmic axis. About `count` of them.
std::vector<double> ticks_of(const Scale& scale, double count) {
    double step = round_step((scale.high - scale.low) / count);
    const bool logarithmic = scale.kind == AxisScale::logarithmic;
    if (logarithmic) step = std::max(1.0, std::round(step));
    std::vector<double> ticks;
    const double first = std::ceil(scale.low / step - 1e-9);
    for (int i = 0; i < 40; ++i) {
        const double tick = step * (first + i);
        if (tick > scale.high + 1e-9 * step) break;
        ticks.push_back(logarithmic ? std::pow(10.0, tick) : tick);
    }
    return ticks;
}

std::string tick_text(const Scale& scale, double tick) {
    if (scale.kind == AxisScale::linear) return fmt::format("{:g}", std::abs(tick) < 1e-12 ? 0.0 : tick);
    const int exponent = static_cast<int>(std::lround(std::log10(tick)));
    if (exponent >= 0 && exponent <= 3) return fmt::format("{:g}", tick);
    constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
    return text;
}

std::string text_at(double x, double y, std::string_view kind, int size, std::string_view anchor,
                    const std::string& words, std::string_view more = {}) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"{}\" font-size=\"{}\" text-anchor=\"{}\"{}>{}</text>\n",
                       x, y, kind, size, anchor, more, xml_text(words));
}

std::string marker_at(PlotMarker marker, double x, double y, std::string_view kind) {
    switch (marker) {
        case PlotMarker::circle:
            return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.2\" class=\"{}\"/>\n", x, y, kind);
        case PlotMarker::square:
            return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"6\" height=\"6\" class=\"{}\"/>\n", x - 3.0,
                               y - 3.0, kind);
        case PlotMarker::triangle:
            return fmt::format("<path d=\"M{:.1f} {:.1f}l3.6 6.4h-7.2z\" class=\"{}\"/>\n", x, y - 3.8, kind);
        case PlotMarker::none:
            break;
    }
    return {};
}

class PlotDrawing {
public:
    explicit PlotDrawing(const Plot& plot)
        : plot_(plot),
          right_(plot.width - right_margin),
          bottom_(plot.height - bottom_margin),
          x_(make_scale(plot.x, values(0), left_margin, right_)),
          y_(make_scale(plot.y, values(1), bottom_, top_margin)) {}

    std::string text() {
        out_ = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
            "role=\"img\">\n<title>{2}</title>\n{3}<rect width=\"{0}\" height=\"{1}\" class=\"plot-paper\"/>\n",
            plot_.width, plot_.height, xml_text(plot_.title), plot_style);
        out_ += text_at(left_margin, 24.0, "plot-text", 16, "start", plot_.title);
        out_ += text_at(left_margin, 44.0, "plot-soft", 12, "start", plot_.subtitle);
        draw_axes();
        draw_legend();
        for (const PlotBand& band : plot_.bands) draw_band(band);
        for (const PlotSeries& series : plot_.series) draw_series(series);
        return out_ + "</svg>\n";
    }

private:
    [[nodiscard]] EachValue values(int axis) const {
        return [this, axis](const std::function<void(double)>& see) {
            for (const PlotSeries& s : plot_.series)
                for (const DVec2& p : s.points) see(p[axis]);
            for (const PlotBand& b : plot_.bands) {
                if (axis == 0) std::for_each(b.x.begin(), b.x.end(), see);
                if (axis == 1) std::for_each(b.low.begin(), b.low.end(), see);
                if (axis == 1) std::for_each(b.high.begin(), b.high.end(), see);
            }
        };
    }

    void draw_axes() {
        const auto line = [](double x1, double y1, double x2, double y2) {
            return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" class=\"plot-grid\"/>\n", x1, y1, x2, y2);
        };
        for (const double tick : ticks_of(x_, 8.0)) {
            const double at = x_.pixel(tick);
            out_ += line(at, top_margin, at, bottom_);
            out_ += text_at(at, bottom_ + 18.0, "plot-text", 12, "middle", tick_text(x_, tick));
        }
        for (const double tick : ticks_of(y_, 7.0)) {
            const double at = y_.pixel(tick);
            out_ += line(left_margin, at, right_, at);
            out_ += text_at(left_margin - 8.0, at + 4.0, "plot-text", 12, "end", tick_text(y_, tick));
        }
        out_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" class=\"plot-frame\"/>\n", left_margin,
                            top_margin, right_ - left_margin, bottom_ - top_margin);
        out_ += text_at(0.5 * (left_margin + right_), bottom_ + 42.0, "plot-text", 13, "middle", plot_.x.label);
        const double middle = 0.5 * (top_margin + bottom_);
        out_ += text_at(18.0, middle, "plot-text", 13, "middle", plot_.y.label,
                        fmt::format(" transform=\"rotate(-90 18 {:.1f})\"", middle));
    }

    /// In a row above the frame.
    void draw_legend() {
        double x = left_margin;
        constexpr double y = top_margin - 16.0;
        const auto advance = [&x](const std::string& name) { x += 44.0 + 6.6 * static_cast<double>(name.size()); };
        for (const PlotBand& band : plot_.bands) {
            if (band.name.empty()) continue;
            out_ += fmt::format(
                "<g class=\"plot-s{}\"><rect x=\"{:.1f}\" y=\"{}\" width=\"24\" height=\"10\" "
                "class=\"plot-band\"/></g>\n",
                band.color, x, y - 9.0);
            out_ += text_at(x + 30.0, y, "plot-text", 12, "start", band.name);
            advance(band.name);
        }
        for (const PlotSeries& series : plot_.series) {
            if (series.name.empty()) continue;
            out_ += fmt::format("<g class=\"plot-s{}\">\n", series.color);
            if (series.line)
                out_ += fmt::format("<path d=\"M{:.1f} {}h24\" class=\"plot-line{}\"/>\n", x, y - 4.0,
                                    series.dashed ? " plot-dash" : "");
            out_ += marker_at(series.marker, x + 12.0, y - 4.0, "plot-full") + "</g>\n";
            out_ += text_at(x + 30.0, y, "plot-text", 12, "start", series.name);
            advance(series.name);
        }
    }

    void draw_band(const PlotBand& band) {
        std::string there;
        std::string back;
        const std::size_t count = std::min({band.x.size(), band.low.size(), band.high.size()});
        for (std::size_t i = 0; i < count; ++i) {
            if (!std::isfinite(band.x[i]) || !std::isfinite(band.low[i]) || !std::isfinite(band.high[i])) continue;
            const double x = x_.pixel(band.x[i]);
            there += fmt::format("{}{:.1f} {:.1f}", there.empty() ? "M" : "L", x, y_.pixel(band.high[i]));
            back.insert(0, fmt::format("L{:.1f} {:.1f}", x, y_.pixel(band.low[i])));
        }
        if (there.empty()) return;
        out_ +=
            fmt::format("<g class=\"plot-s{}\"><path d=\"{}{}z\" class=\"plot-band\"/></g>\n", band.color, there, back);
    }

    void draw_series(const PlotSeries& series) {
        std::string path;
        std::string markers;
        bool pen_down = false;
        for (const DVec2& p : series.points) {
            const bool drawable = std::isfinite(p.x) && std::isfinite(p.y);
            const bool off = drawable && (x_.is_off(p.x) || y_.is_off(p.y));
            if (!drawable || off) pen_down = false;
            if (!drawable) continue;
            const double x = x_.pixel(p.x);
            const double y = y_.pixel(p.y);
            if (!off) path += fmt::format("{}{:.1f} {:.1f}", pen_down ? "L" : "M", x, y);
            pen_down = !off;
            markers += marker_at(series.marker, x, y, off ? "plot-hollow" : "plot-full");
        }
        out_ += fmt::format("<g class=\"plot-s{}\">\n", series.color);
        if (series.line && !path.empty())
            out_ += fmt::format("<path d=\"{}\" class=\"plot-line{}\"/>\n", path, series.dashed ? " plot-dash" : "");
        out_ += markers + "</g>\n";
    }

    const Plot& plot_;
    double right_;
    double bottom_;
    Scale x_;
    Scale y_;
    std::string out_;
};

}  // namespace

std::string plot_svg(const Plot& plot) {
    return PlotDrawing(plot).text();
}

std::string xml_text(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&apos;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

}  // namespace pol
