// SPDX-License-Identifier: Apache-2.0
// Facts T48 to T50 for whole pictures: turned and mirrored cameras, and the scale of light.
#include "maps/evaluate.h"
#include "physics/fact_scene.h"

namespace pol::test {
namespace {

// A handful of surfaces of some 20 operations, each rounded by eps/2, on light of order 1.
constexpr double few_surfaces = 200.0 * eps;

/// Glass, metal and crystal between polarized light and dim surroundings: all four Stokes components everywhere.
Scene still_life() {
    return scene_of(R"(
camera: {position: [0, -6, 2], target: [0, 0, 0.1], fov: 32}
background: 0.2
render: {size: [12, 12], depth: 5}
media:
  glass: 1.5
  silver: {conductor: [0.05, 3.8]}
  crystal: {ordinary: 1.65, extraordinary: 1.5, axis: [1, 0.4, 0.7]}
objects:
  - {name: ball, shape: {sphere: {radius: 0.7}}, transform: [{translate: [-0.4, 0, 0.1]}], medium: glass}
  - {name: mirror, shape: {sphere: {radius: 0.5}}, transform: [{translate: [0.9, 0.5, 0.3]}], medium: silver}
  - {name: stone, shape: {box: {size: [0.8, 0.6, 0.5]}},
     transform: [{rotate: {axis: [1, 2, 3], angle: 25}}, {translate: [0.6, -1, -0.2]}], medium: crystal}
  - {name: floor, shape: {rectangle: {size: [3.1, 5.3]}},
     transform: [{rotate: {axis: [0, 0, 1], angle: 9}}, {translate: [0, 0, -0.9]}],
     emission: {radiance: 1, polarization: {dop: 0.9, azimuth: 25, ellipticity: 0.4, handedness: right}}}
  - {name: wall, shape: {rectangle: {size: [2.3, 2.1]}},
     transform: [{rotate: {axis: [1, 0, 0], angle: 80}}, {translate: [0.2, 2.9, 0.7]}],
     emission: {radiance: 0.7, polarization: {dop: 1, azimuth: -30, ellipticity: 0.2, handedness: left}}}
)");
}

/// Largest component of each kind over the picture, so that no comparison is of zeros.
void expect_colorful(const StokesImage& image) {
    Stokes<double> largest;
    for (const Stokes<double>& s : image.stokes) {
        largest.s1 = std::max(largest.s1, std::abs(s.s1));
        largest.s2 = std::max(largest.s2, std::abs(s.s2));
        largest.s3 = std::max(largest.s3, std::abs(s.s3));
    }
    EXPECT_GT(largest.s1, 0.1);
    EXPECT_GT(largest.s2, 0.1);
    EXPECT_GT(largest.s3, 0.1);
}

// Directions differ by rounding between the two pictures. 144 pixels of up to 4^5 surfaces make 1e5 interfaces, the
// closest of them 1e-5 from a critical angle, where amplitudes have the slope 1/sqrt(1e-5): 300 x 1e-15 x operations.
constexpr double picture_rounding = 1e-10;

/// Turned counter-clockwise about the line of sight: the new x axis is cos x + sin y of the old ones.
Scene rolled(Scene scene, double angle) {
    Camera& camera = scene.camera;
    const DVec3 forward = unit(camera.target - camera.position);
    const DVec3 right = unit(cross(forward, camera.up));
    camera.up = std::cos(angle) * cross(right, forward) - std::sin(angle) * right;
    return scene;
}

TEST(TurnedCamera, T48ShiftsTheAzimuthAndNothingElse) {
    Scene scene = still_life();
    // One ray each at the ball, the mirror, the stone and the floor.
    for (const DVec3& target :
         {DVec3(-0.6, 0.0, 0.3), DVec3(0.8, 0.5, 0.0), DVec3(0.5, -1.0, -0.2), DVec3(0.1, 0.3, -0.9)}) {
        scene.camera.target = target;
        const Stokes<double> s = look(scene);
        const Measures<double> straight = measure(s);
        ASSERT_GT(straight.dolp, 1e-3) << text(target);
        for (const double theta : {0.3, 1.2, -0.7, 2.5}) {
            SCOPED_TRACE(text(target) + " turned by " + text(theta));
            const Stokes<double> turned = look(rolled(scene, theta));
            const double c = std::cos(2.0 * theta);
            const double d = std::sin(2.0 * theta);
            expect_stokes(turned, {s.s0, s.s1 * c + s.s2 * d, -s.s1 * d + s.s2 * c, s.s3}, picture_rounding);
            const Measures<double> m = measure(turned);
            EXPECT_NEAR(m.dop, straight.dop, picture_rounding);
            EXPECT_NEAR(m.ellipticity, straight.ellipticity, picture_rounding / straight.dop);
            EXPECT_NEAR(std::remainder(m.azimuth - (straight.azimuth - theta), pi), 0.0,
                        picture_rounding / straight.dolp);
        }
    }
}

TEST(TurnedCamera, T48TurnsThePictureAndKeepsWhatHasNoDirection) {
    const StokesImage upright = test::render(still_life());
    const StokesImage turned = test::render(rolled(still_life(), 0.5 * pi));
    expect_colorful(upright);
    for (int y = 0; y < upright.height; ++y) {
        for (int x = 0; x < upright.width; ++x) {
            const Stokes<double>& a = upright.at(0, upright.pixel(x, y));
            // The new x axis is the old y axis.
            const Stokes<double>& b = turned.at(0, turned.pixel(upright.height - 1 - y, x));
            ASSERT_NEAR(a.s0, b.s0, picture_rounding) << x << " " << y;
            ASSERT_NEAR(linear_part(a), linear_part(b), picture_rounding) << x << " " << y;
            ASSERT_NEAR(a.s3, b.s3, picture_rounding) << x << " " << y;
        }
    }
}

/// The scene, its lights' states included, in a mirror in the plane x = 0.
Scene mirrored(Scene scene) {
    DMat4 mirror(1.0);
    mirror[0][0] = -1.0;
    for (Object& object : scene.objects) {
        object.to_world = mirror * object.to_world;
        if (auto* emission = std::get_if<Emission>(&object.role)) {
            auto& state = std::get<FixedState>(emission->state);
            state.s2 = -state.s2;
            state.s3 = -state.s3;
        }
    }
    return scene;
}

TEST(MirroredPicture, T50ChangesTheSignsOfS2AndS3Only) {
    const StokesImage here = test::render(still_life());
    const StokesImage there = test::render(mirrored(still_life()));
    expect_colorful(here);
    for (int y = 0; y < here.height; ++y) {
        for (int x = 0; x < here.width; ++x) {
            SCOPED_TRACE(std::to_string(x) + " " + std::to_string(y));
            const Stokes<double>& a = here.at(0, here.pixel(x, y));
            expect_stokes(there.at(0, there.pixel(here.width - 1 - x, y)), {a.s0, a.s1, -a.s2, -a.s3},
                          picture_rounding);
        }
    }
}

/// All light times `factor`.
Scene lit_by(Scene scene, double factor) {
    const auto scale = [&](Spectrum& spectrum) { std::get<ConstantSpectrum>(spectrum).value *= factor; };
    scale(scene.background.radiance);
    for (Object& object : scene.objects)
        if (auto* emission = std::get_if<Emission>(&object.role)) scale(std::get<Spectrum>(emission->radiance));
    return scene;
}

TEST(Maps, T49DoNotHangOnTheUnitOfRadiance) {
    const StokesImage bright = test::render(still_life());
    // A power of two scales every number without rounding; else each radiance is rounded once, by up to eps.
    for (const auto& [factor, tolerance] : {std::pair{0x1p-100, 0.0}, std::pair{0x1p100, 0.0},
                                            std::pair{1e-30, few_surfaces}, std::pair{1e30, few_surfaces}}) {
        const StokesImage scaled = test::render(lit_by(still_life(), factor));
        for (const Quantity quantity :
             {Quantity::dop, Quantity::dolp, Quantity::docp, Quantity::ellipticity, Quantity::azimuth,
              Quantity::handedness, Quantity::residual, Quantity::dop_error, Quantity::unphysical}) {
            SCOPED_TRACE(std::string(info(quantity).name) + " x " + text(factor));
            const Map a = evaluate(bright, quantity, 0).value();
            const Map b = evaluate(scaled, quantity, 0).value();
            for (std::size_t p = 0; p < a.pixels.size(); ++p) {
                ASSERT_EQ(a.pixels[p].state, b.pixels[p].state) << p;
                if (a.pixels[p].state == PixelState::defined) {
                    ASSERT_NEAR(a.pixels[p].value, b.pixels[p].value, tolerance) << p;
                }
            }
        }
    }
}

}  // namespace
}  // namespace pol::test
