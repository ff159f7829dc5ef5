// SPDX-License-Identifier: Apache-2.0
#include "viewer/shown/convention.h"

#include <array>

namespace pol {

namespace {

/// `text` with every `one` for an `other` and the other way round.
std::string with_words_exchanged(std::string_view text, std::string_view one, std::string_view other) {
    std::string out;
    while (!text.empty()) {
        const bool is_one = text.starts_with(one);
        const bool is_other = !is_one && text.starts_with(other);
        out += is_one ? other : is_other ? one : text.substr(0, 1);
        text.remove_prefix(is_one ? one.size() : is_other ? other.size() : 1);
    }
    return out;
}

}  // namespace

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
    const QuantityInfo& about = info(quantity);
    const bool mirrored = viewpoint == Viewpoint::source && !about.from_source.empty();
    const std::string_view text = mirrored ? about.from_source : about.definition;
    const bool is_renamed = positive_s3 == PositiveS3::left && !about.low_word.empty();
    return is_renamed ? with_words_exchanged(text, about.low_word, about.high_word) : std::string(text);
}

ScaleWords Convention::scale_words(Quantity quantity, bool is_difference) const {
    const QuantityInfo& about = info(quantity);
    ScaleWords words;
    if (!depends_on_convention(quantity)) return words;
    words.note = stokes_text();
    words.clockwise = viewpoint == Viewpoint::source;
    if (is_difference) return words;
    const bool is_renamed = positive_s3 == PositiveS3::left;
    words.low = is_renamed ? about.high_word : about.low_word;
    words.high = is_renamed ? about.low_word : about.high_word;
    return words;
}

std::string Convention::state_name(const Stokes<double>& engine) const {
    const Stokes<double> s = stokes(engine);
    if (s.s1 != 0.0) return s.s1 > 0.0 ? "horizontal" : "vertical";
    if (s.s2 != 0.0) return s.s2 > 0.0 ? "+45\u00b0" : "\u221245\u00b0";
    return std::string(handedness_name(s.s3 > 0.0 ? 1 : -1)) + " circular";
}

bool depends_on_convention(Quantity quantity) {
    return !info(quantity).from_source.empty();
}

}  // namespace pol
