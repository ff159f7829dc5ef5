// SPDX-License-Identifier: Apache-2.0
#include "plan/compile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/overloaded.h"
#include "geometry/mesh_check.h"
#include "geometry/shapes.h"
#include "plan/arrangement.h"
#include "plan/compile_light.h"
#include "plan/compile_media.h"
#include "plan/list_features.h"

namespace pol {

namespace {

/// Planes are tested one by one, and whether a mesh is convex takes their number squared. Embree is faster from 2000
/// on.
constexpr std::size_t most_half_spaces = 4096;

/// Shape of a solid in world space: half-spaces where it is flat-faced and convex, else a sphere or a mesh.
using SolidShape = std::variant<HalfSpaceSolid, Sphere, MeshBody>;

Result<SolidShape> from_mesh(const Mesh& object_mesh, const DMat4& to_world, SolidKernel kernel) {
    auto mesh = transformed(object_mesh, to_world);
    if (!mesh) return mesh.error();
    const bool closed = static_cast<bool>(check_closed(mesh.value()));
    const bool few = mesh.value().facets.size() <= most_half_spaces;
    if (kernel == SolidKernel::half_spaces && closed && few && is_convex(mesh.value())) {
        auto solid = HalfSpaceSolid::from_mesh(std::move(mesh).value());
        if (!solid) return solid.error();
        return SolidShape{std::move(solid).value()};
    }
    return SolidShape{MeshBody{std::move(mesh).value(), closed}};
}

Result<SolidShape> solid_shape(const Object& object, SolidKernel kernel) {
    if (const auto* sphere = std::get_if<SphereShape>(&object.shape)) {
        auto made = make_sphere(*sphere, object.to_world);
        if (!made) return made.error();
        return SolidShape{made.value()};
    }
    if (const auto* file = std::get_if<MeshShape>(&object.shape)) {
        POL_EXPECTS(file->mesh != nullptr);
        return from_mesh(*file->mesh, object.to_world, kernel);
    }
    auto mesh = make_mesh(object.shape);
    if (!mesh) return mesh.error();
    return from_mesh(mesh.value(), object.to_world, kernel);
}

Result<Done> add_solid(const Scene& scene, const Object& object, int index, const FilledWith& filling,
                       SolidKernel kernel, MediaTable& media, Plan& plan) {
    auto shape = solid_shape(object, kernel);
    if (!shape) return at_object(shape.error(), scene, index);
    if (const auto* mesh = std::get_if<MeshBody>(&shape.value()); mesh != nullptr && !mesh->closed) {
        Error error = check_closed(mesh->mesh).error();
        error.what =
            "'" + object.name + "' is filled with '" + filling.medium + "' but its mesh is not closed: " + error.what;
        error.place = {};
        return at_object(error, scene, index);
    }
    const auto medium = media.entry(filling.medium, object.to_world);
    if (!medium) return at_object(medium.error(), scene, index);
    plan.solids.push_back({object.name, index, medium.value(), object.priority, std::move(shape).value(), {}});
    return Done{};
}

Result<Done> add_surface(const Scene& scene, const Object& object, int index, SolidKernel kernel, Plan& plan) {
    Surface surface{object.name, index, Sphere{}, AbsorberRole{}};
    const auto open = [&](const auto& shape) -> Result<Done> {
        auto made = OpenSurface::from(shape, object.to_world);
        if (!made) return made.error();
        surface.shape = made.value();
        return Done{};
    };
    const Result<Done> shaped =
        std::visit(Overloaded{
                       [&](const RectangleShape& s) { return open(s); },
                       [&](const DiskShape& s) { return open(s); },
                       [&](const auto&) -> Result<Done> {
                           auto shape = solid_shape(object, kernel);
                           if (!shape) return shape.error();
                           std::visit([&](auto& s) { surface.shape = std::move(s); }, shape.value());
                           return Done{};
                       },
                   },
                   object.shape);
    if (!shaped) return at_object(shaped.error(), scene, index);
    if (const auto* sheet = std::get_if<Sheet>(&object.role)) {
        if (std::holds_alternative<HalfSpaceSolid>(surface.shape) || std::holds_alternative<Sphere>(surface.shape))
            return at_object({ErrorKind::input,
                              "sheet '" + object.name + "' has a closed shape",
                              {},
                              "shape",
                              "use a rectangle, a disk or an open mesh"},
                             scene, index);
        surface.role = SheetRole{sheet_in_world(*sheet, object.to_world)};
    } else if (std::holds_alternative<Emission>(object.role)) {
        surface.role = EmitterRole{static_cast<int>(plan.emitters.size())};
        plan.emitters.emplace_back();  // filled in by compile_light once the wavelength groups are known
    }
    plan.surfaces.push_back(std::move(surface));
    return Done{};
}

/// Wavelengths with equal constants of all media share a group.
Result<Done> group_wavelengths(const Scene& scene, const MediaTable& media, Plan& plan) {
    plan.medium_names = media.names();
    for (std::size_t w = 0; w < plan.wavelengths_nm.size(); ++w) {
        auto at = media.at(plan.wavelengths_nm[w]);
        if (!at) return at.error();
        const auto plates = plate_crystals(scene, plan, plan.wavelengths_nm[w]);
        if (!plates) return plates.error();
        std::size_t group = 0;
        while (group < plan.groups.size() &&
               !(plan.groups[group].media == at.value() && same_plates(plan, static_cast<int>(group), plates.value())))
            ++group;
        if (group == plan.groups.size()) {
            plan.groups.push_back({{}, at.value()});
            append_plates(plan, plates.value());
        }
        plan.groups[group].wavelengths.push_back(static_cast<int>(w));
        plan.group_of_wavelength.push_back(static_cast<int>(group));
    }
    return Done{};
}

double extent(const Plan& plan) {
    double largest = 0.0;
    const auto reach = [&](const DVec3& p) {
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    };
    const Overloaded measure{
        [&](const HalfSpaceSolid& s) { std::for_each(s.vertices().begin(), s.vertices().end(), reach); },
        [&](const Sphere& s) { reach(s.center + DVec3(s.radius)), reach(s.center - DVec3(s.radius)); },
        [&](const MeshBody& s) { std::for_each(s.mesh.vertices.begin(), s.mesh.vertices.end(), reach); },
        [&](const OpenSurface& s) {
            reach(s.center() + s.half_u() + s.half_v()), reach(s.center() - s.half_u() - s.half_v());
        },
    };
    for (const Solid& solid : plan.solids) std::visit(measure, solid.shape);
    for (const Surface& surface : plan.surfaces) std::visit(measure, surface.shape);
    return largest > 0.0 ? largest : 1.0;
}

/// Region of the camera, -1 if it may differ from pixel to pixel. Error: a medium that no camera can stand in.
Result<Done> place_camera(const Scene& scene, Plan& plan) {
    plan.camera = CameraModel(scene.camera, plan.settings.width, plan.settings.height);
    if (scene.camera.projection == Projection::orthographic) {
        plan.camera_region = plan.solids.empty() ? 0 : -1;
    } else {
        plan.camera_region = plan.region_at(scene.camera.position);
    }
    if (plan.camera_region < 0) return Done{};
    const Region& region = plan.regions[static_cast<std::size_t>(plan.camera_region)];
    const MediumKind kind = plan.groups[0].media[static_cast<std::size_t>(region.medium)].dielectric.kind;
    if (kind != MediumKind::isotropic)
        return at_place({ErrorKind::input,
                         "the camera is inside '" + plan.solid(region.owner).name + "', which is not isotropic",
                         {},
                         "camera.position",
                         "a pixel's coherence matrix needs an isotropic medium: move the camera out"},
                        scene, scene.camera.place);
    return Done{};
}

}  // namespace

Result<std::shared_ptr<const Plan>> compile(const Scene& scene, SolidKernel kernel) {
    auto plan = std::make_shared<Plan>();
    plan->settings = scene.render;
    plan->title = scene.title;
    plan->wavelengths_nm = scene.render.wavelengths_nm;
    POL_EXPECTS(!plan->wavelengths_nm.empty());

    MediaTable media(scene);
    if (!scene.ambient.empty()) {
        const auto ambient = media.entry(scene.ambient, DMat4(1.0));
        if (!ambient) return ambient.error();
    }
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const auto* filling = std::get_if<FilledWith>(&object.role);
        auto done = filling != nullptr ? add_solid(scene, object, static_cast<int>(i), *filling, kernel, media, *plan)
                                       : add_surface(scene, object, static_cast<int>(i), kernel, *plan);
        if (!done) return done.error();
    }
    plan->length_scale = extent(*plan);
    if (auto done = group_wavelengths(scene, media, *plan); !done) return done.error();
    if (plan->groups[0].media[0].dielectric.kind != MediumKind::isotropic)
        return Error{ErrorKind::input, "the ambient medium must be isotropic", {}, "ambient", {}};
    if (auto done = arrange(scene, *plan); !done) return done.error();
    if (auto done = place_camera(scene, *plan); !done) return done.error();
    if (auto done = compile_light(scene, *plan); !done) return done.error();
    plan->features = list_features(scene, *plan);
    return std::shared_ptr<const Plan>(std::move(plan));
}

}  // namespace pol
