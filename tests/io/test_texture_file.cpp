// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <vector>

#include "io/scenes/texture_file.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

class TemporaryFolder {
public:
    TemporaryFolder() {
        std::random_device device;
        path_ = fs::temp_directory_path() / ("polariscope_texture_" + std::to_string(device()));
        fs::create_directories(path_);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() { fs::remove_all(path_); }
    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

struct PngRecipe {
    std::uint32_t width;
    std::uint32_t height;
    int bits;
    int color_type;
    std::vector<std::uint16_t> samples;  ///< one per channel, row by row
    bool interlaced = false;
    double gamma = 0.0;
};

/// Writes with libpng's low-level interface; tests only, so an error of libpng ends the test program.
void write_png(const fs::path& path, const PngRecipe& recipe) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    ASSERT_NE(file, nullptr);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, recipe.width, recipe.height, recipe.bits, recipe.color_type,
                 recipe.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (recipe.color_type == PNG_COLOR_TYPE_PALETTE) {
        const png_color palette[] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255}};
        png_set_PLTE(png, info, palette, 4);
    }
    if (recipe.gamma > 0.0) png_set_gAMA(png, info, recipe.gamma);
    png_write_info(png, info);
    if (recipe.bits < 8) png_set_packing(png);
    const std::size_t row_samples = recipe.samples.size() / recipe.height;
    std::vector<std::vector<std::uint8_t>> rows(recipe.height);
    std::vector<png_bytep> pointers;
    for (std::size_t y = 0; y < recipe.height; ++y) {
        for (std::size_t i = 0; i < row_samples; ++i) {
            const std::uint16_t sample = recipe.samples[y * row_samples + i];
            if (recipe.bits == 16) rows[y].push_back(static_cast<std::uint8_t>(sample >> 8u));
            rows[y].push_back(static_cast<std::uint8_t>(sample & 0xffu));
        }
        pointers.push_back(rows[y].data());
    }
    png_write_image(png, pointers.data());
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
}

RgbImage load(const PngRecipe& recipe) {
    const TemporaryFolder folder;
    write_png(folder.path() / "t.png", recipe);
    const Result<RgbImage> image = load_texture(folder.path() / "t.png");
    EXPECT_TRUE(image) << to_string(image.error());
    return image.value();
}

/// IEC 61966-2-1.
double srgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

// Texels are floats: 2^-24 relative.
void expect_texel(const RgbImage& image, std::size_t pixel, double r, double g, double b) {
    const double expected[] = {r, g, b};
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(image.rgb[3 * pixel + c], expected[c], 6e-8 * expected[c]) << pixel << " " << c;
}

TEST(Texture, EightBitColorsAreDecodedFromSrgbRowZeroOnTop) {
    const RgbImage image = load({2, 2, 8, PNG_COLOR_TYPE_RGB, {255, 0, 1, 10, 11, 12, 128, 64, 32, 200, 201, 202}});
    ASSERT_EQ(image.width, 2);
    ASSERT_EQ(image.height, 2);
    ASSERT_EQ(image.rgb.size(), 12u);
    expect_texel(image, 0, 1.0, 0.0, srgb(1 / 255.0));
    expect_texel(image, 1, srgb(10 / 255.0), srgb(11 / 255.0), srgb(12 / 255.0));
    expect_texel(image, 2, srgb(128 / 255.0), srgb(64 / 255.0), srgb(32 / 255.0));
    expect_texel(image, 3, srgb(200 / 255.0), srgb(201 / 255.0), srgb(202 / 255.0));
}

TEST(Texture, SixteenBitsKeepTheirPrecision) {
    const RgbImage image = load({1, 1, 16, PNG_COLOR_TYPE_RGB, {257, 1000, 65535}});
    expect_texel(image, 0, srgb(257 / 65535.0), srgb(1000 / 65535.0), 1.0);
}

TEST(Texture, GraysAndPalettesBecomeColors) {
    const RgbImage gray = load({4, 1, 2, PNG_COLOR_TYPE_GRAY, {0, 1, 2, 3}});
    for (std::size_t i = 0; i < 4; ++i) {
        const double value = srgb(static_cast<double>(i) / 3.0);
        expect_texel(gray, i, value, value, value);
    }
    const RgbImage palette = load({4, 1, 2, PNG_COLOR_TYPE_PALETTE, {2, 1, 0, 3}});
    expect_texel(palette, 0, 0.0, 0.0, 1.0);
    expect_texel(palette, 1, 0.0, 1.0, 0.0);
    expect_texel(palette, 2, 1.0, 0.0, 0.0);
    expect_texel(palette, 3, 1.0, 1.0, 1.0);
}

TEST(Texture, TransparentPartsEmitLess) {
    const RgbImage image = load({2, 1, 8, PNG_COLOR_TYPE_RGBA, {255, 128, 0, 0, 255, 128, 0, 51}});
    expect_texel(image, 0, 0.0, 0.0, 0.0);
    expect_texel(image, 1, 0.2, 0.2 * srgb(128 / 255.0), 0.0);
}

TEST(Texture, ADeclaredGammaIsApplied) {
    expect_texel(load({1, 1, 8, PNG_COLOR_TYPE_RGB, {51, 102, 255}, false, 1.0}), 0, 0.2, 0.4, 1.0);
    expect_texel(load({1, 1, 8, PNG_COLOR_TYPE_RGB, {51, 102, 255}, false, 0.5}), 0, 0.04, 0.16, 1.0);
    expect_texel(load({1, 1, 8, PNG_COLOR_TYPE_RGB, {51, 102, 255}, false, 0.45455}), 0, srgb(0.2), srgb(0.4), 1.0);
}

