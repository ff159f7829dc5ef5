// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pol {

/// Line and column (from 1) in the scene file where a thing was written; 0 if it was made by a program.
struct SourcePlace {
    int file = 0;  ///< index into Scene::files
    int line = 0;
    int column = 0;
};

}  // namespace pol
