// SPDX-License-Identifier: Apache-2.0
// Axes of sheets in scenes: seen at an angle, and on objects that are stretched.
#include "physics/fact_scene.h"
#include "scene/place.h"

namespace pol::test {
namespace {

// Azimuth atan(cos 30) of film that blocks along (-1, 1, 0), in the camera's frame (x to the right, from its own ray).
TEST(TiltedSheet, TurnsTheAzimuthTowardsTheAxisOfTheTiltAsFilmDoes) {
    const auto azimuth = [](const std::string& model) {
        const Stokes<double> s = look(
            "camera: {type: orthographic, position: [5, 0, 8.660254037844386], target: [0, 0, 0], up: [0, 1, 0], "
            "width: 0.1}\nbackground: 1\nobjects:\n  - {name: film, shape: {rectangle: {size: 30}}, sheet: "
            "{polarizer: {axis: [1, 1, 0]" +
            model + "}}}\n");
        EXPECT_NEAR(s.s0, 0.5, 64.0 * eps);
        return degrees(0.5 * std::atan2(s.s2, s.s1));
    };
    const double film = degrees(std::atan(std::cos(radians(30.0))));
    EXPECT_NEAR(azimuth(""), film, 3600.0 * eps);
    EXPECT_NEAR(azimuth(", model: blocking"), film, 3600.0 * eps);
    EXPECT_NEAR(azimuth(", model: passing"), 90.0 - film, 3600.0 * eps);
}

// A sheet of 30 degrees to its first edge behind a polarizer along x passes cos^2 30 = 3/4 of half the light along 30
// degrees: S0 = 3/8, S1 = 3/8 cos 60, S2 = 3/8 sin 60, whatever the edges are stretched to.
TEST(Directions, AnAxisKeepsItsAngleToTheFirstEdgeOfAStretchedSheet) {
    const auto seen = [](const std::string& transform) {
        return look(
            "camera: {type: orthographic, position: [0, 0, 10], target: [0, 0, 0], up: [0, 1, 0], width: 1}\n"
            "background: 1\nobjects:\n"
            "  - {name: first, shape: {rectangle: {size: 9}}, transform: [{translate: [0, 0, -1]}], "
            "sheet: {polarizer: {axis: [1, 0, 0]}}}\n"
            "  - {name: second, shape: {rectangle: {size: 9}}, transform: " +
            transform + ", sheet: {polarizer: {axis: [0.8660254037844386, 0.5, 0]}}}\n");
    };
    const Stokes<double> meant{0.375, 0.1875, 0.375 * std::sin(radians(60.0)), 0.0};
    for (const char* transform : {"[{scale: 2}]", "[{scale: [0.65, 1.2, 1]}]", "[{scale: [3, 3, 0.2]}]",
                                  "[{matrix: [[1, 0.4, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]}]"})
        expect_stokes(seen(transform), meant, 64.0 * eps);
    // Turned by 15 degrees after it was stretched: at 45 to x. Mirrored in x: at 150 degrees.
    expect_stokes(seen("[{scale: [0.65, 1.2, 1]}, {rotate: {axis: [0, 0, 1], angle: 15}}]"), {0.25, 0.0, 0.25, 0.0},
                  64.0 * eps);
    expect_stokes(seen("[{scale: [-0.65, 1.2, 1]}]"), {meant.s0, meant.s1, -meant.s2, 0.0}, 64.0 * eps);
}

TEST(Directions, OpticAxesAndFramesOfLampsAreNotStretchedEither) {
    const DMat4 stretched = scene_of(
                                "camera: {type: orthographic, position: [0, 0, 10], target: [0, 0, 0], up: [0, 1, "
                                "0], width: 1}\nobjects:\n  - {name: stop, shape: {disk: {radius: 1}}, transform: "
                                "[{scale: [2, 1, 1]}, {rotate: {axis: [0, 0, 1], angle: 90}}], absorber: on}\n")
                                .objects.front()
                                .to_world;
    const DVec3 turned = direction_to_world(stretched, {1.0, 1.0, 1.0});
    EXPECT_NEAR(length2(turned - unit(DVec3(-1.0, 1.0, 1.0))), 0.0, 64.0 * eps * eps);
}

}  // namespace
}  // namespace pol::test
