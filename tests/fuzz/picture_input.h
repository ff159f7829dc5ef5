// SPDX-License-Identifier: Apache-2.0
// What is asked of every reader of pictures.
#pragma once

#include <cstddef>

#include "core/contract.h"
#include "io/pictures/picture_file.h"

namespace pol::test {

inline void expect_whole(const StokesImage& image) {
    const std::size_t pixels = image.pixel_count();
    POL_EXPECTS(!image.bands.empty());
    POL_EXPECTS(image.stokes.size() == pixels * image.bands.size());
    POL_EXPECTS(image.sampling_error.empty() || image.sampling_error.size() == image.stokes.size());
    POL_EXPECTS(image.samples.empty() || image.samples.size() == pixels);
    for (std::size_t b = 0; b < image.bands.size(); ++b)
        for (std::size_t i = 0; i < pixels; ++i) {
            const Stokes<double>& s = image.at(b, i);
            const Stokes<double> known = only(image.bands[b].known, s);
            POL_EXPECTS(image.bands[b].known.has(1) || s.s1 == known.s1);
            POL_EXPECTS(image.bands[b].known.has(3) || s.s3 == known.s3);
        }
}

/// Reading ends in a whole picture of the size that its header foretold, or in an error that names the file,
/// or an option that does not fit it.
inline void read(const PictureSource& source) {
    const auto header = read_picture_header(source);
    const auto image = read_picture(source);
    if (!image) {
        POL_EXPECTS(image.error().kind == ErrorKind::usage || !image.error().place.file.empty());
        return;
    }
    expect_whole(image.value());
    POL_EXPECTS(header);
    POL_EXPECTS(header.value().width == image.value().width && header.value().height == image.value().height);
    // Three equal bands become one.
    POL_EXPECTS(header.value().bands.size() >= image.value().bands.size());
}

}  // namespace pol::test
