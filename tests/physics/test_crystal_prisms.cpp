// SPDX-License-Identifier: Apache-2.0
// physics.md T27 to T29: prisms, polarizers with a gap, and beam splitters made of crystals.
#include "physics/crystal_scene.h"

namespace pol::test {
namespace {

/// Camera that looks at `target` along `direction` in the xy plane; the picture's y axis is z, its x axis lies in the
/// xy plane.
std::string camera_in_plane(const DVec3& direction, const DVec3& target) {
    return "camera: {type: orthographic, position: " + text(target - direction * 10.0) + ", target: " + text(target) +
           ", up: [0, 0, 1], width: 0.01}\n";
}

std::string lamp_in_plane(const DVec3& center, const DVec3& normal, double size) {
    return "  - {name: lamp, shape: {rectangle: {size: " + text(size) + "}}, " +
           placed(center, normal, {0.0, 0.0, 1.0}) + ", emission: {radiance: 1}}\n";
}

/// A 60 degree prism with its axis along the refracting edge, met at the middle of its left face at the angle `i`.
const DVec3 left_face_middle(-0.5, 0.5 * std::sqrt(3.0), 0.0);
DVec3 towards_left_face(double i) {
    return {std::cos(i - radians(30.0)), std::sin(i - radians(30.0)), 0.0};
}
std::string prism_scene(double i, const std::string& lamp) {
    return camera_in_plane(towards_left_face(i), left_face_middle) + "media: {crystal: " + calcite({0.0, 0.0, 1.0}) +
           "}\nobjects:\n" + extruded("prism", {{-1.0, 0.0}, {1.0, 0.0}, {0.0, std::sqrt(3.0)}}, "crystal") + lamp;
}
double deviation(double i, const char* route) {
    const Explanation e = explain_look(scene_of(prism_scene(i, "")));
    return angle_between(branch(e, "").start.wave.ray, branch(e, route).start.wave.ray);
}

// The angle is the sum of two refractions, each a few roundings of numbers of order 1 with slopes up to 4 (the o ray
// leaves at 56 degrees).
TEST(Prism, T27OfSixtyDegreesDeviatesEachModeByItsOwnMinimum) {
    const struct {
        const char* route;
        double n, printed_degrees;
    } rows[] = {{"To T", n_o, 52.0332923}, {"Te T", n_e, 36.0094493}};
    for (const auto& row : rows) {
        const double i = std::asin(0.5 * row.n);
        const double least = deviation(i, row.route);
        EXPECT_NEAR(least, 2.0 * i - radians(60.0), 64.0 * eps) << row.route;
        EXPECT_NEAR(degrees(least), row.printed_degrees, printed(7)) << row.route;
        for (const double turned : {-0.01, 0.01}) EXPECT_GT(deviation(i + turned, row.route), least) << row.route;
    }
}

// E is along the axis, and edge, for e, across it for o. The lamp is 2 wide and 20 away, the two beams 16 degrees
// apart. What the crystal does not carry is rounding: amplitudes of 1e-16.
TEST(Prism, T27SendsOutTwoFullyPolarizedOrthogonalBeams) {
    const struct {
        const char* route;
        double n, s1;
    } rows[] = {{"To T", n_o, 1.0}, {"Te T", n_e, -1.0}};
    for (const auto& row : rows) {
        const double i = std::asin(0.5 * row.n);
        const DVec3 out(std::cos(i - radians(30.0)), -std::sin(i - radians(30.0)), 0.0);
        const DVec3 right_face_middle(0.5, 0.5 * std::sqrt(3.0), 0.0);
        const Scene scene = scene_of(prism_scene(i, lamp_in_plane(right_face_middle + out * 20.0, -out, 2.0)));
        const Explanation e = explain_look(scene);
        const ClosedFresnel face(row.n, i);
        const double straight = 0.5 * std::pow(1.0 - (row.n == n_o ? face.R_p() : face.R_s()), 2);
        EXPECT_NEAR(share(e, row.route), straight, 4.0 * surface_rounding) << row.route;
        const Stokes<double> s = look(scene);
        EXPECT_GE(s.s0, straight - surface_rounding) << row.route;
        EXPECT_NEAR(s.s1, row.s1 * s.s0, 4.0 * eps) << row.route;
        EXPECT_NEAR(measure(s).dop, 1.0, 4.0 * eps) << row.route;
    }
}

/// Two prisms with a gap between faces that the light along -x meets at the angle `cut`. The gap lies across the plane
/// z = 0 and is filled with `filling`, if any, which then touches both prisms.
std::string glan(double cut, const DVec3& axis, const std::string& residual = "1e-9", const std::string& filling = "") {
    const double slope = std::tan(cut);
    const double half_gap = 0.001;
    const double length = slope + 0.5;
    std::string objects =
        extruded("near prism", {{-slope + half_gap, -1.0}, {length, -1.0}, {length, 1.0}, {slope + half_gap, 1.0}},
                 "crystal") +
        extruded("far prism", {{-length, -1.0}, {-slope - half_gap, -1.0}, {slope - half_gap, 1.0}, {-length, 1.0}},
                 "crystal");
    if (!filling.empty())
        objects += extruded(
            "layer",
            {{-slope - half_gap, -1.0}, {-slope + half_gap, -1.0}, {slope + half_gap, 1.0}, {slope - half_gap, 1.0}},
            "filling");
    return camera_in_plane({-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}) + "render: {residual: " + residual +
           ", node_budget: 200000}\nmedia: {crystal: " + calcite(axis) +
           (filling.empty() ? "" : ", filling: " + filling) + "}\nobjects:\n" + objects +
           lamp_in_plane({-1000.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 2.0);
}

const DVec3 foucault(0.0, 0.0, 1.0);  // axis across the plane of incidence at the gap
const DVec3 taylor(0.0, 1.0, 0.0);    // axis in it, along the entrance face

const double glan_cut = radians(38.5);

/// Transmittance of one face of the gap for e. Foucault: s light in a medium of index n_e. Taylor: p light; the ratio
/// of tangential E and H of an e wave is sqrt(eps_o eps_e (n.eps n - k_t^2))/(eps_o eps_e) (physics.md 2.7).
double foucault_face() {
    return 1.0 - ClosedFresnel(1.0 / n_e, glan_cut).R_s();
}
double taylor_face() {
    const double k_t = n_e * std::sin(glan_cut);
    const double n_eps_n = eps_o + (eps_e - eps_o) * std::pow(std::sin(glan_cut), 2);
    const double crystal = std::sqrt(eps_o * eps_e * (n_eps_n - k_t * k_t)) / (eps_o * eps_e);
    const double air = std::sqrt(1.0 - k_t * k_t);
    return 1.0 - std::pow((crystal - air) / (crystal + air), 2);
}

TEST(Glan, T28ReflectsTheOrdinaryRayTotallyAndPassesTheExtraordinaryOne) {
    EXPECT_NEAR(foucault_face(), 0.7416319, printed(7));
    EXPECT_NEAR(taylor_face(), 0.9735547, printed(7));
    for (const DVec3& axis : {foucault, taylor}) {
        const Explanation e = explain_look(scene_of(glan(glan_cut, axis)));
        EXPECT_EQ(find_branch(e, "To T"), nullptr);
        EXPECT_EQ(find_branch(e, "To Re"), nullptr);
        EXPECT_NEAR(share(e, "To Ro") / share(e, "To"), 1.0, surface_rounding);
        // In the gap the slope of T is steep: cos in air is 0.38.
        const double face = axis == foucault ? foucault_face() : taylor_face();
        EXPECT_NEAR(share(e, "Te T") / share(e, "Te"), face, 4.0 * surface_rounding);
        EXPECT_NEAR(share(e, "Te T Te") / share(e, "Te T"), face, 4.0 * surface_rounding);
    }
}

// T^2 (1 + q + q^2 + ...) with q = (1 - T)^2 is T/(2 - T); the first six passes leave q^6 of it.
TEST(Glan, T28PassesAllThatTheGapSendsToAndFro) {
    for (const DVec3& axis : {foucault, taylor}) {
        const Explanation e = explain_look(scene_of(glan(glan_cut, axis)));
        const double face = axis == foucault ? foucault_face() : taylor_face();
        const double q = std::pow(1.0 - face, 2);
        const int passes = axis == foucault ? 6 : 2;  // of the weak ones only those above the residual are in the tree
        double sum = 0.0;
        std::string to_and_fro = "Te T";
        for (int i = 0; i < passes; ++i, to_and_fro += " R R") sum += share(e, to_and_fro + " Te") / share(e, "Te");
        EXPECT_NEAR(sum, face / (2.0 - face) * (1.0 - std::pow(q, passes)), 8.0 * surface_rounding);
    }
}

TEST(Glan, T28LetsOutOnlyLightPolarizedAlongItsAxis) {
    const struct {
        DVec3 axis;
        double s1;
    } rows[] = {{foucault, -1.0}, {taylor, 1.0}};  // the picture's y axis is z, its x axis along y
    for (const auto& row : rows) {
        const Stokes<double> s = look(glan(glan_cut, row.axis));
        EXPECT_GT(s.s0, 0.2);
        EXPECT_NEAR(s.s1, row.s1 * s.s0, 4.0 * eps);
    }
}

// The angle at the gap is the camera's direction against a normal that is computed from corners: a few eps, far below
// the 1e-12 rad on either side.
TEST(Glan, T28IsUsableBetweenTheTwoCriticalAngles) {
    const double o_critical = std::asin(1.0 / n_o);
    const double e_critical = std::asin(1.0 / n_e);
    EXPECT_NEAR(degrees(o_critical), 37.0844020, printed(7));
    EXPECT_NEAR(degrees(e_critical), 42.2809388, printed(7));
    const auto passes = [](double cut, const char* route) {
        return find_branch(explain_look(scene_of(glan(cut, foucault, "0.01"))), route) != nullptr;
    };
    EXPECT_TRUE(passes(o_critical - 1e-12, "To T"));
    EXPECT_FALSE(passes(o_critical + 1e-12, "To T"));
    EXPECT_TRUE(passes(e_critical - 1e-12, "Te T"));
    EXPECT_FALSE(passes(e_critical + 1e-12, "Te T"));
}

TEST(Nicol, T28ReflectsTheOrdinaryRayTotallyAtCanadaBalsamAndNeverTheExtraordinaryOne) {
    const double critical = std::asin(1.55 / n_o);
    EXPECT_NEAR(degrees(critical), 69.1694, printed(4));  // physics.md prints 69.168
    for (const double side : {-1e-12, 1e-12}) {
        const Explanation e = explain_look(scene_of(glan(critical + side, foucault, "0.01", "1.55")));
        EXPECT_EQ(find_branch(e, "To T") != nullptr, side < 0.0);
        // For e, with 1.4864, balsam is the denser medium: it always passes.
        const double face = 1.0 - ClosedFresnel(1.55 / n_e, critical + side).R_s();
        EXPECT_NEAR(share(e, "Te T") / share(e, "Te"), face, 4.0 * surface_rounding);
    }
}

/// Two wedges in contact, the nearer one with its axis in the plane of the picture's x axis, the farther one along z.
std::string wollaston(double wedge, const std::string& near_medium, const std::string& far_medium,
                      const std::string& lamp = "") {
    const double slope = std::tan(wedge);
    const double length = slope + 0.5;
    return camera_in_plane({-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}) + "render: {residual: 1e-6, wavelengths: 589.3}\n" +
           "media:\n  near: " + near_medium + "\n  far: " + far_medium + "\nobjects:\n" +
           extruded("near wedge", {{-slope, -1.0}, {length, -1.0}, {length, 1.0}, {slope, 1.0}}, "near") +
           extruded("far wedge", {{-length, -1.0}, {-slope, -1.0}, {slope, 1.0}, {-length, 1.0}}, "far") + lamp;
}

/// From the beam straight on, positive towards +y.
double exit_angle(const Explanation& e, const char* route) {
    const DVec3 d = branch(e, route).start.wave.ray;
    EXPECT_NEAR(d.z, 0.0, 4.0 * eps);
    return std::atan2(d.y, -d.x);
}

/// Snell's law at the seam from n_1 to n_2, then at the exit face.
double exit_angle_by_snell(double wedge, double n_1, double n_2) {
    const double seam = std::asin(n_1 / n_2 * std::sin(wedge));
    return std::asin(n_2 * std::sin(wedge - seam));
}

// Behind the seam e has become o and the other way round, each with the plain index across the plane of incidence.
TEST(Wollaston, T29SplitsABeamIntoTwoThatHaveChangedTheirRoles) {
    const double wedge = radians(15.0);
    const Explanation e = explain_look(scene_of(wollaston(wedge, calcite({0.0, 1.0, 0.0}), calcite({0.0, 0.0, 1.0}))));
    const double weak = exit_angle(e, "Te To T");
    const double strong = exit_angle(e, "To Te T");
    EXPECT_NEAR(weak, exit_angle_by_snell(wedge, n_e, n_o), 16.0 * eps);
    EXPECT_NEAR(strong, exit_angle_by_snell(wedge, n_o, n_e), 16.0 * eps);
    EXPECT_NEAR(degrees(weak), 2.6317701, printed(7));
    EXPECT_NEAR(degrees(strong), -2.6526170, printed(7));
    EXPECT_NEAR(degrees(weak - strong), 5.2843871, printed(7));
    for (const char* unchanged : {"To To", "Te Te"})
        EXPECT_LT(share(e, unchanged), surface_rounding * surface_rounding) << unchanged;
}

TEST(Wollaston, T29OfQuartzCutAtFortyFiveDegreesSplitsByOneDegree) {
    const Explanation e = explain_look(
        scene_of(wollaston(radians(45.0), "{crystal: quartz, axis: [0, 1, 0]}", "{crystal: quartz, axis: [0, 0, 1]}")));
    EXPECT_NEAR(degrees(std::abs(exit_angle(e, "Te To T") - exit_angle(e, "To Te T"))), 1.0428287, printed(7));
}

// A lamp in one of the two beams, 2 degrees wide. Field in the near wedge: e along y, the picture's x axis.
TEST(Wollaston, T29ShowsTwoImagesEachFullyPolarizedAndOrthogonal) {
    const double wedge = radians(15.0);
    const auto image = [&](double angle) {
        const DVec3 out(-std::cos(angle), std::sin(angle), 0.0);
        return look(
            wollaston(wedge, calcite({0.0, 1.0, 0.0}), calcite({0.0, 0.0, 1.0}), lamp_in_plane(out * 30.0, -out, 1.0)));
    };
    const Stokes<double> weak = image(exit_angle_by_snell(wedge, n_e, n_o));
    const Stokes<double> strong = image(exit_angle_by_snell(wedge, n_o, n_e));
    EXPECT_GT(weak.s0, 0.4);
    EXPECT_GT(strong.s0, 0.4);
    EXPECT_NEAR(weak.s1, weak.s0, 4.0 * eps);
    EXPECT_NEAR(strong.s1, -strong.s0, 4.0 * eps);
}

}  // namespace
}  // namespace pol::test
