// SPDX-License-Identifier: Apache-2.0
// Edits of a scene that leave something unchanged: the same scene smaller, elsewhere, in a mirror, in a furnace, of
// glass.
#pragma once

#include <optional>
#include <string>

#include "core/vec.h"
#include "plan/plan.h"
#include "scene/scene.h"

namespace pol::verify {

/// The scene as a square picture of `side` pixels, at most 4 samples each, cut as its file asks but after 1000 rays a
/// sample at most.
Scene small(Scene scene, int side);

/// Cut by depth alone: which branches are followed does not hang on the last bit of a weight.
Scene cut_by_depth(Scene scene, int depth);

/// Every emitter shines on both sides, unpolarized, with the surroundings' radiance: nothing but light everywhere.
Scene as_furnace(Scene scene, double radiance);

/// What in the scene takes light away ("object 'screen' is black"); empty if light is only redirected.
std::optional<std::string> what_loses_light(const Scene& scene, const Plan& plan);

/// The whole scene, camera included, turned by the rotation `turn`, then stretched by `scale`, then moved by `shift`.
/// Lengths in wavelengths stay what they were.
Scene carried(Scene scene, const DMat3& turn, double scale, const DVec3& shift);

/// The scene, its lights' states included, in a mirror that stands in the middle of the picture: the camera sees the
/// mirror image, left for right.
Scene mirrored(Scene scene);

/// All crystals with n_e = n_o (absorption likewise), as crystals or written as glass.
Scene with_equal_indices(Scene scene);
Scene with_glass_for_crystals(Scene scene);

}  // namespace pol::verify
