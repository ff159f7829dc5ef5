// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "maps/colorize.h"
#include "viewer/session/session.h"

namespace pol {

/// How the map on screen is colored, with the words of its color bar.
MapOptions map_options(const Session& session);
/// Its scale: what the picture and its color bar share. Offset and gamma, which a photograph has besides, act on the
/// place in the range. Of color only the kind means something.
MapScale map_look(const Session& session);

/// Values at the two ends of the color bar: the range as seen through the offset. Requires: the map is not `color`.
MapRange bar_range(const Session& session);

/// Makes these the ends of the color bar; for color and intensity by exposure and offset. Does nothing unless
/// low < high and both are finite.
void set_bar_range(Session& session, const MapRange& range);
/// The ends that the quantity has of itself.
void reset_bar_range(Session& session);
/// Whether the ends can be moved: not those of the azimuth, whose scale is closed. Its differences may have a signed
/// scale over a part of the cycle.
bool can_move_range(const Session& session);
/// From the smallest to the largest value that the picture has; the same to both sides of 0 for signed quantities. Does
/// nothing unless can_move_range().
void fit_bar_range(Session& session);

}  // namespace pol
