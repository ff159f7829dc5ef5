// SPDX-License-Identifier: Apache-2.0
#include "io/live/live_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/tev_vectors.h"

namespace pol {
namespace {

/// Requires: `bytes` is such a message; they must stay as long as an update of theirs is used.
template <class Kind>
Kind decoded(const std::vector<std::byte>& bytes) {
    return std::get<Kind>(std::get<tev::Message>(tev::decode(bytes)));
}

tev::CreateImage created(const std::string& name, const std::vector<std::string>& channels, int width = 2,
                         int height = 1) {
    return {false, name, width, height, channels};
}

/// An update of one row of two pixels.
struct Update {
    std::vector<float> numbers;
    tev::UpdateImage message;
    Update(const std::vector<std::string>& channels, std::vector<float> planes) : numbers(std::move(planes)) {
        message = {false, "a", channels, {0, 0, 2, 1}, {}, {}, std::as_bytes(std::span(numbers))};
        for (std::size_t c = 0; c < channels.size(); ++c) {
            message.offsets.push_back(static_cast<std::int64_t>(2 * c));
            message.strides.push_back(1);
        }
    }
};

bool is_stokes(const LivePicture& picture) {
    const std::vector<Band> bands = picture.blank().bands;
    return std::any_of(bands.begin(), bands.end(), [](const Band& band) { return band.known.has(1); });
}

TEST(LivePicture, TilesOfInterleavedNumbersLandInTheirPixels) {
    const auto create = test::tev_vector("create_stokes").bytes;
    const auto all = test::tev_vector("update_v3_all").bytes;
    const auto tile = test::tev_vector("update_v3_tile").bytes;
    const LivePicture picture(decoded<tev::CreateImage>(create));
    ASSERT_TRUE(is_stokes(picture));
    EXPECT_EQ(picture.name(), "stokes");
    StokesImage image = picture.blank();
    ASSERT_EQ(image.width, 3);
    ASSERT_EQ(image.height, 2);
    ASSERT_EQ(image.bands.size(), 1U);
    EXPECT_EQ(image.bands[0].known, StokesComponents::all());
    EXPECT_EQ(image.at(0, 5), Stokes<double>{});

    // It has 0, 1/8, 2/8, ... pixel by pixel.
    picture.apply(decoded<tev::UpdateImage>(all), image);
    for (std::size_t p = 0; p < 6; ++p) {
        const double first = 0.5 * static_cast<double>(p);
        EXPECT_EQ(image.at(0, p), (Stokes<double>{first, first + 0.125, first + 0.25, first + 0.375}));
    }
    // The tile has the same beginning, at (1, 1) and (2, 1).
    picture.apply(decoded<tev::UpdateImage>(tile), image);
    EXPECT_EQ(image.at(0, 3).s0, 1.5);
    EXPECT_EQ(image.at(0, 4), (Stokes<double>{0.0, 0.125, 0.25, 0.375}));
    EXPECT_EQ(image.at(0, 5), (Stokes<double>{0.5, 0.625, 0.75, 0.875}));
}

TEST(LivePicture, RedGreenAndBlueAreThreeBands) {
    const auto create = test::tev_vector("create_rgb12").bytes;
    const auto update = test::tev_vector("update_rgb12").bytes;
    const LivePicture picture(decoded<tev::CreateImage>(create));
    ASSERT_TRUE(is_stokes(picture));
    StokesImage image = picture.blank();
    ASSERT_TRUE(rgb_bands(image.bands));
    picture.apply(decoded<tev::UpdateImage>(update), image);
    for (const Stokes<double>& s : image.stokes) EXPECT_EQ(s, (Stokes<double>{1, 1, 1, 1}));
}

TEST(LivePicture, AWavelengthInTheNamesIsTheBand) {
    const auto create = test::tev_vector("create_spectral").bytes;
    const LivePicture picture(decoded<tev::CreateImage>(create));
    EXPECT_TRUE(is_stokes(picture));
    EXPECT_EQ(wavelengths_of(picture.blank().bands), std::vector<double>{580.0});
}

TEST(LivePicture, ColourHasNoPolarization) {
    const LivePicture picture(created("pbrt", {"A", "B", "G", "R"}));
    EXPECT_FALSE(is_stokes(picture));
    StokesImage image = picture.blank();
    const auto bands = rgb_bands(image.bands);
    ASSERT_TRUE(bands);
    EXPECT_EQ(image.bands[0].known, StokesComponents::s0());
    // pbrt sends one channel a message.
    picture.apply(Update({"R"}, {1, 2}).message, image);
    picture.apply(Update({"G"}, {3, 4}).message, image);
    picture.apply(Update({"B"}, {5, 6}).message, image);
    picture.apply(Update({"A"}, {7, 8}).message, image);
    EXPECT_EQ(image.at((*bands)[0], 1), (Stokes<double>{2, 0, 0, 0}));
    EXPECT_EQ(image.at((*bands)[1], 0), (Stokes<double>{3, 0, 0, 0}));
    EXPECT_EQ(image.at((*bands)[2], 1), (Stokes<double>{6, 0, 0, 0}));
    EXPECT_FALSE(image.origin.layout.empty()) << "how it was understood";
}

TEST(LivePicture, ChannelsOfOtherNamesAreBandsOfTheirOwn) {
    const LivePicture picture(created("depth", {"Z", "mask"}));
    StokesImage image = picture.blank();
    ASSERT_EQ(image.bands.size(), 2U);
    EXPECT_EQ(image.bands[1], named_band("mask", StokesComponents::s0()));
    picture.apply(Update({"mask"}, {1, 2}).message, image);
    EXPECT_EQ(image.at(1, 1).s0, 2.0);
    EXPECT_EQ(image.at(0, 1).s0, 0.0);
}

TEST(LivePicture, AnUpdateMustFitThePicture) {
    const LivePicture picture(created("a", {"S0", "S1", "S2", "S3"}));
    EXPECT_EQ(picture.fault_of(Update({"S0"}, {1, 2}).message), std::nullopt);
    EXPECT_EQ(picture.fault_of(Update({"S0", "S4"}, {1, 2, 3, 4}).message), tev::Fault::channel);
    const auto outside = test::tev_vector("outside").bytes;
    const LivePicture stokes(decoded<tev::CreateImage>(test::tev_vector("create_stokes").bytes));
    EXPECT_EQ(stokes.fault_of(decoded<tev::UpdateImage>(outside)), tev::Fault::rectangle);
}

TEST(LivePicture, TheNameMaySayTheConvention) {
    const LiveName name = read_live_name("a|b|handedness=left,zero=up,y=down,layout=stokes");
    EXPECT_EQ(name.shown, "a|b");
    EXPECT_EQ(name.convention, (StokesConvention{true, true, 90.0}));
    EXPECT_EQ(name.layout, "stokes");
    EXPECT_TRUE(name.problem.empty());
}

TEST(LivePicture, ABarInANameIsAName) {
    EXPECT_EQ(read_live_name("render").shown, "render");
    for (const char* odd : {"left|right", "a|", "a|handedness=both", "a|zero=up,", "a|layout="}) {
        const LiveName name = read_live_name(odd);
        EXPECT_EQ(name.shown, odd);
        EXPECT_EQ(name.convention, std::nullopt);
        EXPECT_FALSE(name.problem.empty());
    }
}

TEST(LivePicture, NumbersAreTurnedIntoOursWhateverOrderTheComponentsComeIn) {
    const LivePicture picture(created("a|handedness=left,zero=up", {"S0", "S1", "S2", "S3"}));
    EXPECT_EQ(picture.name(), "a");
    EXPECT_EQ(picture.key(), "a|handedness=left,zero=up");
    const Stokes<double> ours{1.0, -0.5, -0.25, -0.125};
    StokesImage together = picture.blank();
    picture.apply(Update({"S0", "S1", "S2", "S3"}, {1, 1, 0.5, 0.5, 0.25, 0.25, 0.125, 0.125}).message, together);
    EXPECT_EQ(together.at(0, 1), ours);
    StokesImage apart = picture.blank();
    picture.apply(Update({"S3"}, {0.125, 0.125}).message, apart);
    picture.apply(Update({"S1"}, {0.5, 0.5}).message, apart);
    picture.apply(Update({"S2"}, {0.25, 0.25}).message, apart);
    picture.apply(Update({"S0"}, {1, 1}).message, apart);
    EXPECT_EQ(apart.at(0, 1), ours);
}

TEST(LivePicture, AttributesOutrankTheName) {
    const LivePicture picture(created("a|handedness=left", {"S0", "S1", "S2", "S3"}));
    StokesImage image = picture.blank();
    picture.apply(Update({"S3"}, {0.5, 0.25}).message, image);
    EXPECT_EQ(image.at(0, 0).s3, -0.5);
    picture.apply(tev::Attributes{"a", {{"polarisationHandedness", "right"}, {"samples", "16"}}}, image);
    EXPECT_EQ(image.at(0, 0).s3, 0.5) << "also what came before";
    EXPECT_EQ(image.attributes.at("samples"), "16");
    picture.apply(tev::Attributes{"a", {{"polarisationHandedness", "both"}}}, image);
    EXPECT_FALSE(image.origin.convention.left_handed);
}

TEST(LivePicture, AttributesDoNotGrowWithoutEnd) {
    const LivePicture picture(created("a", {"S0", "S1", "S2", "S3"}));
    StokesImage image = picture.blank();
    for (int i = 0; i < 1000; ++i) picture.apply(tev::Attributes{"a", {{std::to_string(i), "x"}}}, image);
    EXPECT_EQ(image.attributes.size(), tev::MessageLimits{}.attributes);
    picture.apply(tev::Attributes{"a", {{"0", "y"}}}, image);
    EXPECT_EQ(image.attributes.at("0"), "y");
}

TEST(LivePicture, NotANumberAndInfinityAreNumbers) {
    const LivePicture picture(created("a", {"S0", "S1", "S2", "S3"}));
    StokesImage image = picture.blank();
    const float inf = std::numeric_limits<float>::infinity();
    picture.apply(Update({"S0", "S1"}, {inf, -inf, std::nanf(""), 1.0F}).message, image);
    EXPECT_EQ(image.at(0, 0).s0, std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(image.at(0, 0).s1));
    EXPECT_EQ(image.at(0, 1).s1, 1.0);
}

TEST(LivePicture, ItsSizeIsKnownBeforeMemoryIsTaken) {
    const LivePicture huge(created("a", {"S0", "S1", "S2", "S3"}, 65536, 32768));
    EXPECT_EQ(huge.bytes(), 65536.0 * 32768.0 * 32.0);
}

}  // namespace
}  // namespace pol
