// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <string>
#include <vector>

#include "core/number_text.h"
#include "io/files/output_file.h"
#include "io/pictures/form_writing.h"
#include "io/pictures/photograph.h"
#include "io/pictures/polarizer_angles.h"

namespace pol {

namespace {

constexpr double most_code = 65535.0;

/// libpng's writer; its longjmp ends in write(), which holds no object that it could skip.
class PngWriter {
public:
    explicit PngWriter(OutputFile& file)
        : file_(file), png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning)) {
        if (png_ != nullptr) info_ = png_create_info_struct(png_);
    }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;
    ~PngWriter() { png_destroy_write_struct(&png_, &info_); }

    /// Rows of big-endian 16-bit numbers.
    bool write(std::uint32_t width, std::uint32_t height, bool in_color, std::string scale,
               std::vector<std::uint8_t>& pixels) {
        scale_ = std::move(scale);
        const std::size_t row_bytes = pixels.size() / height;
        for (std::size_t y = 0; y < height; ++y) rows_.push_back(pixels.data() + y * row_bytes);
        return png_ != nullptr && info_ != nullptr && write_all(width, height, in_color);
    }

private:
    bool write_all(std::uint32_t width, std::uint32_t height, bool in_color) {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp): libpng has no other way
        png_set_write_fn(png_, this, on_write, nullptr);
        png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        png_set_IHDR(png_, info_, width, height, 16, in_color ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY,
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_gAMA(png_, info_, 1.0);
        png_text text{};
        text.compression = PNG_TEXT_COMPRESSION_NONE;
        text.key = const_cast<char*>(scale_keyword);
        text.text = scale_.data();
        text.text_length = scale_.size();
        png_set_text(png_, info_, &text, 1);
        png_write_info(png_, info_);
        png_write_image(png_, rows_.data());
        png_write_end(png_, nullptr);
        return true;
    }
    [[noreturn]] static void on_error(png_structp png, png_const_charp) { png_longjmp(png, 1); }
    static void on_warning(png_structp, png_const_charp) {}
    static void on_write(png_structp png, png_bytep bytes, png_size_t count) {
        auto* self = static_cast<PngWriter*>(png_get_io_ptr(png));
        if (!self->file_.write(bytes, count)) png_error(png, "write failed");
    }

    OutputFile& file_;
    std::string scale_;
    std::vector<png_bytep> rows_;
    png_structp png_;
    png_infop info_ = nullptr;
};

}  // namespace

Result<Done> write_png4(OutgoingPicture& picture, const std::filesystem::path& path) {
    const StokesImage& image = picture.image;
    const auto colors = rgb_bands(image.bands);
    if (image.bands.size() != 1 && !(colors && image.bands.size() == 3))
        return cannot_hold("photographs hold one band, or R, G and B", "npz, fits and spectral hold all bands");
    POL_TRY_DONE(picture.require_linear("png4"));
    const std::size_t channels = image.bands.size();
    constexpr std::array<double, 4> angles{0.0, 45.0, 90.0, 135.0};
    POL_TRY(const AngleFit malus, fit_angles(angles));
    const auto light = [&](std::size_t angle, std::size_t channel, std::size_t pixel) {
        const Stokes<double> s = picture.at(colors ? (*colors)[channel] : channel, pixel);
        return (s.s0 + s.s1 * malus.cosine[angle] + s.s2 * malus.sine[angle]) / 2.0;
    };
    double brightest = 0.0;
    for (std::size_t a = 0; a < angles.size(); ++a)
        for (std::size_t c = 0; c < channels; ++c)
            for (std::size_t p = 0; p < image.pixel_count(); ++p)
                if (const double value = light(a, c, p); std::isfinite(value)) brightest = std::max(brightest, value);
    if (!(brightest > 0.0)) brightest = 1.0;

    std::size_t cut = 0;
    const std::vector<std::filesystem::path> files = files_of_form(image, path, PictureForm::png4);
    for (std::size_t a = 0; a < angles.size(); ++a) {
        std::vector<std::uint8_t> pixels;
        pixels.reserve(image.pixel_count() * channels * 2);
        for (std::size_t p = 0; p < image.pixel_count(); ++p)
            for (std::size_t c = 0; c < channels; ++c) {
                const double value = light(a, c, p);
                if (!(value >= 0.0) || !std::isfinite(value)) ++cut;
                const double kept = std::isnan(value) ? 0.0 : std::clamp(value, 0.0, brightest);
                const auto code = static_cast<unsigned>(std::lround(kept / brightest * most_code));
                pixels.push_back(static_cast<std::uint8_t>(code >> 8U));
                pixels.push_back(static_cast<std::uint8_t>(code & 0xffU));
            }
        POL_TRY(auto file, OutputFile::create(files[a]));
        PngWriter png(*file);
        if (!png.write(static_cast<std::uint32_t>(image.width), static_cast<std::uint32_t>(image.height), channels == 3,
                       number_text(brightest), pixels) &&
            file->good())
            return Error{ErrorKind::output, "cannot be written as PNG", Place{files[a].string()}};
        POL_TRY_DONE(file->commit());
    }
    picture.lost.push_back(
        fmt::format("Numbers are whole multiples of {:.3g}, a 65535th of the brightest.", brightest / most_code));
    if (picture.known().has(3)) picture.lost.emplace_back("S3 is not in photographs behind linear polarizers.");
    if (cut > 0) picture.lost.push_back(fmt::format("{} numbers are negative or not finite, and cut.", cut));
    if (image.bands.front().wavelength_nm)
        picture.lost.push_back(fmt::format("The wavelength, {}, has no place there.", image.bands.front().label()));
    if (picture.options.convention != StokesConvention{})
        picture.lost.emplace_back("The angles are those of the convention asked for, which a PNG does not name.");
    return Done{};
}

}  // namespace pol
