// SPDX-License-Identifier: Apache-2.0
// Pictures that are no EXR: whatever an .npy, .npz, PNG or FITS file holds. Checksums are made right.
#include <string>
#include <string_view>

#include "fuzz/checksums.h"
#include "fuzz/fuzz_input.h"
#include "fuzz/picture_input.h"
#include "io/pictures/array_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string bytes(pol::test::as_text(data, size));
    const bool is_png = bytes.starts_with("\x89PNG");
    if (is_png) pol::test::mend_png(bytes);
    if (bytes.starts_with("PK")) pol::test::mend_zip(bytes);
    pol::PictureSource source;
    source.files = {pol::test::as_file(bytes, is_png ? ".png" : ".npy")};
    if (!pol::is_array_file(source)) return 0;
    pol::test::read(source);
    for (const pol::PictureLayout& layout : pol::array_layouts()) {
        source.layout = layout.name;
        pol::test::read(source);
    }
    pol::PictureSource set;
    set.files = {source.path(), source.path(), source.path()};
    set.angles_deg = {0.0, 60.0, 120.0};
    pol::test::read(set);
    pol::PictureSource components;
    components.stokes_files = {source.path(), source.path(), {}, source.path()};
    pol::test::read(components);
    return 0;
}
