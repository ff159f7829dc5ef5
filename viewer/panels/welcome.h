// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "viewer/session/session.h"

namespace pol {

/// What stands in place of the picture while nothing is open: how to open something, and the scenes that are shipped.
class Welcome {
public:
    void draw(Session& session);

private:
    bool looked_ = false;
    std::vector<std::filesystem::path> shipped_;
};

}  // namespace pol
