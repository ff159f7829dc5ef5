// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "maps/colorize.h"
#include "viewer/session.h"

namespace pol {

/// Scale and range of the map on screen: what the picture and its color bar share. Offset and gamma, which a photograph
/// has besides, act on the place in the range. Of no meaning for color.
struct MapLook {
    ColorScale scale{};
    MapRange range{};
};

MapLook map_look(const Session& session);
/// Kind of scale on screen: signed for differences, else that of the quantity.
ScaleKind shown_kind(const Session& session);

/// Values at the two ends of the color bar: the range as seen through the offset. Requires: the map is not `color`.
MapRange bar_range(const Session& session);

/// Makes these the ends of the color bar; for color and intensity by exposure and offset. Does nothing unless
/// low < high and both are finite.
void set_bar_range(Session& session, const MapRange& range);
/// The ends that the quantity has of itself.
void reset_bar_range(Session& session);
/// From the smallest to the largest value that the picture has; the same to both sides of 0 for signed quantities. Does
/// nothing for the azimuth, whose scale is closed.
void fit_bar_range(Session& session);

}  // namespace pol
