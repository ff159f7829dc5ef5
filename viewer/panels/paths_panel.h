// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "viewer/pages/path_list.h"
#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// The backward paths of the pinned pixel as a tree: sorted, filtered, with the selected branch in numbers below.
class PathsPanel {
public:
    void draw(const Session& session, Wishes& wishes);

private:
    void draw_controls(const Plan& plan);
    void draw_rows(const Session& session, Wishes& wishes, float height);

    PathList list_;
    std::optional<int> scrolled_to_;  ///< selection that the list was last scrolled to
};

}  // namespace pol
