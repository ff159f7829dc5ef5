// SPDX-License-Identifier: Apache-2.0
// Where a ray may begin: a coherence matrix is written in an isotropic medium that lets light pass.
#pragma once

#include "plan/plan.h"

namespace pol {

/// Radiance is defined where a wave keeps its power over many wavelengths.
constexpr double strongest_camera_extinction = 0.01;

bool is_isotropic(const Plan& plan, int region);

/// Isotropic, and absorbing too little for a wave to notice at any wavelength.
bool is_fit_for_camera(const Plan& plan, int region);

/// The lamp or absorber whose closed body `point` is in, or null: it is seen from outside only.
const Surface* body_around(const Plan& plan, const DVec3& point);

}  // namespace pol
