// SPDX-License-Identifier: Apache-2.0
// The frames that pictures and trees are written in: of the camera, of an interface, and from one to the next.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/units.h"
#include "optics/incidence_frame.h"
#include "plan/camera_model.h"
#include "polarization/coherence_matrix.h"
#include "tracer/throughput.h"

namespace pol {
namespace {

// Unit vectors are good to a few eps, and so are dot products of them.
constexpr double frame_rounding = 16.0 * std::numeric_limits<double>::epsilon();

class RandomDirections {
public:
    DVec3 next() { return unit(DVec3{normal_(engine_), normal_(engine_), normal_(engine_)}); }

private:
    std::mt19937_64 engine_{12345};
    std::normal_distribution<double> normal_;
};

/// x, y, k orthonormal, and x cross y = k.
void expect_right_handed(const DVec3& x, const DVec3& y, const DVec3& k) {
    EXPECT_NEAR(length2(x), 1.0, frame_rounding);
    EXPECT_NEAR(length2(y), 1.0, frame_rounding);
    EXPECT_NEAR(dot(x, y), 0.0, frame_rounding);
    EXPECT_NEAR(dot(x, k), 0.0, frame_rounding);
    EXPECT_NEAR(dot(y, k), 0.0, frame_rounding);
    EXPECT_NEAR(dot(cross(x, y), k), 1.0, frame_rounding);
}

TEST(Frame, OfACameraThatLooksNorthHasXEastAndYUp) {
    Camera camera;
    camera.position = DVec3(0.0, 0.0, 0.0);
    camera.target = DVec3(0.0, 0.0, -1.0);
    camera.up = DVec3(0.0, 2.0, -3.0);
    const CameraRay center = CameraModel(camera, 4, 4).ray(2.0, 2.0);
    EXPECT_EQ(center.direction, DVec3(0.0, 0.0, -1.0));
    EXPECT_EQ(center.x, DVec3(1.0, 0.0, 0.0));
    EXPECT_EQ(center.y, DVec3(0.0, 1.0, 0.0));
}

TEST(Frame, OfEveryPixelIsRightHandedAboutTheLight) {
    RandomDirections random;
    for (int i = 0; i < 50; ++i) {
        Camera camera;
        camera.position = 3.0 * random.next();
        camera.target = random.next();
        camera.up = random.next();
        camera.horizontal_fov = radians(120.0);
        const CameraModel model(camera, 7, 5);
        for (const double x : {0.0, 3.5, 7.0}) {
            const CameraRay ray = model.ray(x, 1.0);
            expect_right_handed(ray.x, ray.y, -ray.direction);
        }
    }
}

TEST(Frame, AtAnInterfaceHasSAcrossThePlaneOfIncidence) {
    const DVec3 n(0.0, 0.0, 1.0);
    const DVec3 k = unit(DVec3(1.0, 0.0, 2.0));
    // s = n x k points along +y for n = z, k in the xz plane towards +x.
    EXPECT_NEAR(incidence_frame(n, k).s.y, 1.0, frame_rounding);
}

TEST(Frame, AtAnInterfaceIsRightHandedAlsoNextToTheNormal) {
    RandomDirections random;
    for (const double tilt : {1.0, 1e-4, 1e-8, 1e-12, 1e-16, 0.0}) {
        SCOPED_TRACE(tilt);
        for (int i = 0; i < 50; ++i) {
            const DVec3 n = random.next();
            const auto frame = incidence_frame(n, unit(n + tilt * random.next()));
            expect_right_handed(frame.x, frame.s, n);
        }
    }
}

// The field itself, as a vector in space, must not depend on the frame it is written in, nor what the camera gets of
// it.
TEST(Frame, ALinearStateKeepsItsFieldInSpaceInEveryFrame) {
    RandomDirections random;
    for (int i = 0; i < 50; ++i) {
        const DVec3 k = random.next();
        const auto a = incidence_frame(random.next(), k);
        const auto b = incidence_frame(random.next(), k);
        const DVec3 a_fields[2] = {a.s, cross(k, a.s)};
        const DVec3 b_fields[2] = {b.s, cross(k, b.s)};
        const double angle = 0.1 * i;
        const DVec3 field = std::cos(angle) * a_fields[0] + std::sin(angle) * a_fields[1];
        const auto outer = [&field](const DVec3(&e)[2]) {
            return CoherenceMatrix<double>::outer({dot(field, e[0]), dot(field, e[1])});
        };
        Throughput<double> m;
        m.m = {{{{0.3, 0.1}, {-0.2, 0.7}}, {{0.5, -0.4}, {0.6, 0.2}}}};
        const Stokes<double> in_a = m.gather(outer(a_fields));
        const Stokes<double> in_b = in_basis(m, a_fields, b_fields[0], b_fields[1]).gather(outer(b_fields));
        EXPECT_NEAR(in_b.s0, in_a.s0, frame_rounding);
        EXPECT_NEAR(in_b.s1, in_a.s1, frame_rounding);
        EXPECT_NEAR(in_b.s2, in_a.s2, frame_rounding);
        EXPECT_NEAR(in_b.s3, in_a.s3, frame_rounding);
    }
}

TEST(Frame, TheWeightOfAThroughputIsTheShareOfUnpolarizedLightThatPasses) {
    Throughput<double> m;
    m.m = {{{{0.3, 0.1}, {-0.2, 0.7}}, {{0.5, -0.4}, {0.6, 0.2}}}};
    EXPECT_NEAR(m.weight(), m.gather(CoherenceMatrix<double>::unpolarized(1.0)).s0, frame_rounding);
}

}  // namespace
}  // namespace pol
