// SPDX-License-Identifier: Apache-2.0
#include "plan/compile.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <string>

#include "core/overloaded.h"
#include "core/random.h"
#include "core/result.h"
#include "geometry/mesh_check.h"
#include "geometry/shapes.h"
#include "plan/arrangement.h"
#include "plan/compile_light.h"
#include "plan/compile_media.h"
#include "plan/list_features.h"
#include "plan/reach.h"
#include "plan/standpoint.h"
#include "scene/check.h"
#include "scene/node_budget.h"
#include "scene/place.h"

namespace pol {

namespace {

std::string direction_text(const DVec3& d) {
    char buffer[96];
    std::snprintf(buffer, sizeof buffer, "[%.6g, %.6g, %.6g]", d.x, d.y, d.z);
    return buffer;
}

/// Planes are tested one by one, and whether a mesh is convex takes their number squared. Embree is faster from 2000
/// on.
constexpr std::size_t most_half_spaces = 4096;

/// Shape of a solid in world space: half-spaces where it is flat-faced and convex, else a sphere or a mesh.
using SolidShape = std::variant<HalfSpaceSolid, Sphere, MeshBody>;

Result<SolidShape> from_mesh(const Mesh& object_mesh, const DMat4& to_world, bool as_mesh) {
    POL_TRY(auto mesh, transformed(object_mesh, to_world));
    const bool closed = static_cast<bool>(check_closed(mesh));
    const bool few = mesh.facets.size() <= most_half_spaces;
    if (!as_mesh && closed && few && is_convex(mesh)) {
        POL_TRY(auto solid, HalfSpaceSolid::from_mesh(std::move(mesh)));
        return SolidShape{std::move(solid)};
    }
    return SolidShape{MeshBody{std::move(mesh), closed}};
}

Result<SolidShape> solid_shape(const Object& object, bool as_mesh) {
    if (const auto* sphere = std::get_if<SphereShape>(&object.shape)) {
        POL_TRY(auto made, make_sphere(*sphere, object.to_world));
        return SolidShape{made};
    }
    if (const auto* file = std::get_if<MeshShape>(&object.shape))
        return from_mesh(*file->mesh, object.to_world, as_mesh);
    POL_TRY(auto mesh, make_mesh(object.shape));
    return from_mesh(mesh, object.to_world, as_mesh);
}

/// By facet, as from_mesh() keeps them: whether it looks along one of `directions`, to a milliradian (what three digits
/// of a direction are good for). Error: a direction that no facet has.
Result<std::vector<bool>> black_facets(const Shape& shape, const std::vector<DVec3>& directions) {
    if (directions.empty()) return std::vector<bool>{};
    const auto refusal = [](std::string what, std::string hint) {
        return Error{ErrorKind::input, std::move(what), {}, "black", std::move(hint)};
    };
    if (std::holds_alternative<SphereShape>(shape))
        return refusal("a sphere has no flat faces",
                       "to blacken all of it write 'absorber: on' in place of the medium");
    std::vector<Plane> facets;
    if (const auto* file = std::get_if<MeshShape>(&shape)) {
        facets = file->mesh->facets;
    } else {
        POL_TRY(auto mesh, make_mesh(shape));
        facets = std::move(mesh.facets);
    }
    std::vector<bool> black(facets.size(), false);
    for (const DVec3& given : directions) {
        const DVec3 direction = unit(given);
        bool found = false;
        DVec3 nearest = facets.front().normal;
        for (std::size_t i = 0; i < facets.size(); ++i) {
            const DVec3& normal = facets[i].normal;
            if (dot(normal, direction) > dot(nearest, direction)) nearest = normal;
            if (length2(normal - direction) > 1e-6) continue;
            black[i] = true;
            found = true;
        }
        if (!found)
            return refusal("no face looks along " + direction_text(given),
                           "the nearest one looks along " + direction_text(nearest));
    }
    return black;
}

Result<Done> add_solid(const Scene& scene, const Object& object, int index, const FilledWith& filling, bool as_mesh,
                       MediaTable& media, Plan& plan) {
    auto shape = solid_shape(object, as_mesh);
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
    auto black = black_facets(object.shape, filling.black_faces);
    if (!black) return at_object(black.error(), scene, index);
    plan.solids.push_back({object.name,
                           index,
                           medium.value(),
                           object.priority,
                           std::move(shape).value(),
                           {},
                           {},
                           std::move(black).value()});
    return Done{};
}

Result<Done> add_surface(const Scene& scene, const Object& object, int index, bool as_mesh, Plan& plan) {
    Surface surface{object.name, index, Sphere{}, AbsorberRole{}};
    const auto open = [&](const auto& shape) -> Result<Done> {
        POL_TRY(auto made, OpenSurface::from(shape, object.to_world));
        surface.shape = made;
        return Done{};
    };
    const Result<Done> shaped = std::visit(Overloaded{
                                               [&](const RectangleShape& s) { return open(s); },
                                               [&](const DiskShape& s) { return open(s); },
                                               [&](const auto&) -> Result<Done> {
                                                   POL_TRY(auto shape, solid_shape(object, as_mesh));
                                                   std::visit([&](auto& s) { surface.shape = std::move(s); }, shape);
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

/// WavelengthGroup::key. Directions are left out: a scene that is turned in space keeps its random numbers.
std::uint32_t key_of(const std::vector<MediumAt>& media, const std::vector<Dielectric<double>>& plates) {
    std::uint64_t key = 0;
    const auto add = [&key](double constant) { key = mix_bits(key ^ std::bit_cast<std::uint64_t>(constant)); };
    const auto add_dielectric = [&add](const Dielectric<double>& d) { add(d.n), add(d.n_e), add(d.kappa); };
    for (const MediumAt& medium : media) {
        add_dielectric(medium.dielectric);
        add(medium.absorption.ordinary), add(medium.absorption.extraordinary);
    }
    for (const Dielectric<double>& plate : plates) add_dielectric(plate);
    return static_cast<std::uint32_t>(key);
}

/// WavelengthGroup::places of a wavelength in a scene with dispersion.
std::uint32_t places_of(double wavelength_nm) {
    return static_cast<std::uint32_t>(mix_bits(std::bit_cast<std::uint64_t>(wavelength_nm))) | 1U;
}

/// Wavelengths with equal constants of all media share a group, if they share the places of their samples.
Result<Done> group_wavelengths(const Scene& scene, const MediaTable& media, Plan& plan) {
    plan.medium_names = media.names();
    for (std::size_t w = 0; w < plan.wavelengths_nm.size(); ++w) {
        POL_TRY(auto at, media.at(plan.wavelengths_nm[w]));
        POL_TRY(const auto plates, plate_crystals(scene, plan, plan.wavelengths_nm[w]));
        const std::uint32_t places = media.disperses() ? places_of(plan.wavelengths_nm[w]) : 0;
        std::size_t group = 0;
        while (group < plan.groups.size() && (plan.kept.tree_per_wavelength ||
                                              !(plan.groups[group].media == at && plan.groups[group].places == places &&
                                                same_plates(plan, static_cast<int>(group), plates))))
            ++group;
        if (group == plan.groups.size()) {
            plan.groups.push_back({{}, at, key_of(at, plates), places});
            append_plates(plan, plates);
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

/// The rectangle that the rays of an orthographic picture start on.
OpenSurface start_of_rays(const Camera& camera, const RenderSettings& settings) {
    const auto corner = [&](double x, double y) {
        return CameraModel(camera, settings.width, settings.height).ray(x, y).origin;
    };
    const DVec3 top_left = corner(0.0, 0.0);
    const DVec3 right = corner(settings.width, 0.0) - top_left;
    const DVec3 down = corner(0.0, settings.height) - top_left;
    DMat4 to_world(1.0);
    to_world[0] = glm::dvec4(right, 0.0);
    to_world[1] = glm::dvec4(down, 0.0);
    to_world[2] = glm::dvec4(unit(cross(right, down)), 0.0);
    to_world[3] = glm::dvec4(top_left + 0.5 * right + 0.5 * down, 1.0);
    return OpenSurface::from(RectangleShape{{1.0, 1.0}}, to_world).value();
}

/// A region unfit for a camera that some pixel's ray starts in, looked for at no more than 65536 pixel centres; -1 if
/// there is none. The tracer fails the samples that start in a sliver between them.
int unfit_start(const Plan& plan) {
    const int width = plan.settings.width;
    const int height = plan.settings.height;
    const int step = 1 + static_cast<int>(std::sqrt(static_cast<double>(width) * height / 65536.0));
    for (int y = 0; y < height; y += step)
        for (int x = 0; x < width; x += step) {
            const int region = plan.region_at(plan.camera.ray(x + 0.5, y + 0.5).origin);
            if (!is_fit_for_camera(plan, region)) return region;
        }
    return -1;
}

/// The lamp or absorber whose closed body a ray of the picture starts in, looked for as above; null if there is none.
const Surface* body_around_camera(const Scene& scene, const Plan& plan) {
    if (scene.camera.projection != Projection::orthographic) return body_around(plan, scene.camera.position);
    const int step =
        1 + static_cast<int>(std::sqrt(static_cast<double>(plan.settings.width) * plan.settings.height / 65536.0));
    for (int y = 0; y < plan.settings.height; y += step)
        for (int x = 0; x < plan.settings.width; x += step)
            if (const Surface* found = body_around(plan, plan.camera.ray(x + 0.5, y + 0.5).origin)) return found;
    return nullptr;
}

/// Fills in Plan::camera, camera_region and camera_regions. Error: a body or a medium that no camera can stand in.
Result<Done> place_camera(const Scene& scene, Plan& plan) {
    plan.camera = CameraModel(scene.camera, plan.settings.width, plan.settings.height);
    if (const Surface* body = body_around_camera(scene, plan))
        return at_place({ErrorKind::input,
                         "the camera is inside '" + body->name + "', a lamp or absorber that is seen from outside only",
                         {},
                         "camera.position",
                         "move the camera out; `background:` is light from everywhere"},
                        scene, scene.camera.place);
    int unfit = -1;
    if (scene.camera.projection == Projection::orthographic) {
        const Reach reach(plan.solids);
        const SurfaceShape start = start_of_rays(scene.camera, plan.settings);
        for (std::size_t r = 0; r < plan.regions.size(); ++r)
            if (reach.into(plan.regions[r], start)) plan.camera_regions.push_back(static_cast<int>(r));
        const bool all_fit = std::all_of(plan.camera_regions.begin(), plan.camera_regions.end(),
                                         [&](int r) { return is_fit_for_camera(plan, r); });
        if (!all_fit) unfit = unfit_start(plan);
    } else {
        plan.camera_regions = {plan.region_at(scene.camera.position)};
        if (!is_fit_for_camera(plan, plan.camera_regions[0])) unfit = plan.camera_regions[0];
    }
    plan.camera_region = plan.camera_regions.size() == 1 && !plan.kept.start_search ? plan.camera_regions[0] : -1;
    if (unfit < 0) return Done{};
    const int owner = plan.regions[static_cast<std::size_t>(unfit)].owner;
    return at_place(
        {ErrorKind::input,
         "the camera is inside '" + plan.solid(owner).name + "', which " +
             (is_isotropic(plan, unfit) ? "absorbs all light within a few wavelengths" : "is not isotropic"),
         {},
         "camera.position",
         "a pixel's coherence matrix needs an isotropic medium with k below 0.01: move the camera out"},
        scene, scene.camera.place);
}

}  // namespace

Result<std::shared_ptr<const Plan>> compile(const Scene& scene, const SpareParts& kept) {
    if (auto problem = first_problem(scene)) return *problem;
    auto plan = std::make_shared<Plan>();
    plan->settings = scene.render;
    plan->settings.node_budget = node_budget_in_force(scene);
    plan->title = scene.title;
    plan->kept = kept;
    if (kept.depth_limit && !plan->settings.depth) plan->settings.depth = std::numeric_limits<int>::max();
    plan->wavelengths_nm = scene.render.wavelengths_nm;

    MediaTable media(scene);
    if (!scene.ambient.empty()) {
        POL_TRY_DONE(media.entry(scene.ambient, DMat4(1.0)));
    }
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const auto* filling = std::get_if<FilledWith>(&object.role);
        POL_TRY_DONE(filling != nullptr
                         ? add_solid(scene, object, static_cast<int>(i), *filling, kept.meshes, media, *plan)
                         : add_surface(scene, object, static_cast<int>(i), kept.meshes, *plan));
    }
    plan->length_scale = extent(*plan);
    POL_TRY_DONE(group_wavelengths(scene, media, *plan));
    if (plan->groups[0].media[0].dielectric.kind != MediumKind::isotropic)
        return Error{ErrorKind::input, "the ambient medium must be isotropic", {}, "ambient", {}};
    for (const WavelengthGroup& group : plan->groups)
        if (group.media[0].dielectric.kappa >= strongest_camera_extinction)
            return Error{ErrorKind::input,
                         "the ambient medium absorbs all light within a few wavelengths",
                         {},
                         "ambient",
                         "a camera needs a medium whose k is below 0.01"};
    POL_TRY_DONE(arrange(scene, *plan));
    POL_TRY_DONE(place_camera(scene, *plan));
    POL_TRY_DONE(compile_light(scene, *plan));
    plan->features = list_features(scene, *plan);
    return std::shared_ptr<const Plan>(std::move(plan));
}

}  // namespace pol
