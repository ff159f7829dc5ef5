// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/hover_readout.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "maps/error_bars.h"
#include "viewer/pages/pixel_readout.h"
#include "viewer/pages/readout_text.h"

namespace pol {

namespace {

std::string first_line(const Session& session, const PixelReadout& readout, bool is_pinned) {
    const Quantity quantity = session.view().quantity;
    const StokesImage& picture = session.current()->picture();
    const std::string place = fmt::format("x {}  y {}{}", picture.left + readout.address.x,
                                          picture.top + readout.address.y, is_pinned ? " (pinned)" : "");
    const std::string polarimeter = session.polarimeter().empty() ? "" : "  behind the polarimeter";
    if (quantity == Quantity::color) {
        const double size =
            std::max({std::abs(readout.color[0]), std::abs(readout.color[1]), std::abs(readout.color[2])});
        return fmt::format("{}  linear sRGB {}  {}  {}{}", place, short_number(readout.color[0], 4, size),
                           short_number(readout.color[1], 4, size), short_number(readout.color[2], 4, size),
                           polarimeter);
    }
    const std::string band = band_text(readout.bands[session.view().band].band);
    if (session.comparison()) {
        const ShownQuantity both = session.shown_quantity();
        const std::size_t pixel = session.current()->picture().pixel(readout.address.x, readout.address.y);
        if (info(quantity).of_two)
            return fmt::format("{}  {} from {}: {}  {}{}", place, info(quantity).title, session.reference()->name(),
                               readout_text(quantity, both.readout(pixel)), band, polarimeter);
        return fmt::format("{}  {} {} minus {}: {}  {}{}", place, info(quantity).title,
                           value_text(quantity, both.own(pixel), 6), value_text(quantity, both.of_reference(pixel), 6),
                           readout_text(quantity, both.readout(pixel)), band, polarimeter);
    }
    const QuantityReadout value = readout.quantity(quantity, session.view().band);
    return fmt::format("{}  {} {}  {}{}", place, info(quantity).title, readout_text(quantity, value), band,
                       polarimeter);
}

std::string second_line(const Session& session, const PixelReadout& readout) {
    const PixelLight& light = readout.bands[session.view().band].light;
    const Stokes<double>& s = light.stokes;
    const auto bars = stokes_bars(light);
    const auto number = [&](unsigned component, double value, Interval<double> MeasureBounds<double>::*bar) {
        if (!light.known.has(component)) return std::string(state_text(PixelState::not_measured));
        const auto interval = bars ? std::optional((*bars).*bar) : std::nullopt;
        return number_text(value, interval, rounding_of(light), 5, "").value;
    };
    using Bars = MeasureBounds<double>;
    std::string text = fmt::format("S0 {}  S1 {}  S2 {}  S3 {}", number(0, s.s0, &Bars::s0), number(1, s.s1, &Bars::s1),
                                   number(2, s.s2, &Bars::s2), number(3, s.s3, &Bars::s3));
    if (readout.has_residual) text += fmt::format("  not traced {}", short_number(light.residual, 3));
    if (readout.samples) text += fmt::format("  samples {}", *readout.samples);
    if (readout.failures && *readout.failures > 0) text += fmt::format("  failed {}", *readout.failures);
    if (session.view().convention != Convention{}) text += "  " + session.view().convention.stokes_text();
    // The inspector may write the same light in another frame.
    if (session.page().frame != FrameChoice::camera) text += "  camera frame";
    return text;
}

}  // namespace

float hover_readout_height() {
    return 2.0F * ImGui::GetTextLineHeightWithSpacing();
}

void draw_hover_readout(const Session& session) {
    const auto& hovered = session.selection().hovered;
    const auto at = hovered ? hovered : session.selection().pinned();
    if (!at) {
        ImGui::TextDisabled("Click a pixel to pin it; drag to pan; wheel to zoom; Shift and drag for a region");
        return;
    }
    const PixelReadout readout = read_pixel(session, *at);
    ImGui::TextUnformatted(first_line(session, readout, !hovered).c_str());
    ImGui::TextUnformatted(second_line(session, readout).c_str());
}

}  // namespace pol
