// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "io/files/output_file.h"
#include "io/pictures/form_writing.h"
#include "io/pictures/npy_format.h"
#include "io/pictures/npz_format.h"
#include "io/pictures/zip_archive.h"

namespace pol {

namespace {

/// Numbers on their way to a file, as little-endian doubles.
template <class Sink>
class DoubleWriter {
public:
    explicit DoubleWriter(Sink& sink) : sink_(sink) {}
    void write(double number) {
        const auto bits = std::bit_cast<std::uint64_t>(number);
        for (unsigned i = 0; i < 8; ++i) buffer_.push_back(static_cast<char>(bits >> 8U * i & 0xffU));
        constexpr std::size_t enough = 1U << 16U;
        if (buffer_.size() >= enough) flush();
    }
    void flush() {
        sink_.write(buffer_.data(), buffer_.size());
        buffer_.clear();
    }

private:
    Sink& sink_;
    std::vector<char> buffer_;
};

/// (n, H, W, 4), or 3 without S3; with `out`, each vector as it gives it.
template <class Sink, class Out>
void write_vectors(Sink& sink, const StokesImage& image, std::size_t length, Out out) {
    const std::string header = npy_header("<f8", {image.bands.size(), static_cast<std::uint64_t>(image.height),
                                                  static_cast<std::uint64_t>(image.width), length});
    sink.write(header.data(), header.size());
    DoubleWriter<Sink> numbers(sink);
    for (std::size_t b = 0; b < image.bands.size(); ++b)
        for (std::size_t p = 0; p < image.pixel_count(); ++p) {
            const Stokes<double> s = out(b, p);
            for (std::size_t i = 0; i < length; ++i) numbers.write(s.*stokes_components[i]);
        }
    numbers.flush();
}

std::size_t length_of(const OutgoingPicture& picture) {
    return picture.known().has(3) ? 4 : 3;
}

void write_numbers(ZipWriter& zip, std::string_view key, const ArrayShape& shape, const std::vector<double>& all) {
    zip.begin_entry(std::string(key) + ".npy");
    const std::string header = npy_header("<f8", shape);
    zip.write(header.data(), header.size());
    DoubleWriter<ZipWriter> numbers(zip);
    for (const double number : all) numbers.write(number);
    numbers.flush();
    zip.end_entry();
}

/// The code points of a text in UTF-8; what is none stands for itself.
std::vector<std::uint32_t> characters(std::string_view text) {
    std::vector<std::uint32_t> codes;
    for (std::size_t i = 0; i < text.size();) {
        const auto first = static_cast<unsigned char>(text[i]);
        const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
        std::uint32_t code = length == 1 ? first : first & (0x7fU >> length);
        for (std::size_t k = 1; k < length && i + k < text.size(); ++k)
            code = code << 6U | (static_cast<unsigned char>(text[i + k]) & 0x3fU);
        codes.push_back(code);
        i += length;
    }
    return codes;
}

/// An array of '<U': 32-bit code points, padded with 0 to the longest. `is_list`: of one axis, else of none.
void write_texts(ZipWriter& zip, std::string_view key, const std::vector<std::string>& texts, bool is_list) {
    std::size_t longest = 1;
    for (const std::string& text : texts) longest = std::max(longest, characters(text).size());
    std::string bytes = npy_header(fmt::format("<U{}", longest), is_list ? ArrayShape{texts.size()} : ArrayShape{});
    for (const std::string& text : texts) {
        std::vector<std::uint32_t> codes = characters(text);
        codes.resize(longest);
        for (const std::uint32_t code : codes)
            for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(code >> 8U * i & 0xffU);
    }
    zip.begin_entry(std::string(key) + ".npy");
    zip.write(bytes.data(), bytes.size());
    zip.end_entry();
}

}  // namespace

Result<Done> write_npy(OutgoingPicture& picture, const std::filesystem::path& path) {
    POL_TRY_DONE(picture.require_linear("npy"));
    const StokesImage& image = picture.image;
    POL_TRY(auto file, OutputFile::create(path));
    write_vectors(*file, image, length_of(picture), [&](std::size_t b, std::size_t p) { return picture.at(b, p); });
    picture.lost.emplace_back(
        "An array has no names: wavelengths, bands and the convention are not in it (npz has them).");
    if (image.width == 3 || image.width == 4 || length_of(picture) == 3)
        picture.lost.emplace_back("Its shape can be taken for another: read it with --layout nhwc.");
    return file->commit();
}

Result<Done> write_npz(OutgoingPicture& picture, const std::filesystem::path& path) {
    POL_TRY_DONE(picture.require_linear("npz"));
    const StokesImage& image = picture.image;
    const std::size_t length = length_of(picture);
    POL_TRY(auto file, OutputFile::create(path));
    ZipWriter zip(*file);
    zip.begin_entry(std::string(npz::stokes) + ".npy");
    write_vectors(zip, image, length, [&](std::size_t b, std::size_t p) { return picture.at(b, p); });
    zip.end_entry();

    std::vector<double> wavelengths;
    std::vector<std::string> names;
    bool any_wavelength = false;
    for (const Band& band : image.bands) {
        wavelengths.push_back(band.wavelength_nm.value_or(std::nan("")));
        any_wavelength |= band.wavelength_nm.has_value();
        names.push_back(band.label());
    }
    if (any_wavelength) write_numbers(zip, npz::wavelengths, {image.bands.size()}, wavelengths);
    write_texts(zip, npz::bands, names, true);
    const auto height = static_cast<std::uint64_t>(image.height);
    const auto width = static_cast<std::uint64_t>(image.width);
    for (const auto& [key, planes] : {std::pair{npz::residual, &image.residual}, std::pair{npz::tail, &image.tail}}) {
        if (planes->empty()) continue;
        const bool shared = planes->size() == image.pixel_count();
        write_numbers(zip, key, shared ? ArrayShape{height, width} : ArrayShape{image.bands.size(), height, width},
                      *planes);
    }
    if (!image.sampling_error.empty()) {
        // Standard errors have no sign, and no convention that is written mixes S1 with S2.
        zip.begin_entry(std::string(npz::sampling_error) + ".npy");
        write_vectors(zip, image, length,
                      [&](std::size_t b, std::size_t p) { return image.sampling_error[b * image.pixel_count() + p]; });
        zip.end_entry();
    }
    write_texts(zip, npz::convention, {picture.options.convention.text()}, false);
    zip.finish();
    return file->commit();
}

}  // namespace pol
