// SPDX-License-Identifier: Apache-2.0
// Degenerate cases of scenes: their scale, their place, their brightness, their edges, their dispersion formulas.
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "geometry/mesh_check.h"
#include "spectrum/refractive_index.h"
#include "verify/degenerate/case_lists.h"
#include "verify/degenerate/closed_paths.h"

namespace pol::verify {

namespace {

constexpr int furnace_depth = 5;

/// The ball of CutFurnace with its radius and offset both times `scale`. Inputs: index, offset / radius.
Experiment scaled_ball(double scale) {
    return render_experiment({1.5, 0.8}, CutFurnace{furnace_depth}, furnace_depth, [scale](std::span<const double> x) {
        return s0_and_s1(look(furnace_sphere(x[0], x[1] * scale, furnace_depth, {0.0, 0.0, 0.0}, scale)));
    });
}

/// The ball of CutFurnace somewhere else. Inputs: index, x of the camera, x of the ball.
struct MovedFurnace {
    template <class Real>
    std::vector<Real> operator()(std::span<const Real> x) const {
        const std::array<Real, 2> at_origin = {x[0], x[1] - x[2]};
        return CutFurnace{furnace_depth}(std::span<const Real>(at_origin));
    }
};

Experiment moved_ball(double distance) {
    return render_experiment({1.5, distance + 0.8, distance}, MovedFurnace{}, furnace_depth,
                             [](std::span<const double> x) {
                                 Scene scene = furnace_sphere(x[0], 0.0, furnace_depth, {x[2], x[2], -x[2]});
                                 scene.camera.position.x = x[1];
                                 scene.camera.target.x = x[1];
                                 return s0_and_s1(look(scene));
                             });
}

/// Inputs: index, offset, radiance. Light divided by radiance.
struct BrightFurnace {
    template <class Real>
    std::vector<Real> operator()(std::span<const Real> x) const {
        return CutFurnace{furnace_depth}(x.first(2));
    }
};

Experiment bright_ball(double radiance) {
    return render_experiment({1.5, 0.8, radiance}, BrightFurnace{}, furnace_depth, [](std::span<const double> x) {
        Scene scene = furnace_sphere(x[0], x[1], furnace_depth);
        scene.background.radiance = ConstantSpectrum{x[2]};
        const OneRay ray = look(scene);
        return std::vector<double>{ray.light.s0 / x[2], ray.light.s1 / x[2]};
    });
}

/// All light that a solid redirects adds up to that of its surroundings. No inputs.
struct NothingLost {
    template <class Real>
    std::vector<Real> operator()(std::span<const Real>) const {
        return {Real(1)};
    }
};

constexpr int edge_depth = 8;

/// What a ray at `from` along `direction` sees of a solid in uniform light, and what the depth limit leaves out.
Experiment nothing_lost(const Shape& shape, const DVec3& from, const DVec3& direction) {
    return render_experiment({}, NothingLost{}, edge_depth, [shape, from, direction](std::span<const double>) {
        Scene scene = empty_scene(camera_at(from, direction, any_perpendicular(direction)));
        scene.background.radiance = ConstantSpectrum{1.0};
        scene.media = {glass_medium("glass", 1.5)};
        scene.objects = {solid("solid", shape, {0.0, 0.0, 0.0}, "glass")};
        scene.render.cut_by_depth_alone(edge_depth);
        const OneRay ray = look(scene);
        return std::vector<double>{ray.light.s0 + ray.untraced};
    });
}

const DVec3 oblique = unit(DVec3(-0.5, -0.7, -0.9));

/// A box of 2 x 2 x 2 whose top has a dent: not convex, so that Embree finds its triangles. Towards `aim`, its top has
/// a corner `sliver` wide.
MeshShape dented_box(double sliver) {
    const std::vector<DVec3> vertices = {{-1.0, -1.0, -1.0}, {1.0, -1.0, -1.0}, {1.0, 1.0, -1.0},
                                         {-1.0, 1.0, -1.0},  {-1.0, -1.0, 1.0}, {1.0, -1.0, 1.0},
                                         {1.0, 1.0, 1.0},    {-1.0, 1.0, 1.0},  {0.0, 1.0 - sliver, 0.5}};
    const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {1, 2, 6},
                                                                 {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7},
                                                                 {4, 5, 8}, {5, 6, 8}, {6, 7, 8}, {7, 4, 8}};
    auto mesh = mesh_from_triangles(vertices, triangles);
    if (!mesh) return {"refused", std::make_shared<Mesh>()};
    return {"dented box", std::make_shared<Mesh>(std::move(mesh).value())};
}

/// Aims at `target`, which lies on an edge, from outside.
Experiment at_edge(const Shape& shape, const DVec3& target) {
    return nothing_lost(shape, target - 5.0 * oblique, oblique);
}

/// Sellmeier's formula near a pole. Inputs: wavelength in nm, B, the pole's wavelength in micrometers.
struct NearPole {
    template <class Real>
    std::vector<Real> operator()(std::span<const Real> x) const {
        using std::sqrt;
        const Real um = x[0] / Real(1000);
        return {sqrt(Real(1) + x[1] * um * um / ((um - x[2]) * (um + x[2])))};
    }
};

DispersiveIndex one_pole(double strength, double pole_um, double min_nm, double max_nm) {
    return {"one pole", DispersionFormula{1, {0.0, strength, pole_um}, min_nm, max_nm}, {}};
}

Experiment near_pole(double distance) {
    Experiment experiment = experiment_on(NearPole{}, {125.0 * (1.0 + distance), 0.7, 0.125}, Accuracy::relative);
    experiment.program = [](std::span<const double> x) {
        const auto index = index_at(one_pole(x[1], x[2], 100.0, 1000.0), x[0]);
        return std::vector<double>{index ? index.value().n : std::numeric_limits<double>::quiet_NaN()};
    };
    return experiment;
}

/// Just inside its range a record answers, just outside it refuses, and below the pole, where n^2 < 0, too.
/// Result: the share of right answers of five.
Experiment range_ends(double distance) {
    Experiment experiment = experiment_on(NothingLost{}, {}, Accuracy::relative);
    experiment.program = [distance](std::span<const double>) {
        const DispersiveIndex record = one_pole(0.7, 0.125, 200.0, 800.0);
        const DispersiveIndex through_pole = one_pole(0.7, 0.125, 100.0, 800.0);
        const double step = std::max(distance, std::numeric_limits<double>::epsilon());
        const int right = static_cast<int>(static_cast<bool>(index_at(record, 200.0 * (1.0 + distance)))) +
                          static_cast<int>(static_cast<bool>(index_at(record, 800.0 * (1.0 - distance)))) +
                          static_cast<int>(!index_at(record, 200.0 * (1.0 - step))) +
                          static_cast<int>(!index_at(record, 800.0 * (1.0 + step))) +
                          static_cast<int>(!index_at(through_pole, 125.0 * (1.0 - step)));
        return std::vector<double>{right / 5.0};
    };
    return experiment;
}

}  // namespace

