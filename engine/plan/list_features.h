// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plan/plan.h"
#include "scene/scene.h"

namespace pol {

/// What the compiled scene needs and what is left out, each with the reason.
Features list_features(const Scene& scene, const Plan& plan);

}  // namespace pol
