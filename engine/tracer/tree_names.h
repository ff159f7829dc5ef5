// SPDX-License-Identifier: Apache-2.0
// What the parts of a tree are called, in text, JSON, CSV, OBJ and the window alike (engine/report/README.md), and what
// can be told of a branch from its tree.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "polarization/measures.h"
#include "tracer/explain.h"

namespace pol {

/// "camera", "reflected", "totally reflected", "transmitted", "through sheet": how a branch came to be.
/// `is_total`: see is_total_reflection; asked of reflected branches only.
const char* name_of(Interaction interaction, bool is_total);
const char* interaction_of(const Plan& plan, const Explanation& explanation, int branch);

/// "emitter", "background", "absorbed", or of what was not followed "residual", "depth limit", "node budget",
/// "tail limit", "numerical failure".
const char* name_of(LeafReason reason);
/// What that means, with the option that moves the limit.
const char* help_of(LeafReason reason);

/// What a branch is, as paths are colored and grouped. The mode of a crystal goes before how the branch came to be,
/// what was not followed before both.
enum class PathKind : std::uint8_t { camera, reflected, transmitted, sheet, ordinary, extraordinary, not_followed };
inline constexpr std::array all_path_kinds{PathKind::camera,      PathKind::reflected, PathKind::transmitted,
                                           PathKind::sheet,       PathKind::ordinary,  PathKind::extraordinary,
                                           PathKind::not_followed};
PathKind kind_of(const RayTreeNode& node);
/// "camera", "reflected", "transmitted", "through sheet", "o", "e", "not followed".
const char* name_of(PathKind kind);

/// "right", "left", "linear", "unpolarized", "none" (no light) or "not a number".
const char* handedness_of(const Measures<double>& measures);
/// Measures of the light that arrives at a branch, in its frame. What is below the rounding of the tree's sum is 0.
/// Requires: node.arriving.
Measures<double> measure_arriving(const Explanation& explanation, const RayTreeNode& node);

/// "s/p", "o" or "e".
const char* mode_of(const Wave<double>& wave);

const std::string& medium_name(const Plan& plan, int region);

/// Refractive index that the branch sees: |k|.
double index_of(const RayTreeNode& node);

/// True if the branch was reflected where nothing could get through: behind its parent's end is a medium that is
/// transparent, but no wave in it.
bool is_total_reflection(const Plan& plan, const Explanation& explanation, int branch);

/// True for a leaf whose light was not followed to its source.
bool is_not_followed(LeafReason reason);

}  // namespace pol
