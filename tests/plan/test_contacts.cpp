// SPDX-License-Identifier: Apache-2.0
// Where surfaces lie in one place: black on glass, equal solids, films, and rays that only touch.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "polarization/measures.h"
#include "support/render_scene.h"

namespace pol {
namespace {

/// Straight down on (0.1, 0.2) with a furnace of radiance 1 around: what is missing from 1 was swallowed.
Stokes<double> seen_from_above(const std::string& objects, const std::string& media = "glass: 1.5") {
    return test::look(
        "camera: {type: orthographic, position: [0.1, 0.2, 9], target: [0.1, 0.2, 0], up: [0, 1, 0], "
        "width: 0.01}\nbackground: 1\nrender: {residual: 1e-13, node_budget: 10000}\nmedia: {" +
        media + "}\nobjects:\n" + objects);
}

/// The reflectance of glass at normal incidence, ((n - 1)/(n + 1))^2 (Born & Wolf 1.5.2).
constexpr double glass_face = 0.04;
/// Some ten roundings of numbers up to 1.
constexpr double rounding = 1e-14;

std::string block(const std::string& name, double bottom, double top, const std::string& more = "medium: glass") {
    return "  - {name: " + name + ", shape: {box: {size: [2, 2, " + std::to_string(top - bottom) +
           "]}}, transform: [{translate: [0, 0, " + std::to_string(0.5 * (bottom + top)) + "]}], " + more + "}\n";
}

// Nothing comes back from black paint: only the upper face is seen. With a gap of any width the lower face reflects
// like glass in air, 0.96^2 * 0.04 / (1 - 0.04^2) more.
TEST(Contacts, AnAbsorberThatTouchesAFaceBlackensIt) {
    const std::string glass = block("glass", -1.0, 0.5);
    for (const std::string paint : {"shape: {rectangle: {size: 2}}, transform: [{translate: [0, 0, -1]}]",
                                    "shape: {rectangle: {size: 1}}, transform: [{rotate: {axis: [1, 0, 0], angle: "
                                    "180}}, {translate: [0, 0, -1]}]",
                                    "shape: {disk: {radius: 5}}, transform: [{translate: [3, 0, -1]}]",
                                    "shape: {box: {size: 3}}, transform: [{translate: [0, 0, -2.5]}]",
                                    "shape: {box: {size: [1, 1, 0.5]}}, transform: [{translate: [0, 0, -0.75]}]"}) {
        for (const std::string& objects : {glass + "  - {name: paint, " + paint + ", absorber: on}\n",
                                           "  - {name: paint, " + paint + ", absorber: on}\n" + glass})
            EXPECT_NEAR(seen_from_above(objects).s0, glass_face, rounding) << objects;
    }
    const std::string gap =
        "  - {name: paint, shape: {rectangle: {size: 2}}, transform: [{translate: [0, 0, -1.000001]}], absorber: on}\n";
    EXPECT_NEAR(seen_from_above(glass + gap).s0, glass_face + 0.96 * 0.96 * 0.04 / (1.0 - 0.04 * 0.04), rounding);
}

// Beside the paint the face reflects and passes light as ever: a furnace loses nothing there.
TEST(Contacts, PaintReachesAsFarAsItsOutline) {
    const std::string glass = block("glass", -1.0, 0.5);
    const std::string right =
        "  - {name: paint, shape: {rectangle: {size: 1}}, transform: [{translate: [0.7, 0.2, -1]}], absorber: on}\n";
    EXPECT_NEAR(seen_from_above(glass + right).s0, 1.0, 1e-12);
    const std::string disk =
        "  - {name: paint, shape: {disk: {radius: 0.5}}, transform: [{translate: [0.45, 0.55, -1]}], absorber: on}\n";
    EXPECT_NEAR(seen_from_above(glass + disk).s0, glass_face, rounding);
    const std::string smaller =
        "  - {name: paint, shape: {disk: {radius: 0.49}}, transform: [{translate: [0.45, 0.55, -1]}], absorber: on}\n";
    EXPECT_NEAR(seen_from_above(glass + smaller).s0, 1.0, 1e-12);
}

// The painted prism: 60 degrees, light in through one leg, total reflection at the other (incidence 60 degrees, beyond
// the critical 41.8), out through the painted base (incidence 0). Nothing but the first face's 4 % comes back.
TEST(Contacts, APaintedPrismReflectsOnlyFromItsFirstFace) {
    const std::string camera =
        "camera: {type: orthographic, position: [8.6602540378443873, 5, 0], target: [0, 0, 0], up: [0, 0, 1], width: "
        "0.01}\n"
        "background: 1\nrender: {residual: 1e-13, node_budget: 10000}\nmedia: {glass: 1.5}\nobjects:\n";
    const std::string prism = "  - {name: prism, shape: {prism: {apex_angle: 60, side: 2, height: 2}}, medium: glass";
    const std::string paint =
        "  - {name: paint, shape: {rectangle: {size: 4}}, transform: [{rotate: {axis: [1, 0, 0], angle: 90}}, "
        "{translate: [0, -0.8660254037844387, 0]}], absorber: on}\n";
    EXPECT_NEAR(test::look(camera + prism + "}\n").s0, 1.0, 1e-12);
    EXPECT_NEAR(test::look(camera + prism + "}\n" + paint).s0, glass_face, rounding);
    EXPECT_NEAR(test::look(camera + prism + ", black: [[0, -1, 0]]}\n").s0, glass_face, rounding);
}

TEST(Contacts, AFaceDeclaredBlackSwallowsLightFromEitherSide) {
    EXPECT_NEAR(seen_from_above(block("glass", -1, 1, "medium: glass, black: [[0, 0, -3]]")).s0, glass_face, rounding);
    EXPECT_EQ(seen_from_above(block("glass", -1, 1, "medium: glass, black: [[0, 0, 1]]")).s0, 0.0);
    // Cemented to glass of the same index the black face lies inside, whichever of the two it was written to.
    const std::string lower = block("lower", -1, 0, "medium: glass");
    const std::string upper = block("upper", 0, 1, "medium: glass");
    EXPECT_NEAR(seen_from_above(lower + block("upper", 0, 1, "medium: glass, black: [[0, 0, -1]]")).s0, glass_face,
                rounding);
    EXPECT_NEAR(seen_from_above(block("lower", -1, 0, "medium: glass, black: [[0, 0, 1]]") + upper).s0, glass_face,
                rounding);
    EXPECT_NEAR(seen_from_above(lower + upper).s0, 1.0, 1e-12);
}

// A lamp in the face of a block, seen through the block: through a gap of air and all
// passes in the block, 0.96^2 / (1 - 0.04^2) of its light gets out. From behind it is black, whatever rounding says of
// who is nearer.
TEST(Contacts, ALampInAFaceIsMetFromOutsideFirst) {
    const auto look = [](double side) {
        return test::look("camera: {type: orthographic, position: [0.1, 0.2, " + std::to_string(9.7 * side) +
                          "], target: [0.1, 0.2, 0], up: [0, 1, 0], width: 0.01}\nrender: {residual: 1e-13, "
                          "node_budget: 10000}\n"
                          "media: {glass: 1.5}\nobjects:\n" +
                          block("glass", -1.3, 0.7) +
                          "  - {name: lamp, shape: {rectangle: {size: 1}}, transform: [{translate: [0, 0, -1.3]}], "
                          "emission: {radiance: 1}}\n")
            .s0;
    };
    EXPECT_NEAR(look(1.0), 0.96 / 1.04, rounding);
    EXPECT_EQ(look(-1.0), 0.0);
}

/// Weight of what the first surface reflects.
double first_reflection(const std::string& objects) {
    const Explanation e =
        test::explain_look(test::scene_of("camera: {type: orthographic, position: [0, 0, 5], target: [0, 0, 0], up: "
                                          "[0, 1, 0], width: 0.01}\nbackground: 1\n"
                                          "render: {residual: 0.3}\nmedia: {glass: 1.5, dense: 2}\nobjects:\n" +
                                          objects));
    for (const RayTreeNode& node : e.tree.nodes)
        if (node.interaction == Interaction::reflected && node.start.depth == 1) return node.start.weight;
    return -1.0;
}

// The solid of the higher priority fills the volume: one interface from air to n = 2, R = (1/3)^2.
TEST(Contacts, OfTwoEqualSolidsOneInterfaceIsLeft) {
    for (const std::string shape : {"{sphere: {radius: 1}}", "{box: {size: 2}}", "{brilliant: {diameter: 2}}"}) {
        const std::string dense = "  - {name: dense, shape: " + shape + ", medium: dense, priority: 1}\n";
        const std::string glass = "  - {name: glass, shape: " + shape + ", medium: glass}\n";
        EXPECT_NEAR(first_reflection(dense + glass), 1.0 / 9.0, rounding) << shape;
        EXPECT_NEAR(first_reflection(glass + dense), 1.0 / 9.0, rounding) << shape;
    }
}

// A ball in a ball of the same size is gone from the picture, too: whole trees, not the first surface only.
TEST(Contacts, ABallUnderABallOfHigherPriorityIsInvisible) {
    const auto picture = [](const std::string& objects) {
        return test::render(
            test::scene_of("camera: {position: [0.3, -5, 2], target: [0, 0, 0], fov: 25}\nbackground: 0.1\nrender: "
                           "{size: [16, 16], residual: 1e-6}\n"
                           "media: {glass: 1.5, dense: 2}\nobjects:\n"
                           "  - {name: lamp, shape: {rectangle: {size: 3}}, transform: [{translate: [0, 0, -2]}], "
                           "emission: {radiance: 1}}\n" +
                           objects));
    };
    const std::string dense = "  - {name: dense, shape: {sphere: {radius: 1}}, medium: dense, priority: 1}\n";
    const std::string glass = "  - {name: glass, shape: {sphere: {radius: 1}}, medium: glass}\n";
    const StokesImage alone = picture(dense);
    for (const std::string& objects : {dense + glass, glass + dense}) {
        const StokesImage both = picture(objects);
        EXPECT_TRUE(both.failures.empty());
        for (std::size_t p = 0; p < alone.pixel_count(); ++p) EXPECT_EQ(both.at(0, p).s0, alone.at(0, p).s0);
    }
}

// A film of a billionth of its width is a film: T = (1 - R)/(1 + R) of a lamp behind it, all passes added as powers.
TEST(Contacts, AFilmOfABillionthOfItsWidthIsOne) {
    const std::string lamp =
        "  - {name: lamp, shape: {rectangle: {size: 3}}, transform: [{translate: [0, 0, -4]}], emission: {radiance: "
        "1}}\n";
    const std::string camera =
        "camera: {type: orthographic, position: [0.1, 0.2, 5], target: [0.1, 0.2, 0], up: [0, 1, 0], width: 0.01}\n"
        "render: {residual: 1e-13}\nmedia: {glass: 1.5}\nobjects:\n";
    for (const std::string thickness : {"1e-6", "1e-9", "1e-10"}) {
        const std::string film = "  - {name: film, shape: {box: {size: [1, 1, " + thickness + "]}}, medium: glass}\n";
        EXPECT_NEAR(test::look(camera + film + lamp).s0, 0.96 / 1.04, rounding) << thickness;
    }
}

// Rays at 1 from the axes of a unit ball touch it and go on: the background, and no failure.
TEST(Contacts, ARayThatTouchesABallGoesOn) {
    for (const std::string medium : {"medium: glass", "medium: calcite", "medium: gold", "absorber: on"}) {
        for (const std::string shift : {"0", "0.5"}) {  // the second ball is touched in the middle of the picture
            const StokesImage image =
                test::render(test::scene_of("camera: {type: orthographic, position: [0, 0, 10], target: [0, 0, 0], up: "
                                            "[0, 1, 0], width: 3}\nbackground: 1\n"
                                            "render: {size: [3, 3], node_budget: 200}\nmedia: {glass: 1.5, calcite: "
                                            "{crystal: calcite}, gold: {conductor: gold}}\n"
                                            "objects:\n  - {name: ball, shape: {sphere: {radius: 1}}, " +
                                            medium + "}\n" +
                                            (shift == "0" || medium == "absorber: on"
                                                 ? std::string()
                                                 : "  - {name: inner, shape: {sphere: {radius: 0.5}}, transform: "
                                                   "[{translate: [0.5, 0, 0]}], medium: glass}\n")));
            EXPECT_TRUE(image.failures.empty()) << medium;
            for (const std::size_t beside : {1U, 3U, 5U, 7U}) EXPECT_EQ(image.at(0, beside).s0, 1.0) << medium;
        }
    }
}

// The bar of an orthographic picture taken from air holds the light of air, 1, not n^2 = 5.76 times as much. In a block
// of glass it is 2.25, and where the picture's plane reaches into both the larger.
TEST(Contacts, BarsOfAnOrthographicCameraAreThoseOfItsMedium) {
    const auto bar = [](const std::string& height, const std::string& width) {
        return test::plan_of(test::scene_of("camera: {type: orthographic, position: [0, 0, " + height +
                                            "], target: [0, 0, -9], up: [0, 1, 0], width: " + width +
                                            "}\nbackground: 1\nmedia: {diamond: 2.4, glass: 1.5}\nobjects:\n"
                                            "  - {name: stone, shape: {sphere: {radius: 1}}, medium: diamond}\n"
                                            "  - {name: block, shape: {box: {size: 2}}, transform: [{translate: [0, 0, "
                                            "5]}], medium: glass}\n"))
            ->brightest[0];
    };
    EXPECT_DOUBLE_EQ(bar("10", "3"), 1.0);
    EXPECT_DOUBLE_EQ(bar("5", "1"), 2.25);
    EXPECT_DOUBLE_EQ(bar("5", "3"), 2.25);
    EXPECT_DOUBLE_EQ(bar("0", "0.5"), 5.76);
}

// No azimuth can be counted from an axis along the ray. Circular light has none and needs no axis.
TEST(Contacts, LightAlongTheAxisOfItsLampFails) {
    const auto failures = [](const std::string& state) {
        return !test::render(
                    test::scene_of("camera: {type: orthographic, position: [5, 0, 0], target: [0, 0, 0], up: [0, 0, "
                                   "1], width: 0.01}\n"
                                   "render: {size: [1, 1]}\nobjects:\n  - {name: lamp, shape: {sphere: {radius: 1}}, "
                                   "emission: {radiance: 1, polarization: {stokes: " +
                                   state + "}}}\n"))
                    .failures.empty();
    };
    EXPECT_TRUE(failures("[1, 0, 0]"));
    EXPECT_TRUE(failures("[0, 0.5, 0], x_axis: [-2, 0, 0]"));
    EXPECT_FALSE(failures("[0, 0, 1]"));
    EXPECT_FALSE(failures("[1, 0, 0], x_axis: [1, 0, 1e-6]"));
}

}  // namespace
}  // namespace pol
