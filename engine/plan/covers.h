// SPDX-License-Identifier: Apache-2.0
// Surfaces that lie in a face of a solid or in each other.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/result.h"
#include "plan/plan.h"
#include "scene/scene.h"

namespace pol {

/// Length of the lists by facet.
std::size_t facet_count(const Solid& solid);

/// Adds to one of the lists by facet of a solid.
void add_contact(Solid& solid, std::vector<std::vector<Contact>> Solid::*list, int facet, const Contact& contact);

/// Fills in Solid::covers from plan.solids and plan.surfaces. Error: a sheet in a solid's face would be both inside and
/// outside of it; of two surfaces in one place (not both black) nothing says which one a ray meets.
Result<Done> find_covers(const Scene& scene, Plan& plan);

/// Pairs of bodies ("'a' and 'b'") with faces that lie in one plane but for more than rounding and less than a
/// millionth of the smaller body. They are traced as written, with that gap or that overlap.
std::vector<std::string> near_misses(const Plan& plan);

}  // namespace pol
