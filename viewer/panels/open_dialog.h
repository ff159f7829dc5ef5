// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// A file name to type, with the folder's scenes and pictures below it, while WindowState::path_entry_visible.
class OpenDialog {
public:
    void draw(const Session& session, Wishes& wishes);

private:
    void look();

    std::string typed_;
    std::string looked_for_;                      // typed_ when matches_ was made
    bool wished_ = false;                         // in the last frame: to open typed_
    std::string refused_;                         // why the file could not be opened
    std::vector<std::filesystem::path> matches_;  // folders first
};

}  // namespace pol
