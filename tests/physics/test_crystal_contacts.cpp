// SPDX-License-Identifier: Apache-2.0
// Crystals in contact beyond facts T26, T36 and T37: every angle, twins, meshes, and inlays in glass.
#include "geometry/shapes.h"
#include "physics/crystal_scene.h"
#include "support/shipped_scenes.h"

namespace pol::test {
namespace {

/// Two plates with axes at 45 degrees to their faces, the lower one turned by `alpha`, `gap` between them.
Explanation two_plates(double alpha, double gap) {
    return explain_look(scene_of(camera_along(downward(0.0)) + "render: {residual: 1e-6}\nmedia: {crystal: " +
                                 calcite({1.0, 0.0, 1.0}) + "}\nobjects:\n" + plate("upper", "crystal") +
                                 plate("lower", "crystal", -1.0 - gap, degrees(alpha)) + lamp_below()));
}

TEST(TwoPlates, T26ThroughAirShareLightAsHuygensSaw) {
    const double t_o = std::pow(1.0 - normal_reflectance(n_o), 2);
    const double t_e = std::pow(1.0 - normal_reflectance(n_45), 2);
    EXPECT_NEAR(t_o, 0.8810839, printed(7));
    EXPECT_NEAR(t_e, 0.9052230, printed(7));
    for (const double alpha : {0.0, 0.5, radians(30.0), radians(45.0), 1.3, radians(90.0)}) {
        const Explanation e = two_plates(alpha, 0.3);
        const double same = std::pow(std::cos(alpha), 2);
        const double other = std::pow(std::sin(alpha), 2);
        EXPECT_NEAR(share(e, "To T To T"), 0.5 * t_o * t_o * same, 4.0 * surface_rounding) << alpha;
        EXPECT_NEAR(share(e, "Te T Te T"), 0.5 * t_e * t_e * same, 4.0 * surface_rounding) << alpha;
        EXPECT_NEAR(share(e, "To T Te T"), 0.5 * t_o * t_e * other, 4.0 * surface_rounding) << alpha;
        EXPECT_NEAR(share(e, "Te T To T"), 0.5 * t_e * t_o * other, 4.0 * surface_rounding) << alpha;
    }
}

/// Share of an o (or e) wave that crosses from a plate with principal section along x into one turned by alpha, as o
/// and as e. At normal incidence H_t = Y E_t, Y = n_o o o^T + n_45 e e^T with the two field directions, so that E_t = 2
/// (Y1 + Y2)^-1 Y1 E_i.
DVec2 contact_shares(double alpha, bool ordinary) {
    const DVec2 e1(1.0, 0.0), o1(0.0, 1.0);
    const DVec2 e2(std::cos(alpha), std::sin(alpha)), o2(-std::sin(alpha), std::cos(alpha));
    const double index = ordinary ? n_o : n_45;
    const double xx = n_45 + n_45 * e2.x * e2.x + n_o * o2.x * o2.x;
    const double xy = n_45 * e2.x * e2.y + n_o * o2.x * o2.y;
    const double yy = n_o + n_45 * e2.y * e2.y + n_o * o2.y * o2.y;
    const DVec2 in = 2.0 * index * (ordinary ? o1 : e1);
    const DVec2 t = DVec2(yy * in.x - xy * in.y, xx * in.y - xy * in.x) / (xx * yy - xy * xy);
    return {n_o / index * std::pow(t.x * o2.x + t.y * o2.y, 2), n_45 / index * std::pow(t.x * e2.x + t.y * e2.y, 2)};
}

TEST(TwoPlates, T26InContactShareLightAsTheAdmittancesOfOneInterfaceSay) {
    for (const double alpha : {0.5, radians(30.0), radians(45.0), 1.3}) {
        const Explanation e = two_plates(alpha, 0.0);
        const DVec2 from_o = contact_shares(alpha, true);
        const DVec2 from_e = contact_shares(alpha, false);
        EXPECT_NEAR(share(e, "To To") / share(e, "To"), from_o.x, 4.0 * surface_rounding) << alpha;
        EXPECT_NEAR(share(e, "To Te") / share(e, "To"), from_o.y, 4.0 * surface_rounding) << alpha;
        EXPECT_NEAR(share(e, "Te To") / share(e, "Te"), from_e.x, 4.0 * surface_rounding) << alpha;
        EXPECT_NEAR(share(e, "Te Te") / share(e, "Te"), from_e.y, 4.0 * surface_rounding) << alpha;
    }
    const Explanation e = two_plates(radians(30.0), 0.0);
    EXPECT_NEAR(share(e, "To To") / share(e, "To"), 0.7496875, printed(7));
    EXPECT_NEAR(share(e, "To Te") / share(e, "To"), 0.2501042, printed(7));
}

// Axes mirrored in the seam: the sections coincide and k sees the same index, but the ray walks off the other way.
TEST(TwoPlates, AsTwinsBringTheExtraordinaryRayBackWithoutAReflection) {
    const Explanation e = two_plates(pi, 0.0);
    const double radius = (eps_o - eps_e) / (eps_o + eps_e);
    EXPECT_NEAR(branch(e, "Te").end.origin.x, radius, 16.0 * eps);
    EXPECT_NEAR(branch(e, "Te Te").end.origin.x, 0.0, 32.0 * eps);
    EXPECT_NEAR(branch(e, "Te Te").end.origin.z, -2.0, 8.0 * eps);
    // Amplitudes of what is absent are rounding, shares their square.
    for (const char* absent : {"Te Re", "Te Ro", "Te To", "To Re", "To Ro", "To Te"})
        EXPECT_LT(share(e, absent), surface_rounding * surface_rounding) << absent;
    EXPECT_NEAR(share(e, "Te Te"), share(e, "Te"), surface_rounding);
}

// Axes that differ in sign are the same axis: the seam between the halves makes no child and changes no direction.
TEST(CrystalsInContact, T36OfOneOrientationAreOneCrystal) {
    const auto scene = [](const std::string& objects) {
        return scene_of(camera_along(downward(0.6)) +
                        "render: {residual: 1e-12, node_budget: 100000}\nmedia: {upper: " + calcite({1.0, 2.0, 3.0}) +
                        ", lower: " + calcite({-1.0, -2.0, -3.0}) + "}\nobjects:\n" + objects +
                        lamp("lamp", {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}, 20.0));
    };
    const Scene two = scene(box("a", {8.0, 8.0, 0.5}, {0.0, 0.0, -0.25}, "upper") +
                            box("b", {8.0, 8.0, 0.5}, {0.0, 0.0, -0.75}, "lower"));
    const Scene one = scene(box("a", {8.0, 8.0, 1.0}, {0.0, 0.0, -0.5}, "upper"));
    const Explanation e = explain_look(two);
    for (const std::string mode : {"To", "Te"}) {
        const RayTreeNode& upper = branch(e, mode);
        ASSERT_EQ(upper.children.size(), 1U) << mode;
        const RayTreeNode& lower = branch(e, mode + " " + mode);
        EXPECT_EQ(lower.start.weight, upper.start.weight);
        EXPECT_LT(angle_between(lower.start.wave.ray, upper.start.wave.ray), 8.0 * eps);
    }
    // Each leaves out 1e-12 of the light; some 50 passes carry the rest.
    expect_stokes(look(two), look(one), 2e-12 + 50.0 * surface_rounding);
}

/// Plates with their axes in the face, along x above and along y below, in contact.
const std::string crossed_plates =
    camera_along(downward(0.0)) +
    "render: {residual: 1e-14, node_budget: 100000}\nmedia: {upper: " + calcite({1.0, 0.0, 0.0}) +
    ", lower: " + calcite({0.0, 1.0, 0.0}) + "}\nobjects:\n" + box("a", {8.0, 8.0, 0.5}, {0.0, 0.0, -0.25}, "upper") +
    box("b", {8.0, 8.0, 0.5}, {0.0, 0.0, -0.75}, "lower") + lamp("lamp", {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}, 20.0);
const double reflected_at_seam = std::pow((n_o - n_e) / (n_o + n_e), 2);

// A plate with a distant box is no convex solid any more and goes to Embree. The ray meets the seam on the diagonal
// between two triangles.
TEST(CrystalsInContact, HaveOneInterfaceAlsoWhereTheyAreMeshes) {
    const Stokes<double> exact = look(crossed_plates);
    for (const auto& meshes : std::vector<std::vector<std::size_t>>{{0}, {1}, {0, 1}}) {
        Scene scene = scene_of(crossed_plates);
        for (const std::size_t object : meshes) {
            Mesh far_box = make_mesh(BoxShape{{1.0, 1.0, 1.0}}).value();
            const DVec3 shift(20.0, 20.0 * static_cast<double>(object), 0.0);
            for (DVec3& vertex : far_box.vertices) vertex += shift;
            for (Plane& plane : far_box.facets) plane.offset += dot(plane.normal, shift);
            const Mesh both = joined(make_mesh(scene.objects[object].shape).value(), far_box);
            scene.objects[object].shape = MeshShape{"", std::make_shared<const Mesh>(both)};
        }
        ASSERT_TRUE(plan_of(scene)->features.meshes);
        expect_stokes(look(scene), exact, 1e-14 + 40.0 * surface_rounding);
        const Explanation e = explain_look(scene);
        EXPECT_EQ(e.result.failures, 0U);
        EXPECT_NEAR(kept(e, "To Te", "To"), 1.0 - reflected_at_seam, surface_rounding);
    }
}

TEST(CrystalsInContact, AnInlayFlushWithItsHostIsMetFromOutsideAtOnce) {
    const Explanation e = explain_look(scene_of(
        camera_along(downward(0.0)) + "media: {glass: 1.5, crystal: " + calcite({1.0, 0.0, 0.0}) + "}\nobjects:\n" +
        "  - {name: host, shape: {box: {size: [8, 8, 1]}}, transform: [{translate: [0, 0, -0.5]}], medium: glass, "
        "priority: 0}\n" +
        "  - {name: inlay, shape: {box: {size: [2, 2, 0.5]}}, transform: [{translate: [0, 0, -0.25]}], "
        "medium: crystal, priority: 1}\n" +
        lamp("lamp", {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}, 20.0)));
    const auto against_glass = [](double n) { return 1.0 - std::pow((n - 1.5) / (n + 1.5), 2); };
    EXPECT_NEAR(share(e, "To"), 0.5 * (1.0 - normal_reflectance(n_o)), surface_rounding);
    EXPECT_NEAR(share(e, "Te"), 0.5 * (1.0 - normal_reflectance(n_e)), surface_rounding);
    EXPECT_NEAR(kept(e, "To T", "To"), against_glass(n_o), surface_rounding);
    EXPECT_NEAR(kept(e, "Te T", "Te"), against_glass(n_e), surface_rounding);
    EXPECT_NEAR(kept(e, "To T T", "To T"), 1.0 - normal_reflectance(1.5), surface_rounding);
    EXPECT_NEAR(branch(e, "To T").end.origin.z, -1.0, 4.0 * eps);
}

}  // namespace
}  // namespace pol::test
