// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "film/film.h"
#include "film/stokes_image.h"
#include "maps/pixel_light.h"
#include "maps/quantity.h"
#include "viewer/shown/convention.h"
#include "viewer/shown/polarimeter.h"

namespace pol {

/// The picture as the sensor behind the polarimeter sees it, labeled in some convention. Every number on screen comes
/// through here. Borrows the picture: made anew for every frame.
class ShownPicture {
public:
    ShownPicture(const StokesImage& picture, const Polarimeter& polarimeter, const Convention& convention = {})
        : picture_(picture), convention_(convention) {
        if (!polarimeter.empty()) train_ = polarimeter.mueller();
    }
    /// Requires: indices inside the picture.
    [[nodiscard]] PixelLight light(std::size_t band, std::size_t pixel) const {
        return labeled(pixel_light(picture_, band, pixel));
    }
    /// The same of the mean light of a rectangle. Requires: it lies inside the picture and is not empty.
    [[nodiscard]] PixelLight mean_light(std::size_t band, const TileRect& rect) const {
        PixelLight mean;
        mean.known = picture_.bands[band].known;
        mean.samples = 0.0;
        for (int y = rect.y0; y < rect.y1; ++y) {
            for (int x = rect.x0; x < rect.x1; ++x) {
                const PixelLight light = pixel_light(picture_, band, picture_.pixel(x, y));
                mean.stokes += light.stokes;
                mean.missing += light.missing;
                mean.surplus += light.surplus;
                mean.residual += light.residual;
                mean.samples += light.samples;
                mean.scale = light.scale;
                mean.peak = light.peak;
                mean.rounding = light.rounding;
                mean.step = light.step;
                mean.is_bounded = light.is_bounded;
            }
        }
        const double share = 1.0 / static_cast<double>(rect.pixel_count());
        mean.stokes = share * mean.stokes;
        mean.missing *= share;
        mean.surplus *= share;
        mean.residual *= share;
        mean.samples *= share;
        return labeled(mean);
    }
    /// Whether the picture tells all that a map of the band needs.
    [[nodiscard]] bool measures(Quantity quantity, std::size_t band) const {
        const QuantityInfo& about = info(quantity);
        return known(band).has(about.needs) && !(about.is_of_bounds() && picture_.residual.empty()) &&
               !(quantity == Quantity::samples && picture_.samples.empty());
    }
    /// Those of a band that are known on screen.
    [[nodiscard]] StokesComponents known(std::size_t band) const {
        const StokesComponents known = picture_.bands[band].known;
        return train_ ? known_behind(*train_, known) : known;
    }
    /// 0 where not known.
    [[nodiscard]] Stokes<double> stokes(std::size_t band, std::size_t pixel) const {
        const Stokes<double>& s = picture_.at(band, pixel);
        return convention_.stokes(train_ ? only(known(band), *train_ * s) : s);
    }
    [[nodiscard]] const StokesImage& picture() const { return picture_; }

private:
    [[nodiscard]] PixelLight labeled(const PixelLight& light) const {
        PixelLight seen = train_ ? behind(*train_, light) : light;
        seen.stokes = convention_.stokes(seen.stokes);
        return seen;
    }

    const StokesImage& picture_;
    Convention convention_;
    std::optional<MuellerMatrix<double>> train_;  // none: the light arrives as it is
};

}  // namespace pol
