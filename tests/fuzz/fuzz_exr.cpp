// SPDX-License-Identifier: Apache-2.0
// Pictures: whatever an EXR file holds, reading it by any layout ends in a picture whose planes have its size and which
// its header foretold, or in an error that names the file. What is no EXR file is taken for a list of channel names.
#include <algorithm>
#include <string>
#include <vector>

#include "core/contract.h"
#include "fuzz/fuzz_input.h"
#include "fuzz/picture_input.h"
#include "io/pictures/picture_file.h"
#include "io/pictures/stokes_channels.h"

namespace {

void find_channels(std::string_view text) {
    std::vector<std::string> names(1);
    for (const char c : text) {
        if (c == '\n')
            names.emplace_back();
        else
            names.back() += c;
    }
    for (const char* generator : {"", "Mitsuba version 3.9.1"}) {
        const auto found = pol::find_stokes_channels(names, generator, "");
        if (!found) continue;
        POL_EXPECTS(!found.value().bands.empty());
        for (const pol::BandChannels& band : found.value().bands)
            for (unsigned s = 0; s < 4; ++s) {
                POL_EXPECTS(band.names[s].empty() != band.band.known.has(s));
                POL_EXPECTS(band.names[s].empty() ||
                            std::find(names.begin(), names.end(), band.names[s]) != names.end());
            }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = pol::test::as_text(data, size);
    pol::PictureSource source;
    source.files = {pol::test::as_file(text, ".exr")};
    pol::test::read(source);
    if (!text.starts_with("\x76\x2f\x31\x01")) {
        find_channels(text);
        return 0;
    }
    for (const char* layout : {"mitsuba", "bare", "plain"}) {
        source.layout = layout;
        pol::test::read(source);
    }
    pol::PictureSource components;
    components.stokes_files = {source.path(), source.path(), {}, source.path()};
    pol::test::read(components);
    return 0;
}
