// SPDX-License-Identifier: Apache-2.0
#include "polariscope/picture.h"

#include <cmath>
#include <cstddef>
#include <optional>

#include "io/pictures/exr_file.h"
#include "io/pictures/picture_file.h"
#include "maps/pixel_light.h"
#include "polariscope/inside.h"
#include "scene/check.h"

namespace polariscope {

using detail::guarded;
using detail::inner;
using detail::Inside;
using detail::usage;

namespace {

/// Why the picture has no such pixel or wavelength, or nothing.
std::optional<Error> outside(const pol::StokesImage& image, int x, int y, int wavelength) {
    if (x < 0 || y < 0 || x >= image.width || y >= image.height)
        return usage("x, y", "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") lies outside of the picture",
                     "it has " + std::to_string(image.width) + " x " + std::to_string(image.height));
    if (wavelength < 0 || static_cast<std::size_t>(wavelength) >= image.bands.size())
        return usage("wavelength", "there is no wavelength " + std::to_string(wavelength),
                     "0 to " + std::to_string(image.bands.size() - 1));
    return std::nullopt;
}

/// read(image, wavelength, pixel) where there is that pixel.
template <class Read>
auto at(const pol::StokesImage& image, int x, int y, int wavelength, const Read& read)
    -> Result<decltype(read(std::size_t{}, std::size_t{}))> {
    using Value = decltype(read(std::size_t{}, std::size_t{}));
    return guarded([&]() -> Result<Value> {
        if (const auto error = outside(image, x, y, wavelength)) return *error;
        return read(static_cast<std::size_t>(wavelength), image.pixel(x, y));
    });
}

}  // namespace

int Picture::width() const {
    return data_->image.width;
}

int Picture::height() const {
    return data_->image.height;
}

std::vector<double> Picture::wavelengths_nm() const {
    return pol::wavelengths_of(data_->image.bands);
}

std::vector<std::string> Picture::bands() const {
    std::vector<std::string> labels;
    for (const pol::Band& band : data_->image.bands) labels.push_back(band.label());
    return labels;
}

bool Picture::is_measured(int component, int band) const {
    const auto& bands = data_->image.bands;
    if (component < 0 || component > 3 || band < 0 || static_cast<std::size_t>(band) >= bands.size()) return false;
    return bands[static_cast<std::size_t>(band)].known.has(static_cast<unsigned>(component));
}

const std::vector<std::string>& Picture::assumed() const {
    return data_->image.origin.assumed;
}

const std::map<std::string, std::string>& Picture::attributes() const {
    return data_->image.attributes;
}

Result<Stokes> Picture::stokes(int x, int y, int wavelength) const {
    const pol::StokesImage& image = data_->image;
    return at(image, x, y, wavelength,
              [&](std::size_t w, std::size_t pixel) { return detail::outer(image.at(w, pixel)); });
}

Result<Coherence> Picture::coherence(int x, int y, int wavelength) const {
    const auto light = stokes(x, y, wavelength);
    if (!light) return light.error();
    for (int component = 0; component < 4; ++component)
        if (!is_measured(component, wavelength))
            return usage("wavelength", "S" + std::to_string(component) + " was not measured there",
                         "a coherence matrix needs all four Stokes components");
    return polariscope::coherence(light.value());
}

Result<double> Picture::missing(int x, int y, int wavelength) const {
    const pol::StokesImage& image = data_->image;
    return at(image, x, y, wavelength,
              [&](std::size_t w, std::size_t pixel) { return pol::pixel_light(image, w, pixel).missing; });
}

Result<double> Picture::surplus(int x, int y, int wavelength) const {
    const pol::StokesImage& image = data_->image;
    return at(image, x, y, wavelength,
              [&](std::size_t w, std::size_t pixel) { return pol::pixel_light(image, w, pixel).surplus; });
}

Result<Stokes> Picture::sampling_error(int x, int y, int wavelength) const {
    const pol::StokesImage& image = data_->image;
    return at(image, x, y, wavelength, [&](std::size_t w, std::size_t pixel) {
        return image.sampling_error.empty() ? Stokes{}
                                            : detail::outer(image.sampling_error[w * image.pixel_count() + pixel]);
    });
}

Result<std::vector<Stokes>> Picture::plane(int wavelength) const {
    return guarded([&]() -> Result<std::vector<Stokes>> {
        const pol::StokesImage& image = data_->image;
        if (const auto error = outside(image, 0, 0, wavelength)) return *error;
        std::vector<Stokes> plane(image.pixel_count());
        for (std::size_t pixel = 0; pixel < plane.size(); ++pixel)
            plane[pixel] = detail::outer(image.at(static_cast<std::size_t>(wavelength), pixel));
        return plane;
    });
}

Result<Picture> make_picture(int width, int height, const std::vector<double>& wavelengths_nm,
                             const std::vector<Stokes>& stokes) {
    return guarded([&]() -> Result<Picture> {
        if (width < 1 || height < 1 || width > pol::max_picture_side || height > pol::max_picture_side)
            return usage("width, height", "each side must have 1 to 65536 pixels", "for example 512");
        pol::StokesImage image;
        image.width = width;
        image.height = height;
        if (wavelengths_nm.empty()) return usage("wavelengths_nm", "there is none", "for example {580.0}");
        double last = 0.0;
        for (const double nm : wavelengths_nm) {
            if (!(nm > last) || !std::isfinite(nm))
                return usage("wavelengths_nm", "must be positive and ascend", "nanometres of vacuum");
            last = nm;
        }
        if (stokes.size() != image.pixel_count() * wavelengths_nm.size())
            return usage("stokes", "has " + std::to_string(stokes.size()) + " entries",
                         "width x height of them per wavelength");
        image.bands = pol::bands_at(wavelengths_nm);
        image.stokes.reserve(stokes.size());
        for (const Stokes& s : stokes) image.stokes.push_back({s.s0, s.s1, s.s2, s.s3});
        return Inside::pack(detail::PictureData{std::move(image)});
    });
}

Result<Picture> read_picture(const std::filesystem::path& file) {
    return guarded([&]() -> Result<Picture> {
        pol::PictureSource source;
        source.files = {file};
        auto image = pol::read_picture(source);
        if (!image) return detail::outer(image.error());
        return Inside::pack(detail::PictureData{std::move(image).value()});
    });
}

Result<Done> write_exr(const Picture& picture, const std::filesystem::path& file) {
    return guarded([&]() -> Result<Done> {
        const auto written = pol::write_exr(inner(picture), file);
        if (!written) return detail::outer(written.error());
        return Done{};
    });
}

}  // namespace polariscope
