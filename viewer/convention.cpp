// SPDX-License-Identifier: Apache-2.0
#include "viewer/convention.h"

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

DVec3 Convention::x_axis(const DVec3& x) const {
    return viewpoint == Viewpoint::source ? -x : x;
}

std::string_view Convention::handedness_name(int handedness) const {
    return (handedness > 0) == (positive_s3 == PositiveS3::right) ? "right" : "left";
}

int Convention::s3_of_matrix() const {
    return (positive_s3 == PositiveS3::left) == (time_sign == TimeSign::plus) ? 1 : -1;
}

std::string Convention::text() const {
    return std::string(viewpoint == Viewpoint::receiver ? "receiver's view" : "source's view") +
           (positive_s3 == PositiveS3::right ? ", S3 > 0 right" : ", S3 > 0 left") +
           (time_sign == TimeSign::minus ? ", exp(-i\u03c9t)" : ", exp(+i\u03c9t)");
}

}  // namespace pol