std::vector<DegenerateCase> scene_cases() {
    const std::string furnace = "closed form: 1 - (1 - R) R^(depth - 1)";
    const std::string all_light = "light and what the depth limit leaves out";
    std::vector<double> all_sizes;
    for (int exponent = -30; exponent <= 30; exponent += 5) all_sizes.push_back(std::pow(10.0, exponent));
    return {
        {"bright-and-dim", "A picture is the same for radiances from 1e-30 to 1e30", "radiance",
         s0_s1 + ", over the radiance", furnace, all_sizes, [](double l, const Turn&) { return bright_ball(l); }},
        {"box-edge", "A ray at an edge of a box hits it once: no leak, no second surface",
         "distance of the ray to the edge", all_light, "closed form: 1", and_zero(decades(-1, -17, 2)),
         [](double d, const Turn&) {
             return at_edge(BoxShape{{2.0, 2.0, 2.0}}, {1.0, 1.0 - d, 0.3});
         }},
        {"box-corner", "A ray at a corner of a box hits it once: no leak, no second surface",
         "distance of the ray to the corner", all_light, "closed form: 1", and_zero(decades(-1, -17, 2)),
         [](double d, const Turn&) {
             return at_edge(BoxShape{{2.0, 2.0, 2.0}}, {1.0 - d, 1.0 - 0.7 * d, 1.0});
         }},
        {"mesh-edge", "A ray at an edge between triangles of a mesh hits it once", "distance of the ray to the edge",
         all_light, "closed form: 1", and_zero(decades(-1, -17, 2)),
         [](double d, const Turn&) {
             return at_edge(dented_box(1.0), {1.0, 0.2 + d, 0.2});
         }},
        {"mesh-corner", "A ray at a corner of a mesh hits it once", "distance of the ray to the corner", all_light,
         "closed form: 1", and_zero(decades(-1, -17, 2)),
         [](double d, const Turn&) {
             return at_edge(dented_box(1.0), {1.0, 1.0 - d, 1.0 - 0.6 * d});
         }},
        {"scale", "A scene of any size makes the same picture", "scale", s0_s1, furnace, decades(-6, 6),
         [](double scale, const Turn&) { return scaled_ball(scale); }},
        {"offset", "A scene far from the origin keeps the digits that its coordinates have", "distance from the origin",
         s0_s1, furnace, decades(0, 12), [](double distance, const Turn&) { return moved_ball(distance); }},
        {"sliver", "A triangle as thin as the welding of vertices allows neither leaks nor turns light away",
         "width of the triangle", all_light, "closed form: 1", decades(-1, -6, 3),
         [](double width, const Turn&) {
             return at_edge(dented_box(width), {0.0, 1.0, 1.0 - 0.25 * width});
         }},
        {"dispersion-pole", "Towards the pole of a dispersion formula the index keeps the digits that its inputs allow",
         "wavelength / pole - 1", "index, to its own size", "the same formula with 113 bits", decades(-1, -14, 2),
         [](double distance, const Turn&) { return near_pole(distance); }},
        {"dispersion-range", "Outside its range, and where n^2 < 0, a record refuses instead of giving a number",
         "distance to the ends of the range, relative", "share of right answers at five wavelengths", "closed form: 1",
         and_zero(decades(-1, -15)), [](double distance, const Turn&) { return range_ends(distance); }},
    };
}

}  // namespace pol::verify
