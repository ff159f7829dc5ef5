// SPDX-License-Identifier: Apache-2.0
// physics.md T4 to T8 and T14 as pictures: piles of glass plates, and glass in uniform surroundings.
#include "physics/fact_scene.h"

namespace pol::test {
namespace {

constexpr double n_glass = 1.5;
const double brewster = std::atan(n_glass);

constexpr double thickness = 0.1;

/// `count` wide horizontal plates under the camera, 0.1 thick and 0.1 apart, over an unpolarized lamp of radiance 1.
/// So wide that a ray has lost all its energy long before it comes to the side of a plate.
std::string pile(int count, double i, const std::string& render) {
    std::string yaml = camera_along(downward(i)) + "render: {" + render + "}\nmedia: {glass: " + text(n_glass) +
                       "}\nobjects:\n" + lamp("lamp", {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}, 1000.0);
    for (int plate = 0; plate < count; ++plate)
        yaml += box("plate " + std::to_string(plate), {400.0, 400.0, thickness},
                    {0.0, 0.0, -thickness * (0.5 + 2.0 * plate)}, "glass");
    return yaml;
}

std::string straight(int plates) {
    return std::string(2 * static_cast<std::size_t>(plates), 'T');
}

/// Light of radiance 1 transmitted with T_s, T_p; the camera's x is s.
Stokes<double> transmitted(double t_s, double t_p) {
    return {0.5 * (t_s + t_p), 0.5 * (t_s - t_p), 0.0, 0.0};
}

/// Transmittance of a pile of `count` plates, all passes added: (1 - R)/(1 + (2 count - 1) R) (Stokes 1862).
double all_passes(int count, double reflectance) {
    return (1.0 - reflectance) / (1.0 + (2.0 * count - 1.0) * reflectance);
}

struct PileFact {
    int plates;
    double straight, all;  ///< degree of polarization at Brewster's angle, physics.md T4 and T5
};
constexpr PileFact pile_facts[] = {{1, 0.1587317687, 0.1479289941},
                                   {2, 0.3096613791, 0.2577319588},
                                   {5, 0.6642754620, 0.4646840149},
                                   {10, 0.9217970265, 0.6345177665}};

// 20 surfaces of some 20 operations, each rounded by eps/2.
constexpr double many_surfaces = 200.0 * eps;

TEST(PileOfPlates, T4PolarizesTheStraightPathByTheProductOfItsSurfaces) {
    for (const PileFact& fact : pile_facts) {
        SCOPED_TRACE(fact.plates);
        // The straight path is the heaviest at every step, so a small budget reaches its end.
        const Stokes<double> s = light_along(pile(fact.plates, brewster, "node_budget: 200"), straight(fact.plates));
        const double alpha = 2.0 * n_glass / (1.0 + n_glass * n_glass);
        const double t_s = std::pow(alpha, 4.0 * fact.plates);
        expect_stokes(s, transmitted(t_s, 1.0), many_surfaces);
        EXPECT_NEAR(measure(s).dop, (1.0 - t_s) / (1.0 + t_s), many_surfaces);
        EXPECT_NEAR(measure(s).dop, fact.straight, printed(10));
    }
}

// What is missing from S0 is at most the residual, and it is s only: p is not reflected at Brewster's angle.
TEST(PileOfPlates, T5PolarizesAllPassesAsStokesFoundIn1862) {
    const double r_s = std::pow((n_glass * n_glass - 1.0) / (n_glass * n_glass + 1.0), 2);
    struct Cut {
        double residual;
        int budget;
    };
    for (const auto& [fact, cut] : {std::pair{pile_facts[0], Cut{1e-13, 1000}}, {pile_facts[1], Cut{1e-6, 100000}}}) {
        SCOPED_TRACE(fact.plates);
        const std::string render = "residual: " + text(cut.residual) + ", node_budget: " + std::to_string(cut.budget);
        const StokesImage image = [&] {
            Scene scene = scene_of(pile(fact.plates, brewster, render));
            scene.render.width = scene.render.height = 1;
            return test::render(scene);
        }();
        const Stokes<double>& s = image.at(0, 0);
        ASSERT_EQ(image.plane_value(image.tail, 0, 0), 0.0) << "the budget was too small";
        const double missing = image.plane_value(image.residual, 0, 0);
        ASSERT_LE(missing, cut.residual);
        const double n2 = std::pow(2.0 * n_glass / (n_glass * n_glass - 1.0), 2);
        const double dop = fact.plates / (fact.plates + n2);
        EXPECT_NEAR(dop, fact.all, printed(10));
        const Stokes<double> whole = transmitted(all_passes(fact.plates, r_s), 1.0);
        EXPECT_LE(s.s0, whole.s0 + many_surfaces);
        EXPECT_GE(s.s0, whole.s0 - missing - many_surfaces);
        EXPECT_NEAR(s.s0 - s.s1, 1.0, many_surfaces);  // all of p
        // P falls by at most (1 + P)/S0 per missing S0.
        EXPECT_NEAR(measure(s).dop, dop, 2.0 * missing / s.s0 + many_surfaces);
    }
}

// The trees of five and ten plates are cut after 500 rays; one random path stands for the rest, in each of 4096 pixels
// that see the same. Their mean is unbiased and must lie within five standard errors, which are known from the pixels.
TEST(PileOfPlates, T5HoldsOnAverageWhereOneRandomPathStandsForTheRest) {
    const double r_s = std::pow((n_glass * n_glass - 1.0) / (n_glass * n_glass + 1.0), 2);
    for (const PileFact& fact : {pile_facts[2], pile_facts[3]}) {
        SCOPED_TRACE(fact.plates);
        const StokesImage image =
            test::render(scene_of(pile(fact.plates, brewster, "size: [64, 64], node_budget: 500")));
        const auto pixels = static_cast<double>(image.pixel_count());
        double sum = 0.0;
        double squares = 0.0;
        double tail = 0.0;
        for (std::size_t p = 0; p < image.pixel_count(); ++p) {
            const Stokes<double>& s = image.at(0, p);
            EXPECT_NEAR(s.s0 - s.s1, 1.0, many_surfaces);  // p needs no random path
            sum += s.s0 + s.s1;
            squares += (s.s0 + s.s1) * (s.s0 + s.s1);
            tail += image.plane_value(image.tail, 0, p);
        }
        const double mean = sum / pixels;
        const double error = std::sqrt((squares / pixels - mean * mean) / (pixels - 1.0));
        ASSERT_GT(tail / pixels, 0.01) << "there is no random path to test";
        ASSERT_LT(error, 0.005);
        EXPECT_NEAR(mean, all_passes(fact.plates, r_s), 5.0 * error);
        // The degree of polarization (1 - T_s)/(1 + T_s) has the slope 2/(1 + T_s)^2 < 2.
        EXPECT_NEAR((1.0 - mean) / (1.0 + mean), fact.all, 10.0 * error);
    }
}

TEST(Plate, T6PolarizesAlongTheStraightPathAndLessInAllPasses) {
    struct AngleFact {
        double degree, straight, all;
    };
    for (const AngleFact& fact :
         {AngleFact{30.0, 0.0339471543, 0.0325945241}, AngleFact{60.0, 0.1901328326, 0.1748251748},
          AngleFact{75.0, 0.3772480996, 0.3056218126}}) {
        SCOPED_TRACE(fact.degree);
        const std::string scene = pile(1, radians(fact.degree), "residual: 1e-13");
        const ClosedFresnel f(n_glass, radians(fact.degree));
        const Stokes<double> one = light_along(scene, "TT");
        expect_stokes(one, transmitted(std::pow(1.0 - f.R_s(), 2), std::pow(1.0 - f.R_p(), 2)), many_surfaces);
        EXPECT_NEAR(measure(one).dop, fact.straight, printed(10));
        const Stokes<double> all = look(scene);
        expect_stokes(all, transmitted(all_passes(1, f.R_s()), all_passes(1, f.R_p())), 1e-13 + many_surfaces);
        EXPECT_NEAR(measure(all).dop, fact.all, printed(10));
        EXPECT_NEAR(std::abs(measure(all).azimuth), 0.5 * pi, many_surfaces);
    }
}

TEST(Plate, T7TransmitsTwelveThirteenthsAtNormalIncidenceUnpolarized) {
    expect_stokes(look(pile(1, 0.0, "residual: 1e-13")), {12.0 / 13.0, 0.0, 0.0, 0.0}, 1e-13 + many_surfaces);
}

TEST(Plate, T8ShiftsARaySidewaysAndKeepsItsDirection) {
    const Explanation e = explain_look(scene_of(pile(1, radians(45.0), "residual: 1e-3")));
    const auto branches = path(e, "TT");
    const DVec3 in = branches[0]->start.wave.ray;
    const DVec3 out = branches[2]->start.wave.ray;
    EXPECT_LT(std::sqrt(length2(out - in)), 8.0 * eps);
    const DVec3 along = branches[2]->start.origin - branches[1]->start.origin;
    const double shift = std::sqrt(length2(along - dot(along, in) * in)) / thickness;
    const double inside = std::asin(std::sin(radians(45.0)) / n_glass);
    // Points are rounded by eps times their distance of 5 from the origin of the ray.
    EXPECT_NEAR(shift, std::sin(radians(45.0) - inside) / std::cos(inside), 20.0 * eps / thickness);
    EXPECT_NEAR(shift, 0.329142, printed(6));
}

/// Scene in unit surroundings, cut after `depth` interactions.
std::string furnace(const std::string& object, double i, int depth) {
    return camera_along(downward(i)) + "render: {depth: " + std::to_string(depth) +
           "}\nbackground: 1\nmedia: {glass: 1.5}\nobjects:\n" + object;
}

const std::string wide_plate = box("plate", {4000.0, 4000.0, 0.1}, {0.0, 0.0, -0.05}, "glass");
/// Top at the origin, where the camera's target meets it at the angle `i`.
const std::string ball =
    "  - {name: ball, shape: {sphere: {radius: 1}}, transform: [{translate: [0, 0, -1]}], medium: glass}\n";

// D interactions bring all but the light that is still inside: (1 - R) R^(D-1) of each polarization.
TEST(Furnace, T14IsShortOfTheLightThatADepthLimitCutsOff) {
    for (const std::string& object : {wide_plate, ball}) {
        for (const double degree : {0.0, 30.0, 60.0, 85.0}) {
            for (int depth = 1; depth <= 12; ++depth) {
                SCOPED_TRACE(object + text(degree) + " " + std::to_string(depth));
                const ClosedFresnel f(n_glass, radians(degree));
                const auto seen = [&](double r) { return 1.0 - (1.0 - r) * std::pow(r, depth - 1); };
                expect_stokes(look(furnace(object, radians(degree), depth)), transmitted(seen(f.R_s()), seen(f.R_p())),
                              many_surfaces);
            }
        }
    }
}

TEST(Furnace, T14HidesGlassWhenNothingIsCutOff) {
    for (const std::string& object : {wide_plate, ball}) {
        for (const double degree : {0.0, 30.0, 60.0, 85.0}) {
            SCOPED_TRACE(object + text(degree));
            // R^D of s at 85 degrees, R = 0.73, is below 1e-16 for D = 120; the paths are few: one leaf per surface.
            const Stokes<double> s = look(furnace(object, radians(degree), 120));
            expect_stokes(s, {1.0, 0.0, 0.0, 0.0}, 5.0 * many_surfaces);
        }
    }
}

}  // namespace
}  // namespace pol::test
