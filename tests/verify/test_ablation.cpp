// SPDX-License-Identifier: Apache-2.0
// What a plan leaves out changes no picture: kept all the same, it gives the same bits; and where it does not, that is
// found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "support/render_scene.h"
#include "verify/ablation/ablation.h"

namespace pol::verify {
namespace {

bool go_on(double /*done*/, const std::string& /*doing*/) {
    return true;
}

AblationRequest small_request(const std::string& name, SampleMode mode = SampleMode::point) {
    AblationRequest request;
    request.scene = test::shipped_scene(name);
    RenderSettings& settings = request.scene.render;
    settings.width = 12;
    settings.height = 9;
    settings.mode = mode;
    settings.samples_per_pixel = mode == SampleMode::area ? 2 : 1;
    // Crystals end in a random tail, which must be the same, too; in mode area they do so anyway.
    if (mode == SampleMode::point) settings.node_budget = 50;
    settings.wavelengths_nm = {450.0, 550.0, 650.0};
    request.rounds = 1;
    return request;
}

AblationResult ablated(const AblationRequest& request) {
    auto result = ablate(request, go_on);
    if (!result) throw std::runtime_error(to_string(result.error()));
    EXPECT_TRUE(result.value().complete);
    return std::move(result).value();
}

const AblationRow* row_of(const AblationResult& result, const std::string& feature) {
    const auto found = std::find_if(result.rows.begin(), result.rows.end(),
                                    [&](const AblationRow& row) { return row.feature == feature; });
    return found == result.rows.end() ? nullptr : &*found;
}

struct SmallScene {
    const char* name;
    SampleMode mode;
    std::vector<const char*> kept;  ///< among others
};

class Ablation : public testing::TestWithParam<SmallScene> {};

TEST_P(Ablation, WhatThePlanLeavesOutChangesNoBitOfThePicture) {
    const AblationResult result = ablated(small_request(GetParam().name, GetParam().mode));
    for (const char* feature : GetParam().kept) EXPECT_NE(row_of(result, feature), nullptr) << feature;
    for (const AblationRow& row : result.rows) {
        EXPECT_TRUE(row.holds) << row.feature;
        if (row.agreement)
            EXPECT_EQ(row.feature, "Embree scene");
        else
            EXPECT_EQ(row.hash, result.hash) << row.feature;
        EXPECT_FALSE(row.reason.empty()) << row.feature;
        EXPECT_GT(row.ratio, 0.0) << row.feature;
    }
    ASSERT_TRUE(result.all);
    EXPECT_EQ(result.all->hash, result.hash);
    EXPECT_TRUE(result.holds());
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Ablation,
    testing::Values(SmallScene{"cube-glass",
                               SampleMode::point,
                               {"dispersion", "crystals (o and e rays)", "absorption along rays", "Embree scene",
                                "shared faces", "lamps or absorbers in faces", "start of every ray",
                                "surfaces in every region", "halves of the samples", "depth limit"}},
                    SmallScene{"cube-glass", SampleMode::area, {"crystals (o and e rays)"}},
                    SmallScene{"cube-calcite", SampleMode::point, {"absorption along rays", "Embree scene"}},
                    SmallScene{"cube-calcite", SampleMode::area, {"depth limit"}},
                    SmallScene{"water-drop", SampleMode::point, {"crystals (o and e rays)", "shared faces"}},
                    SmallScene{"crossed-polarizers", SampleMode::area, {"dispersion", "absorption along rays"}},
                    SmallScene{"wollaston", SampleMode::point, {"absorption along rays", "start of every ray"}},
                    SmallScene{"metal-spheres", SampleMode::area, {"crystals (o and e rays)"}}),
    [](const auto& scene) {
        std::string name = scene.param.name;
        std::replace(name.begin(), name.end(), '-', '_');
        return name + (scene.param.mode == SampleMode::area ? "_area" : "_point");
    });

// Otherwise equal bits would say nothing.
TEST(Ablation, WhatIsKeptIsInThePlan) {
    Scene scene = small_request("cube-glass").scene;
    const auto with = [&scene](bool SpareParts::*part) {
        SpareParts kept;
        kept.*part = true;
        return compile(scene, kept).value();
    };
    const auto plain = compile(scene).value();
    EXPECT_EQ(plain->kernel(), (Kernel{false, false}));
    EXPECT_EQ(with(&SpareParts::crystals)->kernel(), (Kernel{true, false}));
    EXPECT_EQ(with(&SpareParts::absorption)->kernel(), (Kernel{false, true}));
    EXPECT_EQ(plain->groups.size(), 1U);
    EXPECT_EQ(with(&SpareParts::tree_per_wavelength)->groups.size(), 3U);
    EXPECT_EQ(plain->regions[0].caster, nullptr);
    EXPECT_NE(with(&SpareParts::meshes)->regions[0].caster, nullptr);
    EXPECT_TRUE(plain->solid(0).contacts.empty() && plain->solid(0).covers.empty());
    EXPECT_EQ(with(&SpareParts::contacts)->solid(0).contacts.size(), 6U);
    EXPECT_EQ(with(&SpareParts::covers)->solid(0).covers.size(), 6U);
    EXPECT_GE(plain->camera_region, 0);
    EXPECT_EQ(with(&SpareParts::start_search)->camera_region, -1);
    EXPECT_FALSE(plain->settings.depth);
    EXPECT_TRUE(with(&SpareParts::depth_limit)->settings.depth);
    const auto lamps_met = [](const Plan& plan) {
        std::size_t lamps = 0;
        for (const Region& region : plan.regions) lamps += region.surfaces.size();
        return lamps;
    };
    EXPECT_EQ(lamps_met(*plain), 1U);  // from outside the cube
    EXPECT_EQ(lamps_met(*with(&SpareParts::every_surface)), 2U);
    EXPECT_TRUE(test::render(plain).sampling_error.empty());
    EXPECT_FALSE(test::render(with(&SpareParts::halves)).sampling_error.empty());
}

TEST(Ablation, AFeatureThatChangesThePictureIsNamed) {
    AblationRequest request = small_request("cube-glass");
    request.make_plan = [](Scene scene, const SpareParts& kept) {
        if (kept.absorption) scene.background.radiance = ConstantSpectrum{1e-12};
        return compile(scene, kept);
    };
    const AblationResult result = ablated(request);
    EXPECT_FALSE(result.holds());
    for (const AblationRow& row : result.rows)
        EXPECT_EQ(row.holds, row.feature != "absorption along rays") << row.feature;
    EXPECT_FALSE(result.all->holds);
}

// A pixel in a hundred may differ where rounding does; a cube of another glass differs in most.
TEST(Ablation, MeshesThatShowAnotherPictureAreFound) {
    AblationRequest request = small_request("cube-glass");
    request.make_plan = [](Scene scene, const SpareParts& kept) {
        if (kept.meshes) scene.media.at(0).matter = IsotropicMedium{ConstantIndex{{1.6, 0.0}}, {}};
        return compile(scene, kept);
    };
    const AblationResult result = ablated(request);
    for (const AblationRow& row : result.rows) EXPECT_EQ(row.holds, row.feature != "Embree scene") << row.feature;
    EXPECT_TRUE(result.all->holds);
}

// A lamp of a fixed state may not reach into a crystal; one that is looked for everywhere would.
TEST(Ablation, WhatCannotBeKeptIsNamedWithTheReason) {
    const AblationResult result = ablated(small_request("paper-calcite-polarized"));
    EXPECT_TRUE(result.holds());
    EXPECT_EQ(row_of(result, "surfaces in every region"), nullptr);
    ASSERT_EQ(result.not_keepable.size(), 1U);
    EXPECT_EQ(result.not_keepable[0].name, "surfaces in every region");
    EXPECT_NE(result.not_keepable[0].reason.find("reaches into a crystal"), std::string::npos);
    EXPECT_TRUE(result.all);
}

TEST(Ablation, ThePictureIsMadeSmallEnoughToBeSoonDone) {
    AblationRequest request = small_request("cube-glass");
    request.scene.render.width = 4000;
    request.scene.render.height = 2000;
    request.longest_render_s = 1e-9;
    const AblationResult result = ablated(request);
    EXPECT_EQ(result.width, 8);
    EXPECT_EQ(result.height, 4);
}

TEST(Ablation, IsStoppedAtOnce) {
    const auto result = ablate(small_request("cube-glass"), [](double, const std::string&) { return false; });
    ASSERT_TRUE(result);
    EXPECT_FALSE(result.value().complete);
}

TEST(PictureHash, TellsTheLastBitOfAnyNumber) {
    const StokesImage picture = test::render(small_request("cube-calcite", SampleMode::area).scene);
    const std::uint64_t hash = picture_hash(picture, true);
    const auto changed = [&](const auto& change) {
        StokesImage other = picture;
        change(other);
        return picture_hash(other, true) != hash;
    };
    EXPECT_FALSE(changed([](StokesImage&) {}));
    EXPECT_TRUE(changed([](StokesImage& p) { p.stokes.back().s3 = std::nextafter(p.stokes.back().s3, 1.0); }));
    EXPECT_TRUE(changed([](StokesImage& p) { p.residual.back() = std::nextafter(p.residual.back(), 1.0); }));
    EXPECT_TRUE(changed([](StokesImage& p) { p.tail.back() = std::nextafter(p.tail.back(), 1.0); }));
    EXPECT_TRUE(changed([](StokesImage& p) { p.sampling_error.back().s0 += 1.0; }));
    EXPECT_TRUE(changed([](StokesImage& p) { std::swap(p.stokes.front(), p.stokes.back()); }));
}

// Bands of one tree share their planes; the light is the same if they do not.
TEST(PictureHash, DoesNotAskWhetherBandsShareAPlane) {
    const StokesImage shared = test::render(small_request("cube-glass").scene);
    ASSERT_EQ(shared.residual.size(), shared.pixel_count());
    StokesImage apart = shared;
    for (int band = 1; band < 3; ++band)
        apart.residual.insert(apart.residual.end(), shared.residual.begin(), shared.residual.end());
    EXPECT_EQ(picture_hash(apart, false), picture_hash(shared, false));
}

}  // namespace
}  // namespace pol::verify
