// SPDX-License-Identifier: Apache-2.0
// The file that `polariscope render` writes against what `polariscope explain` says of its pixels.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "io/pictures/exr_file.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

/// What the program prints; fails the test unless it exits with 0.
std::string run_program(const std::string& arguments) {
    const std::string command = std::string("'") + POL_PROGRAM + "' " + arguments;
    std::FILE* pipe = ::popen(command.c_str(), "r");
    std::string text;
    std::array<char, 4096> buffer{};
    for (std::size_t n = 1; n > 0;) {
        n = std::fread(buffer.data(), 1, buffer.size(), pipe);
        text.append(buffer.data(), n);
    }
    EXPECT_EQ(::pclose(pipe), 0) << command;
    return text;
}

class ExrOfRender : public testing::TestWithParam<const char*> {
protected:
    ExrOfRender() : exr_(fs::temp_directory_path() / ("polariscope-cli-" + std::to_string(::getpid()) + ".exr")) {}
    ~ExrOfRender() override { fs::remove(exr_); }

    /// Renders the scene of the parameter, 24x16 pixels at 450 and 580 nm.
    StokesImage picture() {
        run_program("render " + scene_ + " -o '" + exr_.string() + "' --quiet");
        auto image = read_exr(exr_);
        EXPECT_TRUE(image) << to_string(image.error());
        return std::move(image).value();
    }

    std::string scene_ = std::string("'") + POL_ASSETS + "/scenes/" + GetParam() +
                         ".yaml' --size 24x16 --wavelengths 450,580 --node-budget 200";
    fs::path exr_;
};

TEST_P(ExrOfRender, HoldsTheExplainedStokesVectorsRoundedToFloat) {
    const StokesImage image = picture();
    ASSERT_EQ(image.width, 24);
    ASSERT_EQ(image.height, 16);
    ASSERT_EQ(wavelengths_of(image.bands), (std::vector<double>{450.0, 580.0}));
    for (const auto& [x, y] : {std::array{0, 0}, std::array{12, 8}, std::array{15, 5}, std::array{23, 15}}) {
        for (std::size_t w = 0; w < 2; ++w) {
            const std::string nm = w == 0 ? "450" : "580";
            const auto tree =
                nlohmann::json::parse(run_program("explain " + scene_ + " --json --wavelength " + nm + " --pixel " +
                                                  std::to_string(x) + "," + std::to_string(y)));
            const std::size_t pixel = static_cast<std::size_t>(y) * 24U + static_cast<std::size_t>(x);
            const Stokes<double>& s = image.at(w, pixel);
            const std::array<double, 4> stored{s.s0, s.s1, s.s2, s.s3};
            for (std::size_t i = 0; i < stored.size(); ++i)
                EXPECT_EQ(static_cast<float>(tree["stokes"][i].get<double>()), static_cast<float>(stored[i]));
            // One plane serves all wavelengths where one tree does.
            const std::size_t plane = image.residual.size() == image.pixel_count() ? 0 : w;
            const double residual = image.residual[plane * image.pixel_count() + pixel];
            EXPECT_EQ(static_cast<float>(tree["residual"].get<double>()), static_cast<float>(residual));
        }
    }
}

TEST_P(ExrOfRender, IsPhysicalAtEveryPixelAndSaysWhatItIs) {
    const StokesImage image = picture();
    double brightest = 0.0;
    for (const Stokes<double>& s : image.stokes) {
        ASSERT_TRUE(std::isfinite(s.s0) && std::isfinite(s.s1) && std::isfinite(s.s2) && std::isfinite(s.s3));
        // Four components rounded to float, each by at most 2^-24 of S0.
        const double p = std::hypot(s.s1, s.s2, s.s3);
        ASSERT_LE(p, s.s0 * (1.0 + 3.0 * 0x1p-24)) << s.s0;
        brightest = std::max(brightest, s.s0);
    }
    EXPECT_GT(brightest, 0.0);
    for (const std::uint32_t n : image.samples) ASSERT_EQ(n, 1U);
    EXPECT_EQ(image.attributes.at("scene"), std::string(GetParam()) + ".yaml");
    EXPECT_FALSE(image.attributes.at("scene_hash").empty());
    EXPECT_NE(image.attributes.at("settings").find("node_budget=200"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Shipped, ExrOfRender,
                         testing::Values("cube-glass", "cube-calcite", "crossed-polarizers", "metal-spheres"),
                         [](const auto& about) {
                             std::string name = about.param;
                             std::erase(name, '-');
                             return name;
                         });

}  // namespace
}  // namespace pol
