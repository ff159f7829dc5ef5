// SPDX-License-Identifier: Apache-2.0
// Degenerate cases of whole paths with a closed form: silhouettes, thin slabs and
// gaps, deep trees, absorption.
#include <cmath>
#include <utility>

#include "core/units.h"
#include "verify/degenerate/case_lists.h"
#include "verify/degenerate/closed_paths.h"

namespace pol::verify {

namespace {

/// Transmittances of parallel faces between the media `n`, all incoherent
/// passes, from the last face up.
template <class Real>
PairOfPowers<Real> stack_transmittance(const std::vector<Real>& n, const Real& k_t) {
    PairOfPowers<Real> through{Real(1), Real(1)};
    PairOfPowers<Real> back{Real(0), Real(0)};
    const auto add_face = [](const Real& r, Real& t_below, Real& r_below) {
        const Real t = Real(1) - r;
        const Real repeated = Real(1) / (Real(1) - r * r_below);
        t_below = t * t_below * repeated;
        r_below = r + t * t * r_below * repeated;
    };
    for (std::size_t i = n.size() - 1; i-- > 0;) {
        const PairOfPowers<Real> r = face_reflectance(n[i], n[i + 1], k_t);
        add_face(r.s, through.s, back.s);
        add_face(r.p, through.p, back.p);
    }
    return through;
}

/// Inputs: angle of incidence, then the indices from above to below.
struct StackOfFaces {
    template <class Real>
    std::vector<Real> operator()(std::span<const Real> x) const {
        using std::sin;
        return s0_and_s1(stack_transmittance(std::vector<Real>(x.begin() + 1, x.end()), Real(x[1] * sin(x[0]))));
    }
};

/// Seen from above at `incidence` in the plane y = 0; the picture's x axis is
/// -y, so S1 is s minus p.
Scene scene_before_lamp(double incidence) {
    const DVec3 along(std::sin(incidence), 0.0, -std::cos(incidence));
    Scene scene = empty_scene(camera_at(-3.0 * along, along, {std::cos(incidence), 0.0, std::sin(incidence)}));
    scene.objects = {lamp_sheet({0.0, 0.0, -4.0}, 40.0)};
    return scene;
}

/// A slab of glass of any thickness: the incoherent sum does not know it.
Experiment thin_slab(double thickness) {
    return render_experiment({0.5, 1.0, 1.5, 1.0}, StackOfFaces{}, 12, [thickness](std::span<const double> x) {
        Scene scene = scene_before_lamp(x[0]);
        scene.media = {glass_medium("glass", x[2])};
        scene.objects.push_back(solid("slab", BoxShape{{4.0, 4.0, thickness}}, {0.0, 0.0, 0.0}, "glass"));
        return s0_and_s1(look(scene));
    });
}

/// Inputs: angle of incidence, then the indices from above to below, as
/// StackOfFaces. Radiance is seen from inside the first medium and sent out
/// inside the last: it changes by the ratio of the squares of their indices.
struct StackBetweenMedia {
    template <class Real>
    std::vector<Real> operator()(std::span<const Real> x) const {
        const Real ratio = x[1] / x.back();
        std::vector<Real> power = StackOfFaces{}(x);
        for (Real& p : power) p = p * ratio * ratio;
        return power;
    }
};

/// A gap of air between two blocks, camera in the upper one, lamp in the lower
/// one; without a gap they are in contact.
Experiment air_gap(double gap) {
    std::vector<double> inputs = {0.4, 1.5, 1.7};
    if (gap > 0.0) inputs.insert(inputs.begin() + 2, 1.0);
    return render_experiment(inputs, StackBetweenMedia{}, 12, [gap](std::span<const double> x) {
        Scene scene = scene_before_lamp(x[0]);
        scene.media = {glass_medium("above", x[1]), glass_medium("below", x.back())};
        scene.objects = {
            solid("top", BoxShape{{6.0, 6.0, 4.0}}, {0.0, 0.0, 2.0 + gap}, "above"),
            solid("bottom", BoxShape{{6.0, 6.0, 2.0}}, {0.0, 0.0, -1.0}, "below"),
            lamp_sheet({0.0, 0.0, -0.5}, 5.0),
            {"lid", RectangleShape{{5.5, 5.5}}, lamp_sheet({0.0, 0.0, 3.5}, 1.0).to_world, Absorber{}, {}}};
        return s0_and_s1(look(scene));
    });
}

/// A ball of water in a thin wall of glass, the glass ball having the lower
/// priority, seen through its middle.
Experiment nested_balls(double wall) {
    return render_experiment({0.0, 1.0, 1.5, 1.333, 1.5, 1.0}, StackOfFaces{}, 16, [wall](std::span<const double> x) {
        Scene scene = scene_before_lamp(x[0]);
        scene.media = {glass_medium("glass", x[2]), glass_medium("water", x[3])};
        scene.objects.push_back(solid("vessel", SphereShape{1.0}, {0.0, 0.0, 0.0}, "glass"));
        scene.objects.push_back(solid("liquid", SphereShape{1.0 - wall}, {0.0, 0.0, 0.0}, "water"));
        scene.objects[1].priority = 1;
        scene.objects[2].priority = 2;
        return s0_and_s1(look(scene));
    });
}

/// Light, linear at 45 degrees to the faces, after `count` total reflections.
/// Inputs: angle of incidence, index. S2 + i S3 = (r_s conj(r_p))^count.
struct TotalReflections {
    int count = 1;
    template <class Real>
    std::vector<Real> operator()(std::span<const Real> x) const {
        using std::cos;
        const Fresnel<Real> f = fresnel(x[1], Real(1), Real(x[1] * cos(x[0])));
        const Complex<Real> once = f.r_s * conj(f.r_p);
        Complex<Real> state(Real(1));
        for (int i = 0; i < count; ++i) state *= once;
        return {Real(1), state.re, state.im};
    }
};

/// The camera stands in glass between two blocks of air one apart; the lamp
/// shines at it from the end of the guide.
Experiment light_guide(int count) {
    return render_experiment({0.9, 1.5}, TotalReflections{count}, count, [count](std::span<const double> x) {
        const DVec3 along(std::sin(x[0]), 0.0, std::cos(x[0]));
        const double length = count * std::tan(x[0]);
        Scene scene = empty_scene(camera_at({0.0, 0.0, 0.0}, along, {0.0, 0.0, 1.0}));
        scene.media = {glass_medium("glass", x[1]), glass_medium("air", 1.0)};
        scene.ambient = "glass";
        const DVec3 block(2.0 * length + 4.0, 2.0, 1.0);
        scene.objects = {solid("roof", BoxShape{block}, {0.5 * length, 0.0, 1.0}, "air"),
                         solid("floor", BoxShape{block}, {0.5 * length, 0.0, -1.0}, "air"),
                         lamp_sheet({0.0, 0.0, 0.0}, 0.9, FixedState{0.0, 1.0, 0.0, {0.0, 1.0, 0.0}})};
        // The lamp's normal z turned along -x, its y axis kept.
        scene.objects[2].to_world =
            DMat4({0.0, 0.0, 1.0, 0.0}, {0.0, 1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0, 0.0}, {length, 0.0, 0.0, 1.0});
        const OneRay ray = look(scene);
        return std::vector<double>{ray.light.s0, ray.light.s2, ray.light.s3};
    });
}

/// All passes of a plate at normal incidence whose o wave is absorbed. Inputs:
/// n_o, n_e, alpha times thickness. T = t^2 a/(1 - R^2 a^2), a = exp(-alpha d).
struct DichroicPlate {
    template <class Real>
    std::vector<Real> operator()(std::span<const Real> x) const {
        using std::exp;
        const auto transmittance = [](const Real& n, const Real& a) {
            const Real r = (n - Real(1)) / (n + Real(1));
            const Real reflectance = r * r;
            const Real t = Real(1) - reflectance;
            return t * t * a / (Real(1) - reflectance * reflectance * a * a);
        };
        const Real o = transmittance(x[0], exp(-x[2]));
        const Real e = transmittance(x[1], Real(1));
        return {(o + e) / Real(2), (o - e) / Real(2)};
    }
};

Experiment dichroic_plate(double n_o, double n_e, double absorbance) {
    return render_experiment({n_o, n_e, absorbance}, DichroicPlate{}, 14, [](std::span<const double> x) {
        Scene scene = scene_before_lamp(0.0);
        scene.unit_nm = 1e9;  // the plate is a metre thick: absorption along the ray, and none that its faces notice
        UniaxialMedium crystal;
        crystal.ordinary = ConstantIndex{{x[0], 0.0}};
        crystal.extraordinary = ConstantIndex{{x[1], 0.0}};
        crystal.axis = {1.0, 0.0, 0.0};
        crystal.absorption_o = ConstantSpectrum{x[2]};
        scene.media = {Medium{"tourmaline", crystal}};
        scene.objects.push_back(solid("plate", BoxShape{{4.0, 4.0, 1.0}}, {0.0, 0.0, 0.0}, "tourmaline"));
        return s0_and_s1(look(scene));
    });
}

std::vector<double> whole_numbers(int first, int last, int factor, int step) {
    std::vector<double> numbers;
    for (int i = first; i <= last; i = i * factor + step) numbers.push_back(i);
    return numbers;
}

const std::string of_stack = "closed form: incoherent passes of parallel faces";

}  // namespace

std::vector<DegenerateCase> path_cases() {
    const std::string furnace = "closed form: 1 - (1 - R) R^(depth - 1)";
    return {
        {"thin-slab",
         "A slab passes the incoherent sum of its reflections, down to 1e-7 of "
         "its width",
         "thickness", s0_s1, of_stack, decades(-1, -7, 2), [](double t, const Turn&) { return thin_slab(t); }},
        {"silhouette", "Towards the rim of a ball the first reflection takes all the light", "radius - offset", s0_s1,
         furnace, decades(-1, -15, 2), [](double d, const Turn&) { return cut_furnace(1.5, 1.0 - d, 5); }},
        {"air-gap",
         "A gap of air is a gap, down to 1e-9 of the scene; without one the "
         "blocks are in contact",
         "gap", s0_s1, of_stack, and_zero(decades(-1, -8, 2)), [](double gap, const Turn&) { return air_gap(gap); }},
        {"vessel-wall", "A liquid in a vessel is met behind its wall however thin that is", "thickness of the wall",
         s0_s1, of_stack, decades(-1, -11, 2), [](double wall, const Turn&) { return nested_balls(wall); }},
        {"depth-limit", "What a depth limit leaves out is what the closed form says", "depth limit", s0_s1, furnace,
         whole_numbers(1, 16, 1, 1),
         [](double depth, const Turn&) { return cut_furnace(2.4, 0.999, static_cast<int>(depth)); }},
        {"light-guide",
         "A ray may be reflected thousands of times: the phases add up and "
         "nothing is lost",
         "total reflections", "S0, S2, S3 of one rendered ray", "closed form: (r_s r_p*)^N",
         whole_numbers(1, 4096, 2, 0), [](double count, const Turn&) { return light_guide(static_cast<int>(count)); }},
        {"dichroic-plate", "A tourmaline plate passes o less and less: P tends to 1", "absorption x thickness", s0_s1,
         "closed form: t^2 a/(1 - R^2 a^2)", decades(-12, 3),
         [](double absorbance, const Turn&) { return dichroic_plate(1.64, 1.62, absorbance); }},
    };
}

}  // namespace pol::verify
