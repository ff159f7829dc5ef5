// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// A file name to type for the scene, while WindowState::save_as_visible. Writes only *.yaml and *.yml, and asks once
/// before it replaces a file that is not the document's own.
class SaveAsDialog {
public:
    void draw(const Session& session, Wishes& wishes);

private:
    void save(const Session& session, Wishes& wishes);

    std::string typed_;
    bool wanted_ = false;               // in the last frame: to save
    bool wished_ = false;               // in the last frame: and the session was to do it
    std::string complaint_;             // why nothing was written
    std::filesystem::path to_replace_;  // asked about: the next press replaces it
};

}  // namespace pol
