// SPDX-License-Identifier: Apache-2.0
// The conventions that other books and programs use, as a way to label the same light. All words and signs of the
// window that depend on a convention come from here.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/vec.h"
#include "maps/colorize.h"
#include "maps/quantity.h"
#include "polarization/coherence_matrix.h"
#include "polarization/mueller.h"
#include "polarization/stokes.h"

namespace pol {

/// Who looks at the light. y is up for both; x is right for each, so the two have opposite x.
enum class Viewpoint : std::uint8_t { receiver, source };
/// Which light has S3 > 0, with "right" = clockwise for the one who looks.
enum class PositiveS3 : std::uint8_t { right, left };
/// Fields vary as exp(-i omega t) or exp(+i omega t).
enum class TimeSign : std::uint8_t { minus, plus };

/// How the engine's numbers are labeled. The default is the engine's own (CONVENTIONS.md).
///
/// | choice          | J_xy       | S2   | S3   | azimuth | chi  | right/left | x axis |
/// | --------------- | ---------- | ---- | ---- | ------- | ---- | ---------- | ------ |
/// | source's view   | -J_xy      | -S2  | -S3  | -psi    | -chi | exchanged  | -x     |
/// | S3 > 0 is left  |            |      | -S3  |         | -chi |            |        |
/// | exp(+i omega t) | J_xy^*     |      |      |         |      |            |        |
///
/// Choices combine by applying each. S0, S1, DoP, DoLP, DoCP, ellipticity, eigenvalues and error bars' widths never
/// change.
struct Convention {
    Viewpoint viewpoint = Viewpoint::receiver;
    PositiveS3 positive_s3 = PositiveS3::right;
    TimeSign time_sign = TimeSign::minus;

    [[nodiscard]] Stokes<double> stokes(const Stokes<double>& engine) const;
    [[nodiscard]] CoherenceMatrix<double> matrix(const CoherenceMatrix<double>& engine) const;
    /// What acts on stokes() as `engine` does on the engine's own.
    [[nodiscard]] MuellerMatrix<double> mueller(const MuellerMatrix<double>& engine) const;
    /// The axis that is called x is this times the engine's.
    [[nodiscard]] double x_sign() const { return viewpoint == Viewpoint::source ? -1.0 : 1.0; }
    /// "right" or "left" for a `handedness` of measure() (+1, -1) of the Stokes vector in this convention.
    [[nodiscard]] std::string_view handedness_name(int handedness) const;
    /// +1 if S3 = 2 Im J_xy here, -1 if S3 = -2 Im J_xy.
    [[nodiscard]] int s3_of_matrix() const;

    /// "receiver's view, S3 > 0 right, exp(-iωt)".
    [[nodiscard]] std::string text() const;
    /// The same without the time sign, which Stokes vectors do not know.
    [[nodiscard]] std::string stokes_text() const;
    /// QuantityInfo::definition, in this convention.
    [[nodiscard]] std::string definition(Quantity quantity) const;
    /// What the scale of a map, or of a difference of maps, says of its signs; empty where they do not depend on this.
    [[nodiscard]] ScaleWords scale_words(Quantity quantity, bool is_difference) const;
    /// "right circular", "+45°": of one of the six standard states, given as the engine's Stokes vector.
    [[nodiscard]] std::string state_name(const Stokes<double>& engine) const;

    friend bool operator==(const Convention&, const Convention&) = default;
};

/// True if values of this map change with the convention, or their names.
bool depends_on_convention(Quantity quantity);

}  // namespace pol
