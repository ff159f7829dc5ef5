// SPDX-License-Identifier: Apache-2.0
// Scenes of physical facts as YAML text, since the user opens and saves them: cameras, lamps and solids whose planes of
// incidence are known.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/vec.h"

namespace pol::verify {

/// Pixels along the sides of a fact's picture: odd, so that the middle pixel's ray is the camera's axis.
constexpr int picture_side = 33;

/// All 17 digits, so that the loader reads the same double.
std::string text(double value);
std::string text(const DVec3& v);

/// Render settings of a fact's picture; `settings` are further YAML entries: "residual: 1e-9, node_budget: 20000".
std::string picture(std::string_view settings = "");

/// Directions that meet the plane z = 0 from above and leave it after reflection, at the angle `i` from the normal, in
/// the plane y = 0.
DVec3 downward(double i);
DVec3 upward(double i);

/// Orthographic camera at `from`, `width` wide, whose picture's x axis is -y: s for every surface across the plane
/// y = 0, so that S1 is s minus p. Requires: `from` and `target` have the same y.
std::string camera_seeing_s_as_x(const DVec3& from, const DVec3& target, double width = 1.0);

/// Camera in front of the origin, looking along `direction`, otherwise as above.
std::string camera_along(const DVec3& direction, double distance = 5.0, double width = 1.0);

/// Camera that looks at `target` along `direction` in the xy plane; the picture's y axis is z, its x axis lies in the
/// xy plane.
std::string camera_in_plane(const DVec3& direction, const DVec3& target, double width = 1.0);

/// Transform step that puts a flat shape's centre at `center`, its x axis along `x` and its front towards `normal`.
std::string placed(const DVec3& center, const DVec3& normal, const DVec3& x);

/// Square lamp whose x axis is -y, as that of the cameras above; `emission` in YAML.
std::string lamp(std::string_view name, const DVec3& center, const DVec3& normal, double size,
                 std::string_view emission = "radiance: 1");
/// Square lamp that stands upright on the xy plane, for camera_in_plane().
std::string lamp_in_plane(const DVec3& center, const DVec3& normal, double size);

/// Unit radiance in the state (s1, s2, s3), as `emission`.
std::string polarized(std::string_view stokes);

std::string box(std::string_view name, const DVec3& size, const DVec3& center, std::string_view medium);

/// A medium: the literal calcite of PHYSICS.md 5 with its axis in object space.
std::string calcite(const DVec3& axis);

/// Convex polygon in the xy plane, 2 high along z.
std::string extruded(std::string_view name, const std::vector<DVec2>& polygon, std::string_view medium);

/// A block with its top in the plane z = 0 that swallows what it lets in.
std::string deep_block(std::string_view medium);

/// A plate 1 thick with its top in the plane z = `top`, turned about z by `turn` degrees.
std::string plate(std::string_view name, std::string_view medium, double top = 0.0, double turn = 0.0);

}  // namespace pol::verify
