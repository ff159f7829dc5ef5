// SPDX-License-Identifier: Apache-2.0
// A scene's twin: the same scene without the effect that one wants to see.
#pragma once

#include <string>

#include "core/result.h"
#include "scene/scene.h"

namespace pol {

/// Every crystal replaced by a glass that has the mean permittivity of the crystal, tr(epsilon)/3 (the permittivity
/// averaged over all directions of E): n^2 = (2 n_o^2 + n_e^2)/3, and alpha = (2 alpha_o + alpha_e)/3. At the
/// wavelengths of the scene's render settings. Virtual crystal plates of emitters stay: they belong to the light.
/// Error: an index is not known at one of the wavelengths; kind usage if the scene has no crystal.
Result<Scene> isotropic_twin(const Scene& scene);

/// What a renderer without polarization would show: light is unpolarized again after every surface.
Scene unpolarized_twin(Scene scene);

/// "calcite.yaml" and "isotropic" give "calcite-isotropic.yaml".
std::string twin_name(const std::string& name, const std::string& kind);

}  // namespace pol
