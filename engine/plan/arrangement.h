// SPDX-License-Identifier: Apache-2.0
// Which solids share volume and faces, and the regions of space that follow from it.
#pragma once

#include <vector>

#include "core/result.h"
#include "plan/plan.h"
#include "scene/scene.h"

namespace pol {

/// Fills in Solid::contacts, Solid::covers and Plan::regions (all but Region::medium of the ambient region, which is
/// entry 0) from plan.solids and plan.surfaces. Error: solids that overlap without a priority, surfaces in one place
/// (plan/covers.h), or Embree.
Result<Done> arrange(const Scene& scene, Plan& plan);

}  // namespace pol
