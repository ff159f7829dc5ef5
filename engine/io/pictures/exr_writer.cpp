// SPDX-License-Identifier: Apache-2.0
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/contract.h"
#include "core/result.h"
#include "core/version.h"
#include "io/files/output_file.h"
#include "io/pictures/exr_file.h"
#include "io/pictures/exr_layout.h"
#include "io/pictures/exr_origin.h"
#include "io/pictures/exr_stream.h"
#include "maps/color_picture.h"

namespace pol {
namespace {

/// The only place where a number of ours becomes a number of the file. What lies above the range of float becomes
/// infinite and what lies below it zero, as IEEE 754 rounds.
float to_file_number(double value) {
    return static_cast<float>(value);
}

/// A channel of the file and the rule that gives its value at a pixel.
struct FloatChannel {
    std::string name;
    Imf::PixelType file_type = Imf::FLOAT;
    std::function<double(std::size_t pixel)> value;
};
struct CountChannel {
    std::string name;
    const std::vector<std::uint32_t>* plane = nullptr;
};
struct Channels {
    std::vector<FloatChannel> numbers;
    std::vector<CountChannel> counts;
};

void add_share_channels(std::vector<FloatChannel>& channels, const StokesImage& image,
                        const std::vector<double>& planes, const std::string& layer) {
    if (planes.empty()) return;
    POL_EXPECTS(planes.size() == image.pixel_count() || planes.size() == image.stokes.size());
    if (planes.size() == image.pixel_count()) {
        channels.push_back({layer, Imf::FLOAT, [&planes](std::size_t pixel) { return planes[pixel]; }});
        return;
    }
    const std::vector<std::string> suffixes = exr::band_suffixes(image.bands);
    for (std::size_t b = 0; b < suffixes.size(); ++b) {
        const std::size_t offset = b * image.pixel_count();
        channels.push_back({fmt::format("{}.{}", layer, suffixes[b]), Imf::FLOAT,
                            [&planes, offset](std::size_t pixel) { return planes[offset + pixel]; }});
    }
}

/// One channel for each measured component and band of `planes`, which may be empty.
void add_stokes_channels(std::vector<FloatChannel>& channels, const StokesImage& image,
                         const std::vector<Stokes<double>>& planes, const std::string& prefix) {
    if (planes.empty()) return;
    POL_EXPECTS(planes.size() == image.stokes.size());
    const std::vector<std::string> suffixes = exr::band_suffixes(image.bands);
    for (std::size_t b = 0; b < suffixes.size(); ++b) {
        const std::size_t offset = b * image.pixel_count();
        for (unsigned s = 0; s < exr::stokes_layers.size(); ++s) {
            if (!image.bands[b].known.has(s)) continue;
            const exr::StokesLayer& layer = exr::stokes_layers[s];
            channels.push_back(
                {fmt::format("{}{}.{}", prefix, layer.name, suffixes[b]), Imf::FLOAT,
                 [&planes, offset, layer](std::size_t pixel) { return planes[offset + pixel].*layer.component; }});
        }
    }
}

/// The channels refer to `image` and `preview`.
Channels channels_of(const StokesImage& image, const std::vector<Rgb>& preview) {
    Channels channels;
    add_stokes_channels(channels.numbers, image, image.stokes, "");
    add_stokes_channels(channels.numbers, image, image.sampling_error, std::string(exr::sampling_error_layer) + ".");
    add_share_channels(channels.numbers, image, image.residual, "residual");
    add_share_channels(channels.numbers, image, image.tail, "tail");
    constexpr std::array<const char*, 3> preview_names{"R", "G", "B"};
    for (std::size_t c = 0; c < preview_names.size(); ++c) {
        channels.numbers.push_back(
            {preview_names[c], Imf::HALF, [&preview, c](std::size_t pixel) { return preview[pixel][c]; }});
    }
    if (!image.samples.empty()) channels.counts.push_back({"samples", &image.samples});
    const bool any_failed = std::any_of(image.failures.begin(), image.failures.end(), [](auto n) { return n > 0; });
    if (any_failed) channels.counts.push_back({"failures", &image.failures});
    for (const CountChannel& channel : channels.counts) POL_EXPECTS(channel.plane->size() == image.pixel_count());
    return channels;
}

Imf::Header header_of(const StokesImage& image, const Channels& channels) {
    const Imath::V2i corner(image.left, image.top);
    const Imath::V2i last = corner + Imath::V2i(image.width - 1, image.height - 1);
    const Imath::V2i whole(image.whole_width > 0 ? image.whole_width - 1 : std::max(last.x, 0),
                           image.whole_height > 0 ? image.whole_height - 1 : std::max(last.y, 0));
    Imf::Header header(Imath::Box2i({0, 0}, whole), Imath::Box2i(corner, last));
    header.compression() = Imf::PIZ_COMPRESSION;
    const auto set = [&header](const std::string& name, const std::string& text) {
        header.insert(name, Imf::StringAttribute(text));
    };
    set("spectralLayoutVersion", "1.0");
    set("emissiveUnits", "W.m^-2.sr^-1");
    set(exr::handedness_attribute, "right");
    const std::string prefix = exr::attribute_prefix;
    set(exr::frame_attribute,
        "camera: x = image right, y = image up, k = towards the camera, transverse to the pixel's ray");
    set(prefix + "azimuthZero", "x axis (image right), counter-clockwise as seen by the camera");
    set(prefix + "timeSign", "exp(-i omega t)");
    set(prefix + "version", program_version());
    for (const auto& [name, text] : image.attributes) set(prefix + name, text);
    for (const auto& [name, text] : exr::own_attributes(image)) set(name, text);
    const std::vector<double> wavelengths = wavelengths_of(image.bands);
    if (!wavelengths.empty()) set(exr::wavelengths_attribute, exr::number_list(wavelengths));
    if (!image.brightest.empty()) set(exr::brightest_attribute, exr::number_list(image.brightest));

    for (const FloatChannel& channel : channels.numbers)
        header.channels().insert(channel.name, Imf::Channel(channel.file_type));
    for (const CountChannel& channel : channels.counts) header.channels().insert(channel.name, Imf::Channel(Imf::UINT));
    return header;
}

/// Writes all lines, a band at a time, so that the floats never need a second picture in memory.
void write_pixels(Imf::OutputFile& file, const StokesImage& image, const Channels& channels,
                  const std::function<void(double)>& progress) {
    const auto width = static_cast<std::size_t>(image.width);
    const std::size_t band_size = width * static_cast<std::size_t>(exr::band_height);
    std::vector<std::vector<float>> numbers(channels.numbers.size());
    std::vector<std::vector<half>> halves(channels.numbers.size());
    for (std::size_t c = 0; c < channels.numbers.size(); ++c) {
        if (channels.numbers[c].file_type == Imf::HALF)
            halves[c].resize(band_size);
        else
            numbers[c].resize(band_size);
    }

    for (int top = 0; top < image.height; top += exr::band_height) {
        const int lines = std::min(exr::band_height, image.height - top);
        const std::size_t first = image.pixel(0, top);
        const std::size_t count = width * static_cast<std::size_t>(lines);
        Imf::FrameBuffer buffer;
        // A slice's base is the address of pixel (0, 0) of the whole picture.
        const std::intptr_t before = std::intptr_t{image.top + top} * image.width + image.left;
        const auto insert = [&](const std::string& name, Imf::PixelType type, const void* band, std::size_t size) {
            const auto base = reinterpret_cast<std::intptr_t>(band) - before * static_cast<std::intptr_t>(size);
            buffer.insert(name, Imf::Slice(type, reinterpret_cast<char*>(base), size, size * width));
        };
        for (std::size_t c = 0; c < channels.numbers.size(); ++c) {
            const FloatChannel& channel = channels.numbers[c];
            if (channel.file_type == Imf::HALF) {
                for (std::size_t i = 0; i < count; ++i) halves[c][i] = half(to_file_number(channel.value(first + i)));
                insert(channel.name, Imf::HALF, halves[c].data(), sizeof(half));
            } else {
                for (std::size_t i = 0; i < count; ++i) numbers[c][i] = to_file_number(channel.value(first + i));
                insert(channel.name, Imf::FLOAT, numbers[c].data(), sizeof(float));
            }
        }
        for (const CountChannel& channel : channels.counts) {
            insert(channel.name, Imf::UINT, channel.plane->data() + first, sizeof(std::uint32_t));
        }
        file.setFrameBuffer(buffer);
        file.writePixels(lines);
        if (progress) progress(static_cast<double>(top + lines) / image.height);
    }
}

std::optional<Error> first_problem(const StokesImage& image) {
    const auto usage = [](std::string what) { return Error{ErrorKind::usage, std::move(what)}; };
    if (image.width <= 0 || image.height <= 0) return usage("a picture without pixels cannot be written");
    if (image.bands.empty()) return usage("a picture without bands cannot be written");
    std::vector<std::string> names = exr::band_suffixes(image.bands);
    std::sort(names.begin(), names.end());
    const auto twin = std::adjacent_find(names.begin(), names.end());
    if (twin != names.end()) return usage(fmt::format("two wavelengths have the same channel name {}", *twin));
    for (const Band& band : image.bands)
        if (band.known == StokesComponents::s0().without(0))
            return usage(fmt::format("band {} has no component that was measured", band.label()));
    return std::nullopt;
}

}  // namespace

Result<Done> write_exr(const StokesImage& image, const std::filesystem::path& path,
                       const std::function<void(double)>& progress) {
    if (const auto problem = first_problem(image)) return *problem;
    POL_EXPECTS(image.stokes.size() == image.pixel_count() * image.bands.size());
    POL_EXPECTS(image.brightest.empty() || image.brightest.size() == image.bands.size());

    POL_TRY(auto created, OutputFile::create(path));
    OutputFile& file = *created;
    std::string complaint;
    try {
        const std::vector<Rgb> preview = color_picture(image);
        const Channels channels = channels_of(image, preview);
        exr::OutputStream stream(file, path.string());
        Imf::OutputFile exr(stream, header_of(image, channels));
        write_pixels(exr, image, channels, progress);
    } catch (const std::exception& exception) {
        complaint = exception.what();
    }
    // OpenEXR writes its table of lines in a destructor, which cannot report; commit() knows of every failed write.
    if (complaint.empty() || !file.good()) return file.commit();
    return Error{ErrorKind::output, fmt::format("cannot be written: {}", complaint), Place{path.string()}};
}

}  // namespace pol
