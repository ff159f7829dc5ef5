// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "plan/plan.h"

namespace pol {

/// Why the kernel that follows several branches side by side (tracer/lane_tracer.h) does not know this plan; empty if
/// it does. The picture is the same to the bit either way.
std::string why_not_in_lanes(const Plan& plan);

}  // namespace pol
