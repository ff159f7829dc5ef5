// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "core/hypot.h"
#include "core/overloaded.h"
#include "core/units.h"
#include "geometry/mesh_check.h"
#include "geometry/shapes.h"
#include "scene/check_rules.h"

namespace pol {
namespace {

bool is_flat_sheet(const Shape& shape) {
    return std::holds_alternative<RectangleShape>(shape) || std::holds_alternative<DiskShape>(shape);
}

void require_angle(SceneCheck& check, double angle_rad, double below_degrees, const std::string& field) {
    check.require(angle_rad > 0.0 && degrees(angle_rad) < below_degrees, field,
                  "must lie between 0 and " + std::to_string(static_cast<int>(below_degrees)) + " degrees",
                  "angles are in degrees");
}

void require_share(SceneCheck& check, double share, const std::string& field) {
    check.require(share > 0.0 && share < 1.0, field, "must lie between 0 and 1", "it is a ratio, not a percentage");
}

/// Combinations of parameters that no solid has, such as a pavilion that is cut away.
void require_possible(SceneCheck& check, const Shape& shape, const std::string& field) {
    if (check.failed()) return;
    const Result<Mesh> mesh = make_mesh(shape);
    if (mesh) return;
    const std::string& parameter = mesh.error().field;
    check.require(false, parameter.empty() ? field : field + "." + parameter, mesh.error().what, mesh.error().hint);
}

void check_shape(SceneCheck& check, const Shape& shape, const std::string& field) {
    std::visit(Overloaded{
                   [&](const BrilliantShape& s) {
                       const std::string name = field + ".brilliant";
                       check.require_size(s.diameter, name + ".diameter");
                       require_share(check, s.table_ratio, name + ".table_ratio");
                       require_angle(check, s.crown_angle, 90.0, name + ".crown_angle");
                       require_angle(check, s.pavilion_angle, 90.0, name + ".pavilion_angle");
                       require_share(check, s.girdle_ratio, name + ".girdle_ratio");
                       require_share(check, s.star_length, name + ".star_length");
                       require_share(check, s.lower_half_length, name + ".lower_half_length");
                       require_possible(check, shape, name);
                   },
                   [&](const BoxShape& s) {
                       for (int i = 0; i < 3; ++i) check.require_size(s.size[i], field + ".box.size");
                   },
                   [&](const ExtrusionShape& s) {
                       check.require(s.polygon.size() >= 3, field + ".extrusion.polygon",
                                     "needs at least three corners",
                                     "write [[x, y], [x, y], [x, y]] counter-clockwise");
                       for (const DVec2& p : s.polygon) {
                           check.require_position({p.x, p.y, 0.0}, field + ".extrusion.polygon");
                       }
                       check.require_size(s.height, field + ".extrusion.height");
                       require_possible(check, shape, field + ".extrusion");
                   },
                   [&](const PrismShape& s) {
                       require_angle(check, s.apex_angle, 180.0, field + ".prism.apex_angle");
                       check.require_size(s.side, field + ".prism.side");
                       check.require_size(s.height, field + ".prism.height");
                       require_possible(check, shape, field + ".prism");
                   },
                   [&](const RhombShape& s) {
                       require_angle(check, s.angle, 90.0, field + ".rhomb.angle");
                       check.require_size(s.aperture, field + ".rhomb.aperture");
                       check.require_size(s.height, field + ".rhomb.height");
                       require_possible(check, shape, field + ".rhomb");
                   },
                   [&](const SphereShape& s) { check.require_size(s.radius, field + ".sphere.radius"); },
                   [&](const RectangleShape& s) {
                       check.require_size(s.size.x, field + ".rectangle.size");
                       check.require_size(s.size.y, field + ".rectangle.size");
                   },
                   [&](const DiskShape& s) { check.require_size(s.radius, field + ".disk.radius"); },
                   [&](const MeshShape& s) {
                       check.require(s.mesh != nullptr && !s.mesh->triangles.empty(), field + ".mesh.file", "is empty",
                                     "name an OBJ, PLY, STL or glTF file");
                   },
               },
               shape);
}

void check_filled_mesh(SceneCheck& check, const Shape& shape, const std::string& field) {
    const auto* mesh = std::get_if<MeshShape>(&shape);
    if (mesh == nullptr || mesh->mesh == nullptr || check.failed()) return;
    const Result<Done> closed = check_closed(*mesh->mesh);
    if (!closed)
        check.require(false, field, mesh->path + " is not the surface of a solid: " + closed.error().what,
                      closed.error().hint);
}

void check_transform(SceneCheck& check, const DMat4& to_world, const std::string& field) {
    double scale = 1.0;
    bool believable = true;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) believable = believable && std::abs(to_world[column][row]) <= max_length;
    }
    for (int column = 0; column < 3; ++column) scale *= std::sqrt(length2(DVec3(to_world[column])));
    check.require(believable, field, "has numbers beyond 1e15", "look for absurd scales and translations");
    const bool affine =
        to_world[0][3] == 0.0 && to_world[1][3] == 0.0 && to_world[2][3] == 0.0 && to_world[3][3] == 1.0;
    check.require(affine, field, "is not affine", "the last row must be 0 0 0 1");
    // The determinant of the columns' directions is the volume of a parallelepiped with unit edges; below 1e-9 the
    // solid is flat within the accuracy with which touching faces are found.
    const double volume = std::abs(glm::determinant(DMat3(to_world)));
    check.require(scale > 0.0 && volume > 1e-9 * scale, field, "is singular: it flattens the object",
                  "scale by numbers other than 0");
}

