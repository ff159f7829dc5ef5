// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/result.h"
#include "plan/plan.h"
#include "scene/scene.h"

namespace pol {

/// Turns the user's document into the immutable plan that workers read. Errors: whatever scene/check has to say about
/// the scene, and what it cannot see without geometry (overlapping solids, impossible shapes, a camera inside a
/// crystal), each with the place in the scene file.
Result<std::shared_ptr<const Plan>> compile(const Scene& scene, const SpareParts& kept = {});

}  // namespace pol
