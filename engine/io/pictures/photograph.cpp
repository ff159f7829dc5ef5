// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/photograph.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "io/files/input_file.h"
#include "io/files/png_reader.h"
#include "io/pictures/array_layout.h"
#include "io/pictures/picture_reading.h"

namespace pol {

namespace {

constexpr std::uintmax_t max_file_bytes = std::uintmax_t{4} << 30U;

std::optional<double> positive_number(std::string_view text) {
    double number = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (status != std::errc() || end != text.data() + text.size() || !(number > 0.0) || !std::isfinite(number))
        return std::nullopt;
    return number;
}

}  // namespace

std::vector<Band> Photograph::bands(StokesComponents known) const {
    if (channels == 1) return {named_band("mono", known)};
    return {named_band("R", known), named_band("G", known), named_band("B", known)};
}

Result<Photograph> read_photograph(const std::filesystem::path& path, bool with_pixels) {
    const auto damaged = [&path](const PngReader& png) {
        return input_error("is a damaged PNG: " + png.message(), "copy or save it again", path);
    };
    POL_TRY(const auto bytes, read_input_file(path, max_file_bytes));
    if (!is_png(bytes))
        return input_error("is not a PNG picture", "polarization cameras' pictures are read as PNG", path);
    PngReader png(bytes);
    if (!png.read_header()) return damaged(png);
    if (png.promises_too_much())
        return input_error("promises more pixels than the file can hold", "copy or save it again", path);
    if (auto size = check_picture_size(png.width, png.height, 3); !size) {
        Error error = size.error();
        error.place.file = path.string();
        return error;
    }
    if (!png.prepare_rows(PngReader::Color::as_stored)) return damaged(png);

    Photograph photo;
    photo.width = static_cast<int>(png.width);
    photo.height = static_cast<int>(png.height);
    photo.channels = png.channels < 3 ? 1 : 3;
    photo.has_alpha = png.channels % 2 == 0;
    photo.most = png.bytes_per_sample == 2 ? 65535 : 255;
    // gAMA has five decimals.
    photo.says_linear = !png.says_srgb && std::abs(png.gamma - 1.0) < 1e-5;
    photo.says_encoded = png.says_srgb || (png.gamma != 0.0 && !photo.says_linear);
    photo.gamma = png.gamma;
    if (const auto scale = png.text(scale_keyword)) photo.scale = positive_number(*scale);
    if (!with_pixels) return photo;

    std::vector<std::uint8_t> rows(png.row_bytes * png.height);
    if (!png.read_rows(rows)) return damaged(png);
    photo.codes.reserve(photo.channels * png.width * png.height);
    for (std::size_t y = 0; y < png.height; ++y)
        for (std::size_t x = 0; x < png.width; ++x)
            for (std::size_t c = 0; c < photo.channels; ++c)
                photo.codes.push_back(
                    static_cast<std::uint16_t>(png.sample(rows.data() + y * png.row_bytes, x * png.channels + c)));
    return photo;
}

std::uint32_t common_power_of_two(const std::vector<std::uint16_t>& codes) {
    std::uint16_t all = 0;
    for (const std::uint16_t code : codes) all = static_cast<std::uint16_t>(all | code);
    return all == 0 ? 1U : 1U << static_cast<unsigned>(std::countr_zero(all));
}

}  // namespace pol
