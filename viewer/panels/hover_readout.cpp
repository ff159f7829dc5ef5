// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/hover_readout.h"

#include <fmt/format.h>
#include <imgui.h>

#include <string>

#include "viewer/pixel_reading.h"
#include "viewer/reading_text.h"

namespace pol {

namespace {

std::string first_line(const Session& session, const PixelReading& reading, bool is_pinned) {
    const Quantity quantity = session.view.quantity;
    const std::string place =
        fmt::format("x {}  y {}{}", reading.address.x, reading.address.y, is_pinned ? " (pinned)" : "");
    const std::string bench = session.bench.empty() ? "" : "  behind the bench";
    if (quantity == Quantity::color) {
        return fmt::format("{}  linear sRGB {}  {}  {}{}", place, short_number(reading.color[0], 4),
                           short_number(reading.color[1], 4), short_number(reading.color[2], 4), bench);
    }
    const double nm = reading.wavelengths[session.view.wavelength].wavelength_nm;
    if (session.comparison()) {
        const ShownQuantity both = session.shown_quantity();
        const std::size_t pixel = session.current()->picture().pixel(reading.address.x, reading.address.y);
        const auto text = [&](const MapPixel& value) { return reading_text(quantity, {value, std::nullopt}); };
        return fmt::format("{}  {} {} minus {}: {}  {:.6g} nm{}", place, info(quantity).title, text(both.own(pixel)),
                           text(both.of_reference(pixel)), text(both.at(pixel)), nm, bench);
    }
    const QuantityReading value = reading.quantity(quantity, session.view.wavelength);
    return fmt::format("{}  {} {}  {:.6g} nm{}", place, info(quantity).title, reading_text(quantity, value), nm, bench);
}

std::string second_line(const Session& session, const PixelReading& reading) {
    const PixelLight& light = reading.wavelengths[session.view.wavelength].light;
    const Stokes<double>& s = light.stokes;
    std::string text = fmt::format("S0 {}  S1 {}  S2 {}  S3 {}", short_number(s.s0, 5), short_number(s.s1, 5),
                                   short_number(s.s2, 5), short_number(s.s3, 5));
    text += fmt::format("  not traced {}", short_number(light.residual, 3));
    if (reading.samples) text += fmt::format("  samples {}", *reading.samples);
    if (reading.failures && *reading.failures > 0) text += fmt::format("  failed {}", *reading.failures);
    return text;
}

}  // namespace

float hover_readout_height() {
    return 2.0F * ImGui::GetTextLineHeightWithSpacing();
}

void draw_hover_readout(const Session& session) {
    const auto& hovered = session.selection.hovered;
    const auto at = hovered ? hovered : session.selection.pinned();
    if (!at) {
        ImGui::TextDisabled("Click a pixel to pin it; drag to pan; wheel to zoom; Shift and drag for a region");
        return;
    }
    const PixelReading reading = read_pixel(session, *at);
    ImGui::TextUnformatted(first_line(session, reading, !hovered).c_str());
    ImGui::TextUnformatted(second_line(session, reading).c_str());
}

}  // namespace pol
