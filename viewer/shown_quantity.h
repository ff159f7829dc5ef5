// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "maps/evaluate.h"
#include "viewer/bench.h"
#include "viewer/shown_picture.h"
#include "viewer/view_settings.h"

namespace pol {

/// A picture that another one is held against, and which of its wavelengths is compared.
struct ReferencePicture {
    const StokesImage* picture = nullptr;
    std::size_t wavelength = 0;
};

/// The shown quantity, behind the bench, pixel by pixel: that of the picture, or how far it is from the reference's.
/// Borrows the pictures: made anew for every frame. Requires: the quantity is not `color`.
class ShownQuantity {
public:
    ShownQuantity(const StokesImage& picture, const ViewSettings& view, const Bench& bench,
                  const std::optional<ReferencePicture>& reference);

    /// The number on screen.
    [[nodiscard]] MapPixel at(std::size_t pixel) const;
    [[nodiscard]] MapPixel own(std::size_t pixel) const { return value(picture_, wavelength_, pixel); }
    /// Requires: there is a reference.
    [[nodiscard]] MapPixel of_reference(std::size_t pixel) const {
        return value(*reference_, reference_wavelength_, pixel);
    }

private:
    [[nodiscard]] MapPixel value(const ShownPicture& picture, std::size_t wavelength, std::size_t pixel) const;

    Quantity quantity_;
    ShownPicture picture_;
    std::size_t wavelength_;
    std::optional<ShownPicture> reference_;
    std::size_t reference_wavelength_ = 0;
    std::optional<double> d65_;  ///< none outside its table
};

}  // namespace pol
