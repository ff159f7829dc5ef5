// SPDX-License-Identifier: Apache-2.0
#include "cli/render_display.h"

#include <fmt/format.h>

#include <utility>

#include "cli/messages.h"
#include "film/band.h"
#include "io/live/live_address.h"

namespace pol {

Result<std::unique_ptr<RenderDisplay>> RenderDisplay::open(const std::string& address, const std::string& name,
                                                           const Plan& plan, const Renderer& renderer) {
    const auto where = read_live_address(address);
    if (!where) {
        Error error = where.error();
        error.field = "--display";
        return error;
    }
    LiveSource source;
    source.name = name;
    source.width = plan.settings.width;
    source.height = plan.settings.height;
    source.bands = bands_at(plan.wavelengths_nm);
    const Film& film = renderer.film();
    source.tile_count = [&film] { return film.tile_count(); };
    source.tile_if_newer = [&film](int tile, Version& seen) { return film.tile_if_newer(tile, seen); };
    return std::unique_ptr<RenderDisplay>(new RenderDisplay(where.value(), std::move(source)));
}

void RenderDisplay::finish() {
    constexpr double patience_s = 10.0;  // the last tiles of a large picture; one that stands still is given up before
    const Result<Done> sent = sender_.finish(patience_s);
    if (!sent) remark(fmt::format("the display at {} does not show all of it: {}\n", where_, sent.error().what));
}

}  // namespace pol
