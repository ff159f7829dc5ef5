// SPDX-License-Identifier: Apache-2.0
// A session that shows a picture whose every pixel is known, through the same door as a user's file.
#pragma once

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "io/pictures/exr_file.h"
#include "viewer/session/session.h"

namespace pol {

/// Pictures of the tests are read back from 32-bit floats: compare with what the session holds, not with `image`. Its
/// first wavelength is shown.
inline void open_picture(Session& session, const StokesImage& image) {
    const auto path =
        std::filesystem::temp_directory_path() / ("polariscope_known_" + std::to_string(getpid()) + ".exr");
    ASSERT_TRUE(write_exr(image, path));
    ASSERT_TRUE(session.open(path));
    session.change_view().band = 0;
    std::filesystem::remove(path);
}

/// Light of S0 = `s0`, degree of polarization `p`, azimuth `psi` and ellipticity angle `chi`, in radians.
inline Stokes<double> polarized_light(double s0, double p, double psi, double chi) {
    return {s0, s0 * p * std::cos(2.0 * chi) * std::cos(2.0 * psi), s0 * p * std::cos(2.0 * chi) * std::sin(2.0 * psi),
            s0 * p * std::sin(2.0 * chi)};
}

/// Two wavelengths, 500 and 600 nm. From left to right the azimuth turns by half a turn, from top to bottom the
/// degree of polarization rises from 0 to 1 and the light from left-handed to right-handed. Residual 1 %.
inline StokesImage known_picture(int width = 16, int height = 12) {
    StokesImage image;
    image.width = width;
    image.height = height;
    image.bands = bands_at({500.0, 600.0});
    image.brightest = {1.0, 1.0};
    for (const double s0 : {0.5, 0.25}) {
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const double p = static_cast<double>(y) / (height - 1);
                const double psi = -1.5 + 3.0 * x / (width - 1);
                const double chi = -0.7 + 1.4 * y / (height - 1);
                image.stokes.push_back(polarized_light(s0, p, psi, chi));
            }
        }
    }
    image.residual.assign(image.pixel_count(), 0.01);
    image.samples.assign(image.pixel_count(), 4);
    return image;
}

}  // namespace pol
