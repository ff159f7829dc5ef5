// SPDX-License-Identifier: Apache-2.0
// Invariants that compare a scene with an edited copy of itself.
#include <algorithm>
#include <cmath>
#include <variant>

#include "polarization/measures.h"
#include "render/render_to_end.h"
#include "tracer/explain.h"
#include "verify/invariants/error_bar_check.h"
#include "verify/invariants/invariants.h"
#include "verify/invariants/scene_twins.h"

namespace pol::verify {

namespace {

StokesImage render(const std::shared_ptr<const Plan>& plan, int threads, int tile_size) {
    return render_to_end(plan, {}, {threads, tile_size}).picture;
}

/// Interfaces that a ray may meet where a symmetry is tested: few enough for crystals, whose trees double each time.
constexpr int twin_depth = 5;

/// Directions agree to rounding between the two pictures. Amplitudes inherit it times the slope of Fresnel's formulas,
/// 1/sqrt(x) at the distance x from a critical angle: with 1e6 interfaces in a picture the closest comes within 1e-6,
/// slope 1e3, so 1e-15 x 40 surfaces' operations x 1e3 < 1e-10.
constexpr double twin_rounding = 1e-10;

/// A pixel differs for good where a path passes an edge by less than rounding: scenes put edges where pixel centres
/// are.
std::size_t allowed_flips(const StokesImage& image) {
    return std::max<std::size_t>(2, image.pixel_count() / 100) * image.bands.size();
}
constexpr const char* flips = "a pixel may differ where a path meets an edge exactly";

/// Adds all pixels of two pictures; pixel (x, y) of `here` is compared with `there_of(x, y)`.
template <class ThereOf>
void compare(Tally& tally, const StokesImage& here, double tolerance, const ThereOf& there_of) {
    for (std::size_t w = 0; w < here.bands.size(); ++w)
        for (int y = 0; y < here.height; ++y)
            for (int x = 0; x < here.width; ++x) {
                const Stokes<double> d = here.at(w, here.pixel(x, y)) - there_of(w, x, y);
                const double scale = here.brightest[w] > 0.0 ? here.brightest[w] : 1.0;
                tally.add((std::abs(d.s0) + polarized_part(d)) / (tolerance * scale),
                          {x, y, *here.bands[w].wavelength_nm});
            }
}

/// Adds all pixels of two pictures that must be the same to the last bit.
void compare_bits(Tally& tally, const StokesImage& a, const StokesImage& b) {
    for (std::size_t w = 0; w < a.bands.size(); ++w)
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x) {
                const std::size_t p = a.pixel(x, y);
                const bool same = a.at(w, p) == b.at(w, p) &&
                                  a.plane_value(a.residual, w, p) == b.plane_value(b.residual, w, p) &&
                                  a.plane_value(a.tail, w, p) == b.plane_value(b.tail, w, p);
                tally.add_exact(same, {x, y, *a.bands[w].wavelength_nm});
            }
}

InvariantResult twin_failed(const Error& error) {
    return does_not_apply("the edited scene does not compile: " + error.what);
}

/// True if all light that the picture sees leaves its source in a medium of the camera's index: else equal radiance
/// everywhere is no equilibrium (PHYSICS.md 2.3).
bool shines_in_one_medium(const SceneUnderTest& test) {
    const Plan& plan = *test.plan;
    const auto index_of = [&](int region) {
        const int medium = plan.regions[static_cast<std::size_t>(region)].medium;
        return plan.groups[0].media[static_cast<std::size_t>(medium)].dielectric.n;
    };
    for (int y = 0; y < test.image.height; ++y)
        for (int x = 0; x < test.image.width; ++x) {
            const Explanation e = explain(plan, x, y, 0, 0);
            for (const RayTreeNode& node : e.tree.nodes)
                if (node.brings_light() && index_of(node.end.region) != index_of(e.task.region)) return false;
        }
    return true;
}

DMat3 some_rotation() {
    const DVec3 x = unit(DVec3(0.3, -0.7, 0.5));
    const DVec3 y = any_perpendicular(x);
    return {x, y, cross(x, y)};
}

}  // namespace

InvariantResult is_invisible_in_a_furnace(const SceneUnderTest& test) {
    if (const auto loss = what_loses_light(test.scene, *test.plan)) return does_not_apply(*loss);
    constexpr double radiance = 0.75;
    const auto furnace = under_test(as_furnace(test.scene, radiance));
    if (!furnace) return twin_failed(furnace.error());
    if (!shines_in_one_medium(furnace.value()))
        return does_not_apply("there are lights in another medium than the camera's");
    const StokesImage& image = furnace.value().image;
    const double rounding = radiance * tree_rounding(furnace.value().statistics.most_nodes);
    Tally tally;
    for (std::size_t w = 0; w < image.bands.size(); ++w)
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const std::size_t p = image.pixel(x, y);
                const double residual = image.plane_value(image.residual, w, p);
                const double tail = image.plane_value(image.tail, w, p);
                const Stokes<double>& s = image.at(w, p);
                // What was not traced is missing from S0; |s| is at most what is missing or estimated.
                const double lost = std::abs(s.s0 - radiance * (1.0 - residual));
                const double polarized = polarized_part(s) - radiance * (residual + 2.0 * tail);
                tally.add(std::max(lost, polarized) / rounding, {x, y, *image.bands[w].wavelength_nm});
            }
    return tally.result();
}

