// SPDX-License-Identifier: Apache-2.0
#include "viewer/map_look.h"

namespace pol {

MapLook map_look(const Session& session) {
    const ViewSettings& view = session.view;
    const MapOptions options{view.style, view.range[static_cast<std::size_t>(view.quantity)], view.exposure};
    return {view.scale.value_or(scale_for(view.quantity, view.style)),
            range_for(view.quantity, options, session.shown_map.summary().high)};
}

}  // namespace pol
