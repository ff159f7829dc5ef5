// SPDX-License-Identifier: Apache-2.0
// physics.md T30 to T34, T36 and T38 to T40: single faces of a crystal, and conservation.
#include "io/index_file.h"
#include "physics/crystal_scene.h"

namespace pol::test {
namespace {

TEST(CrystalFace, T30ReflectsNoPAtTheBrewsterAngleOfItsCut) {
    const struct {
        DVec3 axis;
        double brewster, printed_degrees, n_s;  // n_s: index that s sees
    } rows[] = {
        {{0.0, 0.0, 1.0}, std::atan(std::sqrt(eps_e * (eps_o - 1.0) / (eps_e - 1.0))), 60.7847111, n_o},
        {{1.0, 0.0, 0.0}, std::atan(std::sqrt(eps_o * (eps_e - 1.0) / (eps_o - 1.0))), 54.0424954, n_o},
        {{0.0, 1.0, 0.0}, std::atan(n_o), 58.9104081, n_e},
    };
    for (const auto& row : rows) {
        const double i = row.brewster;
        EXPECT_NEAR(degrees(i), row.printed_degrees, printed(7));
        const Stokes<double> s =
            look(camera_along(downward(i)) + "media: {crystal: " + calcite(row.axis) + "}\nobjects:\n" +
                 deep_block("crystal") + lamp("lamp", upward(i) * 10.0, -upward(i), 0.5));
        const double r_s = ClosedFresnel(row.n_s, i).R_s();
        expect_stokes(s, {0.5 * r_s, 0.5 * r_s, 0.0, 0.0}, surface_rounding);
        EXPECT_NEAR(measure(s).dop, 1.0, 4.0 * eps);
    }
}

/// Inside a crystal with its axis along (1, 1, 1): a wave normal meets the face z = 0 from below at the angle `i` in
/// the plane y = 0. The light came in through a face across that wave normal. Extrusions lie along z, so everything is
/// turned: (x, y, z) of the fact is (x, z, -y) of the scene.
Explanation inside_calcite(double i) {
    const DVec3 s(std::sin(i), std::cos(i), 0.0);
    const DVec2 corner(-1.0, 0.0);
    const DVec2 along_face(std::cos(i), -std::sin(i));
    const DVec3 from = s * -5.0;
    return explain_look(scene_of("camera: {type: orthographic, position: " + text(from) +
                                 ", target: [0, 0, 0], up: [0, 0, 1], width: 0.01}\nrender: {depth: 2}\n" +
                                 "media: {crystal: " + calcite({1.0, 1.0, -1.0}) + "}\nobjects:\n" +
                                 extruded("wedge", {corner, corner + along_face * 1.5, {3.0, 0.0}}, "crystal")));
}

TEST(InsideCalcite, T31BeyondTheExtraordinarySheetAllPowerStaysInTheReflectedOrdinaryWave) {
    const Explanation e = inside_calcite(radians(75.0));
    EXPECT_EQ(branch(e, "To").children.size(), 1U);
    EXPECT_NEAR(kept(e, "To Ro", "To"), 1.0, surface_rounding);

    // The e sheet ends where disc of physics.md 2.5 vanishes; with n.eps n = (2 eps_o + eps_e)/3 that is
    // k_t^2 = eps_e (2 eps_o + eps_e)/(eps_o + 2 eps_e) for this axis and plane.
    const double end = std::sqrt(eps_e * (2.0 * eps_o + eps_e) / (eps_o + 2.0 * eps_e));
    EXPECT_NEAR(end, 1.5414548, printed(7));
    const double last = std::asin(end / n_o);
    EXPECT_NEAR(degrees(last), 68.3543897, printed(7));
    // The angle at the face is good to a few eps.
    EXPECT_NE(find_branch(inside_calcite(last - 1e-12), "To Re"), nullptr);
    EXPECT_EQ(find_branch(inside_calcite(last + 1e-12), "To Re"), nullptr);
}

TEST(InsideCalcite, T32TotalReflectionTurnsAThirdOfTheOrdinaryWaveIntoTheExtraordinary) {
    const Explanation e = inside_calcite(radians(60.0));
    EXPECT_EQ(branch(e, "To").children.size(), 2U);
    EXPECT_NEAR(kept(e, "To Ro", "To"), 0.6648153, printed(7));
    EXPECT_NEAR(kept(e, "To Re", "To"), 0.3351847, printed(7));
    EXPECT_NEAR(kept(e, "To Ro", "To") + kept(e, "To Re", "To"), 1.0, surface_rounding);
    // Both keep the tangential wave vector and turn the normal one round.
    for (const char* route : {"To Ro", "To Re"}) {
        const DVec3 k = branch(e, route).start.wave.k;
        EXPECT_NEAR(k.x, n_o * std::sin(radians(60.0)), 16.0 * eps) << route;
        EXPECT_NEAR(k.z, 0.0, 16.0 * eps) << route;
        EXPECT_LT(branch(e, route).start.wave.ray.y, 0.0) << route;
    }
}

// Seen from below through a polarizer, so that s or p alone is traced: the scene's z axis points into the crystal.
TEST(CrystalFace, T33WithAnObliqueAxisSharesSAndPAmongFourWaves) {
    const double i = radians(40.0);
    const DVec3 d(std::sin(i), 0.0, std::cos(i));
    const DVec3 s(0.0, 1.0, 0.0);
    const DVec3 p_reflected = cross(DVec3(d.x, 0.0, -d.z), s);
    const struct {
        DVec3 passes;
        double r_s, r_p, t_o, t_e;
    } rows[] = {{s, .0988192860, .0003862017, .0136222293, .8871722831},
                {cross(d, s), .0000051598, .0260771219, .9598073577, .0141103606}};
    for (const auto& row : rows) {
        const Explanation e = explain_look(
            scene_of(camera_along(d) + "render: {depth: 2}\nmedia: {crystal: " + calcite({1.0, 2.0, 3.0}) +
                     "}\nobjects:\n" + box("block", {40.0, 40.0, 4.0}, {0.0, 0.0, 2.0}, "crystal") +
                     "  - {name: polarizer, shape: {disk: {radius: 1}}, " + placed(d * -2.0, d, s) +
                     ", sheet: {polarizer: {axis: " + (row.passes == s ? "[1, 0, 0]" : "[0, 1, 0]") + "}}}\n"));
        const double light = share(e, "S");
        EXPECT_NEAR(light, 0.5, surface_rounding);
        EXPECT_NEAR(share_along(e, "S R", s) / light, row.r_s, printed(10));
        EXPECT_NEAR(share_along(e, "S R", p_reflected) / light, row.r_p, printed(10));
        EXPECT_NEAR(share(e, "S To") / light, row.t_o, printed(10));
        EXPECT_NEAR(share(e, "S Te") / light, row.t_e, printed(10));
        const DVec3 ray = branch(e, "S Te").start.wave.ray;
        EXPECT_NEAR(ray.x, .4125141726, printed(10));
        EXPECT_NEAR(ray.y, -.1022513741, printed(10));
        EXPECT_NEAR(ray.z, .9051942962, printed(10));
    }
}

TEST(CrystalFace, T34RefractsTheExtraordinaryRayByTheLawOfItsCut) {
    const struct {
        double incidence, c_cut, a_cut, ordinary;  // printed degrees
    } rows[] = {{30.0, 21.7288873, 15.8234678, 17.5474435}, {60.0, 38.6539716, 28.7588923, 31.4803007}};
    for (const auto& row : rows) {
        const double i = radians(row.incidence);
        const auto ray_angle = [&](const DVec3& axis, const char* route) {
            const Explanation e =
                explain_look(scene_of(camera_along(downward(i)) + "media: {crystal: " + calcite(axis) +
                                      "}\nobjects:\n" + deep_block("crystal")));
            return angle_between(branch(e, route).start.wave.ray, downward(0.0));
        };
        const double s = std::sin(i);
        const DVec3 across_face(0.0, 0.0, 1.0);
        const DVec3 in_face(1.0, 0.0, 0.0);
        const double c_cut = ray_angle(across_face, "Te");
        const double a_cut = ray_angle(in_face, "Te");
        EXPECT_NEAR(c_cut, std::atan(n_o * s / (n_e * std::sqrt(eps_e - s * s))), surface_rounding);
        EXPECT_NEAR(a_cut, std::atan(n_e * s / (n_o * std::sqrt(eps_o - s * s))), surface_rounding);
        EXPECT_NEAR(degrees(c_cut), row.c_cut, printed(7));
        EXPECT_NEAR(degrees(a_cut), row.a_cut, printed(7));
        for (const DVec3& axis : {across_face, in_face})
            EXPECT_NEAR(degrees(ray_angle(axis, "To")), row.ordinary, printed(7));
    }
}

// The axis is across the plane of incidence: p is o and sees no boundary at all, s is e and sees 1.4864 in 1.6584.
TEST(CrystalFace, T36InALiquidOfTheOrdinaryIndexIsInvisibleToTheOrdinaryRay) {
    const double i = radians(35.0);
    const std::string yaml =
        camera_along(downward(i)) +
        "ambient: liquid\nrender: {residual: 1e-14}\nmedia: {liquid: 1.6584, crystal: " + calcite({0.0, 1.0, 0.0}) +
        "}\nobjects:\n" + box("plate", {8.0, 8.0, 0.5}, {0.0, 0.0, -0.25}, "crystal") +
        lamp("lamp", {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}, 20.0);
    const Stokes<double> s = look(yaml);
    const double r_s = ClosedFresnel(n_e / n_o, i).R_s();
    const double t_s = (1.0 - r_s) / (1.0 + r_s);
    expect_stokes(s, {0.5 * (1.0 + t_s), 0.5 * (t_s - 1.0), 0.0, 0.0}, all_passes);
    const Explanation e = explain_look(scene_of(yaml));
    EXPECT_NEAR(share(e, "To"), 0.5, surface_rounding);
    EXPECT_LT(share_along(e, "R", cross(upward(i), DVec3(0.0, 1.0, 0.0))), surface_rounding * surface_rounding);
    EXPECT_LT(angle_between(branch(e, "To T").start.wave.ray, downward(i)), 8.0 * eps);
}

/// A calcite jewel in uniform surroundings, as few pixels as show all of its facets.
Scene jewel_in_a_furnace() {
    return scene_of(
        "camera: {position: [0.35, -4, 3.2], target: [0, 0, -0.1], fov: 32}\n"
        "background: 1\nrender: {size: [12, 12], residual: 0.05, node_budget: 20000}\n"
        "media: {crystal: " +
        calcite({1.0, 2.0, 3.0}) +
        "}\nobjects:\n  - {name: stone, shape: {brilliant: {diameter: 2}}, medium: crystal}\n");
}

// J = L/2 for what was traced and something between 0 and residual L for what was not (performance.md 3.3). Rounding:
// thousands of leaves whose weights, 1 in all, passed through some 10 surfaces.
TEST(CrystalInAFurnace, T38IsInvisibleAndUnpolarizedButForItsResidual) {
    const StokesImage image = render(jewel_in_a_furnace());
    double least_open = 1.0;
    for (std::size_t p = 0; p < image.pixel_count(); ++p) {
        const double residual = image.plane_value(image.residual, 0, p);
        EXPECT_LE(residual, 0.05);
        EXPECT_EQ(image.plane_value(image.tail, 0, p), 0.0);
        EXPECT_NEAR(image.at(0, p).s0, 1.0 - residual, 1e-12);
        EXPECT_LE(polarized_part(image.at(0, p)), residual + 1e-12);
        least_open = std::min(least_open, residual);
    }
    EXPECT_EQ(least_open, 0.0);  // beside the jewel
    EXPECT_GT(image.plane_value(image.residual, 0, image.pixel(6, 6)), 0.0);
}

// A plate's tree ends by itself: nothing is left over, P = 0 to rounding.
TEST(CrystalInAFurnace, T38IsUnpolarizedToRoundingWhereTheTreeIsFollowedToTheEnd) {
    const Stokes<double> s = look(
        camera_along(downward(0.7)) +
        "background: 1\nrender: {residual: 1e-13, node_budget: 200000}\nmedia: {crystal: " + calcite({1.0, 2.0, 3.0}) +
        "}\nobjects:\n" + box("plate", {1000.0, 1000.0, 0.5}, {0.0, 0.0, 0.0}, "crystal"));
    expect_stokes(s, {1.0, 0.0, 0.0, 0.0}, 1e-13 + 50.0 * surface_rounding);
}

// The parent's weight at the surface is what its children carry; the tree is what the picture is made of.
TEST(CrystalInAFurnace, T39ConservesEnergyAtEveryInterfaceOfAPicture) {
    const auto plan = plan_of(jewel_in_a_furnace());
    int interfaces = 0;
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x) {
            const Explanation e = explain(*plan, x, y, 0, 0);
            EXPECT_TRUE(e.exact());
            EXPECT_EQ(e.result.failures, 0U);
            EXPECT_NEAR(e.result.resolved + e.result.absorbed + e.result.residual, 1.0, 1e-11);
            for (const RayTreeNode& node : e.tree.nodes) {
                if (node.reason || node.children.empty()) continue;
                double sum = 0.0;
                for (const int child : node.children) sum += e.tree.nodes[static_cast<std::size_t>(child)].start.weight;
                ASSERT_NEAR(sum / node.end.weight, 1.0, 1e-11);
                ++interfaces;
            }
        }
    EXPECT_GT(interfaces, 1000);
}

// Biaxial media are not rendered; the indices of KTP that ship with the program must still give its optic axes:
// tan^2 V = eps_z (eps_y - eps_x)/(eps_x (eps_z - eps_y)) from z, and the cone of internal conical refraction.
TEST(BiaxialIndices, T40OfKtpGiveItsOpticAxesAndCone) {
    const auto eps_at_d = [](const char* record) {
        const auto index = load_index(record, POL_ASSETS);
        EXPECT_TRUE(index) << record;
        const auto n = index_at(index.value(), 589.3);
        EXPECT_TRUE(n) << record;
        return n.value().n * n.value().n;
    };
    const double x = eps_at_d("ktp-alpha");
    const double y = eps_at_d("ktp-beta");
    const double z = eps_at_d("ktp-gamma");
    EXPECT_NEAR(degrees(std::atan(std::sqrt(z * (y - x) / (x * (z - y))))), 18.47219, printed(5));
    EXPECT_NEAR(degrees(std::atan(y * std::sqrt((1.0 / x - 1.0 / y) * (1.0 / y - 1.0 / z)))), 1.90721, printed(5));
}

}  // namespace
}  // namespace pol::test
