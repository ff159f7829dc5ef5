// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "report/ray_table.h"
#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// The ray states of the pinned pixel's tree as a table that can be sorted by any column and exported.
class RayTablePanel {
public:
    void draw(const Session& session, Wishes& wishes);

private:
    /// Row order for the column that the user sorts by.
    void sort(int column, bool descending);
    void draw_table(const Session& session, Wishes& wishes);

    std::shared_ptr<const Plan> plan_;
    std::shared_ptr<const Explanation> explanation_;
    std::optional<RayTable> rays_;  ///< of the two above
    std::vector<int> order_;        ///< branches, as they are shown
    int sorted_by_ = 0;             ///< column
    bool descending_ = false;
    std::optional<int> scrolled_to_;
};

}  // namespace pol
