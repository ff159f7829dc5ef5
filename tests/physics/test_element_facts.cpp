// SPDX-License-Identifier: Apache-2.0
// Facts T13, T42 and T43 with ideal sheets, through whole scenes: Malus and what retarders do.
#include "physics/fact_scene.h"

namespace pol::test {
namespace {

// A sheet is a dozen operations of order 1 and a sine or cosine of an angle that was converted from degrees.
constexpr double one_sheet = 16.0 * eps;

/// Sheets over a lamp, the first one nearest to the camera, which looks down: its x and y are those of the world.
std::string stack(const std::vector<std::string>& sheets, const std::string& emission = "radiance: 1") {
    std::string yaml =
        "camera: {type: orthographic, position: [0, 0, 9], target: [0, 0, 0], up: [0, 1, 0], width: 0.01}\n"
        "objects:\n  - {name: lamp, shape: {rectangle: {size: 4}}, transform: [{translate: [0, 0, -1]}], emission: {" +
        emission + "}}\n";
    for (std::size_t i = 0; i < sheets.size(); ++i)
        yaml += "  - {name: sheet " + std::to_string(i) +
                ", shape: {disk: {radius: 1}}, transform: [{translate: [0, 0, " +
                text(8.0 - 0.25 * static_cast<double>(i)) + "]}], sheet: {" + sheets[i] + "}}\n";
    return yaml;
}

std::string axis_at(double azimuth) {
    return text(DVec3(std::cos(azimuth), std::sin(azimuth), 0.0));
}
std::string polarizer(double degree) {
    return "polarizer: {axis: " + axis_at(radians(degree)) + "}";
}
std::string retarder(double degree, double retardance) {
    return "retarder: {fast_axis: " + axis_at(radians(degree)) + ", retardance: " + text(retardance) + "}";
}

TEST(IdealPolarizer, T13PassesHalfOfUnpolarizedLightAlongItsAxis) {
    for (const double degree : {0.0, 30.0, 90.0, 135.0}) {
        SCOPED_TRACE(degree);
        const double angle = radians(degree);
        expect_stokes(look(stack({polarizer(degree)})),
                      {0.5, 0.5 * std::cos(2.0 * angle), 0.5 * std::sin(2.0 * angle), 0.0}, one_sheet);
    }
}

TEST(IdealPolarizer, T13ObeysTheLawOfMalus) {
    for (double degree = 0.0; degree <= 180.0; degree += 7.5) {
        SCOPED_TRACE(degree);
        const double cos_angle = std::cos(radians(degree));
        EXPECT_NEAR(look(stack({polarizer(degree), polarizer(0.0)})).s0, 0.5 * cos_angle * cos_angle, one_sheet);
    }
    EXPECT_NEAR(look(stack({polarizer(90.0), polarizer(0.0)})).s0, 0.0, one_sheet * one_sheet);
}

TEST(IdealPolarizer, T13PassesAnEighthThroughThreeAtFortyFiveDegreesEach) {
    const Stokes<double> s = look(stack({polarizer(90.0), polarizer(45.0), polarizer(0.0)}));
    expect_stokes(s, {0.125, -0.125, 0.0, 0.0}, one_sheet);
}

TEST(IdealPolarizer, T13TurnsLightByAFanWithTheLossOfManySmallSteps) {
    for (const int steps : {1, 2, 3, 9, 30}) {
        SCOPED_TRACE(steps);
        std::vector<std::string> fan;
        for (int i = 0; i <= steps; ++i) fan.push_back(polarizer(90.0 - 90.0 * i / steps));
        const double expected = 0.5 * std::pow(std::cos(0.5 * pi / steps), 2 * steps);
        expect_stokes(look(stack(fan)), {expected, -expected, 0.0, 0.0}, steps * one_sheet);
    }
}

// One model acts by the part of its axis that lies across the light. The other, film, blocks along b = n x axis = (-c,
// c - 3 s, s), with the sheet's normal n = (s, 0, c), and passes what is along k x b, that is (c - 3 s, c) for k along
// z.
TEST(IdealPolarizer, SeenObliquelyActsByItsProjectedAxisOrAcrossTheOneItBlocks) {
    const double tilt = radians(40.0);
    const DVec3 axis(1.0, 1.0, 3.0);  // in the world: at 45 degrees to the camera, which looks along z
    const DVec3 in_sheet(axis.x * std::cos(tilt) - axis.z * std::sin(tilt), axis.y,
                         axis.x * std::sin(tilt) + axis.z * std::cos(tilt));
    const auto tilted = [&](const std::string& model) {
        return "  - {name: tilted, shape: {disk: {radius: 1}}, transform: [{rotate: {axis: [0, 1, 0], angle: 40}}, "
               "{translate: "
               "[0, 0, 3]}], sheet: {polarizer: {axis: " +
               text(in_sheet) + model + "}}}\n";
    };
    expect_stokes(look(stack({}) + tilted(", model: passing")), {0.5, 0.0, 0.5, 0.0}, 4.0 * one_sheet);
    const double psi = std::atan2(std::cos(tilt), std::cos(tilt) - 3.0 * std::sin(tilt));
    expect_stokes(look(stack({}) + tilted("")), {0.5, 0.5 * std::cos(2.0 * psi), 0.5 * std::sin(2.0 * psi), 0.0},
                  4.0 * one_sheet);
}

// Light at +45 degrees, fast axis along x: y lags by the retardance and E = (1, exp(i retardance))/sqrt 2, so that
// s3 = 2 Im E_x E_y^* = -sin(retardance).
TEST(IdealRetarder, DelaysTheSlowAxisAndMakesLeftHandedLightOfPlusFortyFive) {
    for (const double retardance : {0.0, 30.0, 90.0, 180.0, 270.0}) {
        SCOPED_TRACE(retardance);
        const double delta = radians(retardance);
        expect_stokes(look(stack({retarder(0.0, retardance)}, polarized("[0, 1, 0]"))),
                      {1.0, 0.0, std::cos(delta), -std::sin(delta)}, one_sheet);
    }
}

TEST(IdealRetarder, T42OfHalfAWaveTurnsLinearLightByTwiceItsAngleAndExchangesRightAndLeft) {
    for (const double degree : {0.0, 10.0, 22.5, 45.0, 80.0}) {
        SCOPED_TRACE(degree);
        const double phi = radians(degree);
        expect_stokes(look(stack({retarder(degree, 180.0)}, polarized("[1, 0, 0]"))),
                      {1.0, std::cos(4.0 * phi), std::sin(4.0 * phi), 0.0}, 2.0 * one_sheet);
        expect_stokes(look(stack({retarder(degree, 180.0)}, polarized("[0, 0, 1]"))), {1.0, 0.0, 0.0, -1.0},
                      2.0 * one_sheet);
    }
}

TEST(IdealRetarder, T43BetweenCrossedPolarizersShowsItsAngleAndRetardance) {
    for (const double degree : {0.0, 15.0, 45.0, 70.0}) {
        for (const double retardance : {20.0, 90.0, 180.0, 300.0}) {
            SCOPED_TRACE(text(degree) + " " + text(retardance));
            const double expected =
                0.5 * std::pow(std::sin(2.0 * radians(degree)), 2) * std::pow(std::sin(0.5 * radians(retardance)), 2);
            EXPECT_NEAR(look(stack({polarizer(90.0), retarder(degree, retardance), polarizer(0.0)})).s0, expected,
                        3.0 * one_sheet);
        }
    }
}

TEST(IdealCircularPolarizer, PassesOneHandednessOnly) {
    for (const auto& [hand, s3] : {std::pair{"right", 1.0}, std::pair{"left", -1.0}}) {
        SCOPED_TRACE(hand);
        const std::string sheet = std::string("circular: {passes: ") + hand + "}";
        expect_stokes(look(stack({sheet})), {0.5, 0.0, 0.0, 0.5 * s3}, one_sheet);
        expect_stokes(look(stack({sheet}, polarized("[0, 0, " + text(s3) + "]"))), {1.0, 0.0, 0.0, s3}, one_sheet);
        expect_stokes(look(stack({sheet}, polarized("[0, 0, " + text(-s3) + "]"))), {0.0, 0.0, 0.0, 0.0}, one_sheet);
        expect_stokes(look(stack({sheet}, polarized("[1, 0, 0]"))), {0.5, 0.0, 0.0, 0.5 * s3}, one_sheet);
    }
}

}  // namespace
}  // namespace pol::test
