// SPDX-License-Identifier: Apache-2.0
// A picture as other programs make them: no wavelengths, S3 missing in one band, a part of a larger picture, and
// assumptions of its reader.
#pragma once

#include "viewer/known_picture.h"

namespace pol {

/// Bands R (all components) and G (S0 to S2), 16 x 12 pixels from 100,20 of 640 x 480. Light as that of known_picture.
inline StokesImage foreign_picture() {
    StokesImage image = known_picture();
    image.bands = {named_band("R"), named_band("G", StokesComponents::linear())};
    for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel)
        image.stokes[image.pixel_count() + pixel].s3 = 0.0;
    image.residual.clear();
    image.brightest.clear();
    image.samples.clear();
    image.left = 100;
    image.top = 20;
    image.whole_width = 640;
    image.whole_height = 480;
    image.stored.bits = 16;
    image.origin.layout = "Mitsuba 3, rgb";
    image.origin.assumed = {"Azimuth is counted from image right."};
    image.origin.remarks = {"The labels were shifted by one channel."};
    return image;
}

}  // namespace pol
