// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/picture_overlay.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "maps/color_picture.h"
#include "viewer/pages/pixel_page.h"
#include "viewer/pages/readout_text.h"
#include "viewer/shown/shown_quantity.h"
#include "viewer/widgets/ink.h"

namespace pol {

namespace {

/// Smallest cell of the veil: finer than this nobody sees, and a noisy selection would cost a frame.
constexpr double least_veil_cell = 2.0;
constexpr ImU32 veil_color = IM_COL32(0, 0, 0, 170);

/// Pixels that can be seen.
TileRect visible_pixels(const Session& session, const PlacedPicture& placed) {
    const StokesImage& picture = session.current()->picture();
    const DVec2 low = placed.transform.picture_from_view({0.0, 0.0});
    const DVec2 high = placed.transform.picture_from_view(placed.viewport.size);
    const auto inside = [](double value, int size) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(size)));
    };
    return {inside(std::floor(low.x), picture.width), inside(std::floor(low.y), picture.height),
            inside(std::ceil(high.x), picture.width), inside(std::ceil(high.y), picture.height)};
}

/// What stands inside a pixel: a line per number.
class PixelLabels {
public:
    explicit PixelLabels(const Session& session) : shown_(session.shown_picture()) {
        if (session.view().quantity == Quantity::color)
            weights_ = band_colors(shown_.picture().bands);
        else
            quantity_.emplace(session.shown_quantity());
    }

    [[nodiscard]] std::string text(std::size_t pixel) const {
        if (!quantity_) {
            Rgb color{};
            for (std::size_t w = 0; w < weights_.size(); ++w) {
                for (std::size_t c = 0; c < 3; ++c) color[c] += weights_[w][c] * shown_.stokes(w, pixel).s0;
            }
            const double size = std::max({std::abs(color[0]), std::abs(color[1]), std::abs(color[2])});
            return fmt::format("{}\n{}\n{}", short_number(color[0], 3, size), short_number(color[1], 3, size),
                               short_number(color[2], 3, size));
        }
        const QuantityReadout readout = quantity_->readout(pixel);
        switch (readout.pixel.state) {
            case PixelState::defined:
                return number_text(readout.pixel.value, readout.bar, readout.rounding, 3, "").value;
            case PixelState::undetermined:
                return "?";
            case PixelState::not_a_number:
                return "NaN";
            case PixelState::unphysical:
                return "!";
            case PixelState::not_measured:
            case PixelState::no_light:
            case PixelState::dark:
            case PixelState::undefined:
                break;
        }
        return "-";
    }

private:
    ShownPicture shown_;
    std::optional<ShownQuantity> quantity_;  // none: color
    std::vector<Rgb> weights_;
};

void draw_numbers(const Session& session, const PlacedPicture& placed, ImDrawList& list) {
    const bool is_color = session.view().quantity == Quantity::color;
    const ImVec2 widest = ImGui::CalcTextSize(is_color ? "0.0123\n0.0123\n0.0123" : "-0.00123");
    const double needed = std::max(widest.x, widest.y) + 4.0F;
    if (!session.view().numbers_in_pixels || placed.transform.scale < needed) return;
    const PixelLabels labels(session);
    const StokesImage& picture = session.current()->picture();
    const TileRect seen = visible_pixels(session, placed);
    for (int y = seen.y0; y < seen.y1; ++y) {
        for (int x = seen.x0; x < seen.x1; ++x) {
            const std::string text = labels.text(picture.pixel(x, y));
            const ImVec2 size = ImGui::CalcTextSize(text.c_str());
            const DVec2 middle = placed.window_from_picture({x + 0.5, y + 0.5});
            rimmed_text(list, point(glm::round(middle - 0.5 * DVec2(size.x, size.y))), white_ink, text);
        }
    }
}

void draw_region(const Session& session, const PlacedPicture& placed, ImDrawList& list) {
    const auto& region = session.selection().region;
    if (!region) return;
    const auto at = [&](int x, int y) {
        return point(placed.window_from_picture({static_cast<double>(x), static_cast<double>(y)}));
    };
    const ImVec2 a = at(region->x0, region->y0);
    const ImVec2 b = at(region->x1, region->y1);
    list.AddRect(a, b, rim_color, 0.0F, 0, 3.0F);
    list.AddRect(a, b, white_ink, 0.0F, 0, 1.0F);
}

/// Axes of the frame that the pixel's state is written in.
void draw_frame(const DVec2& center, double clear, const PageAxes& axes, ImDrawList& list) {
    constexpr double length = 26.0;
    const auto draw_axis = [&](const DVec2& along, ImU32 color, const std::string& name) {
        rimmed_arrow(list, point(center + clear * along), point(center + (clear + length) * along), color);
        const DVec2 middle = center + (clear + length + 9.0) * along;
        rimmed_text(list, point(middle - DVec2(3.5, 7.0)), white_ink, name);
    };
    draw_axis(axes.x, IM_COL32(255, 110, 90, 255), "x");
    draw_axis(axes.y, IM_COL32(120, 220, 120, 255), "y");
}

