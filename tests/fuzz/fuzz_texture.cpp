// SPDX-License-Identifier: Apache-2.0
// Textures: any bytes as a PNG file. Every chunk gets the checksum it should have: without that, hardly a changed byte
// would get past it into the reader.
#include "core/contract.h"
#include "fuzz/checksums.h"
#include "fuzz/fuzz_input.h"
#include "io/scenes/texture_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string png(pol::test::as_text(data, size));
    pol::test::mend_png(png);
    const auto texture = pol::load_texture(pol::test::as_file(png, ".png"));
    if (!texture) return 0;
    const pol::RgbImage& image = texture.value();
    POL_EXPECTS(image.width > 0 && image.height > 0);
    POL_EXPECTS(image.rgb.size() ==
                std::size_t{3} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    return 0;
}
