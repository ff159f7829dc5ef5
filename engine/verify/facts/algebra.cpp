// SPDX-License-Identifier: Apache-2.0
// T46 to T50: incoherent sums, turned and mirrored cameras, and the scale of light.
#include <fmt/format.h>

#include <cmath>

#include "core/hypot.h"
#include "core/units.h"
#include "verify/facts/chapters.h"
#include "verify/facts/closed_forms.h"
#include "verify/facts/scene_text.h"

namespace pol::verify {

namespace {

/// Two linear states of equal radiance 0.04 in one pixel, `degree` apart: a lamp reflected by a glass surface and
/// another one below it, dimmer by R n^2/T.
std::string beam_splitter(double degree) {
    const auto linear = [](double radiance, double azimuth) {
        return "radiance: " + text(radiance) + ", polarization: {dop: 1, azimuth: " + text(azimuth) + "}";
    };
    return camera_along(downward(0.0)) + picture() + "media: {glass: 1.5}\nobjects:\n" +
           box("block", {4.0, 4.0, 4.0}, {0.0, 0.0, -2.0}, "glass") +
           lamp("above", {0.0, 0.0, 10.0}, {0.0, 0.0, -1.0}, 1.0, linear(1.0, 0.0)) +
           lamp("below", {0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, 1.0, linear(0.04 * 2.25 / 0.96, degree));
}

Fact sum_of_equal_states() {
    Fact fact{
        "T46",
        "Two equal linear states at an angle theta add, incoherently, to P = |cos theta|, never to elliptic light.",
        "coherence matrices add, PHYSICS.md 1"};
    const Tolerance tolerance = rounding(200.0 / 0.08, "two surfaces / 0.08");
    for (const double degree : {15.0, 60.0}) {
        const std::string name = fmt::format("{} degrees", degree);
        const std::size_t view = add_view(fact, name, beam_splitter(degree));
        expect(fact, view, "degree of polarization", std::cos(radians(degree)), tolerance, of_pixel(dop));
        expect(fact, view, "azimuth", 0.5 * degree, rounding(60.0 * 200.0 / 0.04, "two surfaces / 0.04, in degrees"),
               of_pixel(azimuth_degrees), "deg");
        expect(fact, view, "S3", 0.0, rounding(1.0, "S3"), of_pixel(s3));
    }
    return fact;
}

Fact sum_of_orthogonal_states() {
    Fact fact{"T47", "Two equal orthogonal states add, incoherently, to unpolarized light.",
              "coherence matrices add, PHYSICS.md 1"};
    const std::size_t view = add_view(fact, "", beam_splitter(90.0));
    expect(fact, view, "radiance", 0.08, rounding(32.0, "two surfaces"), of_pixel(s0));
    expect(fact, view, "degree of polarization", 0.0, rounding(200.0 / 0.08, "two surfaces / 0.08"), of_pixel(dop));
    return fact;
}

/// Light at +45 degrees made elliptic by a metal met at 50 degrees; the camera is rolled counter-clockwise by `roll`
/// degrees from the one whose x axis is s. `mirrored` puts all of it into a mirror in the plane y = 0.
struct EllipticScene {
    double roll = 0.0;
    bool mirrored = false;
    double radiance = 1.0;
};
constexpr double incidence = 50.0;
constexpr double metal_n = 0.05;
constexpr double metal_k = 3.8;

std::string elliptic_scene(const EllipticScene& scene) {
    const double i = radians(incidence);
    const DVec3 d = downward(i);
    // A mirror in y = 0 keeps all solids and directions here and turns the sense of rolling and of the lamp's azimuth.
    const double roll = radians(scene.mirrored ? -scene.roll : scene.roll);
    const DVec3 x(0.0, -1.0, 0.0);
    const DVec3 y = cross(x, d);  // the picture's up
    const DVec3 up = std::cos(roll) * y - std::sin(roll) * x;
    return fmt::format("camera: {{type: orthographic, position: {}, target: [0, 0, 0], up: {}, width: 1}}\n",
                       text(d * -5.0), text(up)) +
           picture() + fmt::format("media: {{metal: {{conductor: [{}, {}]}}}}\nobjects:\n", metal_n, metal_k) +
           deep_block("metal") +
           lamp("lamp", upward(i) * 10.0, -upward(i), 0.6,
                fmt::format("radiance: {}, polarization: {{stokes: [0, {}, 0]}}", text(scene.radiance),
                            scene.mirrored ? -1 : 1));
}

/// The light of elliptic_scene() without roll and mirror, in the frame of the camera whose x axis is s.
Stokes<double> elliptic_light() {
    return ClosedFresnel({metal_n, metal_k}, radians(incidence)).of_diagonal_light();
}

double polarized_length(const Stokes<double>& s) {
    return std::hypot(s.s1, s.s2, s.s3);
}
double expected_ellipticity(const Stokes<double>& s) {
    return std::abs(s.s3) / (polarized_length(s) + pol::hypot(s.s1, s.s2));
}

const Tolerance one_surface = rounding(64.0, "one surface and a frame");
const Tolerance one_surface_degrees = rounding(64.0 * 60.0 * 4.0, "one surface and a frame, in degrees");

Fact rolled_camera() {
    Fact fact{"T48", "Rolling the camera by theta shifts the azimuth by -theta and changes nothing else.",
              "rotation of the basis, PHYSICS.md 1"};
    const Stokes<double> s = elliptic_light();
    for (const double theta : {0.0, 20.0, -65.0}) {
        const std::string name = fmt::format("rolled by {} degrees", theta);
        const std::size_t view = add_view(fact, name, elliptic_scene({theta}));
        const double c = std::cos(2.0 * radians(theta));
        const double d = std::sin(2.0 * radians(theta));
        expect(fact, view, "S1", s.s1 * c + s.s2 * d, one_surface, of_pixel(s1));
        expect(fact, view, "S2", -s.s1 * d + s.s2 * c, one_surface, of_pixel(s2));
        expect(fact, view, "S3", s.s3, one_surface, of_pixel(s3));
        expect(fact, view, "degree of polarization", polarized_length(s) / s.s0, one_surface, of_pixel(dop));
        expect(fact, view, "ellipticity", expected_ellipticity(s), one_surface, of_pixel(ellipticity));
    }
    return fact;
}

Fact scale_of_light() {
    Fact fact{"T49", "Degree of polarization, ellipticity and azimuth do not depend on how bright the light is.",
              "ratios of Stokes components, PHYSICS.md 1"};
    const Stokes<double> s = elliptic_light();
    for (const double radiance : {1e-30, 1.0, 1e30}) {
        const std::string name = fmt::format("radiance {}", radiance);
        const std::size_t view = add_view(fact, name, elliptic_scene({0.0, false, radiance}));
        expect(fact, view, "degree of polarization", 1.0, one_surface, of_pixel(dop));
        expect(fact, view, "ellipticity", expected_ellipticity(s), one_surface, of_pixel(ellipticity));
        expect(fact, view, "azimuth", degrees(0.5 * std::atan2(s.s2, s.s1)), one_surface_degrees,
               of_pixel(azimuth_degrees), "deg");
    }
    return fact;
}

Fact mirrored_scene() {
    Fact fact{"T50", "In a mirror S2 and S3 change sign; degree of polarization and ellipticity stay.",
              "reflection of the basis, PHYSICS.md 1"};
    const Stokes<double> s = elliptic_light();
    for (const auto& [name, mirrored, sign] :
         {std::tuple{"scene", false, 1.0}, std::tuple{"its mirror image", true, -1.0}}) {
        const std::size_t view = add_view(fact, name, elliptic_scene({20.0, mirrored}));
        const double c = std::cos(radians(40.0));
        const double d = std::sin(radians(40.0));
        expect(fact, view, "S1", s.s1 * c + s.s2 * d, one_surface, of_pixel(s1));
        expect(fact, view, "S2", sign * (-s.s1 * d + s.s2 * c), one_surface, of_pixel(s2));
        expect(fact, view, "S3", sign * s.s3, one_surface, of_pixel(s3));
        expect(fact, view, "ellipticity", expected_ellipticity(s), one_surface, of_pixel(ellipticity));
    }
    return fact;
}

}  // namespace

std::vector<Fact> algebra_facts() {
    return {sum_of_equal_states(), sum_of_orthogonal_states(), rolled_camera(), scale_of_light(), mirrored_scene()};
}

}  // namespace pol::verify