void check_sheet(SceneCheck& check, const Sheet& sheet, const Shape& shape, const std::string& field) {
    const auto require_sheet_axis = [&](const DVec3& axis, const std::string& name) {
        check.require_axis(axis, name);
        if (check.failed() || !is_flat_sheet(shape)) return;
        const DVec3 direction = unit(axis);
        check.require(pol::hypot(direction.x, direction.y) > 1e-9, name, "is perpendicular to the sheet",
                      "the sheet lies in the xy plane of the object; take an axis in it, such as [1, 0, 0]");
    };
    std::visit(Overloaded{
                   [&](const LinearPolarizer& s) { require_sheet_axis(s.axis, field + ".polarizer.axis"); },
                   [&](const Retarder& s) {
                       require_sheet_axis(s.fast_axis, field + ".retarder.fast_axis");
                       check.require(std::isfinite(s.retardance), field + ".retarder.retardance", "must be finite",
                                     "a quarter-wave plate has 90 degrees");
                   },
                   [&](const CircularPolarizer&) {},
               },
               sheet);
}

bool is_whole(const RgbImage* image) {
    return image != nullptr && image->width > 0 && image->height > 0 &&
           image->rgb.size() ==
               std::size_t{3} * static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height);
}

void check_radiance(SceneCheck& check, const Radiance& radiance, const Shape& shape, const std::string& field) {
    const std::vector<double>& wavelengths_nm = check.scene().render.wavelengths_nm;
    std::visit(Overloaded{
                   [&](const Spectrum& spectrum) { check_spectrum(check, spectrum, wavelengths_nm, field); },
                   [&](const TexturedRadiance& textured) {
                       check.require(is_flat_sheet(shape), field, "only a rectangle or a disk can carry a texture",
                                     "use {rectangle: {size: ...}} or a uniform radiance");
                       check.require(is_whole(textured.image.get()), field + ".texture", "the texture is empty",
                                     "name a PNG file");
                       check_spectrum(check, D65Spectrum{textured.scale}, wavelengths_nm, field + ".scale");
                   },
               },
               radiance);
}

void check_state(SceneCheck& check, const EmittedState& emitted, const std::string& field) {
    std::visit(Overloaded{
                   [](const Unpolarized&) {},
                   [&](const FixedState& state) {
                       const double polarized = std::hypot(state.s1, state.s2, state.s3);
                       // A state made from degree and angles is rounded three times; 4 ulp is more than that.
                       check.require(polarized <= 1.0 + 4.0 * 2.220446049250313e-16, field,
                                     "is more than fully polarized: |(s1, s2, s3)| > 1",
                                     "divide by the intensity s0 first");
                       check.require_axis(state.x_axis, field + ".x_axis");
                   },
                   [&](const CrystalPlateState& plate) {
                       const std::string name = field + ".crystal_plate";
                       require_medium(check, plate.medium, name + ".medium");
                       const Medium* medium = find_medium(check.scene(), plate.medium);
                       check.require(medium == nullptr || crystal_in(medium->matter) != nullptr, name + ".medium",
                                     "'" + plate.medium + "' is not a uniaxial crystal",
                                     "use a medium such as {crystal: calcite}");
                       check.require_axis(plate.axis, name + ".axis");
                   },
               },
               emitted);
}

void check_emission(SceneCheck& check, const Emission& emission, const Shape& shape, const std::string& field) {
    check_radiance(check, emission.radiance, shape, field + ".radiance");
    check_state(check, emission.state, field + ".polarization");
}

}  // namespace

void check_objects(SceneCheck& check) {
    const Scene& scene = check.scene();
    std::set<std::string> names;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const std::string field = "objects[" + std::to_string(i) + "]";
        check.about(object.place);
        check.require(!object.name.empty(), field + ".name", "an object needs a name", "messages call it by that name");
        check.require(names.insert(object.name).second, field + ".name",
                      "another object is called '" + object.name + "'", "rename one of them");
        check_shape(check, object.shape, field + ".shape");
        check_transform(check, object.to_world, field + ".transform");
        check.require(!object.priority || std::holds_alternative<FilledWith>(object.role), field + ".priority",
                      "only an object with a medium can have a priority: it decides which medium fills a volume",
                      "leave it out; lamps, sheets and absorbers stay where they are, whatever they lie in");
        std::visit(Overloaded{
                       [&](const FilledWith& role) {
                           for (const DVec3& direction : role.black_faces)
                               check.require_axis(direction, field + ".black");
                           require_medium(check, role.medium, field + ".medium");
                           check.require(!is_flat_sheet(object.shape), field + ".medium",
                                         "a rectangle or disk encloses nothing that could be filled",
                                         "use a closed shape such as a thin box");
                           check_filled_mesh(check, object.shape, field + ".shape.mesh.file");
                       },
                       [&](const Emission& role) { check_emission(check, role, object.shape, field + ".emission"); },
                       [&](const Sheet& role) { check_sheet(check, role, object.shape, field + ".sheet"); },
                       [&](const Absorber&) {},
                   },
                   object.role);
        if (check.failed()) return;
    }
}

}  // namespace pol
