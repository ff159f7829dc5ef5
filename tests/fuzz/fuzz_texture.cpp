// SPDX-License-Identifier: Apache-2.0
// Textures: any bytes as a PNG file. Every chunk gets the checksum it should have: without that, hardly a changed byte
// would get past it into the reader.
#include <zlib.h>

#include "core/contract.h"
#include "fuzz/fuzz_input.h"
#include "io/scenes/texture_file.h"

namespace {

std::size_t big_endian(const std::string& bytes, std::size_t at) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

/// PNG: 8 bytes of signature, then chunks of length, type, data and the CRC of type and data.
void mend_checksums(std::string& png) {
    std::size_t at = 8;
    while (at + 12 <= png.size()) {
        const std::size_t length = big_endian(png, at);
        if (length > png.size() - at - 12) return;
        const auto* type = reinterpret_cast<const Bytef*>(png.data() + at + 4);
        const auto crc = crc32(0, type, static_cast<uInt>(length + 4));
        for (std::size_t i = 0; i < 4; ++i) png[at + 8 + length + i] = static_cast<char>(crc >> (24U - 8U * i));
        at += length + 12;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string png(pol::test::as_text(data, size));
    mend_checksums(png);
    const auto texture = pol::load_texture(pol::test::as_file(png, ".png"));
    if (!texture) return 0;
    const pol::RgbImage& image = texture.value();
    POL_EXPECTS(image.width > 0 && image.height > 0);
    POL_EXPECTS(image.rgb.size() ==
                std::size_t{3} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    return 0;
}
