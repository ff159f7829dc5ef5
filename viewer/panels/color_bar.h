// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// Height of draw_color_bar() in points: title and legend, bar, ticks.
float color_bar_height();

/// Title of the map, legend of the pixels without a value with their share, color scale with ticks, unit and, if it is
/// signed, what the signs are called in the shown convention. The ends
/// of the bar can be dragged, a double click gives them back; the right button types numbers.
class ColorBar {
public:
    void draw(const Session& session, Wishes& wishes, float width);

private:
    enum class Handle { none, low, high, both };
    void edit(const Session& session, Wishes& wishes, float width);

    Handle handle_ = Handle::none;
    MapRange grabbed_{};
};

/// The cyclic scale as a wheel: every direction in the color of light that swings along it. `center` in window points.
void draw_azimuth_wheel(const Session& session, const DVec2& center, double radius);

}  // namespace pol
