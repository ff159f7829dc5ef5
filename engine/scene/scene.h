// SPDX-License-Identifier: Apache-2.0
// The user's document: plain values, edited freely, read by nobody else while a picture is made (see plan/).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/source_place.h"
#include "core/vec.h"
#include "geometry/shape.h"
#include "optics/elements.h"
#include "scene/camera.h"
#include "scene/light.h"
#include "scene/medium.h"
#include "scene/render_settings.h"
#include "spectrum/spectrum.h"

namespace pol {

/// The object is filled with a medium (name in Scene::media) and bounded by a smooth surface.
struct FilledWith {
    std::string medium;
    /// Outward directions in object space, any length: the flat faces that look that way swallow all light that falls
    /// on them, from either side.
    std::vector<DVec3> black_faces{};
};

/// The object's surface swallows all light: a screen, a housing, an aperture plate.
struct Absorber {};

/// What an object is to light. Sheet axes are in object space here; compiling turns them into world space.
using Role = std::variant<FilledWith, Emission, Sheet, Absorber>;

struct Object {
    std::string name;
    Shape shape;
    DMat4 to_world{1.0};  ///< affine; may mirror or shear, must be invertible
    Role role;
    /// Decides who owns the volume where solids overlap: the higher number. Without it an overlap is an error. Only
    /// objects that are FilledWith a medium may have one.
    std::optional<int> priority;
    SourcePlace place{};
};

/// Scene unit of length; only extinction coefficients k of index tables need it (alpha = 4 pi k / lambda).
struct Scene {
    std::string title;
    double unit_nm = 1e6;  ///< nanometres per scene unit; default: 1 unit = 1 mm
    Camera camera;
    Background background;
    std::string ambient;  ///< medium around everything; empty: vacuum
    std::vector<Medium> media;
    std::vector<Object> objects;
    RenderSettings render;
    std::vector<std::string> files;  ///< scene file and its includes, for messages; SourcePlace::file indexes it
};

}  // namespace pol
