// SPDX-License-Identifier: Apache-2.0
#include "viewer/shown/region_statistics.h"

#include <cmath>

#include "core/contract.h"

namespace pol {

namespace {

bool is_finite(const PixelLight& light) {
    const Stokes<double>& s = light.stokes;
    return std::isfinite(s.s0) && std::isfinite(s.s1) && std::isfinite(s.s2) && std::isfinite(s.s3) &&
           std::isfinite(light.missing) && std::isfinite(light.surplus) && std::isfinite(light.residual);
}

bool is_inside(const StokesImage& picture, const TileRect& region) {
    return region.x0 >= 0 && region.y0 >= 0 && region.x0 < region.x1 && region.y0 < region.y1 &&
           region.x1 <= picture.width && region.y1 <= picture.height;
}

/// Calls `take` with the light of every pixel that counts.
template <class Take>
void for_each_light(const ShownPicture& shown, std::size_t band, const TileRect& region, const Take& take) {
    const StokesImage& picture = shown.picture();
    for (int y = region.y0; y < region.y1; ++y) {
        for (int x = region.x0; x < region.x1; ++x) {
            const std::size_t pixel = picture.pixel(x, y);
            if (!picture.samples.empty() && picture.samples[pixel] == 0) continue;
            const PixelLight light = shown.light(band, pixel);
            if (is_finite(light)) take(light);
        }
    }
}

}  // namespace

RegionStatistics region_statistics(const ShownPicture& picture, std::size_t band, const TileRect& region) {
    POL_EXPECTS(is_inside(picture.picture(), region) && band < picture.picture().bands.size());
    RegionStatistics found;
    PixelLight& mean = found.mean;
    mean.known = picture.known(band);
    mean.samples = 0.0;
    for_each_light(picture, band, region, [&](const PixelLight& light) {
        ++found.count;
        mean.stokes += light.stokes;
        mean.missing += light.missing;
        mean.surplus += light.surplus;
        mean.residual += light.residual;
        mean.samples += light.samples;
        mean.scale = light.scale;
        mean.peak = light.peak;
        mean.rounding = light.rounding;
        mean.step = light.step;
    });
    found.left_out = region.pixel_count() - found.count;
    if (found.count == 0) return found;
    const double share = 1.0 / static_cast<double>(found.count);
    mean.stokes = share * mean.stokes;
    mean.missing *= share;
    mean.samples *= share;
    mean.surplus *= share;
    mean.residual *= share;
    if (found.count == 1) return found;
    // A second look: the difference of two large sums would lose what a uniform region has.
    Stokes<double> squares{};
    for_each_light(picture, band, region, [&](const PixelLight& light) {
        const Stokes<double> d = light.stokes - mean.stokes;
        squares += Stokes<double>{d.s0 * d.s0, d.s1 * d.s1, d.s2 * d.s2, d.s3 * d.s3};
    });
    const auto deviation = [&](double sum) { return std::sqrt(sum / static_cast<double>(found.count - 1)); };
    found.deviation = {deviation(squares.s0), deviation(squares.s1), deviation(squares.s2), deviation(squares.s3)};
    return found;
}

StokesImage cut_out(const StokesImage& picture, std::size_t band, const TileRect& region) {
    POL_EXPECTS(is_inside(picture, region) && band < picture.bands.size());
    StokesImage part;
    part.width = region.x1 - region.x0;
    part.height = region.y1 - region.y0;
    part.left = picture.left + region.x0;
    part.top = picture.top + region.y0;
    part.whole_width = picture.whole_width;
    part.whole_height = picture.whole_height;
    part.bands = {picture.bands[band]};
    part.stored = picture.stored;
    if (!picture.brightest.empty()) part.brightest = {picture.brightest[band]};
    if (!picture.peak.empty()) part.peak = {picture.peak[band]};
    for (int y = region.y0; y < region.y1; ++y) {
        for (int x = region.x0; x < region.x1; ++x) {
            const std::size_t pixel = picture.pixel(x, y);
            part.stokes.push_back(picture.at(band, pixel));
            if (!picture.residual.empty()) part.residual.push_back(picture.plane_value(picture.residual, band, pixel));
            if (!picture.tail.empty()) part.tail.push_back(picture.plane_value(picture.tail, band, pixel));
        }
    }
    return part;
}

}  // namespace pol
