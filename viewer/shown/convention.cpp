// SPDX-License-Identifier: Apache-2.0
#include "viewer/shown/convention.h"

#include <fmt/format.h>

#include <array>

namespace pol {

Stokes<double> Convention::stokes(const Stokes<double>& s) const {
    const bool mirrored = viewpoint == Viewpoint::source;
    const bool s3_flips = mirrored != (positive_s3 == PositiveS3::left);
    return {s.s0, s.s1, mirrored ? -s.s2 : s.s2, s3_flips ? -s.s3 : s.s3};
}

CoherenceMatrix<double> Convention::matrix(const CoherenceMatrix<double>& j) const {
    CoherenceMatrix<double> out = j;
    if (viewpoint == Viewpoint::source) out.xy = -out.xy;
    if (time_sign == TimeSign::plus) out.xy = conj(out.xy);
    return out;
}

MuellerMatrix<double> Convention::mueller(const MuellerMatrix<double>& engine) const {
    const Stokes<double> sign = stokes({1.0, 1.0, 1.0, 1.0});
    const std::array<double, 4> signs{sign.s0, sign.s1, sign.s2, sign.s3};
    MuellerMatrix<double> out = engine;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) out.m[row][column] *= signs[row] * signs[column];
    return out;
}

std::string_view Convention::handedness_name(int handedness) const {
    return (handedness > 0) == (positive_s3 == PositiveS3::right) ? "right" : "left";
}

int Convention::s3_of_matrix() const {
    return (positive_s3 == PositiveS3::left) == (time_sign == TimeSign::plus) ? 1 : -1;
}

std::string Convention::text() const {
    return stokes_text() + (time_sign == TimeSign::minus ? ", exp(-i\u03c9t)" : ", exp(+i\u03c9t)");
}

std::string Convention::stokes_text() const {
    return std::string(viewpoint == Viewpoint::receiver ? "receiver's view" : "source's view") + ", S3 > 0 " +
           std::string(handedness_name(1));
}

std::string Convention::definition(Quantity quantity) const {
    const bool mirrored = viewpoint == Viewpoint::source;
    switch (quantity) {
        case Quantity::azimuth:
            if (!mirrored) break;
            return "atan2(S2, S1) / 2: direction of the major axis, 0 to the left, clockwise as the camera sees it: "
                   "counter-clockwise for the source";
        case Quantity::handedness:
            return fmt::format("S3 / |(S1, S2, S3)|: -1 {} circular, 0 linear, 1 {} circular, as the {} sees it",
                               handedness_name(-1), handedness_name(1), mirrored ? "source" : "receiver");
        case Quantity::s2:
            return std::string(info(quantity).definition) + (mirrored ? ", as the source sees it" : "");
        case Quantity::s3:
            return fmt::format("S3 / S0: 1 {} circular, -1 {} circular{}", handedness_name(1), handedness_name(-1),
                               mirrored ? ", as the source sees it" : "");
        default:
            break;
    }
    return std::string(info(quantity).definition);
}

ScaleWords Convention::scale_words(Quantity quantity, bool is_difference) const {
    ScaleWords words;
    if (!depends_on_convention(quantity)) return words;
    words.note = stokes_text();
    words.clockwise = viewpoint == Viewpoint::source;
    if (is_difference || (quantity != Quantity::s3 && quantity != Quantity::handedness)) return words;
    words.low = handedness_name(-1);
    words.high = handedness_name(1);
    return words;
}

std::string Convention::state_name(const Stokes<double>& engine) const {
    const Stokes<double> s = stokes(engine);
    if (s.s1 != 0.0) return s.s1 > 0.0 ? "horizontal" : "vertical";
    if (s.s2 != 0.0) return s.s2 > 0.0 ? "+45\u00b0" : "\u221245\u00b0";
    return std::string(handedness_name(s.s3 > 0.0 ? 1 : -1)) + " circular";
}

bool depends_on_convention(Quantity quantity) {
    return quantity == Quantity::azimuth || quantity == Quantity::handedness || quantity == Quantity::s2 ||
           quantity == Quantity::s3;
}

}  // namespace pol
