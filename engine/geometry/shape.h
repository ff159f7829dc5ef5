// SPDX-License-Identifier: Apache-2.0
// Shapes as the user writes them, in object space, lengths in scene units, angles in radians: a closed set.
// shapes.h turns the flat-faced ones into meshes.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/vec.h"
#include "geometry/mesh.h"

namespace pol {

/// Round brilliant: table up (+z), girdle plane at z = 0. Lengths follow from the girdle diameter.
struct BrilliantShape {
    double diameter = 2.0;
    double table_ratio = 0.57;                   ///< table diameter / girdle diameter
    double crown_angle = 0.6021385919380436;     ///< 34.5 degrees
    double pavilion_angle = 0.7112216701876893;  ///< 40.75 degrees
    double girdle_ratio = 0.03;                  ///< girdle thickness / diameter
    double star_length = 0.55;                   ///< of the way from table to girdle, seen from above
    double lower_half_length = 0.77;             ///< of the way from girdle to culet
};

/// Axis-aligned box centred on the origin. A plate or a cube is a box.
struct BoxShape {
    DVec3 size{1.0, 1.0, 1.0};
};

/// Right prism: convex polygon in the xy plane (counter-clockwise), extruded along z from -height/2 to +height/2.
struct ExtrusionShape {
    std::vector<DVec2> polygon;
    double height = 1.0;
};

/// Triangular prism, edge along z: apex at +y with the given angle, legs of length `side`.
struct PrismShape {
    double apex_angle = 0.0;
    double side = 1.0;
    double height = 1.0;
};

/// Fresnel rhomb: parallelogram in the xy plane extruded along z. Light enters along +x through the face normal to
/// x, meets the two long faces at `angle`, and leaves along +x. `aperture` is the height of the entrance face.
struct RhombShape {
    double angle = 0.0;  ///< angle of incidence on the long faces
    double aperture = 1.0;
    double height = 1.0;
};

struct SphereShape {
    double radius = 1.0;
};

/// Rectangle in the xy plane, centred, normal +z. Open: not a solid.
struct RectangleShape {
    DVec2 size{1.0, 1.0};
};

/// Disk in the xy plane, centred, normal +z. Open: not a solid.
struct DiskShape {
    double radius = 1.0;
};

/// OBJ, PLY, STL or glTF file; `path` as resolved against the scene file, `mesh` what was read from it.
struct MeshShape {
    std::string path;
    std::shared_ptr<const Mesh> mesh;
};

using Shape = std::variant<BrilliantShape, BoxShape, ExtrusionShape, PrismShape, RhombShape, SphereShape,
                           RectangleShape, DiskShape, MeshShape>;

}  // namespace pol
