// SPDX-License-Identifier: Apache-2.0
// T19 and PHYSICS.md 1 for whole paths: camera and lamp exchange places, and the Mueller matrix is transposed.
#include <array>

#include "physics/fact_scene.h"

namespace pol::test {
namespace {

/// Six surfaces of some 20 operations, each rounded by eps/2, in two scenes whose directions differ by a few eps.
constexpr double whole_path = 512.0 * eps;

/// End of a path in air: a point on it, the direction into the scene, and the x axis of the polarization frame there.
struct PathEnd {
    DVec3 point, inward, x;
};

/// A skew block of glass on a metal plate: paths through it bend out of every plane.
const std::string things = R"(
media:
  glass: 1.7
  metal: {conductor: [0.6, 2.1]}
objects:
  - {name: block, shape: {box: {size: [2, 1.6, 1.2]}}, transform: [{rotate: {axis: [3, -1, 2], angle: 35}}], medium: glass}
  - {name: plate, shape: {box: {size: [9, 9, 1]}}, transform: [{rotate: {axis: [1, 2, 0.5], angle: 12}},
     {translate: [0, 0, -2.5]}], medium: metal}
)";

/// The camera at `seen_from` sees along its inward direction with the given x axis; a lamp stands at `lit_from`.
Scene scene_between(const PathEnd& seen_from, const PathEnd& lit_from, const std::string& stokes) {
    const DVec3 up = cross(seen_from.x, seen_from.inward);
    return scene_of("camera: {type: orthographic, position: " + text(seen_from.point) +
                    ", target: " + text(seen_from.point + seen_from.inward) + ", up: " + text(up) +
                    ", width: 0.01}\nrender: {depth: 6}\n" + things +
                    "  - {name: lamp, shape: {rectangle: {size: 0.05}}, " +
                    placed(lit_from.point, lit_from.inward, lit_from.x) + ", emission: {" + polarized(stokes) + "}}\n");
}

/// Mueller matrix of the path with that route, from the lamp's frame to the camera's: columns by four states.
std::array<std::array<double, 4>, 4> mueller(const PathEnd& seen_from, const PathEnd& lit_from,
                                             const std::string& letters) {
    std::array<std::array<double, 4>, 4> m{};
    const char* states[] = {"[0, 0, 0]", "[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]"};
    for (std::size_t column = 0; column < 4; ++column) {
        const Stokes<double> s = light_along(explain_look(scene_between(seen_from, lit_from, states[column])), letters);
        const double values[] = {s.s0, s.s1, s.s2, s.s3};
        for (std::size_t row = 0; row < 4; ++row) m[row][column] = values[row] - (column == 0 ? 0.0 : m[row][0]);
    }
    return m;
}

// With y turned over at both ends, so that frames stay right-handed about the reversed light, the matrix of the
// reversed path is Theta M^T Theta, Theta = diag(1, 1, -1, 1).
TEST(ReversedRay, T19HasTheTransposedMuellerMatrixOfAnyPathThroughGlassAndMetal) {
    const DVec3 eye(1.5, -4.0, 3.0);
    int paths = 0;
    bool circular_from_linear = false;
    for (const DVec3& target : {DVec3(0.1, 0.05, 0.2), DVec3(-0.5, 0.2, 0.1), DVec3(0.4, -0.3, -0.2)}) {
        const DVec3 sight = unit(target - eye);
        const PathEnd camera{eye, sight, unit(cross(sight, DVec3(0.2, 0.1, 1.0)))};
        // Where the paths of this camera leave: with the lamp out of the way and bright surroundings.
        Scene bright = scene_between(camera, {DVec3(90.0), unit(DVec3(1.0)), unit(DVec3(1.0, -1.0, 0.0))}, "[0, 0, 0]");
        bright.background.radiance = ConstantSpectrum{1.0};
        const Explanation all = explain_look(bright);
        for (const int leaf : all.tree.leaves) {
            const RayTreeNode& end = all.tree.nodes[static_cast<std::size_t>(leaf)];
            if (end.reason != LeafReason::background || end.start.weight < 1e-4) continue;
            const std::string letters = route(all.tree, leaf);
            SCOPED_TRACE(letters);
            const DVec3 inward = -end.start.wave.ray;
            const PathEnd lamp_end{end.start.origin - 2.0 * inward, inward, any_perpendicular(inward)};
            const auto there = mueller(camera, lamp_end, letters);
            const auto back = mueller(lamp_end, camera, {letters.rbegin(), letters.rend()});
            for (std::size_t row = 0; row < 4; ++row)
                for (std::size_t column = 0; column < 4; ++column) {
                    const double sign = (row == 2) == (column == 2) ? 1.0 : -1.0;
                    EXPECT_NEAR(back[row][column], sign * there[column][row], whole_path) << row << " " << column;
                }
            circular_from_linear |= std::abs(there[3][2]) > 1e-2;
            ++paths;
        }
    }
    EXPECT_GE(paths, 10);
    EXPECT_TRUE(circular_from_linear) << "nothing tested the sign of s3";
}

}  // namespace
}  // namespace pol::test
