// SPDX-License-Identifier: Apache-2.0
#include "verify/invariants/scene_twins.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <variant>

#include "core/overloaded.h"
#include "scene/medium_fields.h"
#include "scene/node_budget.h"

namespace pol::verify {

namespace {

/// A coefficient per length, where lengths grow by `scale`.
void stretch(Absorption& absorption, double scale) {
    std::visit(Overloaded{[&](ConstantSpectrum& s) { s.value /= scale; },
                          [&](TabulatedSpectrum& s) {
                              for (double& value : s.value) value /= scale;
                          },
                          [&](D65Spectrum& s) { s.scale /= scale; }},
               absorption);
}

/// Directions in world space, each through `map`; those in the space of objects go along with their objects.
void map_world_axes(Matter& matter, const std::function<DVec3(const DVec3&)>& map) {
    std::visit(Overloaded{
                   [](IsotropicMedium&) {},
                   [&](UniaxialMedium& crystal) {
                       if (crystal.axis_space == AxisSpace::world) crystal.axis = map(crystal.axis);
                   },
                   [](ConductorMedium&) {},
               },
               matter);
}

/// What its axes, which go along with the object, do not say.
void mirror(Sheet& sheet) {
    std::visit(Overloaded{
                   [](LinearPolarizer&) {},
                   [](Retarder&) {},
                   [](CircularPolarizer& circular) {
                       circular.passes = circular.passes == Handedness::right ? Handedness::left : Handedness::right;
                   },
               },
               sheet);
}

}  // namespace

Scene small(Scene scene, int side) {
    scene.render.width = scene.render.height = side;
    scene.render.node_budget = std::min(node_budget_in_force(scene), 1000);
    scene.render.samples_per_pixel = std::min(scene.render.samples_per_pixel, 4);
    return scene;
}

Scene cut_by_depth(Scene scene, int depth) {
    scene.render.depth = depth;
    scene.render.residual = 0.0;
    scene.render.node_budget = 1000000;
    return scene;
}

Scene as_furnace(Scene scene, double radiance) {
    scene.background.radiance = ConstantSpectrum{radiance};
    for (Object& object : scene.objects)
        if (std::holds_alternative<Emission>(object.role))
            object.role = Emission{Spectrum{ConstantSpectrum{radiance}}, Unpolarized{}, true};
    return scene;
}

std::optional<std::string> what_loses_light(const Scene& scene, const Plan& plan) {
    for (const Object& object : scene.objects) {
        if (std::holds_alternative<Sheet>(object.role)) return fmt::format("'{}' is an ideal sheet", object.name);
        if (std::holds_alternative<Absorber>(object.role)) return fmt::format("'{}' is black", object.name);
        if (const auto* filled = std::get_if<FilledWith>(&object.role);
            filled != nullptr && !filled->black_faces.empty())
            return fmt::format("'{}' has black faces", object.name);
    }
    for (const WavelengthGroup& group : plan.groups)
        for (std::size_t m = 0; m < group.media.size(); ++m)
            if (group.media[m].dielectric.kind == MediumKind::conductor || group.media[m].absorption.absorbs())
                return fmt::format("medium '{}' absorbs", plan.medium_names[m]);
    return std::nullopt;
}

Scene carried(Scene scene, const DMat3& turn, double scale, const DVec3& shift) {
    const auto point = [&](const DVec3& p) { return turn * p * scale + shift; };
    DMat4 map(turn * scale);
    map[3] = glm::dvec4(shift, 1.0);
    scene.camera.position = point(scene.camera.position);
    scene.camera.target = point(scene.camera.target);
    scene.camera.up = turn * scene.camera.up;
    scene.camera.width *= scale;
    scene.unit_nm /= scale;
    for (Object& object : scene.objects) object.to_world = map * object.to_world;
    for (Medium& medium : scene.media) {
        for_each_field(medium.matter,
                       Overloaded{[](const auto&, const RefractiveIndex&) {},
                                  [&](const auto&, Absorption& absorption) { stretch(absorption, scale); },
                                  [](const auto&, const DVec3&) {}, [](const auto&, AxisSpace) {}});
        map_world_axes(medium.matter, [&](const DVec3& axis) { return turn * axis; });
    }
    return scene;
}

Scene mirrored(Scene scene) {
    const Camera& camera = scene.camera;
    const DVec3 right = unit(cross(unit(camera.target - camera.position), camera.up));
    const auto reflected = [&right](const DVec3& v) { return v - right * (2.0 * dot(v, right)); };
    DMat4 map(1.0);
    for (int i = 0; i < 3; ++i) {
        DVec3 axis(0.0);
        axis[i] = 1.0;
        map[i] = glm::dvec4(reflected(axis), 0.0);
    }
    map[3] = glm::dvec4(camera.position - reflected(camera.position), 1.0);
    for (Object& object : scene.objects) {
        object.to_world = map * object.to_world;
        if (auto* emission = std::get_if<Emission>(&object.role)) {
            if (auto* state = std::get_if<FixedState>(&emission->state)) {
                state->s2 = -state->s2;
                state->s3 = -state->s3;
            }
        } else if (auto* sheet = std::get_if<Sheet>(&object.role)) {
            mirror(*sheet);
        }
    }
    for (Medium& medium : scene.media) map_world_axes(medium.matter, reflected);
    return scene;
}

Scene with_equal_indices(Scene scene) {
    for (Medium& medium : scene.media)
        std::visit(Overloaded{
                       [](IsotropicMedium&) {},
                       [](UniaxialMedium& crystal) {
                           crystal.extraordinary = crystal.ordinary;
                           crystal.absorption_e = crystal.absorption_o;
                       },
                       [](ConductorMedium&) {},
                   },
                   medium.matter);
    return scene;
}

Scene with_glass_for_crystals(Scene scene) {
    for (Medium& medium : scene.media)
        medium.matter = std::visit(Overloaded{
                                       [](const IsotropicMedium& glass) -> Matter { return glass; },
                                       [](const UniaxialMedium& crystal) -> Matter {
                                           return IsotropicMedium{crystal.ordinary, crystal.absorption_o};
                                       },
                                       [](const ConductorMedium& metal) -> Matter { return metal; },
                                   },
                                   medium.matter);
    return scene;
}

}  // namespace pol::verify
