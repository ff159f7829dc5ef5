// SPDX-License-Identifier: Apache-2.0
// The conventions that other programs write Stokes vectors in, as what turns theirs into ours.
#pragma once

#include <string>

#include "polarization/stokes.h"

namespace pol {

/// In which convention numbers are written. The default is the engine's (CONVENTIONS.md): x = image right, y = image
/// up, azimuth counter-clockwise from x as the receiver sees it, S3 > 0 right.
///
/// | choice               | theirs to ours                                          |
/// | -------------------- | ------------------------------------------------------- |
/// | left_handed          | S3 := -S3 (the source's view, radio and IEEE names)       |
/// | y_down               | S2 := -S2, S3 := -S3 (axes x right, y down; right-handed) |
/// | azimuth_zero_deg = z | S1 + i S2 := (S1 + i S2) exp(2 i z), z from image right, counter-clockwise; 90: "from
/// vertical" |
///
/// Applied in this order. Quarter turns are exact.
struct StokesConvention {
    bool left_handed = false;
    bool y_down = false;
    double azimuth_zero_deg = 0.0;

    [[nodiscard]] Stokes<double> to_ours(const Stokes<double>& theirs) const;
    [[nodiscard]] Stokes<double> from_ours(const Stokes<double>& ours) const;
    /// "S3 > 0 right, azimuth from image right counter-clockwise": what a user reads.
    [[nodiscard]] std::string text() const;
    friend bool operator==(const StokesConvention&, const StokesConvention&) = default;
};

}  // namespace pol
