// SPDX-License-Identifier: Apache-2.0
#include "io/scenes/texture_file.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "core/result.h"
#include "io/files/input_file.h"
#include "spectrum/color.h"

namespace pol {
namespace {

constexpr std::uintmax_t max_file_bytes = std::uintmax_t{1} << 30u;
constexpr std::uint64_t max_pixels = std::uint64_t{64} << 20u;
/// zlib never inflates by more than 1032:1; a header that promises more pixels than the file can hold is a lie.
constexpr std::uint64_t max_inflation = 1032;

/// libpng with its error handling by longjmp kept inside: each step returns false after an error, and holds no local
/// object that a jump could skip.
class PngReader {
public:
    explicit PngReader(const std::string& bytes)
        : bytes_(bytes), png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning)) {
        if (png_ != nullptr) info_ = png_create_info_struct(png_);
    }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

    /// Reads up to the pixels; takes no memory that grows with the picture.
    bool read_header() {
        if (png_ == nullptr || info_ == nullptr) return false;
        if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp): libpng has no other way
        png_set_read_fn(png_, this, on_read);
        png_set_user_limits(png_, 1u << 24u, 1u << 24u);
        png_set_chunk_malloc_max(png_, 8u << 20u);
        png_read_info(png_, info_);
        width = png_get_image_width(png_, info_);
        height = png_get_image_height(png_, info_);
        stored_bits = std::uint64_t{png_get_bit_depth(png_, info_)} * png_get_channels(png_, info_);
        if (png_get_valid(png_, info_, PNG_INFO_sRGB) == 0 && png_get_gAMA(png_, info_, &gamma) == 0) gamma = 0.0;
        return true;
    }

    /// Asks for 3 or 4 channels of 8 or 16 bits and makes libpng's rows.
    bool prepare_rows() {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp)
        png_set_expand(png_);
        png_set_gray_to_rgb(png_);
        if (std::endian::native == std::endian::little) png_set_swap(png_);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        channels = png_get_channels(png_, info_);
        bytes_per_sample = png_get_bit_depth(png_, info_) / 8u;
        row_bytes = png_get_rowbytes(png_, info_);
        return true;
    }

    /// Fills `rows`, one pointer to row_bytes bytes per row.
    bool read_rows(png_bytep* rows) {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp)
        png_read_image(png_, rows);
        png_read_end(png_, nullptr);
        return true;
    }

    [[nodiscard]] std::string message() const { return message_.data(); }

    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint64_t stored_bits = 0;  ///< per pixel in the file
    double gamma = 0.0;             ///< of the file's gAMA chunk; 0: sRGB
    std::size_t channels = 0;
    std::size_t bytes_per_sample = 0;
    std::size_t row_bytes = 0;

private:
    [[noreturn]] static void on_error(png_structp png, png_const_charp text) {
        auto* self = static_cast<PngReader*>(png_get_error_ptr(png));
        std::strncpy(self->message_.data(), text, self->message_.size() - 1);
        png_longjmp(png, 1);
    }
    static void on_warning(png_structp, png_const_charp) {}
    static void on_read(png_structp png, png_bytep target, png_size_t count) {
        auto* self = static_cast<PngReader*>(png_get_io_ptr(png));
        if (count > self->bytes_.size() - self->position_) png_error(png, "the file ends too early");
        std::memcpy(target, self->bytes_.data() + self->position_, count);
        self->position_ += count;
    }

    const std::string& bytes_;
    std::size_t position_ = 0;
    std::array<char, 200> message_{};
    png_structp png_;
    png_infop info_ = nullptr;
};

/// Linear value of every sample code.
std::vector<double> decoding_table(std::size_t bytes_per_sample, double gamma) {
    const std::size_t codes = bytes_per_sample == 2 ? 65536 : 256;
    // 0.45455 is how writers say "sRGB, roughly".
    const bool is_srgb = gamma == 0.0 || std::abs(gamma - 0.45455) < 0.001;
    std::vector<double> table;
    for (std::size_t code = 0; code < codes; ++code) {
        const double encoded = static_cast<double>(code) / static_cast<double>(codes - 1);
        table.push_back(is_srgb ? srgb_decode(encoded) : std::pow(encoded, 1.0 / gamma));
    }
    return table;
}

std::size_t sample_at(const std::uint8_t* row, std::size_t index, std::size_t bytes_per_sample) {
    if (bytes_per_sample == 1) return row[index];
    std::uint16_t value = 0;
    std::memcpy(&value, row + 2 * index, 2);
    return value;
}

/// The stored precision of textures.
float to_texel(double value) {
    return static_cast<float>(value);
}

std::vector<float> decode(const PngReader& png, const std::vector<std::uint8_t>& pixels) {
    const std::vector<double> linear = decoding_table(png.bytes_per_sample, png.gamma);
    const double opaque = static_cast<double>(linear.size() - 1);
    std::vector<float> rgb;
    rgb.reserve(std::size_t{3} * png.width * png.height);
    for (std::size_t y = 0; y < png.height; ++y) {
        const std::uint8_t* row = pixels.data() + y * png.row_bytes;
        for (std::size_t x = 0; x < png.width; ++x) {
            const std::size_t first = x * png.channels;
            const double alpha =
                png.channels == 4 ? static_cast<double>(sample_at(row, first + 3, png.bytes_per_sample)) / opaque : 1.0;
            for (std::size_t c = 0; c < 3; ++c) {
                rgb.push_back(to_texel(alpha * linear[sample_at(row, first + c, png.bytes_per_sample)]));
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
    POL_TRY(const auto bytes, read_input_file(path, max_file_bytes));
    const std::string& file = bytes;
    if (png_sig_cmp(reinterpret_cast<png_const_bytep>(file.data()), 0, std::min<std::size_t>(file.size(), 8)) != 0 ||
        file.size() < 8) {
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
    if (pixel_count * png.stored_bits / 8 > file.size() * max_inflation) {
        return error("promises more pixels than the file can hold", "export the texture again");
    }

    if (!png.prepare_rows()) return error("is a damaged PNG: " + png.message(), "export the texture again");
    std::vector<std::uint8_t> pixels(png.row_bytes * png.height);
    std::vector<png_bytep> rows;
    for (std::size_t y = 0; y < png.height; ++y) rows.push_back(pixels.data() + y * png.row_bytes);
    if (!png.read_rows(rows.data())) return error("is a damaged PNG: " + png.message(), "export the texture again");
    return RgbImage{static_cast<int>(png.width), static_cast<int>(png.height), decode(png, pixels)};
}

}  // namespace pol
