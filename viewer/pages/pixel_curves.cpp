// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "viewer/pages/page_frame.h"
#include "viewer/pages/pixel_page.h"
#include "viewer/pages/pixel_readout.h"
#include "viewer/pages/readout_text.h"

namespace pol {

std::vector<PageCurve> spectrum_curves(const Session& session) {
    const PixelReadout readout = read_pixel(session, *session.selection().pinned(), Convention{});
    const double angle = shown_angle(session);
    std::vector<PageCurve> curves;
    PageCurve s0{"S0", {}, {}, 0.0, 0.0, false};
    for (const BandReadout& at : readout.bands) {
        const double value = at.light.stokes.s0;
        if (!at.light.known.has(0)) {
            s0.texts.emplace_back(state_text(PixelState::not_measured));
            s0.values.emplace_back();
            continue;
        }
        const auto bars = stokes_bars(at.light);
        const NumberText text =
            number_text(value, bars ? std::optional(bars->s0) : std::nullopt, rounding_of(at.light), 6, "");
        s0.texts.push_back(std::isfinite(value) ? text.value + (text.bar.empty() ? "" : " " + text.bar)
                                                : std::string(state_text(PixelState::not_a_number)));
        s0.values.push_back(std::isfinite(value) ? std::optional(value) : std::nullopt);
        if (std::isfinite(value)) s0.high = std::max(s0.high, value);
    }
    curves.push_back(std::move(s0));
    for (const Quantity quantity : {Quantity::dop, Quantity::azimuth, Quantity::ellipticity}) {
        const QuantityInfo& about = info(quantity);
        PageCurve curve{std::string(about.title), {}, {}, about.low, about.high, about.kind == ScaleKind::cyclic};
        if (!about.unit.empty()) curve.name += fmt::format(" ({})", about.unit);
        for (const BandReadout& at : readout.bands) {
            PixelLight light = at.light;
            light.known = known_in_frame(at.light.known, angle);
            light.stokes = session.view().convention.stokes(only(light.known, rotate_basis(at.light.stokes, angle)));
            const QuantityReadout shown = read_light(light, quantity, 1.0);
            const MapPixel& pixel = shown.pixel;
            curve.values.push_back(pixel.state == PixelState::defined ? std::optional(pixel.value) : std::nullopt);
            curve.texts.push_back(readout_text(quantity, shown));
        }
        curves.push_back(std::move(curve));
    }
    return curves;
}

}  // namespace pol
