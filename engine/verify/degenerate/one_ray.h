// SPDX-License-Identifier: Apache-2.0
// Scenes of one pixel, made in memory by the thousand, with settings that no text needs to survive, and the light that
// the renderer finds in it.
#pragma once

#include <string>

#include "core/vec.h"
#include "polarization/stokes.h"
#include "scene/scene.h"

namespace pol::verify {

/// What the renderer makes of the middle ray of a scene.
struct OneRay {
    Stokes<double> light{};
    double untraced = 0.0;  ///< residual and tail: the share that is missing or estimated
};

/// Renders the scene as one pixel. Every number is NaN if the scene is refused or its arithmetic failed.
OneRay look(const Scene& scene);

/// Orthographic camera at `from` that looks along `direction`, its picture's x axis across `up`.
Camera camera_at(const DVec3& from, const DVec3& direction, const DVec3& up);

/// One wavelength, no background, the tree followed down to `residual`.
Scene empty_scene(const Camera& camera, double residual = 1e-16);

Medium glass_medium(const std::string& name, double n);
Object solid(const std::string& name, Shape shape, const DVec3& center, const std::string& medium);
/// Square of unit radiance on both sides, across z.
Object lamp_sheet(const DVec3& center, double size, EmittedState state = Unpolarized{});

}  // namespace pol::verify
