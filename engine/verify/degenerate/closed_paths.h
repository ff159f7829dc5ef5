// SPDX-License-Identifier: Apache-2.0
// Closed forms over any number type for experiments that render, and the ball in uniform light.
#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "optics/fresnel.h"
#include "verify/degenerate/experiment.h"
#include "verify/degenerate/one_ray.h"

namespace pol::verify {

/// Rounded operations of the tracer on a ray's way to a surface and across it: some 15 to the hit point, 20 for the
/// frame of incidence, 20 for Fresnel's amplitudes, 5 for the matrix of the branch.
constexpr int surface_operations = 60;

/// An experiment whose program renders and whose reference is a closed form over any number type. `surfaces`: on the
/// longest path that counts.
template <class ClosedForm>
Experiment render_experiment(std::vector<double> inputs, const ClosedForm& closed_form, int surfaces,
                             std::function<std::vector<double>(std::span<const double>)> render) {
    Experiment experiment = experiment_on(closed_form, std::move(inputs));
    experiment.program = std::move(render);
    experiment.chain = surfaces * surface_operations;
    return experiment;
}

template <class Real>
struct PairOfPowers {
    Real s{};
    Real p{};
};

/// Reflectances at the face between indices n1 and n2, k_t the tangential wave vector.
template <class Real>
PairOfPowers<Real> face_reflectance(const Real& n1, const Real& n2, const Real& k_t) {
    using std::sqrt;
    const Fresnel<Real> f = fresnel(n1, n2, Real(sqrt((n1 - k_t) * (n1 + k_t))));
    return {norm2(f.r_s), norm2(f.r_p)};
}

/// S0 and S1 of light in a picture whose x axis is s, from the powers of s and p of unpolarized light.
template <class Real>
std::vector<Real> s0_and_s1(const PairOfPowers<Real>& power) {
    return {(power.s + power.p) / Real(2), (power.s - power.p) / Real(2)};
}

inline std::vector<double> s0_and_s1(const OneRay& ray) {
    return {ray.light.s0, ray.light.s1};
}

/// A glass sphere of radius 1 in uniform light, met at the distance `offset` from its axis, cut after `depth` faces.
/// Inputs: index, offset. T14: 1 - (1 - R) R^(depth - 1).
struct CutFurnace {
    int depth = 1;
    template <class Real>
    std::vector<Real> operator()(std::span<const Real> x) const {
        const PairOfPowers<Real> r = face_reflectance(Real(1), x[0], x[1]);
        const auto light = [this](const Real& reflectance) {
            Real missing = Real(1) - reflectance;
            for (int i = 1; i < depth; ++i) missing = missing * reflectance;
            return Real(1) - missing;
        };
        return s0_and_s1(PairOfPowers<Real>{light(r.s), light(r.p)});
    }
};

inline Scene furnace_sphere(double n, double offset, int depth, const DVec3& center = {0.0, 0.0, 0.0},
                            double radius = 1.0) {
    // Seen along -z with up = x: the picture's x axis is y, across the plane of incidence.
    Scene scene =
        empty_scene(camera_at(center + DVec3(offset, 0.0, 5.0 * radius), {0.0, 0.0, -radius}, {1.0, 0.0, 0.0}));
    scene.background.radiance = ConstantSpectrum{1.0};
    scene.media = {glass_medium("glass", n)};
    scene.objects = {solid("ball", SphereShape{radius}, center, "glass")};
    scene.render.cut_by_depth_alone(depth);
    return scene;
}

/// The middle ray of that ball as the renderer sees it. Inputs: index, offset.
inline Experiment cut_furnace(double n, double offset, int depth) {
    return render_experiment({n, offset}, CutFurnace{depth}, depth, [depth](std::span<const double> x) {
        return s0_and_s1(look(furnace_sphere(x[0], x[1], depth)));
    });
}

}  // namespace pol::verify
