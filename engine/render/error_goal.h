// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plan/plan.h"

namespace pol {

/// An error that a picture is to fall below, relative to it, and how it is split: truncation may take
/// `truncation_share` of it, sampling the rest, so that their sum stays below it whatever their signs.
struct ErrorGoal {
    double error = 0.0;
    double truncation_share = 0.5;

    [[nodiscard]] double truncation() const { return truncation_share * error; }
    [[nodiscard]] double sampling() const { return error - truncation(); }
};

/// The split that costs least, from a few hundred trees of the plan that are followed to its residual and to an eighth
/// of it. Sampling to the error e costs e^(-4/3) samples (CUTTING.md 4), each of n branches, which grow with the
/// logarithm of the share t that truncation may take: dn/dt = -b/t. So n (1 - t)^(-4/3) is least at t = r/(r + 4/3)
/// with r = b/n, a few hundredths in glass. Within 0.01 and 0.5. Half where the depth cuts the trees, which no residual
/// changes; all of it in mode point, which samples nothing.
ErrorGoal cheapest_goal(const Plan& plan, double error);

/// Residual (RenderSettings) at which truncation should be below its share of the goal, at most the plan's own: from
/// as many trees. The plan's own where none is found: the trees meet no light, or no residual changes them. A guess
/// that saves a first round; the rule judges by the whole picture (finer_residual).
double residual_for(const Plan& plan, const ErrorGoal& goal);

}  // namespace pol
