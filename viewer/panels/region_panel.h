// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "viewer/pages/region_page.h"
#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// Statistics of the selected region, and how far it is from the reference.
class RegionPanel {
public:
    void draw(const Session& session, Wishes& wishes);

private:
    std::optional<RegionPageKey> key_;  // that page_ was made for
    RegionPage page_;
    double made_s_ = 0.0;  // on ImGui's clock
};

}  // namespace pol
