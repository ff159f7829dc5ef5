// SPDX-License-Identifier: Apache-2.0
#include "viewer/shown_quantity.h"

#include "core/contract.h"
#include "maps/difference.h"
#include "spectrum/illuminant.h"

namespace pol {

ShownQuantity::ShownQuantity(const StokesImage& picture, const ViewSettings& view, const Bench& bench,
                             const std::optional<ReferencePicture>& reference)
    : quantity_(view.quantity), picture_(picture, bench), wavelength_(view.wavelength) {
    POL_EXPECTS(quantity_ != Quantity::color);
    if (reference) {
        reference_.emplace(*reference->picture, bench);
        reference_wavelength_ = reference->wavelength;
    }
    if (const auto d65 = d65_at(picture.wavelengths_nm[wavelength_])) d65_ = d65.value();
}

MapPixel ShownQuantity::at(std::size_t pixel) const {
    return reference_ ? difference(quantity_, own(pixel), of_reference(pixel)) : own(pixel);
}

MapPixel ShownQuantity::value(const ShownPicture& picture, std::size_t wavelength, std::size_t pixel) const {
    if (quantity_ == Quantity::intensity && !d65_) return {0.0, 0.0, PixelState::undefined};
    return evaluate_light(picture.light(wavelength, pixel), quantity_, d65_.value_or(1.0));
}

}  // namespace pol
