// SPDX-License-Identifier: Apache-2.0
// Long because it is one drawing: picture, bar, wheel, ticks and legend are placed against each other.
#include "report/map_picture.h"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "core/contract.h"
#include "core/units.h"
#include "report/bar_ticks.h"

namespace pol {
namespace {

constexpr int least_longer_side = 384;
constexpr int largest_canvas = 32000;

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

/// One line of the legend: a colored box and what it means. A box that fades has no single state.
struct LegendEntry {
    PixelState state = PixelState::defined;
    std::string text;
};

std::string percentage(std::size_t count, std::size_t total) {
    const double percent = 100.0 * static_cast<double>(count) / static_cast<double>(total);
    return percent < 0.1 ? fmt::format("{} px", count) : fmt::format("{:.1f} %", percent);
}

std::vector<LegendEntry> legend_of(const ColoredMap& map) {
    std::vector<LegendEntry> entries;
    const std::size_t total = map.picture.pixels.size();
    const auto add = [&](PixelState state, std::string_view text) {
        const std::size_t count = map.state_count[static_cast<std::size_t>(state)];
        if (count > 0) entries.push_back({state, fmt::format("{} ({})", text, percentage(count, total))});
    };
    if (map.fades)
        entries.push_back(
            {PixelState::defined, fmt::format("fades below {} % polarized", 100.0 * full_weight_polarization)});
    if (map.fades_by_bar)
        entries.push_back({PixelState::defined, "fades as the error bar widens to half of the range"});
    const bool needs_axis = info(map.quantity).carrier == Carrier::linear_part;
    const std::string as_none = map.black_is_none ? ", drawn as 0" : "";
    add(PixelState::no_light, "no light" + as_none);
    add(PixelState::dark, fmt::format("dark: below {} of the brightest pixel, and not determined", dark_share));
    add(PixelState::undefined, (needs_axis ? "unpolarized or circular" : "unpolarized") + as_none);
    add(PixelState::undetermined, "not determined: too much light not traced");
    add(PixelState::not_a_number, "not a number");
    add(PixelState::unphysical, "unphysical: negative S0 or residual, or polarized light without S0");
    add(PixelState::not_measured, "not measured: the picture does not have all components");
    return entries;
}

std::string tick_text(double value) {
    return fmt::format("{:.4g}", value == 0.0 ? 0.0 : value);
}

std::string label_of(const Band& band) {
    return band.wavelength_nm ? fmt::format("{:.6g} nm", *band.wavelength_nm) : band.name;
}

std::string title_of(const ColoredMap& map) {
    const std::string_view title = info(map.quantity).title;
    if (map.quantity == Quantity::color) return std::string(title);
    return fmt::format("{}{}, {}", title, map.is_difference && !info(map.quantity).of_two ? ", difference" : "",
                       label_of(map.band));
}

/// Positions in pixels of the canvas. Everything but the picture scales with `unit`, so that the legend of a large
/// picture can still be read when the whole is shown smaller.
struct Layout {
    double unit = 1.0;
    int factor = 1;
    int shown_width = 0;
    int shown_height = 0;
    double margin = 0.0;
    double picture_top = 0.0;
    double bar_left = 0.0;
    double bar_top = 0.0;
    double bar_width = 0.0;
    double bar_height = 0.0;
    double wheel_radius = 0.0;
    double legend_top = 0.0;
    double legend_line = 0.0;
    int width = 0;
    int height = 0;
};

class Drawing {
public:
    Drawing(const ColoredMap& map, const std::string& caption)
        : map_(map), caption_(caption), legend_(legend_of(map)), title_(title_of(map)) {
        if (map.scale) {
            for (const double tick : bar_ticks(map.range, map.kind())) {
                ticks_.emplace_back(tick, tick_text(tick) + degree_sign() + end_word(tick, map.range, map.words));
            }
        }
        arrange();
    }

    [[nodiscard]] bool is_too_large() const {
        return layout_.width > largest_canvas || layout_.height > largest_canvas;
    }

    RgbPicture draw() {
        const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, layout_.width, layout_.height),
                              cairo_surface_destroy);
        context_ = Context(cairo_create(surface.get()), cairo_destroy);
        cairo_set_source_rgb(context_.get(), 1.0, 1.0, 1.0);
        cairo_paint(context_.get());
        draw_texts();
        if (map_.scale) draw_bar();
        if (layout_.wheel_radius > 0.0) draw_wheel_labels();
        cairo_surface_flush(surface.get());
        RgbPicture canvas = pixels_of(surface.get());
        paint_picture(canvas);
        if (map_.scale) paint_bar(canvas);
        if (layout_.wheel_radius > 0.0) paint_wheel(canvas);
        paint_legend(canvas);
        return canvas;
    }

private:
    [[nodiscard]] std::string degree_sign() const { return info(map_.quantity).unit == "\u00b0" ? "\u00b0" : ""; }
    [[nodiscard]] std::string bar_heading() const {
        return degree_sign().empty() ? std::string(unit_of(map_.quantity, map_.band)) : "";
    }
    [[nodiscard]] double title_size() const { return 15.0 * layout_.unit; }
    [[nodiscard]] double text_size() const { return 12.0 * layout_.unit; }

