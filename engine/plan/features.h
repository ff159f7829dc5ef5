// SPDX-License-Identifier: Apache-2.0
// What a scene needs of the tracer and what was left out, with the reason: shown by `polariscope plan`.
#pragma once

#include <string>
#include <vector>

#include "plan/spare_parts.h"

namespace pol {

/// One line of the plan's account.
struct Feature {
    std::string name;  ///< "dispersion", "crystals", ...
    bool needed = false;
    std::string reason;  ///< by which object, or why not
    /// Of a feature that was left out: its code, which compile() can keep. Null: there is none that would run.
    bool SpareParts::*spare = nullptr;
};

/// The account for the user, and what makes bounds less than bounds.
struct Features {
    bool meshes = false;  ///< an Embree scene is built
    std::string kernel;   ///< name of the kernel that will run
    std::vector<Feature> list;
    /// What the model of light leaves out though this scene would show it, a sentence each (coherence.h). Where there
    /// is one, bounds are those of the model and not of the truth.
    std::vector<std::string> doubts;
};

}  // namespace pol
