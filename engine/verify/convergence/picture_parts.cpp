// SPDX-License-Identifier: Apache-2.0
#include "verify/convergence/picture_parts.h"

#include <algorithm>
#include <cstddef>

#include "core/contract.h"

namespace pol::verify {

StokesImage at_wavelengths(const StokesImage& picture, const std::vector<double>& wavelengths_nm) {
    const std::vector<double> there = wavelengths_of(picture.bands);
    if (there == wavelengths_nm) return picture;
    StokesImage part;
    part.width = picture.width;
    part.height = picture.height;
    part.bands = bands_at(wavelengths_nm);
    part.samples = picture.samples;
    part.failures = picture.failures;
    part.attributes = picture.attributes;
    const auto pixels = static_cast<std::ptrdiff_t>(picture.pixel_count());
    for (const double wavelength : wavelengths_nm) {
        const auto found = std::find(there.begin(), there.end(), wavelength);
        POL_EXPECTS(found != there.end());
        const auto index = found - there.begin();
        const auto take = [&](const auto& planes, auto& target) {
            if (planes.size() <= picture.pixel_count()) return;  // absent, or shared by all wavelengths
            const auto plane = planes.begin() + index * pixels;
            target.insert(target.end(), plane, plane + pixels);
        };
        const auto light = picture.stokes.begin() + index * pixels;
        part.stokes.insert(part.stokes.end(), light, light + pixels);
        take(picture.residual, part.residual);
        take(picture.tail, part.tail);
        if (!picture.brightest.empty()) part.brightest.push_back(picture.brightest[static_cast<std::size_t>(index)]);
    }
    if (part.residual.empty()) part.residual = picture.residual;
    if (part.tail.empty()) part.tail = picture.tail;
    return part;
}

StokesImage every_second_wavelength(const StokesImage& picture) {
    std::vector<double> some;
    const std::vector<double> all = wavelengths_of(picture.bands);
    for (std::size_t w = 0; w < all.size(); w += 2) some.push_back(all[w]);
    return at_wavelengths(picture, some);
}

StokesImage mean_of(const StokesImage& a, const StokesImage& b) {
    POL_EXPECTS(a.stokes.size() == b.stokes.size() && a.residual.size() == b.residual.size());
    StokesImage mean = a;
    mean.sampling_error.clear();
    for (std::size_t i = 0; i < mean.stokes.size(); ++i) mean.stokes[i] = 0.5 * (a.stokes[i] + b.stokes[i]);
    for (std::size_t i = 0; i < mean.residual.size(); ++i) mean.residual[i] = 0.5 * (a.residual[i] + b.residual[i]);
    mean.tail.assign(std::max(a.tail.size(), b.tail.size()), 0.0);
    for (const StokesImage* one : {&a, &b})
        for (std::size_t i = 0; i < one->tail.size(); ++i) mean.tail[i] += 0.5 * one->tail[i];
    return mean;
}

}  // namespace pol::verify
