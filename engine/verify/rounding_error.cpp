// SPDX-License-Identifier: Apache-2.0
#include "verify/rounding_error.h"

#include <cmath>

#include "core/contract.h"
#include "polarization/coherence_matrix.h"
#include "verify/error_metrics.h"

namespace pol::verify {

RoundingError rounding_error(const StokesImage& picture, const StokesImage& turned) {
    POL_EXPECTS(picture.stokes.size() == turned.stokes.size());
    constexpr double same_path = 1e-9;
    RoundingError error;
    error.pixels = picture.pixel_count();
    const double unit = matrix_rms(picture);
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t p = 0; p < error.pixels; ++p) {
        double squares = 0.0;
        for (std::size_t w = 0; w < picture.wavelengths_nm.size(); ++w)
            squares += frobenius_square(turned.at(w, p) - picture.at(w, p));
        if (!(squares <= same_path * same_path * unit * unit)) {
            ++error.other_paths;
            continue;
        }
        sum += squares;
        count += static_cast<double>(picture.wavelengths_nm.size());
    }
    if (count > 0.0 && unit > 0.0) error.fro_c = std::sqrt(sum / count) / unit;
    return error;
}

}  // namespace pol::verify
