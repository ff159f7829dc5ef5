// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/png_file.h"

#include <fmt/format.h>
#include <png.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "core/contract.h"
#include "core/result.h"
#include "io/files/output_file.h"

namespace pol {
namespace {

static_assert(sizeof(Rgb8) == 3, "libpng reads the pixels as packed triples");

}  // namespace

std::vector<std::uint8_t> png_bytes(const RgbPicture& picture) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = PNG_FORMAT_RGB;
    // A bound that libpng states, so that the picture is compressed only once.
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::vector<std::uint8_t> bytes(size);
    if (png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.pixels.data(), 0, nullptr) == 0) return {};
    bytes.resize(size);
    return bytes;
}

Result<Done> write_png(const RgbPicture& picture, const std::filesystem::path& path) {
    if (picture.width <= 0 || picture.height <= 0) {
        return Error{ErrorKind::usage, "a picture without pixels cannot be written", Place{path.string()}};
    }
    POL_EXPECTS(picture.pixels.size() ==
                static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    POL_TRY(auto file, OutputFile::create(path));
    const std::vector<std::uint8_t> bytes = png_bytes(picture);
    if (bytes.empty()) {
        return Error{ErrorKind::output,
                     fmt::format("a picture of {} x {} pixels cannot be encoded as PNG", picture.width, picture.height),
                     Place{path.string()}};
    }
    file->write(bytes.data(), bytes.size());
    return file->commit();
}

}  // namespace pol
