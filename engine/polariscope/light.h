// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <complex>

namespace polariscope {

/// x, y, z in scene units, or a direction.
using Vector = std::array<double, 3>;

/// Stokes vector: spectral radiance in the unit of the scene's lamps, at one vacuum wavelength.
///
/// Written in a right-handed frame (x, y, k), k along the light. Of a picture: x to its right, y up, both across the
/// ray of the pixel, k towards the camera. s1: x minus y, s2: +45 minus -45 degrees, s3: right minus left circular,
/// "right" being clockwise for the receiver (Born & Wolf, Principles of Optics, 7th ed., 1.4.2 and 10.9.3).
struct Stokes {
    double s0 = 0.0;
    double s1 = 0.0;
    double s2 = 0.0;
    double s3 = 0.0;
    friend bool operator==(const Stokes&, const Stokes&) = default;
};

/// Coherence matrix J = <E E^H> in the frame of a Stokes vector, fields varying as exp(-i omega t): J_xx, J_yy real,
/// J_xy = <E_x E_y^*>, J_yx = conj(J_xy). Hermitian and positive semidefinite; its trace is s0 (Born & Wolf 10.9.1).
struct Coherence {
    double xx = 0.0;
    double yy = 0.0;
    std::complex<double> xy{};
    friend bool operator==(const Coherence&, const Coherence&) = default;
};

/// xx = (s0 + s1)/2, yy = (s0 - s1)/2, xy = (s2 + i s3)/2. Small s1 beside a large s0 lose relative precision: keep
/// numbers as Stokes vectors.
Coherence coherence(const Stokes& light);
/// s0 = xx + yy, s1 = xx - yy, s2 = 2 Re xy, s3 = 2 Im xy.
Stokes stokes(const Coherence& light);

}  // namespace polariscope
