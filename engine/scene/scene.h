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

enum class SampleMode {
    point,  ///< one ray through the pixel centre, the paper's mode
    area,   ///< box filter over the pixel, quasi-random
};

/// How the picture is made unless the command line says otherwise.
struct RenderSettings {
    int width = 512;
    int height = 512;
    std::vector<double> wavelengths_nm{580.0};
    SampleMode mode = SampleMode::point;
    int samples_per_pixel = 1;
    double residual = 1e-3;    ///< largest share of a pixel that may stay untraced
    std::optional<int> depth;  ///< the paper's depth limit; none: cut by energy alone
    int node_budget = 1000;    ///< branches a sample may follow before its random tail
    std::uint64_t seed = 0;
    bool unpolarized = false;  ///< light is unpolarized again after every surface, as renderers without polarization do
    /// The samples of a pixel that make its picture have the numbers first_sample() to last_sample(). Sample 0 is the
    /// ray through the pixel's centre, which a click and the preview show. In mode area it is none of the picture's: a
    /// sample in a place that is always the same would pull the mean towards what is there.
    [[nodiscard]] int first_sample() const { return mode == SampleMode::area ? 1 : 0; }
    [[nodiscard]] int last_sample() const { return first_sample() + samples_per_pixel - 1; }

    /// The paper's mode: the depth alone cuts the tree. Residual and node budget can be set again afterwards.
    void cut_by_depth_alone(int limit) {
        depth = limit;
        residual = 0.0;
        node_budget = whole_tree;
    }

    /// The paper's depth of 9 makes 3^9 = 19683 leaves in a crystal, 4^9 = 262144 in a twin. Deeper trees than this
    /// many branches end in a random tail all the same: a branch takes 250 bytes of every thread.
    static constexpr int whole_tree = 1 << 20;

    friend bool operator==(const RenderSettings&, const RenderSettings&) = default;
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
