// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "plan/plan.h"
#include "tracer/explain.h"

namespace pol {

/// The explanation for a person: matrix, frame, measures with error bars, and the tree down to branches of weight
/// `least_share`.
std::string explanation_as_text(const Plan& plan, const Explanation& explanation, double least_share);

/// The same for a program: every branch, numbers that read back to the same bits. What the keys mean:
/// engine/report/README.md.
std::string explanation_as_json(const Plan& plan, const Explanation& explanation);

}  // namespace pol
