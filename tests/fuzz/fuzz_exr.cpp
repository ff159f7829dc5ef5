// SPDX-License-Identifier: Apache-2.0
// Pictures: whatever an EXR file holds, reading it ends in a picture whose planes have its size, or in an error.
#include "core/contract.h"
#include "fuzz/fuzz_input.h"
#include "io/pictures/exr_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto picture = pol::read_exr(pol::test::as_file(pol::test::as_text(data, size), ".exr"));
    if (!picture) return 0;
    const pol::StokesImage& image = picture.value();
    const std::size_t pixels = image.pixel_count();
    POL_EXPECTS(!image.bands.empty());
    POL_EXPECTS(image.stokes.size() == pixels * image.bands.size());
    POL_EXPECTS(image.sampling_error.empty() || image.sampling_error.size() == image.stokes.size());
    POL_EXPECTS(image.samples.empty() || image.samples.size() == pixels);
    return 0;
}
