// SPDX-License-Identifier: Apache-2.0
// EXR as Mitsuba and wave_tracer lay it out.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "io/files/output_file.h"
#include "io/pictures/exr_layout.h"
#include "io/pictures/exr_stream.h"
#include "io/pictures/form_writing.h"
#include "spectrum/color.h"

namespace pol {

namespace {

constexpr std::array<const char*, 3> color_names{"R", "G", "B"};

/// Planes of one kind of float, a line at a time.
Result<Rounding> write_planes(const OutgoingPicture& picture, const std::filesystem::path& path,
                              const std::vector<OutgoingPlane>& planes, bool as_half) {
    const StokesImage& image = picture.image;
    Rounding rounding;
    POL_TRY(auto created, OutputFile::create(path));
    OutputFile& file = *created;
    std::string complaint;
    try {
        Imf::Header header(image.width, image.height);
        header.compression() = Imf::PIZ_COMPRESSION;
        header.insert(exr::convention_attribute, Imf::StringAttribute(picture.options.convention.text()));
        for (const OutgoingPlane& plane : planes)
            header.channels().insert(plane.name, Imf::Channel(as_half ? Imf::HALF : Imf::FLOAT));
        exr::OutputStream stream(file, path.string());
        Imf::OutputFile exr(stream, header);
        const auto width = static_cast<std::size_t>(image.width);
        std::vector<std::vector<float>> floats(planes.size(), std::vector<float>(width));
        std::vector<std::vector<half>> halves(planes.size(), std::vector<half>(width));
        for (int y = 0; y < image.height; ++y) {
            Imf::FrameBuffer buffer;
            for (std::size_t c = 0; c < planes.size(); ++c) {
                for (std::size_t x = 0; x < width; ++x) {
                    const double number = planes[c].value(image.pixel(static_cast<int>(x), y));
                    floats[c][x] = static_cast<float>(number);
                    halves[c][x] = half(floats[c][x]);
                    const double kept = as_half ? static_cast<double>(static_cast<float>(halves[c][x]))
                                                : static_cast<double>(floats[c][x]);
                    if (std::isfinite(number) && std::isinf(kept))
                        ++rounding.infinite;
                    else if (kept != number && !std::isnan(kept))
                        ++rounding.changed;
                }
                char* line =
                    as_half ? reinterpret_cast<char*>(halves[c].data()) : reinterpret_cast<char*>(floats[c].data());
                // A stride of 0 along y: every line is read from the same place.
                buffer.insert(planes[c].name, Imf::Slice(as_half ? Imf::HALF : Imf::FLOAT, line,
                                                         as_half ? sizeof(half) : sizeof(float), 0));
            }
            exr.setFrameBuffer(buffer);
            exr.writePixels(1);
        }
    } catch (const std::exception& exception) {
        complaint = exception.what();
    }
    if (!complaint.empty() && file.good())
        return Error{ErrorKind::output, fmt::format("cannot be written: {}", complaint), Place{path.string()}};
    POL_TRY_DONE(file.commit());
    return rounding;
}

/// Share of each band in R, G and B.
Result<std::vector<Rgb>> color_shares(OutgoingPicture& picture) {
    const std::vector<Band>& bands = picture.image.bands;
    if (const auto places = rgb_bands(bands)) {
        std::vector<Rgb> shares(bands.size(), Rgb{});
        for (std::size_t c = 0; c < 3; ++c) shares[(*places)[c]][c] = 1.0;
        if (bands.size() > 3) picture.lost.emplace_back("Bands besides R, G and B are left out.");
        return shares;
    }
    const std::vector<double> wavelengths = wavelengths_of(bands);
    if (!wavelengths.empty()) {
        picture.lost.emplace_back(
            "Wavelengths become linear sRGB by the CIE 1931 observer: R, G and B may be more than fully polarized "
            "where light is saturated, and the spectrum cannot be had back.");
        return color_weights(wavelengths);
    }
    if (bands.size() == 1) {
        if (bands.front().name != "mono")
            picture.lost.push_back(fmt::format("The band '{}' has no name there.", bands.front().name));
        return std::vector<Rgb>{{1.0, 1.0, 1.0}};
    }
    return cannot_hold("Mitsuba's layout holds R, G and B, and the bands of this picture have other names",
                       "npz and fits hold bands of any name");
}

}  // namespace

Result<Done> write_mitsuba(OutgoingPicture& picture, const std::filesystem::path& path) {
    const StokesImage& image = picture.image;
    if (picture.known() != StokesComponents::all())
        return cannot_hold("Mitsuba's layout has S0 to S3, and this picture has not measured all of them",
                           "npy, npz, four and fits leave S3 out");
    POL_TRY(const std::vector<Rgb> shares, color_shares(picture));
    const auto color_of = [&picture, &shares](std::size_t component, std::size_t color, std::size_t pixel) {
        // A single share of 1 copies the number; sums would lose the sign of 0.
        double sum = -0.0;
        for (std::size_t b = 0; b < shares.size(); ++b)
            if (shares[b][color] != 0.0) sum += shares[b][color] * (picture.at(b, pixel).*stokes_components[component]);
        return sum;
    };
    std::vector<OutgoingPlane> planes;
    for (std::size_t c = 0; c < 3; ++c) {
        planes.push_back({color_names[c], [=](std::size_t pixel) { return color_of(0, c, pixel); }});
        for (std::size_t i = 0; i < 4; ++i)
            planes.push_back(
                {fmt::format("S{}.{}", i, color_names[c]), [=](std::size_t pixel) { return color_of(i, c, pixel); }});
    }
    planes.push_back({"A", [](std::size_t) { return 1.0; }});
    if (rgb_bands(image.bands)) {
        // Equal colors read back as one band.
        bool equal = true;
        for (std::size_t p = 0; p < image.pixel_count() && equal; ++p)
            for (std::size_t i = 0; i < 4; ++i)
                equal = equal && color_of(i, 0, p) == color_of(i, 1, p) && color_of(i, 0, p) == color_of(i, 2, p);
        if (equal) picture.lost.emplace_back("R, G and B are equal, and read back as one band.");
    }
    POL_TRY(const Rounding rounding, write_planes(picture, path, planes, picture.options.half));
    rounding.note(picture.options.half ? "16-bit floats" : "32-bit floats", picture.lost);
    return Done{};
}

Result<Done> write_four(OutgoingPicture& picture, const std::filesystem::path& path) {
    const std::vector<Band>& bands = picture.image.bands;
    const auto colors = rgb_bands(bands);
    if (bands.size() != 1 && !(colors && bands.size() == 3))
        return cannot_hold("four files hold one band, or R, G and B", "npz, fits and spectral hold all bands");
    const StokesComponents known = picture.known();
    if (!known.has(0)) return cannot_hold("the picture has no S0", "choose another form");
    if (known != StokesComponents::all())
        picture.lost.emplace_back("A component that was not measured has no file: open the others with --stokes.");
    if (bands.size() == 1 && bands.front().label() != "mono")
        picture.lost.push_back(fmt::format("The band '{}' has no name there.", bands.front().label()));
    const std::vector<std::filesystem::path> files = files_of_form(picture.image, path, PictureForm::four);
    Rounding all;
    std::size_t next = 0;
    for (unsigned i = 0; i < 4; ++i) {
        if (!known.has(i)) continue;
        std::vector<OutgoingPlane> planes;
        for (std::size_t c = 0; c < bands.size(); ++c) {
            const std::size_t band = colors ? (*colors)[c] : c;
            planes.push_back({colors ? color_names[c] : "L", [&picture, band, i](std::size_t pixel) {
                                  return picture.at(band, pixel).*stokes_components[i];
                              }});
        }
        POL_TRY(const Rounding rounding, write_planes(picture, files[next++], planes, false));
        all.changed += rounding.changed;
        all.infinite += rounding.infinite;
    }
    all.note("32-bit floats", picture.lost);
    return Done{};
}

}  // namespace pol
