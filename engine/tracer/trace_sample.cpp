// SPDX-License-Identifier: Apache-2.0
#include "tracer/trace_sample.h"

namespace pol {

TraceResult trace_sample(const Plan& plan, const TraceTask& task, std::span<Stokes<double>> sums,
                         const KeepGoing& keep_going) {
    Patient patient{{}, &keep_going};
    return with_kernel(plan, [&](auto plan_for_kernel) { return Tracer(plan_for_kernel, patient).trace(task, sums); });
}

}  // namespace pol
