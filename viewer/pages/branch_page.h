// SPDX-License-Identifier: Apache-2.0
// One branch of a tree as text: what it met, what it carries. No ImGui.
#pragma once

#include <string>

#include "tracer/explain.h"
#include "viewer/pages/pixel_page.h"

namespace pol {

/// "reflected o calcite", "transmitted glass", "totally reflected glass": how the branch came to be and where it goes.
std::string branch_title(const Plan& plan, const Explanation& explanation, int branch, bool is_total_reflection);

/// Where it ends: "cube 3" (object and facet), "light" (an emitter), "background", or why it was not followed.
std::string branch_end(const Plan& plan, const Explanation& explanation, int branch);

/// All numbers of a branch, in the engine's conventions.
PageGroup make_branch_page(const Plan& plan, const Explanation& explanation, int branch);

}  // namespace pol
