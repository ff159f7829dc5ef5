// SPDX-License-Identifier: Apache-2.0
#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfStringAttribute.h>
#include <ImfTestFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <fstream>
#include <functional>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/result.h"
#include "io/pictures/exr_channel.h"
#include "io/pictures/exr_file.h"
#include "io/pictures/exr_header.h"
#include "io/pictures/exr_layout.h"
#include "io/pictures/exr_parts.h"

namespace pol {
namespace {

/// A failure inside this file, which has no path yet.
Error input_error(std::string what, std::string hint = {}) {
    return Error{ErrorKind::input, std::move(what), {}, {}, std::move(hint)};
}

/// "1, 2.5, 3": empty if any part is not a number.
std::vector<double> parse_numbers(std::string_view text) {
    std::vector<double> numbers;
    while (!text.empty()) {
        text.remove_prefix(std::min(text.find_first_not_of(", "), text.size()));
        if (text.empty()) break;
        double value = 0.0;
        const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (status != std::errc{}) return {};
        numbers.push_back(value);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    return numbers;
}

/// The wavelengths to the last bit if our attribute agrees with the rounded ones of the channel names.
std::vector<double> exact_wavelengths(const exr::Parts& parts, const exr::Layer& channels) {
    std::vector<double> named;
    for (const auto& [wavelength, name] : channels) named.push_back(wavelength);
    const std::vector<double> exact = parse_numbers(parts.text(exr::wavelengths_attribute));
    const bool agree = std::equal(exact.begin(), exact.end(), named.begin(), named.end(),
                                  [](double a, double b) { return wavelength_suffix(a) == wavelength_suffix(b); });
    return agree ? exact : named;
}

/// Reads planes of numbers part by part and band by band and hands each value to its place in the picture.
class PlaneReader {
public:
    PlaneReader(int width, const std::map<std::string, int>& parts)
        : width_(static_cast<std::size_t>(width)), parts_(parts) {}

    /// `store(pixel, value)` is called once for every pixel.
    template <class Store>
    void add(const std::string& channel, Store store) {
        planes_.push_back({channel, std::vector<float>(band_size()), std::move(store)});
    }
    void add_count(const std::string& channel, std::vector<std::uint32_t>& plane) {
        counts_.push_back({channel, &plane});
    }

    /// Throws what OpenEXR throws.
    void read(Imf::MultiPartInputFile& file) {
        std::set<int> used;
        for (const auto& [channel, part] : parts_) used.insert(part);
        for (const int part : used) read_part(file, part);
    }

private:
    void read_part(Imf::MultiPartInputFile& file, int number) {
        Imf::InputPart part(file, number);
        const Imath::Box2i window = part.header().dataWindow();
        for (int top = window.min.y; top <= window.max.y; top += exr::band_height) {
            const int bottom = std::min(top + exr::band_height - 1, window.max.y);
            const std::size_t first = width_ * static_cast<std::size_t>(top - window.min.y);
            Imf::FrameBuffer buffer;
            // A slice's base is the address of pixel (0, 0) of the file's own coordinates.
            const auto insert = [&](const std::string& name, Imf::PixelType type, void* band) {
                const std::intptr_t size = 4;
                const std::intptr_t offset =
                    (std::intptr_t{top} * static_cast<std::intptr_t>(width_) + window.min.x) * size;
                const auto base = reinterpret_cast<std::intptr_t>(band) - offset;
                buffer.insert(name, Imf::Slice(type, reinterpret_cast<char*>(base), 4, 4 * width_));
            };
            const auto is_here = [&](const auto& plane) { return parts_.at(plane.channel) == number; };
            for (Plane& plane : planes_)
                if (is_here(plane)) insert(plane.channel, Imf::FLOAT, plane.band.data());
            for (Count& count : counts_)
                if (is_here(count)) insert(count.channel, Imf::UINT, count.plane->data() + first);
            part.setFrameBuffer(buffer);
            part.readPixels(top, bottom);
            const std::size_t size = width_ * static_cast<std::size_t>(bottom - top + 1);
            for (Plane& plane : planes_) {
                if (!is_here(plane)) continue;
                for (std::size_t i = 0; i < size; ++i) plane.store(first + i, static_cast<double>(plane.band[i]));
            }
        }
    }

    struct Plane {
        std::string channel;
        std::vector<float> band;
        std::function<void(std::size_t, double)> store;
    };
    struct Count {
        std::string channel;
        std::vector<std::uint32_t>* plane;
    };
    [[nodiscard]] std::size_t band_size() const { return width_ * static_cast<std::size_t>(exr::band_height); }

    std::size_t width_;
    const std::map<std::string, int>& parts_;  ///< by channel
    std::vector<Plane> planes_;
    std::vector<Count> counts_;
};

void add_shares(PlaneReader& reader, const std::vector<std::string>& channels, std::size_t pixels,
                std::vector<double>& planes) {
    planes.resize(channels.size() * pixels);
    for (std::size_t c = 0; c < channels.size(); ++c) {
        const std::size_t offset = c * pixels;
        reader.add(channels[c], [&planes, offset](std::size_t pixel, double value) { planes[offset + pixel] = value; });
    }
}

/// Most by which OpenEXR shrinks the numbers of a picture: zlib by 1032, PIZ by 410; the DWA kinds keep one of 64
/// numbers and then use zlib.
double largest_compression(Imf::Compression kind) {
    return kind == Imf::DWAA_COMPRESSION || kind == Imf::DWAB_COMPRESSION ? 0x1p18 : 2048.0;
}

Result<StokesImage> read_picture(Imf::MultiPartInputFile& file, std::uintmax_t file_bytes) {
    const exr::Parts parts(file);
    POL_TRY(const auto found, exr::layout_of(parts));
    const exr::Layout& layout = found;
    const std::vector<std::string> channels = layout.channels();
    POL_TRY(const auto located, parts.locate(channels));
    double compression = 0.0;
    for (const auto& [channel, part] : located) {
        if (!file.partComplete(part))
            return input_error("is incomplete: some scan lines are missing", "was the program that wrote it stopped?");
        compression = std::max(compression, largest_compression(parts.header(part).compression()));
    }

    const Imf::Header& header = parts.header(located.at(channels.front()));
    const Imath::Box2i& window = header.dataWindow();
    const double width = double{1} + window.max.x - window.min.x;
    const double height = double{1} + window.max.y - window.min.y;
    const auto wavelengths = static_cast<double>(layout.stokes[0].size());
    const double shares = static_cast<double>(layout.residual.size() + layout.tail.size());
    const double stokes_planes = wavelengths + static_cast<double>(layout.sampling_error[0].size());
    const double bytes = width * height * (stokes_planes * sizeof(Stokes<double>) + (shares + 1.0) * sizeof(double));
    if (bytes > max_exr_bytes) {
        return input_error(fmt::format("a picture of {} x {} pixels at {} wavelengths is too large ({:.3g} GiB)", width,
                                       height, wavelengths, bytes / 0x1p30),
                           fmt::format("at most {:.0f} GiB", max_exr_bytes / 0x1p30));
    }
    const double least_stored = width * height * 4.0 * wavelengths * 2.0;  // S0 to S3 as half floats
    if (least_stored > compression * static_cast<double>(file_bytes))
        return input_error(fmt::format("promises {} x {} pixels, more than the file can hold", width, height),
                           "copy or render it again");

    StokesImage image;
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    image.left = window.min.x - header.displayWindow().min.x;
    image.top = window.min.y - header.displayWindow().min.y;
    image.whole_width = header.displayWindow().max.x - header.displayWindow().min.x + 1;
    image.whole_height = header.displayWindow().max.y - header.displayWindow().min.y + 1;
    image.stored = parts.stored(layout.stokes_channels());
    image.bands = bands_at(exact_wavelengths(parts, layout.stokes[0]));
    const std::size_t pixels = image.pixel_count();
    image.stokes.resize(pixels * image.bands.size());

    PlaneReader reader(image.width, located);
    for (std::size_t s = 0; s < layout.stokes.size(); ++s) {
        const auto component = exr::stokes_layers[s].component;
        const double sign = s == 3 && layout.left_handed ? -1.0 : 1.0;
        std::size_t offset = 0;
        for (const auto& [wavelength, name] : layout.stokes[s]) {
            reader.add(name, [&image, component, sign, offset](std::size_t pixel, double value) {
                image.stokes[offset + pixel].*component = sign * value;
            });
            offset += pixels;
        }
    }
    image.sampling_error.resize(pixels * layout.sampling_error[0].size());
    for (std::size_t s = 0; s < layout.sampling_error.size(); ++s) {
        const auto component = exr::stokes_layers[s].component;
        for (std::size_t w = 0; w < layout.sampling_error[s].size(); ++w) {
            const std::size_t offset = w * pixels;
            reader.add(layout.sampling_error[s][w], [&image, component, offset](std::size_t pixel, double value) {
                image.sampling_error[offset + pixel].*component = value;
            });
        }
    }
    add_shares(reader, layout.residual, pixels, image.residual);
    add_shares(reader, layout.tail, pixels, image.tail);
    for (const std::string& name : layout.counts) {
        std::vector<std::uint32_t>& plane = name == "samples" ? image.samples : image.failures;
        plane.resize(pixels);
        reader.add_count(name, plane);
    }
    reader.read(file);

    const std::vector<double> brightest = parse_numbers(parts.text(exr::brightest_attribute));
    if (brightest.size() == image.bands.size()) image.brightest = brightest;
    const std::string_view prefix = exr::attribute_prefix;
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
        const std::string name = attribute.name();
        if (!name.starts_with(prefix) || name == exr::wavelengths_attribute || name == exr::brightest_attribute)
            continue;
        const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
        if (text != nullptr) image.attributes.emplace(name.substr(prefix.size()), text->value());
    }
    return image;
}

std::optional<Error> file_problem(const std::filesystem::path& path) {
    std::error_code status;
    if (!std::filesystem::exists(path, status))
        return input_error("there is no such file", "check the path and its spelling");
    if (std::filesystem::is_directory(path, status))
        return input_error("is a folder, not an EXR file", "name a picture in it");
    if (!std::filesystem::is_regular_file(path, status)) return input_error("is not a regular file", "check the path");
    if (!std::ifstream(path, std::ios::binary)) return input_error("cannot be read", "check its permissions");
    if (std::filesystem::file_size(path, status) == 0) return input_error("is empty", "render it again");
    if (!Imf::isOpenExrFile(path.c_str()))
        return input_error("is not an EXR file", "name a picture that polariscope render wrote");
    return exr_header_problem(path);
}

}  // namespace

Result<StokesImage> read_exr(const std::filesystem::path& path) {
    const auto located = [&path](Error error) {
        error.place.file = path.string();
        return error;
    };
    if (const auto problem = file_problem(path)) return located(*problem);
    try {
        Imf::MultiPartInputFile file(path.c_str());
        Result<StokesImage> image = read_picture(file, std::filesystem::file_size(path));
        if (!image) return located(image.error());
        return image;
    } catch (const std::bad_alloc&) {
        return located(input_error("is too large for the memory of this machine", "look at it on a larger one"));
    } catch (const std::exception& exception) {
        return located(
            input_error(fmt::format("is damaged or truncated: {}", exception.what()), "copy or render it again"));
    }
}

}  // namespace pol