TEST(Texture, InterlacingChangesNothing) {
    PngRecipe recipe{9, 7, 8, PNG_COLOR_TYPE_RGB, {}};
    for (std::uint16_t i = 0; i < 9 * 7 * 3; ++i) recipe.samples.push_back(i);
    const RgbImage plain = load(recipe);
    recipe.interlaced = true;
    EXPECT_EQ(load(recipe).rgb, plain.rgb);
}

TEST(Texture, WhatIsNoPngIsAnErrorThatNamesTheFile) {
    const TemporaryFolder folder;
    const auto complaint = [&](const std::string& content) {
        const fs::path file = folder.path() / "bad.png";
        std::ofstream(file, std::ios::binary) << content;
        const Result<RgbImage> image = load_texture(file);
        EXPECT_FALSE(image);
        EXPECT_EQ(image.error().place.file, file.string());
        EXPECT_EQ(image.error().kind, ErrorKind::input);
        EXPECT_FALSE(image.error().hint.empty());
        return image.error().what;
    };
    EXPECT_EQ(complaint(""), "is not a PNG picture");
    EXPECT_EQ(complaint("\x89PNG"), "is not a PNG picture");
    EXPECT_EQ(complaint("\xff\xd8\xff\xe0 JFIF and so on"), "is not a PNG picture");
    EXPECT_EQ(complaint("\x89PNG\r\n\x1a\n"), "is a damaged PNG: the file ends too early");
    EXPECT_EQ(load_texture(folder.path()).error().what, "is a folder");
    EXPECT_EQ(load_texture(folder.path() / "none.png").error().what, "there is no such file");
}

std::string png_bytes(const PngRecipe& recipe) {
    const TemporaryFolder folder;
    write_png(folder.path() / "t.png", recipe);
    std::ifstream stream(folder.path() / "t.png", std::ios::binary);
    std::stringstream buffer;
    buffer << stream.rdbuf();
    return buffer.str();
}

/// The PNG with other dimensions in its header and the checksum put right (CRC-32 of ISO 3309, bit by bit).
std::string with_size(std::string png, std::uint32_t width, std::uint32_t height) {
    const auto put = [&](std::size_t at, std::uint32_t value) {
        for (std::size_t i = 0; i < 4; ++i) png[at + i] = static_cast<char>((value >> (24u - 8u * i)) & 0xffu);
    };
    put(16, width);
    put(20, height);
    std::uint32_t crc = 0xffffffffu;
    for (std::size_t i = 12; i < 29; ++i) {
        crc ^= static_cast<std::uint8_t>(png[i]);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1u) ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
    }
    put(29, ~crc);
    return png;
}

TEST(Texture, AHeaderThatPromisesTooMuchIsRefusedBeforeMemoryIsTaken) {
    const TemporaryFolder folder;
    const std::string small = png_bytes({2, 2, 8, PNG_COLOR_TYPE_RGB, std::vector<std::uint16_t>(12, 7)});
    const auto complaint = [&](std::uint32_t width, std::uint32_t height) {
        const fs::path file = folder.path() / "big.png";
        std::ofstream(file, std::ios::binary) << with_size(small, width, height);
        const Result<RgbImage> image = load_texture(file);
        EXPECT_FALSE(image);
        return image.error().what;
    };
    EXPECT_EQ(complaint(8000, 8000), "promises more pixels than the file can hold");
    EXPECT_EQ(complaint(10000, 10000), "has 10000 x 10000 pixels, more than 64 Mi");
    EXPECT_EQ(complaint(2, 3).substr(0, 17), "is a damaged PNG:");
    EXPECT_EQ(complaint(0x7fffffff, 0x7fffffff).substr(0, 17), "is a damaged PNG:");
    EXPECT_EQ(complaint(0, 2).substr(0, 17), "is a damaged PNG:");
}

TEST(Texture, SurvivesRandomDamage) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "t.png";
    std::mt19937 random(11);
    const auto pick = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    PngRecipe recipe{16, 16, 8, PNG_COLOR_TYPE_RGB, {}, true, 0.5};
    for (int i = 0; i < 768; ++i) recipe.samples.push_back(static_cast<std::uint16_t>(pick(256)));
    const std::string original = png_bytes(recipe);
    int refused = 0;
    for (int i = 0; i < 800; ++i) {
        std::string bytes = original;
        for (std::size_t edits = 1 + pick(3); edits > 0; --edits) {
            const std::size_t at = 8 + pick(bytes.size() - 8);
            if (pick(8) == 0) {
                bytes.resize(at + 1);
            } else {
                bytes[at] = static_cast<char>(random());
            }
        }
        // A header of random size reaches the decoder only with a sound checksum.
        if (pick(3) == 0)
            bytes = with_size(original, static_cast<std::uint32_t>(pick(40)), static_cast<std::uint32_t>(pick(40)));
        std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
        const Result<RgbImage> image = load_texture(file);
        if (!image) {
            ++refused;
        } else {
            EXPECT_EQ(image.value().rgb.size(), 3 * static_cast<std::size_t>(image.value().width) *
                                                    static_cast<std::size_t>(image.value().height));
        }
    }
    EXPECT_GT(refused, 400);
}

}  // namespace
}  // namespace pol
