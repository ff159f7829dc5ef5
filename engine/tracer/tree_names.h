// SPDX-License-Identifier: Apache-2.0
// What the parts of a tree are called, and what can be told of a branch from its tree.
#pragma once

#include <string>

#include "tracer/explain.h"

namespace pol {

/// "camera", "reflected", "transmitted", "through sheet".
const char* name_of(Interaction interaction);

/// "emitter", "background", ..., with the option that moves the limit.
const char* name_of(LeafReason reason);

/// "s/p", "o" or "e".
const char* mode_of(const Wave<double>& wave);

const std::string& medium_name(const Plan& plan, int region);

/// Refractive index that the branch sees: |k|.
double index_of(const RayTreeNode& node);

/// True if the branch was reflected where nothing could get through: behind its parent's end is a medium that is
/// transparent, but no wave in it.
bool is_total_reflection(const Plan& plan, const Explanation& explanation, int branch);

/// True for a leaf whose light was not followed to its source.
bool is_unresolved(LeafReason reason);

}  // namespace pol
