// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "plan/plan.h"

namespace pol {

/// What this scene would show and powers that are added cannot: one sentence per solid or gap, thinnest first, empty
/// for everyday scenes. It names whatever lies between two parallel faces (within 1e-3 rad) so near each other that
/// light of the picture's wavelengths is still coherent after it: where the rays o and e of a crystal, or two passes,
/// differ in optical path by less than lambda^2 over the band width. The band of a wavelength is the distance to its
/// neighbor, that of a single one is 10 nm, an interference filter. Faces are those of flat solids, closed meshes of up
/// to 20000 facets and nested spheres; what swallows all light on the way or is a metal is left out.
///
/// `unit_nm`: nanometres per scene unit. Requires: the plan is complete but for its doubts.
std::vector<std::string> coherence_doubts(const Plan& plan, double unit_nm);

}  // namespace pol
