// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "compare/pairing.h"
#include "maps/error_bars.h"
#include "maps/evaluate.h"
#include "viewer/shown/polarimeter.h"
#include "viewer/shown/shown_picture.h"
#include "viewer/shown/view_settings.h"

namespace pol {

/// One quantity with its rigorous bar, both in the quantity's unit.
struct QuantityReadout {
    MapPixel pixel{};
    std::optional<Interval<double>> bar;  ///< as error_bar (maps/error_bars.h)
    double rounding = 0.0;                ///< a value of at most this size is nothing but rounding
};

/// What rounding may leave of the components of some light, or of S0 where that is all that there is.
double rounding_of(const PixelLight& light);
/// Bars of the components. Empty where nothing is bounded: as error_bars, or S0 is negative.
std::optional<MeasureBounds<double>> stokes_bars(const PixelLight& light);
/// `quantity` of some light with its bar; `d65` as in maps::evaluate_light. Requires: quantity is not `color`.
QuantityReadout read_light(const PixelLight& light, Quantity quantity, double d65);

/// A picture that another one is held against, and which of its bands is compared.
struct ReferencePicture {
    const StokesImage* picture = nullptr;
    std::size_t band = 0;
};

/// The shown quantity, behind the polarimeter and in the shown convention, pixel by pixel: that of the picture, or how
/// far it is from the reference's. Borrows the pictures: made anew for every frame. Requires: the quantity is not
/// `color`.
class ShownQuantity {
public:
    ShownQuantity(const StokesImage& picture, const ViewSettings& view, const Polarimeter& polarimeter,
                  const std::optional<ReferencePicture>& reference);

    /// The number on screen.
    [[nodiscard]] MapPixel at(std::size_t pixel) const;
    /// The same with its bar; that of a difference is as wide as both bars together.
    [[nodiscard]] QuantityReadout readout(std::size_t pixel) const;
    [[nodiscard]] QuantityReadout own(std::size_t pixel) const { return read(picture_, band_, pixel); }
    /// At the same place of the whole picture; `undefined` where the reference has no pixel. Requires: there is a
    /// reference.
    [[nodiscard]] QuantityReadout of_reference(std::size_t pixel) const;

private:
    /// Index into the reference; none where it has no pixel.
    [[nodiscard]] std::optional<std::size_t> in_reference(std::size_t pixel) const;
    [[nodiscard]] QuantityReadout read(const ShownPicture& picture, std::size_t band, std::size_t pixel) const;
    [[nodiscard]] MapPixel value(const ShownPicture& picture, std::size_t band, std::size_t pixel) const;

    Quantity quantity_;
    ShownPicture picture_;
    std::size_t band_;
    std::optional<ShownPicture> reference_;
    std::optional<compare::SharedArea> shared_;
    std::size_t reference_band_ = 0;
    std::optional<double> d65_;  ///< none outside its table
};

}  // namespace pol