InvariantResult is_the_same_for_any_threads_and_tiles(const SceneUnderTest& test) {
    Tally tally;
    compare_bits(tally, test.image, render(test.plan, 3, 5));
    compare_bits(tally, test.image, render(test.plan, 2, 64));
    return tally.result();
}

InvariantResult looks_the_same_moved_turned_and_scaled(const SceneUnderTest& test) {
    const Scene scene = cut_by_depth(test.scene, twin_depth);
    const auto here = under_test(scene);
    if (!here) return twin_failed(here.error());
    const double extent = here.value().plan->length_scale;
    const DMat3 none(1.0);
    const struct {
        DMat3 turn;
        double scale;
        DVec3 shift;
    } carries[] = {{none, 1e-6, DVec3(0.0)},
                   {none, 1e6, DVec3(0.0)},
                   {none, 1.0, DVec3(7.3, -4.1, 5.9) * extent},
                   {some_rotation(), 1.0, DVec3(0.0)},
                   {some_rotation(), 1e3, DVec3(-2.2e3, 3.1e3, 1e3) * extent}};
    Tally tally;
    for (const auto& carry : carries) {
        const auto there = under_test(carried(scene, carry.turn, carry.scale, carry.shift));
        if (!there) return twin_failed(there.error());
        const StokesImage& image = there.value().image;
        compare(tally, here.value().image, twin_rounding,
                [&](std::size_t w, int x, int y) { return image.at(w, image.pixel(x, y)); });
    }
    return tally.result(std::size(carries) * allowed_flips(test.image), flips);
}

InvariantResult flips_s2_and_s3_in_a_mirror(const SceneUnderTest& test) {
    Scene scene = cut_by_depth(test.scene, twin_depth);
    scene.render.mode = SampleMode::point;  // samples within a pixel do not lie in mirror symmetry
    scene.render.samples_per_pixel = 1;
    const auto here = under_test(scene);
    const auto there = under_test(mirrored(scene));
    if (!here || !there) return twin_failed(here ? there.error() : here.error());
    const StokesImage& image = there.value().image;
    Tally tally;
    compare(tally, here.value().image, twin_rounding, [&](std::size_t w, int x, int y) {
        const Stokes<double>& s = image.at(w, image.pixel(image.width - 1 - x, y));
        return Stokes<double>{s.s0, s.s1, -s.s2, -s.s3};
    });
    return tally.result(allowed_flips(test.image), flips);
}

InvariantResult is_glass_with_equal_indices(const SceneUnderTest& test) {
    const auto is_crystal = [](const Medium& medium) { return crystal_in(medium.matter) != nullptr; };
    if (std::none_of(test.scene.media.begin(), test.scene.media.end(), is_crystal))
        return does_not_apply("there is no crystal");
    for (const Object& object : test.scene.objects)
        if (const auto* emission = std::get_if<Emission>(&object.role))
            if (std::holds_alternative<CrystalPlateState>(emission->state))
                return does_not_apply("'" + object.name + "' is covered by a virtual crystal plate");
    const auto crystal = under_test(with_equal_indices(test.scene));
    const auto glass = under_test(with_glass_for_crystals(test.scene));
    if (!crystal || !glass) return twin_failed(crystal ? glass.error() : crystal.error());
    Tally tally;
    compare_bits(tally, crystal.value().image, glass.value().image);
    return tally.result();
}

InvariantResult has_true_error_bars(const SceneUnderTest& test) {
    const auto cut = [&](double residual, int node_budget) {
        Scene scene = test.scene;
        scene.render.residual = residual;
        scene.render.node_budget = node_budget;
        scene.render.depth.reset();
        return scene;
    };
    const auto deep = under_test(cut(1e-6, 10000));
    if (!deep) return twin_failed(deep.error());
    Tally tally;
    for (const Scene& scene : {cut(0.3, 10000), cut(0.05, 1000), cut(1e-3, 20)}) {
        const auto shallow = under_test(scene);
        if (!shallow) return twin_failed(shallow.error());
        const StokesImage& a = shallow.value().image;
        const StokesImage& b = deep.value().image;
        for (std::size_t w = 0; w < a.bands.size(); ++w)
            for (int y = 0; y < a.height; ++y)
                for (int x = 0; x < a.width; ++x)
                    tally.add_exact(!contradiction(a, b, w, a.pixel(x, y)), {x, y, *a.bands[w].wavelength_nm});
    }
    return tally.result();
}

}  // namespace pol::verify
