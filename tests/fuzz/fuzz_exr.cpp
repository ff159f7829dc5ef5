// SPDX-License-Identifier: Apache-2.0
// Pictures: whatever an EXR file holds, reading it by any layout ends in a picture whose planes have its size and which
// its header foretold, or in an error that names the file. What is no EXR file is taken for a list of channel names.
#include <algorithm>
#include <string>
#include <vector>

#include "core/contract.h"
#include "fuzz/fuzz_input.h"
#include "io/pictures/picture_file.h"
#include "io/pictures/stokes_channels.h"

namespace {

void expect_whole(const pol::StokesImage& image) {
    const std::size_t pixels = image.pixel_count();
    POL_EXPECTS(!image.bands.empty());
    POL_EXPECTS(image.stokes.size() == pixels * image.bands.size());
    POL_EXPECTS(image.sampling_error.empty() || image.sampling_error.size() == image.stokes.size());
    POL_EXPECTS(image.samples.empty() || image.samples.size() == pixels);
    for (std::size_t b = 0; b < image.bands.size(); ++b)
        for (std::size_t i = 0; i < pixels; ++i) {
            const pol::Stokes<double>& s = image.at(b, i);
            const pol::Stokes<double> known = pol::only(image.bands[b].known, s);
            POL_EXPECTS(image.bands[b].known.has(1) || s.s1 == known.s1);
            POL_EXPECTS(image.bands[b].known.has(3) || s.s3 == known.s3);
        }
}

void read(const pol::PictureSource& source) {
    const auto header = pol::read_picture_header(source);
    const auto image = pol::read_picture(source);
    if (!image) {
        POL_EXPECTS(!image.error().place.file.empty());
        return;
    }
    expect_whole(image.value());
    POL_EXPECTS(header);
    POL_EXPECTS(header.value().width == image.value().width && header.value().height == image.value().height);
    // Three equal bands become one.
    POL_EXPECTS(header.value().bands.size() >= image.value().bands.size());
}

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
    read(source);
    if (!text.starts_with("\x76\x2f\x31\x01")) {
        find_channels(text);
        return 0;
    }
    for (const char* layout : {"mitsuba", "bare", "plain"}) {
        source.layout = layout;
        read(source);
    }
    pol::PictureSource components;
    components.stokes_files = {source.path(), source.path(), {}, source.path()};
    read(components);
    return 0;
}
