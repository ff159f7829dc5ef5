// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "viewer/session/session.h"

namespace pol {

/// A file name to type for the scene, while session.window.save_as_visible. Writes only *.yaml and *.yml, and asks once
/// before it replaces a file that is not the document's own.
class SaveAsDialog {
public:
    void draw(Session& session);

private:
    void save(Session& session);

    std::string typed_;
    bool was_refused_ = false;          // in the last frame
    std::string complaint_;             // why nothing was written
    std::filesystem::path to_replace_;  // asked about: the next press replaces it
};

}  // namespace pol
