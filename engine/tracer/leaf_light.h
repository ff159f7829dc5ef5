// SPDX-License-Identifier: Apache-2.0
// What an emitter sends along a backward ray, gathered to the camera.
#pragma once

#include <span>
#include <vector>

#include "core/vec.h"
#include "plan/emitter.h"
#include "polarization/stokes.h"
#include "tracer/node.h"

namespace pol {

/// Stokes vector at the camera, per unit radiance of the emitter, of its light along -node.wave.ray (basic radiance: no
/// n^2 factor). `normal` leans towards the light's way out, `n` is the index of the isotropic medium there. In a crystal
/// each mode carries half the radiance.
Stokes<double> emitted_state(const Emitter& emitter, int group, const Node& node, const DVec3& normal, double n);

/// Appends radiance(wavelength) * state for each of `wavelengths`; `uv` is the place on a textured surface.
void emitted_radiance(const Emitter& emitter, std::span<const int> wavelengths, const DVec2& uv, const Stokes<double>& state,
                      std::vector<Stokes<double>>& light);

}  // namespace pol
