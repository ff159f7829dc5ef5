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

}  // namespace pol
