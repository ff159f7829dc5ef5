// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "viewer/panels/placed_picture.h"
#include "viewer/session/session.h"
#include "viewer/shown/glyphs.h"

namespace pol {

/// Polarization ellipses, azimuth strokes or both over the picture, where they mean something.
class GlyphOverlay {
public:
    /// Requires: a document is shown. `seen`: pixels in the viewport.
    void draw(const Session& session, const PlacedPicture& placed, const TileRect& seen);

private:
    /// What the glyphs were made from.
    struct Source {
        std::uint64_t layout = 0;
        std::uint64_t version = 0;
        std::size_t band = 0;
        int cell = 0;
        std::array<int, 4> seen{};
        Polarimeter polarimeter;
        friend bool operator==(const Source&, const Source&) = default;
    };
    Source source_;
    std::vector<Glyph> glyphs_;
};

}  // namespace pol
