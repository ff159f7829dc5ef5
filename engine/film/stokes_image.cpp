// SPDX-License-Identifier: Apache-2.0
#include "film/stokes_image.h"

#include <algorithm>
#include <cmath>

#include "core/hypot.h"

namespace pol {

double peak_of(const StokesImage& image, std::size_t band) {
    const double brightest = image.brightest.empty() ? 0.0 : image.brightest[band];
    double peak = 0.0;
    for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel) {
        const double sure = image.at(band, pixel).s0 - image.plane_value(image.tail, band, pixel) * brightest;
        if (std::isfinite(sure)) peak = std::max(peak, sure);
    }
    return peak;
}

std::vector<double> peaks_of(const StokesImage& image) {
    std::vector<double> peaks;
    for (std::size_t band = 0; band < image.bands.size(); ++band) peaks.push_back(peak_of(image, band));
    return peaks;
}

void read_in(StokesImage& image, const StokesConvention& convention) {
    const StokesConvention before = image.origin.convention;
    if (convention == before) return;
    for (Stokes<double>& s : image.stokes) s = convention.to_ours(before.from_ours(s));
    // Standard errors have no sign. Those of S1 and S2 mix where the frame turns: a bound if they are correlated.
    const double turn = convention.azimuth_zero_deg - before.azimuth_zero_deg;
    if (std::fmod(turn, 90.0) != 0.0) {
        for (Stokes<double>& error : image.sampling_error) {
            const double both = hypot(error.s1, error.s2);
            error.s1 = both;
            error.s2 = both;
        }
    }
    image.origin.convention = convention;
}

}  // namespace pol
