// SPDX-License-Identifier: Apache-2.0
// The one place where a plan gets the kernel that its media need.
#pragma once

#include <utility>

#include "plan/plan.h"

namespace pol {

/// A plan, and in its type the kernel that it needs. Only with_kernel() makes one: a crystal is never traced as glass.
template <bool anisotropic, bool absorbing>
class PlanForKernel {
public:
    [[nodiscard]] const Plan& plan() const { return plan_; }

private:
    template <class Use>
    friend decltype(auto) with_kernel(const Plan& plan, Use&& use);
    explicit PlanForKernel(const Plan& plan) : plan_(plan) {}

    const Plan& plan_;
};

/// Calls use(PlanForKernel<anisotropic, absorbing>), of which a Tracer is made, with what plan.kernel() says. The plan
/// must outlive what `use` makes of it.
template <class Use>
decltype(auto) with_kernel(const Plan& plan, Use&& use) {
    const Kernel kernel = plan.kernel();
    if (kernel.anisotropic) {
        if (kernel.absorbing) return std::forward<Use>(use)(PlanForKernel<true, true>(plan));
        return std::forward<Use>(use)(PlanForKernel<true, false>(plan));
    }
    if (kernel.absorbing) return std::forward<Use>(use)(PlanForKernel<false, true>(plan));
    return std::forward<Use>(use)(PlanForKernel<false, false>(plan));
}

}  // namespace pol
