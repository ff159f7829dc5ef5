// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "viewer/pages/path_list.h"
#include "viewer/session/session.h"

namespace pol {

/// The backward paths of the pinned pixel as a tree: sorted, filtered, with the selected branch in numbers below.
class PathsPanel {
public:
    void draw(Session& session);

private:
    void draw_controls(Session& session);
    void draw_rows(Session& session, float height);

    PathList list_;
    std::optional<int> scrolled_to_;  ///< selection that the list was last scrolled to
};

}  // namespace pol
