// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "scene/scene.h"

namespace pol {

/// Largest picture: pixels per side, and pixels in all.
inline constexpr int max_picture_side = 65536;
inline constexpr double max_picture_pixels = 2147483648.0;

/// Smallest and largest length in scene units that is taken for serious.
inline constexpr double min_length = 1e-15;
inline constexpr double max_length = 1e15;

/// The first thing in `scene` that cannot be rendered, or nothing. Looks at values only: ranges, names, and whether
/// every spectrum and index in use covers the wavelengths of `scene.render`. Overlapping solids are found when the
/// scene is compiled, which asks here first.
///
/// The error has kind input, a field path as in the scene file ("objects[2].medium", "media.glass.index"), a hint, and
/// the place of the object or medium if it came from a file.
std::optional<Error> first_problem(const Scene& scene);

/// One sentence for each medium in use whose record has an extinction k, but not at all wavelengths of `scene.render`:
/// there k counts as 0. Requires: the scene has no problem.
std::vector<std::string> unknown_extinctions(const Scene& scene);

}  // namespace pol
