// SPDX-License-Identifier: Apache-2.0
// Glass plates beyond facts T5 and T14: piles whose trees end in a random path, and furnaces at every depth.
#include "physics/fact_scene.h"

namespace pol::test {
namespace {

constexpr double n_glass = 1.5;
const double plate_brewster = std::atan(n_glass);

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

/// Light of radiance 1 transmitted with T_s, T_p; the camera's x is s.
Stokes<double> transmitted(double t_s, double t_p) {
    return {0.5 * (t_s + t_p), 0.5 * (t_s - t_p), 0.0, 0.0};
}

// 20 surfaces of some 20 operations, each rounded by eps/2.
constexpr double many_surfaces = 200.0 * eps;

// The trees of five and ten plates are cut after 500 rays; one random path stands for the rest, in each of 4096 pixels
// that see the same. Their mean is unbiased and must lie within five standard errors, which are known from the pixels.
TEST(PileOfPlates, T5HoldsOnAverageWhereOneRandomPathStandsForTheRest) {
    const double r_s = std::pow((n_glass * n_glass - 1.0) / (n_glass * n_glass + 1.0), 2);
    const double spread = std::pow(2.0 * n_glass / (n_glass * n_glass - 1.0), 2);
    for (const int plates : {5, 10}) {
        SCOPED_TRACE(plates);
        const StokesImage image =
            test::render(scene_of(pile(plates, plate_brewster, "size: [64, 64], node_budget: 500")));
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
        EXPECT_NEAR(mean, verify::pile_transmittance(plates, r_s), 5.0 * error);
        // The degree of polarization (1 - T_s)/(1 + T_s) has the slope 2/(1 + T_s)^2 < 2.
        EXPECT_NEAR((1.0 - mean) / (1.0 + mean), plates / (plates + spread), 10.0 * error);
    }
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
