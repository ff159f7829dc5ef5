// SPDX-License-Identifier: Apache-2.0
#include "io/files/png_reader.h"

#include <png.h>

#include <array>
#include <bit>
#include <csetjmp>
#include <cstring>

#include "core/contract.h"

namespace pol {

bool is_png(std::string_view bytes) {
    return bytes.size() >= 8 && png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) == 0;
}

/// libpng with its error handling by longjmp kept inside the steps, which hold no local object that a jump could skip.
struct PngReader::Library {
    explicit Library(std::string_view all)
        : bytes(all), png(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning)) {
        if (png != nullptr) info = png_create_info_struct(png);
    }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
    ~Library() { png_destroy_read_struct(&png, &info, nullptr); }

    [[noreturn]] static void on_error(png_structp png, png_const_charp text) {
        auto* self = static_cast<Library*>(png_get_error_ptr(png));
        std::strncpy(self->message.data(), text, self->message.size() - 1);
        png_longjmp(png, 1);
    }
    static void on_warning(png_structp, png_const_charp) {}
    static void on_read(png_structp png, png_bytep target, png_size_t count) {
        auto* self = static_cast<Library*>(png_get_io_ptr(png));
        if (count > self->bytes.size() - self->position) png_error(png, "the file ends too early");
        std::memcpy(target, self->bytes.data() + self->position, count);
        self->position += count;
    }

    std::string_view bytes;
    std::size_t position = 0;
    std::array<char, 200> message{};
    std::vector<png_bytep> rows;
    png_structp png;
    png_infop info = nullptr;
};

PngReader::PngReader(std::string_view bytes) : library_(std::make_unique<Library>(bytes)) {}
PngReader::~PngReader() = default;

bool PngReader::read_header() {
    png_structp png = library_->png;
    png_infop info = library_->info;
    if (png == nullptr || info == nullptr) return false;
    if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp): libpng has no other way
    png_set_read_fn(png, library_.get(), Library::on_read);
    png_set_user_limits(png, 1u << 24u, 1u << 24u);
    png_set_chunk_malloc_max(png, 8u << 20u);
    png_read_info(png, info);
    width = png_get_image_width(png, info);
    height = png_get_image_height(png, info);
    stored_bits = std::uint64_t{png_get_bit_depth(png, info)} * png_get_channels(png, info);
    says_srgb = png_get_valid(png, info, PNG_INFO_sRGB) != 0;
    if (!says_srgb && png_get_gAMA(png, info, &gamma) == 0) gamma = 0.0;
    return true;
}

bool PngReader::promises_too_much() const {
    constexpr std::uint64_t max_inflation = 1032;
    return std::uint64_t{width} * height * stored_bits / 8 > library_->bytes.size() * max_inflation;
}

bool PngReader::prepare_rows(Color color) {
    png_structp png = library_->png;
    png_infop info = library_->info;
    if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp)
    png_set_expand(png);
    if (color == Color::rgb) png_set_gray_to_rgb(png);
    if (std::endian::native == std::endian::little) png_set_swap(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    channels = png_get_channels(png, info);
    bytes_per_sample = png_get_bit_depth(png, info) / 8u;
    row_bytes = png_get_rowbytes(png, info);
    return true;
}

bool PngReader::read_rows(std::vector<std::uint8_t>& pixels) {
    POL_EXPECTS(pixels.size() == row_bytes * height);
    for (std::size_t y = 0; y < height; ++y) library_->rows.push_back(pixels.data() + y * row_bytes);
    if (setjmp(png_jmpbuf(library_->png)) != 0) return false;  // NOLINT(cert-err52-cpp)
    png_read_image(library_->png, library_->rows.data());
    png_read_end(library_->png, nullptr);
    return true;
}

std::size_t PngReader::sample(const std::uint8_t* row, std::size_t index) const {
    if (bytes_per_sample == 1) return row[index];
    std::uint16_t value = 0;
    std::memcpy(&value, row + 2 * index, 2);
    return value;
}

std::optional<std::string> PngReader::text(std::string_view keyword) const {
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(library_->png, library_->info, &texts, &count);
    for (int i = 0; i < count; ++i)
        if (keyword == texts[i].key && texts[i].text != nullptr) return std::string(texts[i].text);
    return std::nullopt;
}

std::string PngReader::message() const {
    return library_->message.data();
}

}  // namespace pol
