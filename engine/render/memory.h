// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plan/plan.h"

namespace pol {

/// Whether the machine would give the memory that a render takes at its end, when the sums and the picture made of them
/// stand side by side. Nothing is touched: a system that promises more than it has is not found out.
bool fits_memory(const Plan& plan);

}  // namespace pol
