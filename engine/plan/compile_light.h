// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/result.h"
#include "plan/plan.h"
#include "scene/scene.h"

namespace pol {

/// A sheet whose axis is given in object space, in world space.
Sheet sheet_in_world(const Sheet& sheet, const DMat4& to_world);

/// Crystals of the virtual plates of all emitters at one wavelength, in the order of plan.emitters; emitters without a
/// plate have an isotropic stand-in.
Result<std::vector<Dielectric<double>>> plate_crystals(const Scene& scene, const Plan& plan, double wavelength_nm);
/// Whether the plates of wavelength group `group` are these.
bool same_plates(const Plan& plan, int group, const std::vector<Dielectric<double>>& plates);
/// Adds a wavelength group to the plates.
void append_plates(Plan& plan, const std::vector<Dielectric<double>>& plates);

/// Fills in radiance, state and brightest of every emitter, the background and Plan::brightest. Error: a spectrum
/// outside its table, a polarized emitter inside a crystal.
Result<Done> compile_light(const Scene& scene, Plan& plan);

}  // namespace pol
