// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// The scene of the current document, to edit; of a picture without one, draw_picture_header.
class ScenePanel {
public:
    void draw(const Session& session, Wishes& wishes);

private:
    std::string wavelengths_;  // as being typed
};

}  // namespace pol
