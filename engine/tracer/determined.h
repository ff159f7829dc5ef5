// SPDX-License-Identifier: Apache-2.0
// When a sample that no residual was asked for is followed far enough (CUTTING.md 2.1).
#pragma once

#include <cstdint>

#include "plan/plan.h"
#include "polarization/bounds.h"
#include "tracer/trace_task.h"

namespace pol {

/// The least open weight that is followed: less is below the rounding of what is found, and "no light"
/// (maps/evaluate.h) where nothing is.
constexpr double least_open_weight = 1e-13;

/// A sample that surely brings less than this part of the brightest light is dark in most pictures (dark_share in
/// maps/evaluate.h). It gets no more branches in all than dark_budget: enough for nearly every one in a glass stone,
/// while in a crystal, where dark trees end as slowly as bright ones, they would take most of the time.
constexpr double dark_part = 1e-4;
constexpr std::uint32_t dark_budget = 48;

/// Whether what is open of a sample matters to its maps no more, if the radiance of every lamp is its luminance.
/// Whatever wavelengths share the tree, they find the same answer.
inline bool maps_are_determined(const WavelengthGroup& group, const TraceResult& found, double open) {
    if (open <= least_open_weight) return true;
    const double missing = open * group.brightest_luminance;
    const bool is_dark = found.seen.s0 + missing <= dark_part * group.brightest_luminance;
    return (is_dark && found.nodes >= dark_budget) || is_determined(found.seen, missing);
}

/// Whether a sample with so much open is followed further, if its budget allows. `residual` and `until_determined` as
/// TraceTask has them.
inline bool is_followed(double residual, bool until_determined, const WavelengthGroup& group, const TraceResult& found,
                        double open) {
    return open > residual || (until_determined && !maps_are_determined(group, found, open));
}

}  // namespace pol
