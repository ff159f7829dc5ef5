// SPDX-License-Identifier: Apache-2.0
#include "viewer/shown/shown_quantity.h"

#include <cmath>

#include "core/contract.h"
#include "maps/difference.h"

namespace pol {

double rounding_of(const PixelLight& light) {
    const double s0 = std::abs(light.stokes.s0);
    const double dark = pixel_noise * light.scale;
    return s0 + light.missing <= dark ? dark : pixel_noise * s0;
}

std::optional<MeasureBounds<double>> stokes_bars(const PixelLight& light) {
    return light.stokes.s0 >= 0.0 ? error_bars(light) : std::nullopt;
}

QuantityReadout read_light(const PixelLight& light, Quantity quantity, double d65) {
    QuantityReadout readout{evaluate_light(light, quantity, d65), error_bar(light, quantity, d65), 0.0};
    const QuantityInfo& about = info(quantity);
    readout.rounding = about.is_over_d65 ? rounding_of(light) / d65 : pixel_noise * about.rounding_size;
    return readout;
}

ShownQuantity::ShownQuantity(const StokesImage& picture, const ViewSettings& view, const Polarimeter& polarimeter,
                             const std::optional<ReferencePicture>& reference)
    : quantity_(view.quantity), picture_(picture, polarimeter, view.convention), band_(view.band) {
    POL_EXPECTS(quantity_ != Quantity::color);
    if (reference) {
        reference_.emplace(*reference->picture, polarimeter, view.convention);
        reference_band_ = reference->band;
        shared_ = compare::shared_area(picture, *reference->picture);
    }
    if (const auto d65 = white_of(picture.bands[band_])) d65_ = d65.value();
}

std::optional<std::size_t> ShownQuantity::in_reference(std::size_t pixel) const {
    if (!shared_) return std::nullopt;
    const compare::Area& here = shared_->in_a;
    const auto width = static_cast<std::size_t>(picture_.picture().width);
    const int x = static_cast<int>(pixel % width) - here.x;
    const int y = static_cast<int>(pixel / width) - here.y;
    if (x < 0 || y < 0 || x >= here.width || y >= here.height) return std::nullopt;
    return reference_->picture().pixel(shared_->in_b.x + x, shared_->in_b.y + y);
}

MapPixel ShownQuantity::at(std::size_t pixel) const {
    if (!reference_) return value(picture_, band_, pixel);
    const auto there = in_reference(pixel);
    if (!there) return {0.0, 0.0, PixelState::undefined};
    if (quantity_ == Quantity::poincare)
        return poincare_distance(picture_.light(band_, pixel), reference_->light(reference_band_, *there));
    return difference(quantity_, value(picture_, band_, pixel), value(*reference_, reference_band_, *there));
}

QuantityReadout ShownQuantity::of_reference(std::size_t pixel) const {
    const auto there = in_reference(pixel);
    if (!there) return {{0.0, 0.0, PixelState::undefined}, std::nullopt};
    return read(*reference_, reference_band_, *there);
}

QuantityReadout ShownQuantity::readout(std::size_t pixel) const {
    const QuantityReadout a = own(pixel);
    if (!reference_) return a;
    const QuantityReadout b = of_reference(pixel);
    QuantityReadout by{at(pixel), std::nullopt, a.rounding + b.rounding};
    if (by.pixel.state != PixelState::defined || !a.bar || !b.bar) return by;
    // Around the difference itself, which of azimuths is that of lines.
    const double plain = a.pixel.value - b.pixel.value;
    by.bar = Interval<double>{by.pixel.value + (a.bar->low - b.bar->high - plain),
                              by.pixel.value + (a.bar->high - b.bar->low - plain)};
    return by;
}

QuantityReadout ShownQuantity::read(const ShownPicture& picture, std::size_t band, std::size_t pixel) const {
    if (info(quantity_).is_over_d65 && !d65_) return {{0.0, 0.0, PixelState::undefined}, std::nullopt};
    return read_light(picture.light(band, pixel), quantity_, d65_.value_or(1.0));
}

MapPixel ShownQuantity::value(const ShownPicture& picture, std::size_t band, std::size_t pixel) const {
    if (info(quantity_).is_over_d65 && !d65_) return {0.0, 0.0, PixelState::undefined};
    return evaluate_light(picture.light(band, pixel), quantity_, d65_.value_or(1.0));
}

}  // namespace pol
