// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viewer/session/session.h"

namespace pol {

/// A file name to type, with the folder's scenes and pictures below it, while session.window.path_entry_visible.
class OpenDialog {
public:
    void draw(Session& session);

private:
    void look();

    std::string typed_;
    std::string looked_for_;                      // typed_ when matches_ was made
    bool was_refused_ = false;                    // in the last frame
    std::string refused_;                         // why the file could not be opened
    std::vector<std::filesystem::path> matches_;  // folders first
};

}  // namespace pol
