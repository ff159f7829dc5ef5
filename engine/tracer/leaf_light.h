// SPDX-License-Identifier: Apache-2.0
// What an emitter or the background sends along a backward ray, gathered to the camera through the ray's throughput.
#pragma once

#include <span>

#include "plan/plan.h"
#include "polarization/stokes.h"
#include "tracer/crossing.h"
#include "tracer/node.h"

namespace pol {

/// Light of the uniform surroundings on a ray that leaves the scene, one Stokes vector per wavelength of the group.
/// camera_n: index at the camera; radiance there is n_camera^2 times basic radiance (PHYSICS.md 2.3). Returns the light
/// that it would be if the radiance were the luminance, which no list of wavelengths changes.
Stokes<double> background_light(const Plan& plan, const WavelengthGroup& group, const Node& node, double camera_n,
                                std::span<Stokes<double>> light);

/// False: the emitter's linear polarization is counted from an axis that lies along this ray, to 1e-12 rad, and so has
/// no direction.
bool has_state_along(const Emitter& emitter, const DVec3& ray);

/// The same of an emitter that the ray has met at node.origin. In a crystal each mode carries half the radiance.
Stokes<double> emitter_light(const Plan& plan, int group, const Emitter& emitter, const Node& node,
                             const Crossing& crossing, double camera_n, std::span<Stokes<double>> light);

}  // namespace pol
