// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "plan/plan.h"
#include "tracer/observers.h"
#include "tracer/trace.h"

namespace pol {

/// One sample by itself, with the kernel that the plan needs: adds its light to `sums`, one Stokes vector per
/// wavelength of the task's group. TraceResult::cancelled once `keep_going` has said no; it is asked after 256 branches
/// each.
TraceResult trace_sample(
    const Plan& plan, const TraceTask& task, std::span<Stokes<double>> sums,
    const KeepGoing& keep_going = [](std::size_t /*branches*/) { return true; });

}  // namespace pol
