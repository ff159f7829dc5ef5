// SPDX-License-Identifier: Apache-2.0
// What the commands that trace a scene have in common: the scene and the settings that may replace those in the file.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/result.h"
#include "plan/plan.h"
#include "scene/scene.h"

namespace CLI {
class App;
}

namespace pol {

struct SceneOptions {
    std::string scene;
    std::optional<std::string> size;  ///< "WxH"
    std::optional<int> samples;
    std::optional<std::string> mode;
    std::optional<double> residual;
    std::optional<int> depth;
    std::optional<int> node_budget;
    std::optional<std::string> wavelengths;
    std::optional<std::uint64_t> seed;
    bool unpolarized = false;
};

/// Adds the scene argument and the options above.
void add_scene_options(CLI::App& command, SceneOptions& options);

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
