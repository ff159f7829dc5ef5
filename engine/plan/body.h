// SPDX-License-Identifier: Apache-2.0
// Objects of the scene in world space, ready to be hit: solids that light enters, surfaces that end or change a ray.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/vec.h"
#include "geometry/half_space_solid.h"
#include "geometry/mesh.h"
#include "geometry/open_surface.h"
#include "geometry/sphere.h"
#include "optics/elements.h"
#include "plan/emitter.h"

namespace pol {

/// A facet of a solid, or a surface, that a ray has just left and cannot hit again at once.
struct Left {
    int body = -1;
    int facet = -1;
    int triangle = -1;  ///< of a mesh, as RayCaster gave it; -1 if unknown
};

/// Shape that Embree intersects; the index is the mesh's place in its body, see Region::caster.
struct MeshBody {
    Mesh mesh;
    bool closed = false;
};

/// Part of a solid's facet that coincides with a facet of another body. With a solid: one interface instead of two.
/// With a lamp or something black: that is what a ray meets there.
struct Contact {
    int body = -1;
    int facet = -1;
    /// True: both look the same way, the nested solid's face is part of its host's. False: they face each other.
    bool flush = false;
    double margin = 0.0;  ///< how far rounding may have moved the two from each other
};

/// A solid that is filled with a medium.
struct Solid {
    std::string name;
    int object = -1;  ///< index into Scene::objects
    int medium = -1;  ///< index into Plan::media
    std::optional<int> priority;
    std::variant<HalfSpaceSolid, Sphere, MeshBody> shape;
    std::vector<std::vector<Contact>> contacts;  ///< with solids, by facet; empty if the solid touches none
    std::vector<std::vector<Contact>> covers;    ///< with lamps and absorbers, by facet; empty if there are none
    std::vector<bool> black;                     ///< by facet: it was declared to swallow all light; empty: none

    [[nodiscard]] bool is_black(int facet) const { return !black.empty() && black[static_cast<std::size_t>(facet)]; }
};

struct EmitterRole {
    int emitter = -1;  ///< index into Plan::emitters
};
struct SheetRole {
    Sheet sheet;  ///< axes in world space
};
struct AbsorberRole {};

using SurfaceShape = std::variant<OpenSurface, HalfSpaceSolid, Sphere, MeshBody>;

/// A surface that swallows, emits or polarizes.
struct Surface {
    std::string name;
    int object = -1;
    SurfaceShape shape;
    std::variant<EmitterRole, SheetRole, AbsorberRole> role;
};

}  // namespace pol
