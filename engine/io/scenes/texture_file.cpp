// SPDX-License-Identifier: Apache-2.0
#include "io/scenes/texture_file.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/result.h"
#include "io/files/input_file.h"
#include "io/files/png_reader.h"
#include "spectrum/color.h"

namespace pol {
namespace {

constexpr std::uintmax_t max_texture_file_bytes = std::uintmax_t{1} << 30u;
constexpr std::uint64_t max_pixels = std::uint64_t{64} << 20u;

/// The stored precision of textures.
float to_texel(double value) {
    return static_cast<float>(value);
}

std::vector<float> decode(const PngReader& png, const std::vector<std::uint8_t>& pixels) {
    const std::vector<double> linear = decoding_table(png.bytes_per_sample == 2 ? 65535 : 255, png.gamma);
    const double opaque = static_cast<double>(linear.size() - 1);
    std::vector<float> rgb;
    rgb.reserve(std::size_t{3} * png.width * png.height);
    for (std::size_t y = 0; y < png.height; ++y) {
        const std::uint8_t* row = pixels.data() + y * png.row_bytes;
        for (std::size_t x = 0; x < png.width; ++x) {
            const std::size_t first = x * png.channels;
            const double alpha = png.channels == 4 ? static_cast<double>(png.sample(row, first + 3)) / opaque : 1.0;
            for (std::size_t c = 0; c < 3; ++c) {
                rgb.push_back(to_texel(alpha * linear[png.sample(row, first + c)]));
            }
        }
    }
    return rgb;
}

}  // namespace

Result<RgbImage> load_texture(const std::filesystem::path& path) {
    const auto error = [&](std::string what, std::string hint) {
        return Error{ErrorKind::input, std::move(what), {path.string(), 0, 0}, {}, std::move(hint)};
    };
    POL_TRY(const auto bytes, read_input_file(path, max_texture_file_bytes));
    const std::string& file = bytes;
    if (!is_png(file)) {
        return error("is not a PNG picture", "convert the texture to PNG, 8 or 16 bits");
    }

    PngReader png(file);
    if (!png.read_header()) return error("is a damaged PNG: " + png.message(), "export the texture again");
    const std::uint64_t pixel_count = std::uint64_t{png.width} * png.height;
    if (pixel_count > max_pixels) {
        return error(
            "has " + std::to_string(png.width) + " x " + std::to_string(png.height) + " pixels, more than 64 Mi",
            "scale the texture down");
    }
    if (png.promises_too_much()) {
        return error("promises more pixels than the file can hold", "export the texture again");
    }

    if (!png.prepare_rows(PngReader::Color::rgb))
        return error("is a damaged PNG: " + png.message(), "export the texture again");
    std::vector<std::uint8_t> pixels(png.row_bytes * png.height);
    if (!png.read_rows(pixels)) return error("is a damaged PNG: " + png.message(), "export the texture again");
    return RgbImage{static_cast<int>(png.width), static_cast<int>(png.height), decode(png, pixels)};
}

}  // namespace pol
