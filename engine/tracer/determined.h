// SPDX-License-Identifier: Apache-2.0
// When a sample that no residual was asked for is followed far enough (CUTTING.md 2.1).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "plan/plan.h"
#include "polarization/bounds.h"
#include "polarization/stokes.h"
#include "tracer/trace_task.h"

namespace pol {

/// The least open weight that is followed: less is below the rounding of what is found, and "no light"
/// (maps/evaluate.h) where nothing is.
constexpr double least_open_weight = 1e-13;

/// A sample that surely brings less than this part of the brightest light is dark in most pictures (dark_share in
/// maps/evaluate.h). It gets no more branches in all than dark_budget: enough for nearly every one in a glass stone,
/// while in a crystal, where dark trees end as slowly as bright ones, they would take most of the time.
constexpr double dark_part = 1e-4;
constexpr std::uint32_t dark_budget = 64;

/// Whether what is open of a sample matters to its maps at none of the group's wavelengths. `found`: the light of the
/// sample so far, by wavelength of the group; `nodes`: branches that were followed.
inline bool maps_are_determined(const Plan& plan, const WavelengthGroup& group, std::span<const Stokes<double>> found,
                                double open, std::uint32_t nodes) {
    if (open <= least_open_weight) return true;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double brightest = plan.brightest[static_cast<std::size_t>(group.wavelengths[i])];
        const double missing = open * brightest;
        const bool is_dark = found[i].s0 + missing <= dark_part * brightest;
        if ((!is_dark || nodes < dark_budget) && !is_determined(found[i], missing)) return false;
    }
    return true;
}

/// Whether a sample with so much open is followed further, if its budget allows. `found`, `nodes`: as above.
inline bool goes_on(const TraceTask& task, const Plan& plan, std::span<const Stokes<double>> found, double open,
                    std::uint32_t nodes) {
    if (open > task.residual || !task.until_determined) return open > task.residual;
    return !maps_are_determined(plan, plan.groups[static_cast<std::size_t>(task.group)], found, open, nodes);
}

}  // namespace pol
