// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>

#include "viewer/pages/thumbnail.h"
#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// All that is open: thumbnail, name, size and bands, with the reference marked. A click shows a picture, the cross
/// closes it.
class PicturesPanel {
public:
    /// Worth a place in the window: with one picture there is nothing to choose.
    [[nodiscard]] static bool is_needed(const Session& session) { return session.documents().size() > 1; }
    void draw(const Session& session, Wishes& wishes);

private:
    struct Kept {
        Thumbnail thumbnail;
        std::uint64_t version = 0;
        double made_s = 0.0;  // on ImGui's clock
    };
    const Thumbnail& thumbnail(const Document& document);

    std::map<std::uint64_t, Kept> kept_;  // by picture layout
};

}  // namespace pol
