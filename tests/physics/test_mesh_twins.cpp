// SPDX-License-Identifier: Apache-2.0
// Solids as sets of half-spaces and as meshes in Embree: one picture, and no ray that leaks.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/shapes.h"
#include "polarization/measures.h"
#include "support/shipped_scenes.h"
#include "tracer/observers.h"

namespace pol {
namespace {

/// Pixels of the two pictures whose Stokes vectors differ by more than `tolerance` times the brightest light.
int differing_pixels(const StokesImage& a, const StokesImage& b, double tolerance) {
    int count = 0;
    for (std::size_t p = 0; p < a.pixel_count(); ++p) {
        const Stokes<double> d = a.at(0, p) - b.at(0, p);
        if (!(std::abs(d.s0) + polarized_part(d) <= tolerance * a.brightest[0])) ++count;
    }
    return count;
}

/// A jewel and a distant box, as two half-space solids or as one mesh, which is not convex and goes to Embree.
Scene jewel_scene(bool one_mesh, const std::string& medium) {
    Scene scene = test::scene_of(R"(
camera: {position: [0.35, -4, 3.2], target: [0, 0, -0.1], fov: 34}
background: 0.1
render: {size: [40, 40], depth: 7, residual: 0, node_budget: 1000000}
media:
  glass: 1.5
  crystal: {ordinary: 1.6, extraordinary: 1.5, axis: [1, 0, 1]}
objects:
  - {name: stone, shape: {brilliant: {diameter: 2}}, medium: glass}
  - {name: far box, shape: {box: {size: 0.5}}, transform: [{translate: [1.5, 1.5, 0]}], medium: glass}
  - {name: lamp, shape: {rectangle: {size: 3}}, transform: [{translate: [0, 0, -0.95]}],
     emission: {radiance: 1, polarization: {dop: 1, azimuth: 20, ellipticity: 0.5, handedness: left}}}
)");
    for (std::size_t i = 0; i < 2; ++i) scene.objects[i].role = FilledWith{medium};
    if (!one_mesh) return scene;
    const auto world_mesh = [](const Object& object) {
        return transformed(make_mesh(object.shape).value(), object.to_world).value();
    };
    const Mesh both = test::joined(world_mesh(scene.objects[0]), world_mesh(scene.objects[1]));
    scene.objects[0].shape = MeshShape{"", std::make_shared<const Mesh>(both)};
    scene.objects.erase(scene.objects.begin() + 1);
    return scene;
}

// Planes and normals are the same doubles on both ways, so points agree to a few roundings. Amplitudes inherit that
// times the slope of Fresnel's formulas, 1/sqrt(x) at the distance x from the critical angle: with 1e6 interfaces in a
// picture the closest comes within x = 1e-6, slope 1e3, so 1e-15 x 40 surfaces operations x 1e3 < 1e-10. A pixel
// differs for good where a path passes an edge by less than the rounding.
TEST(HalfSpacesAndEmbree, ShowTheSamePictureOfTheSameSolid) {
    for (const std::string medium : {"glass", "crystal"}) {
        Scene exact = jewel_scene(false, medium);
        Scene mesh = jewel_scene(true, medium);
        if (medium == "crystal")
            for (Scene* scene : {&exact, &mesh}) *scene = verify::cut_by_depth(test::small(*scene, 20), 5);
        ASSERT_FALSE(test::plan_of(exact)->features.meshes);
        ASSERT_TRUE(test::plan_of(mesh)->features.meshes);
        const StokesImage a = test::render(exact);
        const StokesImage b = test::render(mesh);
        EXPECT_LE(differing_pixels(a, b, 1e-10), static_cast<int>(a.pixel_count() / 200)) << medium;
        EXPECT_TRUE(b.failures.empty()) << medium;
    }
}

/// Corners of all facets of `mesh`, and midpoints of all triangle edges (diagonals of facets among them).
std::vector<DVec3> corners_and_midpoints(const Mesh& mesh) {
    std::vector<DVec3> points = mesh.vertices;
    for (const auto& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i];
            const std::uint32_t b = t[(i + 1) % 3];
            if (a < b) points.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
        }
    return points;
}

// A ray that meets an edge exactly may take either facet, but must take one: no failure, and no energy lost.
TEST(HalfSpacesAndEmbree, NoRayLeaksThroughAnEdgeOrCornerOfTheBrilliant) {
    for (const bool one_mesh : {false, true}) {
        Scene scene = jewel_scene(one_mesh, "glass");
        scene.render.depth = 6;
        const auto plan = test::plan_of(scene);
        const Mesh stone = make_mesh(BrilliantShape{}).value();
        Silent silent;
        Tracer<false, false, Silent> tracer(*plan, silent);
        int rays = 0;
        for (const DVec3& point : corners_and_midpoints(stone)) {
            for (int i = 0; i < 25; ++i) {
                // Points of a spiral on a sphere around the stone.
                const double height = -0.96 + 0.08 * i;
                const double radius = std::sqrt(1.0 - height * height);
                const DVec3 from = 5.0 * DVec3(radius * std::cos(2.4 * i), radius * std::sin(2.4 * i), height);
                Camera camera;
                camera.position = from;
                camera.target = point;
                camera.up = DVec3(0.1, 0.2, 1.0);
                camera.horizontal_fov = 0.1;
                TraceTask task;
                task.ray = CameraModel(camera, 1, 1).ray(0.5, 0.5);
                task.residual = plan->settings.residual;
                task.node_budget = plan->settings.node_budget;
                Stokes<double> light;
                const TraceResult r = tracer.trace(task, {&light, 1});
                ASSERT_EQ(r.failures, 0U) << "one mesh: " << one_mesh << ", direction " << i;
                ASSERT_NEAR(r.resolved + r.absorbed + r.residual, 1.0, 1e-11);
                ++rays;
            }
        }
        EXPECT_GT(rays, 2000);
    }
}

}  // namespace
}  // namespace pol