/// Corners of the tiles that workers are at.
void draw_tiles_under_way(const Session& session, const PlacedPicture& placed, ImDrawList& list) {
    constexpr ImU32 color = IM_COL32(255, 214, 10, 140);
    for (const TileRect& tile : session.current()->progress().under_way) {
        const DVec2 low = placed.window_from_picture({1.0 * tile.x0, 1.0 * tile.y0});
        const DVec2 high = placed.window_from_picture({1.0 * tile.x1, 1.0 * tile.y1});
        const DVec2 arm = 0.2 * (high - low);
        for (const DVec2 corner : {low, high, DVec2(low.x, high.y), DVec2(high.x, low.y)}) {
            const DVec2 inward(corner.x == low.x ? arm.x : -arm.x, corner.y == low.y ? arm.y : -arm.y);
            list.AddLine(point(corner), point(corner + DVec2(inward.x, 0.0)), color);
            list.AddLine(point(corner), point(corner + DVec2(0.0, inward.y)), color);
        }
    }
}

void draw_pins(const Session& session, const PlacedPicture& placed, ImDrawList& list) {
    const Selection& selection = session.selection();
    const double half = std::max(4.0, 0.5 * placed.transform.scale);
    for (std::size_t i = 0; i < selection.pins.size(); ++i) {
        const bool is_current = static_cast<int>(i) == selection.current;
        const PixelAddress& pin = selection.pins[i];
        const DVec2 center = placed.window_from_picture({pin.x + 0.5, pin.y + 0.5});
        const ImU32 color = is_current ? pin_ink : white_ink;
        const DVec2 corner(half, half);
        list.AddRect(point(center - corner), point(center + corner), rim_color, 0.0F, 0, 3.5F);
        list.AddRect(point(center - corner), point(center + corner), color, 0.0F, 0, 1.5F);
        if (selection.pins.size() > 1)
            rimmed_text(list, point(center + DVec2(half + 2.0, half - 4.0)), color, std::to_string(i + 1));
        if (is_current) draw_frame(center, half + 1.0, page_axes(session), list);
    }
}

bool same(const ViewTransform& a, const ViewTransform& b) {
    return a.scale == b.scale && a.offset == b.offset;
}

}  // namespace

void PictureOverlay::draw(const Session& session, const PlacedPicture& placed) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ViewRect& viewport = placed.viewport;
    list.PushClipRect(point(viewport.origin), point(viewport.origin + viewport.size), true);
    draw_tiles_under_way(session, placed, list);
    draw_veil(session, placed);
    const TileRect seen = visible_pixels(session, placed);
    if (seen.x0 < seen.x1 && seen.y0 < seen.y1) glyphs_.draw(session, placed, seen);
    draw_numbers(session, placed, list);
    draw_region(session, placed, list);
    draw_pins(session, placed, list);
    list.PopClipRect();
}

void PictureOverlay::draw_veil(const Session& session, const PlacedPicture& placed) {
    const StokesImage& picture = session.current()->picture();
    const std::vector<bool>& marked = session.selection().marked;
    if (marked.size() != picture.pixel_count()) return;
    const ViewTransform& transform = placed.transform;
    const bool is_current = veil_marks_ == session.selection().marked_version && same(veil_transform_, transform) &&
                            veil_view_ == placed.viewport.size;
    if (!is_current) {
        veil_.clear();
        veil_marks_ = session.selection().marked_version;
        veil_transform_ = transform;
        veil_view_ = placed.viewport.size;
        // A cell is a whole number of pixels; it counts as marked if one of them is, so that no marked pixel is lost.
        const int step = std::max(1, static_cast<int>(std::ceil(least_veil_cell / transform.scale)));
        veil_cell_ = static_cast<float>(step * transform.scale);
        const TileRect seen = visible_pixels(session, placed);
        const auto is_marked = [&](int x0, int y0) {
            for (int y = y0; y < std::min(y0 + step, picture.height); ++y) {
                for (int x = x0; x < std::min(x0 + step, picture.width); ++x) {
                    if (marked[picture.pixel(x, y)]) return true;
                }
            }
            return false;
        };
        for (int y = seen.y0 / step * step; y < seen.y1; y += step) {
            int begin = -1;
            for (int x = seen.x0 / step * step; x < seen.x1 + step; x += step) {
                const bool is_veiled = x < seen.x1 && !is_marked(x, y);
                if (is_veiled && begin < 0) begin = x;
                if (is_veiled || begin < 0) continue;
                const DVec2 from = transform.view_from_picture({static_cast<double>(begin), static_cast<double>(y)});
                const DVec2 to = transform.view_from_picture({static_cast<double>(std::min(x, picture.width)), 0.0});
                veil_.push_back({static_cast<float>(from.x), static_cast<float>(to.x), static_cast<float>(from.y)});
                begin = -1;
            }
        }
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 origin = point(placed.viewport.origin);
    for (const VeilRun& run : veil_)
        list.AddRectFilled({origin.x + run.x0, origin.y + run.y}, {origin.x + run.x1, origin.y + run.y + veil_cell_},
                           veil_color);
}

}  // namespace pol
