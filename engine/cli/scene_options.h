// SPDX-License-Identifier: Apache-2.0
// What the commands that trace a scene have in common: the scene and the settings that may replace those in the file.
#pragma once

#include "cli/command_line.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "core/result.h"
#include "plan/plan.h"
#include "scene/scene.h"

namespace pol {

/// What the command line says of a setting; a flag that is there is true.
using GivenSetting = std::variant<bool, int, double, std::uint64_t, std::string>;

struct SceneOptions {
    std::string scene;
    std::map<std::string_view, GivenSetting> given;  ///< by the keys of scene/setting_table.h

    /// Requires: there is a setting with that key.
    [[nodiscard]] bool gives(std::string_view key) const;
};

/// Adds the scene argument and an option for each setting.
void add_scene_options(ProgramCommand command, SceneOptions& options);

/// The options that are given, as they would be written again: " --mode area --spp 4".
std::string given_text(const SceneOptions& options);

/// The scene with the options in place of its own settings. With a depth limit and no residual, the depth alone cuts
/// the tree, as in the paper.
Result<Scene> load_scene_with(const SceneOptions& options);

/// Loads and compiles.
struct LoadedPlan {
    Scene scene;
    std::shared_ptr<const Plan> plan;
};
Result<LoadedPlan> load_plan(const SceneOptions& options);

/// Says on stderr what the model leaves out though the scene would show it (Features::doubts).
void remark_doubts(const Plan& plan);

}  // namespace pol
