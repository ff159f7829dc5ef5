// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "io/scenes/scene_file.h"
#include "io/scenes/scene_hash.h"
#include "support/render_scene.h"
#include "viewer/shown/twins.h"

namespace pol {
namespace {

constexpr const char* crystal_scene =
    "camera: {position: [0.3, 0.2, 5], target: [0, 0, 0], fov: 20, up: [0, 1, 0]}\n"
    "render: {size: [6, 6], wavelengths: [500, 600], residual: 1e-4}\n"
    "media:\n"
    "  calcite: {ordinary: 1.658, extraordinary: 1.486, axis: [1, 0, 1], absorption_o: 0.3, absorption_e: 0.6}\n"
    "objects:\n"
    "  - name: plate\n"
    "    shape: {box: {size: [4, 4, 1]}}\n"
    "    medium: calcite\n"
    "  - name: lamp\n"
    "    shape: {rectangle: {size: 20}}\n"
    "    transform: [{translate: [0, 0, -5]}]\n"
    "    emission: {radiance: 1, polarization: {crystal_plate: {medium: calcite, axis: [1, 0, 0], ray: e, fresnel: "
    "off}}}\n";

TEST(IsotropicTwin, HasTheMeanPermittivityAndKeepsThePlateOfTheLamp) {
    const Scene scene = test::scene_of(crystal_scene);
    const auto twin = isotropic_twin(scene);
    ASSERT_TRUE(twin);
    const auto* glass = std::get_if<IsotropicMedium>(&twin.value().media[0].matter);
    ASSERT_NE(glass, nullptr);
    // tr(epsilon)/3 by hand: (2 * 1.658^2 + 1.486^2)/3 = (5.497928 + 2.208196)/3 = 2.568708
    EXPECT_NEAR(std::pow(index_at(glass->index, 500.0).value().n, 2), 2.568708, 1e-12);
    EXPECT_NEAR(std::get<ConstantSpectrum>(glass->absorption).value, 0.4, 1e-15);
    const auto& plate = std::get<CrystalPlateState>(std::get<Emission>(twin.value().objects[1].role).state);
    EXPECT_EQ(plate.medium, "calcite (plate)");
    EXPECT_FALSE(test::plan_of(twin.value())->kernel().anisotropic);
}

// With n_e = n_o a crystal is glass, so the twin's picture is the picture.
TEST(IsotropicTwin, OfACrystalWithoutBirefringenceIsTheSamePicture) {
    Scene scene = test::scene_of(crystal_scene);
    auto& crystal = std::get<UniaxialMedium>(scene.media[0].matter);
    crystal.extraordinary = crystal.ordinary = ConstantIndex{{1.5, 0.0}};
    crystal.absorption_o = crystal.absorption_e = ConstantSpectrum{0.0};
    std::get<Emission>(scene.objects[1].role).state = FixedState{0.8, 0.0, 0.6};
    const auto twin = isotropic_twin(scene);
    ASSERT_TRUE(twin);
    const StokesImage a = test::render(scene);
    const StokesImage b = test::render(twin.value());
    for (std::size_t i = 0; i < a.stokes.size(); ++i) {
        EXPECT_NEAR(a.stokes[i].s0, b.stokes[i].s0, 1e-14);
        EXPECT_NEAR(a.stokes[i].s1, b.stokes[i].s1, 1e-14);
        EXPECT_NEAR(a.stokes[i].s3, b.stokes[i].s3, 1e-14);
    }
}

TEST(IsotropicTwin, FollowsTheDispersionOfTheCrystal) {
    Scene scene = test::shipped_scene("paper-calcite-unpolarized");
    scene.render.wavelengths_nm = {450.0, 580.0, 650.0};
    const auto& crystal = std::get<UniaxialMedium>(scene.media[0].matter);
    const auto twin = isotropic_twin(scene);
    ASSERT_TRUE(twin);
    const auto& glass = std::get<IsotropicMedium>(twin.value().media[0].matter);
    for (const double nm : scene.render.wavelengths_nm) {
        const double o = index_at(crystal.ordinary, nm).value().n;
        const double e = index_at(crystal.extraordinary, nm).value().n;
        EXPECT_NEAR(index_at(glass.index, nm).value().n, std::sqrt((2.0 * o * o + e * e) / 3.0), 1e-14);
    }
    // It can be saved and comes back.
    const auto loaded = parse_scene(save_scene(twin.value()), "twin.yaml", POL_TESTS_DIR);
    ASSERT_TRUE(loaded);
    EXPECT_EQ(scene_hash(loaded.value()), scene_hash(twin.value()));
}

TEST(IsotropicTwin, NeedsACrystal) {
    EXPECT_FALSE(isotropic_twin(test::shipped_scene("cube-glass")));
    EXPECT_EQ(twin_name("calcite.yaml", "isotropic"), "calcite-isotropic.yaml");
}

}  // namespace
}  // namespace pol
