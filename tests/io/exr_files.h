// SPDX-License-Identifier: Apache-2.0
// What the tests of EXR files share.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "io/pictures/exr_file.h"

namespace pol {

namespace fs = std::filesystem;

/// An empty folder of its own for each test.
class ExrFile : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("polariscope-exr-" + std::to_string(::getpid()));
        fs::remove_all(folder_);
        fs::create_directory(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] fs::path path(const std::string& name = "picture.exr") const { return folder_ / name; }
    [[nodiscard]] std::size_t file_count() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    fs::path folder_;
};

/// Different numbers everywhere, all of them floats.
inline StokesImage sample_image(int width, int height, std::vector<double> wavelengths_nm) {
    StokesImage image;
    image.width = width;
    image.height = height;
    image.bands = bands_at(wavelengths_nm);
    const std::size_t count = image.pixel_count() * image.bands.size();
    for (std::size_t i = 0; i < count; ++i) {
        const double base = 1.0 + static_cast<double>(i);
        image.stokes.push_back({base, base / 2.0, -base / 4.0, base / 8.0});
        image.residual.push_back(std::ldexp(base, -20));
        image.sampling_error.push_back({base / 16.0, base / 32.0, base / 64.0, base / 128.0});
    }
    for (std::size_t i = 0; i < image.pixel_count(); ++i) {
        image.tail.push_back(std::ldexp(static_cast<double>(i), -30));
        image.samples.push_back(static_cast<std::uint32_t>(i) + 4000000000U);
        image.failures.push_back(static_cast<std::uint32_t>(i % 2));
    }
    image.brightest.assign(image.bands.size(), 0.1);
    image.attributes["scene_hash"] = "0123456789abcdef";
    return image;
}

}  // namespace pol
