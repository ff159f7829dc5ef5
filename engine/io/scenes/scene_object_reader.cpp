// SPDX-License-Identifier: Apache-2.0
// Objects of a scene file: shape, transform, and what they are to light.
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

#include "core/units.h"
#include "io/meshes/mesh_file.h"
#include "io/scenes/scene_reader.h"
#include "io/scenes/texture_file.h"

namespace pol {
namespace {

/// Rodrigues' formula. glm::rotate is not used: it builds the same matrix from a less exact 1 - cos.
DMat4 rotation(const DVec3& axis, double angle_rad) {
    const DVec3 a = unit(axis);
    const double s = std::sin(angle_rad);
    const double half = std::sin(0.5 * angle_rad);
    const double v = 2.0 * half * half;
    DMat4 m(1.0);
    for (int column = 0; column < 3; ++column) {
        DVec3 e(0.0);
        e[column] = 1.0;
        m[column] = glm::dvec4(e + s * cross(a, e) + v * cross(a, cross(a, e)), 0.0);
    }
    return m;
}

DMat4 read_rotation(const YamlValue& value) {
    const YamlMap map = value.map({"axis", "angle"});
    const DVec3 axis = map.at("axis").vec3();
    if (!(length2(axis) > 0.0)) {
        map.at("axis").fail("has no direction: its length is zero", "write a vector such as [0, 0, 1]");
    }
    if (!std::isfinite(length2(axis))) map.at("axis").fail("is absurdly long", "write a vector such as [0, 0, 1]");
    return rotation(axis, map.at("angle").angle());
}

DMat4 read_matrix(const YamlValue& value) {
    const std::vector<YamlValue> rows = value.list();
    if (rows.size() != 3) value.fail("expected three rows", "write three rows of four numbers; the fourth is 0 0 0 1");
    DMat4 m(1.0);
    for (int row = 0; row < 3; ++row) {
        const std::vector<double> numbers = rows[static_cast<std::size_t>(row)].numbers();
        if (numbers.size() != 4)
            rows[static_cast<std::size_t>(row)].fail("expected four numbers", "write [a, b, c, t]");
        for (int column = 0; column < 4; ++column) m[column][row] = numbers[static_cast<std::size_t>(column)];
    }
    return m;
}

Sheet read_sheet(const YamlValue& value) {
    const auto [kind, content] = value.tagged({"polarizer", "retarder", "circular"});
    if (kind == "polarizer") {
        const YamlMap map = content.map({"axis", "model"});
        const auto model = map.find("model");
        const bool passing = model && model->choice({"blocking", "passing"}) == "passing";
        return LinearPolarizer{map.at("axis").vec3(), passing ? PolarizerModel::passing : PolarizerModel::blocking};
    }
    if (kind == "retarder") {
        const YamlMap map = content.map({"fast_axis", "retardance"});
        return Retarder{map.at("fast_axis").vec3(), map.at("retardance").angle()};
    }
    const std::string passes = content.map({"passes"}).at("passes").choice({"right", "left"});
    return CircularPolarizer{passes == "right" ? Handedness::right : Handedness::left};
}

/// Degree p, azimuth psi, ellipticity e = b/a: s = p (cos 2chi cos 2psi, cos 2chi sin 2psi, +-sin 2chi) with tan chi =
/// e (PHYSICS.md 1); + is right-handed.
FixedState read_ellipse(const YamlMap& map) {
    const double degree = map.at("dop").number();
    if (degree < 0.0 || degree > 1.0) map.at("dop").fail("must lie between 0 and 1", "1 is fully polarized");
    const double azimuth = map.at("azimuth").angle();
    double ellipticity = 0.0;
    double sign = 1.0;
    if (const auto value = map.find("ellipticity")) {
        ellipticity = value->number();
        if (ellipticity < 0.0 || ellipticity > 1.0) value->fail("must lie between 0 and 1", "0 is linear, 1 circular");
        if (ellipticity > 0.0) sign = map.at("handedness").choice({"right", "left"}) == "right" ? 1.0 : -1.0;
    }
    const double e2 = ellipticity * ellipticity;
    const double cos_2chi = (1.0 - e2) / (1.0 + e2);
    const double sin_2chi = 2.0 * ellipticity / (1.0 + e2);
    FixedState state;
    state.s1 = degree * cos_2chi * std::cos(2.0 * azimuth);
    state.s2 = degree * cos_2chi * std::sin(2.0 * azimuth);
    state.s3 = degree * sin_2chi * sign;
    return state;
}

CrystalPlateState read_crystal_plate(const YamlValue& value) {
    const YamlMap map = value.map({"medium", "axis", "ray", "fresnel"});
    CrystalPlateState plate;
    plate.medium = map.at("medium").text();
    plate.axis = map.at("axis").vec3();
    const std::string ray = map.at("ray").choice({"o", "e"});
    plate.passed = ray == "o" ? CrystalRay::ordinary : CrystalRay::extraordinary;
    plate.fresnel = map.at("fresnel").truth();
    return plate;
}

EmittedState read_state(const YamlValue& value) {
    if (value.is_scalar()) {
        static_cast<void>(value.choice({"unpolarized"}));
        return Unpolarized{};
    }
    const YamlMap map = value.map({"stokes", "dop", "azimuth", "ellipticity", "handedness", "x_axis", "crystal_plate"});
    if (map.has("crystal_plate")) return read_crystal_plate(value.map({"crystal_plate"}).at("crystal_plate"));
    FixedState state;
    if (map.has("stokes")) {
        const DVec3 s = value.map({"stokes", "x_axis"}).at("stokes").vec3();
        state.s1 = s.x;
        state.s2 = s.y;
        state.s3 = s.z;
    } else {
        state = read_ellipse(map);
    }
    if (const auto axis = map.find("x_axis")) state.x_axis = axis->vec3();
    return state;
}

Radiance read_radiance(const YamlValue& value, const AssetFolders& folders) {
    if (!value.is_map()) return read_spectrum(value);
    const YamlMap map = value.map({"d65", "table", "texture", "scale"});
    if (!map.has("texture")) return read_spectrum(value);
    const YamlMap textured = value.map({"texture", "scale"});
    const YamlValue file = textured.at("texture");
    TexturedRadiance radiance;
    radiance.path = find_asset(file, folders, "textures").string();
    if (const auto scale = textured.find("scale")) radiance.scale = scale->number();
    Result<RgbImage> image = load_texture(radiance.path);
    if (!image) fail_because_of(file, image.error());
    radiance.image = std::make_shared<const RgbImage>(std::move(image).value());
    return radiance;
}

/// A number for all sides, or one number a side.
template <class Vector>
Vector read_size(const YamlValue& value) {
    if (value.is_scalar()) return Vector(value.number());
    if constexpr (Vector::length() == 2) {
        return value.vec2();
    } else {
        return value.vec3();
    }
}

BrilliantShape read_brilliant(const YamlValue& value) {
    const YamlMap map = value.map({"diameter", "table_ratio", "crown_angle", "pavilion_angle", "girdle_ratio",
                                   "star_length", "lower_half_length"});
    BrilliantShape shape;
    shape.diameter = map.at("diameter").number();
    if (const auto v = map.find("table_ratio")) shape.table_ratio = v->number();
    if (const auto v = map.find("crown_angle")) shape.crown_angle = v->angle();
    if (const auto v = map.find("pavilion_angle")) shape.pavilion_angle = v->angle();
    if (const auto v = map.find("girdle_ratio")) shape.girdle_ratio = v->number();
    if (const auto v = map.find("star_length")) shape.star_length = v->number();
    if (const auto v = map.find("lower_half_length")) shape.lower_half_length = v->number();
    return shape;
}

UprightShape read_mesh(const YamlValue& value, const AssetFolders& folders) {
    const YamlMap map = value.map({"file", "up"});
    const YamlValue file = map.at("file");
    MeshShape shape{find_asset(file, folders, "scenes").string(), nullptr};
    Result<Mesh> mesh = load_mesh(shape.path);
    if (!mesh) fail_because_of(file, mesh.error());
    shape.mesh = std::make_shared<const Mesh>(std::move(mesh).value());
    UprightShape result{shape};
    const auto up = map.find("up");
    if (up && up->choice({"y", "z"}) == "y") {
        // (x, y, z) -> (x, -z, y)
        result.upright[1] = {0.0, 0.0, 1.0, 0.0};
        result.upright[2] = {0.0, -1.0, 0.0, 0.0};
    }
    return result;
}

ExtrusionShape read_extrusion(const YamlValue& value) {
    const YamlMap map = value.map({"polygon", "height"});
    ExtrusionShape shape;
    for (const YamlValue& corner : map.at("polygon").list()) shape.polygon.push_back(corner.vec2());
    shape.height = map.at("height").number();
    return shape;
}

}  // namespace

std::filesystem::path find_asset(const YamlValue& value, const AssetFolders& folders, const std::string& kind,
                                 std::initializer_list<const char*> ends) {
    const std::filesystem::path name = value.text();
    for (const auto& folder : {folders.scene, folders.assets / kind, folders.assets}) {
        std::error_code error;
        const std::filesystem::path path = std::filesystem::absolute(folder / name, error);
        const std::filesystem::path plain = path.lexically_normal();
        for (const char* end : ends) {
            std::error_code failed;
            if (error || !std::filesystem::is_regular_file(path.string() + end, failed)) continue;
            // Behind a link to a folder, ".." is not the part before it.
            return std::filesystem::equivalent(path.string() + end, plain.string() + end, failed) ? plain : path;
        }
        if (name.is_absolute()) break;
    }
    value.fail("there is no file '" + name.string() + *ends.begin() + "'",
               "looked beside the scene file, then in assets/" + kind + " and assets");
}

void fail_because_of(const YamlValue& value, Error error) {
    if (error.place.line == 0) {
        if (!error.place.file.empty()) {
            error.what = std::filesystem::path(error.place.file).filename().string() + ": " + error.what;
        }
        error.place = value.message_place();
        error.field = value.path();
    }
    error.kind = ErrorKind::input;
    throw YamlComplaint{std::move(error)};
}

UprightShape read_shape(const YamlValue& value, const AssetFolders& folders) {
    const auto [kind, content] =
        value.tagged({"brilliant", "box", "extrusion", "prism", "rhomb", "sphere", "rectangle", "disk", "mesh"});
    if (kind == "mesh") return read_mesh(content, folders);
    if (kind == "brilliant") return {read_brilliant(content)};
    if (kind == "box") return {BoxShape{read_size<DVec3>(content.map({"size"}).at("size"))}};
    if (kind == "extrusion") return {read_extrusion(content)};
    if (kind == "prism") {
        const YamlMap map = content.map({"apex_angle", "side", "height"});
        return {PrismShape{map.at("apex_angle").angle(), map.at("side").number(), map.at("height").number()}};
    }
    if (kind == "rhomb") {
        const YamlMap map = content.map({"angle", "aperture", "height"});
        return {RhombShape{map.at("angle").angle(), map.at("aperture").number(), map.at("height").number()}};
    }
    if (kind == "sphere") return {SphereShape{content.map({"radius"}).at("radius").number()}};
    if (kind == "rectangle") return {RectangleShape{read_size<DVec2>(content.map({"size"}).at("size"))}};
    return {DiskShape{content.map({"radius"}).at("radius").number()}};
}

DMat4 read_transform(const YamlValue& value, DMat4 to_world) {
    for (const YamlValue& step : value.list()) {
        const auto [kind, content] = step.tagged({"translate", "rotate", "scale", "matrix"});
        DMat4 m(1.0);
        if (kind == "translate") m = glm::translate(m, content.vec3());
        if (kind == "rotate") m = read_rotation(content);
        if (kind == "scale") m = glm::scale(m, read_size<DVec3>(content));
        if (kind == "matrix") m = read_matrix(content);
        to_world = m * to_world;
    }
    return to_world;
}

Emission read_emission(const YamlValue& value, const AssetFolders& folders) {
    const YamlMap map = value.map({"radiance", "polarization", "two_sided"});
    Emission emission;
    emission.radiance = read_radiance(map.at("radiance"), folders);
    if (const auto state = map.find("polarization")) emission.state = read_state(*state);
    if (const auto two_sided = map.find("two_sided")) emission.two_sided = two_sided->truth();
    return emission;
}

Object read_object(const YamlValue& value, const AssetFolders& folders) {
    const YamlMap map =
        value.map({"name", "shape", "transform", "medium", "emission", "sheet", "absorber", "priority", "black"});
    Object object;
    object.place = value.place();
    object.name = map.at("name").text();
    UprightShape shape = read_shape(map.at("shape"), folders);
    object.shape = std::move(shape.shape);
    object.to_world = shape.upright;
    if (const auto transform = map.find("transform")) object.to_world = read_transform(*transform, shape.upright);
    int roles = 0;
    for (const char* role : {"medium", "emission", "sheet", "absorber"}) roles += map.has(role) ? 1 : 0;
    if (roles != 1) {
        value.fail("'" + object.name + "' must have exactly one of medium, emission, sheet or absorber, found " +
                       std::to_string(roles),
                   "say what the object is to light");
    }
    if (const auto medium = map.find("medium")) object.role = FilledWith{medium->text()};
    if (const auto emission = map.find("emission")) object.role = read_emission(*emission, folders);
    if (const auto sheet = map.find("sheet")) object.role = read_sheet(*sheet);
    if (const auto absorber = map.find("absorber")) {
        if (!absorber->truth()) absorber->fail("an object without a role", "write 'absorber: on' or another role");
        object.role = Absorber{};
    }
    if (const auto priority = map.find("priority")) object.priority = priority->whole();
    if (const auto black = map.find("black")) {
        auto* solid = std::get_if<FilledWith>(&object.role);
        if (solid == nullptr) black->fail("only an object with a medium has faces to blacken", "leave it out");
        for (const YamlValue& direction : black->list()) solid->black_faces.push_back(direction.vec3());
    }
    return object;
}

}  // namespace pol
