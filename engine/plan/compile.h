// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/result.h"
#include "plan/plan.h"
#include "scene/scene.h"

namespace pol {

/// How flat convex solids are met.
enum class SolidKernel {
    half_spaces,  ///< all their planes in double
    embree,       ///< as any other mesh: another way to the same hits, for checks
};

/// Turns the user's document into the immutable plan that workers read. Errors: whatever scene/check has to say about
/// the scene, and what it cannot see without geometry (overlapping solids, impossible shapes, a camera inside a
/// crystal), each with the place in the scene file. With SolidKernel::embree, touching solids are refused, too: only
/// half-spaces tell which of their facets coincide.
Result<std::shared_ptr<const Plan>> compile(const Scene& scene, SolidKernel kernel = SolidKernel::half_spaces);

}  // namespace pol