    void use_font(cairo_t* context, double size, cairo_font_weight_t weight) const {
        cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, weight);
        cairo_set_font_size(context, size);
    }

    [[nodiscard]] double text_width(const std::string& text, double size, cairo_font_weight_t weight) const {
        const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, 1), cairo_surface_destroy);
        const Context context(cairo_create(surface.get()), cairo_destroy);
        use_font(context.get(), size, weight);
        cairo_text_extents_t extents;
        cairo_text_extents(context.get(), text.c_str(), &extents);
        return extents.x_advance;
    }

    void arrange() {
        Layout& l = layout_;
        const int longer = std::max(map_.picture.width, map_.picture.height);
        l.factor = std::max(1, (least_longer_side + longer - 1) / longer);
        l.shown_width = map_.picture.width * l.factor;
        l.shown_height = map_.picture.height * l.factor;
        l.unit = std::max(1.0, std::max(l.shown_width, l.shown_height) / 700.0);
        l.margin = std::round(14.0 * l.unit);
        l.picture_top = std::round(l.margin + (caption_.empty() ? 26.0 : 44.0) * l.unit);
        double right = l.margin + l.shown_width;
        double bottom = l.picture_top + l.shown_height;

        if (map_.scale) {
            // Differences are no directions of the picture.
            const bool has_wheel = map_.kind() == ScaleKind::cyclic && !map_.is_difference;
            double label_width = text_width(bar_heading(), text_size(), CAIRO_FONT_WEIGHT_NORMAL);
            for (const auto& [value, text] : ticks_) {
                label_width = std::max(label_width, text_width(text, text_size(), CAIRO_FONT_WEIGHT_NORMAL));
            }
            l.bar_left = std::round(right + 18.0 * l.unit);
            l.bar_width = std::round(20.0 * l.unit);
            const double heading = bar_heading().empty() ? 0.0 : 22.0 * l.unit;
            const double arrow = 12.0 * l.unit;
            l.bar_top = std::round(l.picture_top + heading + arrow);
            l.wheel_radius = has_wheel ? std::round(34.0 * l.unit) : 0.0;
            const double wheel_height = has_wheel ? 2.0 * l.wheel_radius + 48.0 * l.unit : 0.0;
            const double wanted = l.shown_height - heading - 2.0 * arrow - wheel_height;
            l.bar_height = std::round(std::max(160.0 * l.unit, wanted));
            right = l.bar_left + l.bar_width + 10.0 * l.unit + label_width;
            if (has_wheel) right = std::max(right, l.bar_left + 2.0 * l.wheel_radius + 34.0 * l.unit);
            bottom = std::max(bottom, l.bar_top + l.bar_height + arrow + wheel_height);
        }
        right = std::max(right, l.margin + text_width(title_, title_size(), CAIRO_FONT_WEIGHT_BOLD));
        l.legend_line = std::round(20.0 * l.unit);
        l.legend_top = std::round(bottom + 10.0 * l.unit);
        const std::vector<std::string> notes = range_notes();
        for (const LegendEntry& entry : legend_) {
            right = std::max(right,
                             l.margin + 24.0 * l.unit + text_width(entry.text, text_size(), CAIRO_FONT_WEIGHT_NORMAL));
        }
        for (const std::string& note : notes) {
            right = std::max(right, l.margin + text_width(note, text_size(), CAIRO_FONT_WEIGHT_NORMAL));
        }
        const double lines = static_cast<double>(legend_.size() + notes.size());
        l.width = static_cast<int>(std::ceil(right + l.margin));
        l.height =
            static_cast<int>(std::ceil((lines > 0.0 ? l.legend_top + lines * l.legend_line : bottom) + l.margin));
        shorten_caption();
    }

    void shorten_caption() {
        const double room = layout_.width - 2.0 * layout_.margin;
        while (!caption_.empty() && text_width(caption_, text_size(), CAIRO_FONT_WEIGHT_NORMAL) > room) {
            if (caption_.ends_with("\u2026")) caption_.resize(caption_.size() - 3);
            // A UTF-8 character ends before the next byte that does not continue one.
            while (!caption_.empty() && (static_cast<unsigned char>(caption_.back()) & 0xC0U) == 0x80U)
                caption_.pop_back();
            if (!caption_.empty()) caption_.pop_back();
            caption_ += "\u2026";
        }
    }

    [[nodiscard]] std::vector<std::string> range_notes() const {
        std::vector<std::string> notes;
        if (map_.black_is_none && !map_.is_difference) notes.emplace_back("value \u00d7 D65");
        if (!map_.words.note.empty()) notes.push_back(map_.words.note);
        const std::size_t total = map_.picture.pixels.size();
        if (map_.above > 0) notes.push_back(fmt::format("above the range: {}", percentage(map_.above, total)));
        if (map_.below > 0) notes.push_back(fmt::format("below the range: {}", percentage(map_.below, total)));
        return notes;
    }

    /// On whole pixels: between them, versions of cairo place letters differently.
    void text(double x, double y, const std::string& line, double gray) {
        cairo_set_source_rgb(context_.get(), gray, gray, gray);
        cairo_move_to(context_.get(), std::round(x), std::round(y));
        cairo_show_text(context_.get(), line.c_str());
    }

    void draw_texts() {
        const Layout& l = layout_;
        use_font(context_.get(), title_size(), CAIRO_FONT_WEIGHT_BOLD);
        text(l.margin, l.margin + 13.0 * l.unit, title_, 0.0);
        use_font(context_.get(), text_size(), CAIRO_FONT_WEIGHT_NORMAL);
        if (!caption_.empty()) text(l.margin, l.margin + 32.0 * l.unit, caption_, 0.35);
        double baseline = l.legend_top + 14.0 * l.unit;
        for (const LegendEntry& entry : legend_) {
            text(l.margin + 24.0 * l.unit, baseline, entry.text, 0.1);
            baseline += l.legend_line;
        }
        for (const std::string& note : range_notes()) {
            text(l.margin, baseline, note, 0.1);
            baseline += l.legend_line;
        }
    }

    /// Frame, numbers and the arrows of values out of range; the colors are painted over it.
    void draw_bar() {
        const Layout& l = layout_;
        cairo_t* context = context_.get();
        if (!bar_heading().empty()) text(l.bar_left, l.picture_top + 12.0 * l.unit, bar_heading(), 0.1);
        cairo_set_line_width(context, l.unit);
        for (const auto& [value, label] : ticks_) {
            const double y = bar_position(value);
            cairo_set_source_rgb(context, 0.2, 0.2, 0.2);
            cairo_move_to(context, l.bar_left + l.bar_width, y);
            cairo_line_to(context, l.bar_left + l.bar_width + 5.0 * l.unit, y);
            cairo_stroke(context);
            text(l.bar_left + l.bar_width + 9.0 * l.unit, y + 4.3 * l.unit, label, 0.1);
        }
        if (map_.above > 0) draw_arrow(l.bar_top, -1.0, 1.0);
        if (map_.below > 0) draw_arrow(l.bar_top + l.bar_height, 1.0, 0.0);
    }

    void draw_arrow(double y, double direction, double t) {
        const Layout& l = layout_;
        const Rgb8 color = encode(scale_color(*map_.scale, t));
        cairo_t* context = context_.get();
        cairo_move_to(context, l.bar_left, y + direction * 2.0 * l.unit);
        cairo_line_to(context, l.bar_left + l.bar_width, y + direction * 2.0 * l.unit);
        cairo_line_to(context, l.bar_left + l.bar_width / 2.0, y + direction * 11.0 * l.unit);
        cairo_close_path(context);
        cairo_set_source_rgb(context, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
        cairo_fill_preserve(context);
        cairo_set_source_rgb(context, 0.2, 0.2, 0.2);
        cairo_stroke(context);
    }

    [[nodiscard]] double bar_position(double value) const {
        const double t = (value - map_.range.low) / (map_.range.high - map_.range.low);
        return layout_.bar_top + layout_.bar_height * (1.0 - t);
    }

    [[nodiscard]] std::pair<double, double> wheel_center() const {
        const Layout& l = layout_;
        return {std::round(l.bar_left + l.wheel_radius),
                std::round(l.bar_top + l.bar_height + 38.0 * l.unit + l.wheel_radius)};
    }

    void draw_wheel_labels() {
        const Layout& l = layout_;
        const auto [x, y] = wheel_center();
        text(x + l.wheel_radius + 5.0 * l.unit, y + 4.0 * l.unit, "0\u00b0", 0.1);
        const std::string up = "90\u00b0";
        text(x - text_width(up, text_size(), CAIRO_FONT_WEIGHT_NORMAL) / 2.0, y - l.wheel_radius - 5.0 * l.unit, up,
             0.1);
    }

    static RgbPicture pixels_of(cairo_surface_t* surface) {
        RgbPicture picture{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
        const unsigned char* data = cairo_image_surface_get_data(surface);
        const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
        picture.pixels.reserve(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
        for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y) {
            for (std::size_t x = 0; x < static_cast<std::size_t>(picture.width); ++x) {
                std::uint32_t pixel = 0;
                std::memcpy(&pixel, data + y * stride + 4 * x, sizeof pixel);
                picture.pixels.push_back({static_cast<std::uint8_t>(pixel >> 16U),
                                          static_cast<std::uint8_t>(pixel >> 8U), static_cast<std::uint8_t>(pixel)});
            }
        }
        return picture;
    }

    static Rgb8& pixel_at(RgbPicture& canvas, int x, int y) {
        return canvas
            .pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(canvas.width) + static_cast<std::size_t>(x)];
    }

    /// Calls color(x, y) for each pixel of a box and draws a frame one pixel wide around it.
    template <class Color>
    static void paint_box(RgbPicture& canvas, int left, int top, int width, int height, Color color) {
        constexpr Rgb8 frame{90, 90, 90};
        for (int y = -1; y <= height; ++y) {
            for (int x = -1; x <= width; ++x) {
                const bool is_inside = x >= 0 && x < width && y >= 0 && y < height;
                pixel_at(canvas, left + x, top + y) = is_inside ? color(x, y) : frame;
            }
        }
    }

    /// The hatch in pixels of the canvas, so that it looks alike however much the picture is enlarged.
    [[nodiscard]] Rgb8 hatch(PixelState state, int x, int y) const {
        return state_color(state, static_cast<int>(x / layout_.unit), static_cast<int>(y / layout_.unit));
    }

    void paint_picture(RgbPicture& canvas) const {
        const Layout& l = layout_;
        paint_box(canvas, static_cast<int>(l.margin), static_cast<int>(l.picture_top), l.shown_width, l.shown_height,
                  [&](int x, int y) {
                      const std::size_t pixel =
                          static_cast<std::size_t>(y / l.factor) * static_cast<std::size_t>(map_.picture.width) +
                          static_cast<std::size_t>(x / l.factor);
                      const PixelState state = map_.states[pixel];
                      return is_hatched(state) ? hatch(state, x, y) : map_.picture.pixels[pixel];
                  });
    }

    void paint_bar(RgbPicture& canvas) const {
        const Layout& l = layout_;
        paint_box(canvas, static_cast<int>(l.bar_left), static_cast<int>(l.bar_top), static_cast<int>(l.bar_width),
                  static_cast<int>(l.bar_height),
                  [&](int, int y) { return encode(scale_color(*map_.scale, 1.0 - (y + 0.5) / l.bar_height)); });
    }

    /// Every direction of the picture in the color of light that swings along it.
    void paint_wheel(RgbPicture& canvas) const {
        const auto [center_x, center_y] = wheel_center();
        const int radius = static_cast<int>(layout_.wheel_radius);
        for (int y = -radius; y <= radius; ++y) {
            for (int x = -radius; x <= radius; ++x) {
                const double distance = std::hypot(x, y);
                if (distance > radius || distance < 0.35 * radius) continue;
                // Half a turn is the whole scale; rows run downwards. A line from the left is one from the right, too.
                const double turn = std::atan2(map_.words.clockwise ? y : -y, x) / pi + 0.5;
                pixel_at(canvas, static_cast<int>(center_x) + x, static_cast<int>(center_y) + y) =
                    encode(scale_color(*map_.scale, turn - std::floor(turn)));
            }
        }
    }

    void paint_legend(RgbPicture& canvas) const {
        const Layout& l = layout_;
        const int size = static_cast<int>(std::round(14.0 * l.unit));
        double top = l.legend_top + 2.0 * l.unit;
        for (const LegendEntry& entry : legend_) {
            paint_box(canvas, static_cast<int>(l.margin) + 1, static_cast<int>(top), size, size, [&](int x, int y) {
                if (is_hatched(entry.state)) return hatch(entry.state, x, y);
                if (entry.state != PixelState::defined) return state_color(entry.state, x, y, map_.black_is_none);
                // The fade: the middle of the scale on the left, no weight on the right.
                return faded(scale_color(*map_.scale, 0.75), 1.0 - (x + 0.5) / size);
            });
            top += l.legend_line;
        }
    }

    const ColoredMap& map_;
    std::string caption_;
    std::vector<LegendEntry> legend_;
    std::string title_;
    std::vector<std::pair<double, std::string>> ticks_;
    Layout layout_{};
    Context context_{nullptr, cairo_destroy};
};

}  // namespace

Result<RgbPicture> map_picture(const ColoredMap& map, const std::string& caption) {
    POL_EXPECTS(map.picture.width > 0 && map.picture.height > 0);
    Drawing drawing(map, caption);
    if (drawing.is_too_large()) {
        Error error{ErrorKind::output, "the picture is too large to be drawn with a color bar"};
        error.hint =
            fmt::format("--plain writes the {} x {} pixels of the map alone", map.picture.width, map.picture.height);
        return error;
    }
    return drawing.draw();
}

}  // namespace pol
