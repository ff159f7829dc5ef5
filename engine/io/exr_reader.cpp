// SPDX-License-Identifier: Apache-2.0
#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
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
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "io/exr_channel.h"
#include "io/exr_file.h"
#include "io/exr_header.h"
#include "io/exr_layout.h"

namespace pol {
namespace {

/// Wavelength in nm and full channel name of the channels of one layer, ascending.
using Layer = std::map<double, std::string>;

/// A failure inside this file, which has no path yet.
Error input_error(std::string what, std::string hint = {}) {
    return Error{ErrorKind::input, std::move(what), {}, {}, std::move(hint)};
}

std::vector<std::string> channel_names(const Imf::Header& header) {
    std::vector<std::string> names;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        names.emplace_back(channel.name());
    }
    return names;
}

Layer layer_of(const std::vector<std::string>& names, const std::string& layer) {
    Layer channels;
    for (const std::string& name : names) {
        if (!name.starts_with(layer + ".")) continue;
        const std::optional<double> wavelength =
            parse_wavelength_suffix(std::string_view(name).substr(layer.size() + 1));
        if (wavelength) channels.emplace(*wavelength, name);
    }
    return channels;
}

std::string text_attribute(const Imf::Header& header, const std::string& name) {
    const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(name);
    return attribute == nullptr ? std::string() : attribute->value();
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
std::vector<double> exact_wavelengths(const Imf::Header& header, const Layer& channels) {
    std::vector<double> named;
    for (const auto& [wavelength, name] : channels) named.push_back(wavelength);
    const std::vector<double> exact = parse_numbers(text_attribute(header, exr::wavelengths_attribute));
    const bool agree = std::equal(exact.begin(), exact.end(), named.begin(), named.end(),
                                  [](double a, double b) { return wavelength_suffix(a) == wavelength_suffix(b); });
    return agree ? exact : named;
}

struct Layout {
    std::array<Layer, 4> stokes;
    std::vector<std::string> residual;
    std::vector<std::string> tail;
    std::array<std::vector<std::string>, 4> sampling_error;  ///< by Stokes component
    std::optional<std::string> samples;
    std::optional<std::string> failures;
    bool left_handed = false;
};

Result<std::vector<std::string>> share_channels(const std::vector<std::string>& names, const std::string& layer,
                                                const Layer& stokes) {
    if (std::find(names.begin(), names.end(), layer) != names.end()) return std::vector<std::string>{layer};
    std::vector<std::string> channels;
    const Layer found = layer_of(names, layer);
    if (found.empty()) return channels;
    for (const auto& [wavelength, name] : stokes) {
        const auto channel = found.find(wavelength);
        if (channel == found.end()) {
            return input_error(fmt::format("channel {}.{} is missing", layer, wavelength_suffix(wavelength)),
                               "render it again");
        }
        channels.push_back(channel->second);
    }
    return channels;
}

/// The first few names, for a message.
std::string some_of(const std::vector<std::string>& names) {
    constexpr std::size_t shown = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(shown, names.size()); ++i) {
        if (i > 0) text += ", ";
        text += names[i];
    }
    return names.size() > shown ? text + ", ..." : text;
}

Result<Layout> layout_of(const Imf::Header& header) {
    const std::vector<std::string> names = channel_names(header);
    Layout layout;
    for (std::size_t s = 0; s < layout.stokes.size(); ++s)
        layout.stokes[s] = layer_of(names, exr::stokes_layers[s].name);
    if (std::all_of(layout.stokes.begin(), layout.stokes.end(), [](const Layer& layer) { return layer.empty(); })) {
        return input_error(fmt::format("no Stokes channels; found {}", some_of(names)),
                           "expected S0.580,000000nm to S3.580,000000nm (Fichet, Pacanowski & Wilkie 2021)");
    }
    for (std::size_t s = 0; s < layout.stokes.size(); ++s) {
        for (const Layer& other : layout.stokes) {
            for (const auto& [wavelength, name] : other) {
                if (layout.stokes[s].contains(wavelength)) continue;
                return input_error(fmt::format("{} has no channel for {}", exr::stokes_layers[s].name, name),
                                   "S0, S1, S2 and S3 must have the same wavelengths");
            }
        }
    }

    Result<std::vector<std::string>> residual = share_channels(names, "residual", layout.stokes[0]);
    if (!residual) return residual.error();
    layout.residual = residual.value();
    Result<std::vector<std::string>> tail = share_channels(names, "tail", layout.stokes[0]);
    if (!tail) return tail.error();
    layout.tail = tail.value();
    for (std::size_t s = 0; s < layout.stokes.size(); ++s) {
        const std::string layer = std::string(exr::sampling_error_layer) + "." + exr::stokes_layers[s].name;
        Result<std::vector<std::string>> channels = share_channels(names, layer, layout.stokes[s]);
        if (!channels) return channels.error();
        layout.sampling_error[s] = channels.value();
        const std::size_t expected = layout.sampling_error[0].empty() ? 0 : layout.stokes[0].size();
        if (layout.sampling_error[s].size() != expected)
            return input_error(fmt::format("{} does not have the channels of {}", layer, exr::stokes_layers[0].name),
                               "render it again");
    }
    if (header.channels().findChannel("samples") != nullptr) layout.samples = "samples";
    if (header.channels().findChannel("failures") != nullptr) layout.failures = "failures";

    const std::string handedness = text_attribute(header, exr::handedness_attribute);
    layout.left_handed = handedness == "left";
    if (!handedness.empty() && handedness != "left" && handedness != "right") {
        return input_error(fmt::format("polarisationHandedness is '{}'", handedness), "expected left or right");
    }
    return layout;
}

/// Reads planes of numbers band by band and hands each value to its place in the picture.
class PlaneReader {
public:
    explicit PlaneReader(int width) : width_(static_cast<std::size_t>(width)) {}

    /// `store(pixel, value)` is called once for every pixel.
    template <class Store>
    void add(const std::string& channel, Store store) {
        planes_.push_back({channel, std::vector<float>(band_size()), std::move(store)});
    }
    void add_count(const std::string& channel, std::vector<std::uint32_t>& plane) {
        counts_.push_back({channel, &plane});
    }

    /// Throws what OpenEXR throws.
    void read(Imf::InputFile& file) {
        const Imath::Box2i window = file.header().dataWindow();
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
            for (Plane& plane : planes_) insert(plane.channel, Imf::FLOAT, plane.band.data());
            for (Count& count : counts_) insert(count.channel, Imf::UINT, count.plane->data() + first);
            file.setFrameBuffer(buffer);
            file.readPixels(top, bottom);
            const std::size_t size = width_ * static_cast<std::size_t>(bottom - top + 1);
            for (Plane& plane : planes_) {
                for (std::size_t i = 0; i < size; ++i) plane.store(first + i, static_cast<double>(plane.band[i]));
            }
        }
    }

private:
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

Result<StokesImage> read_picture(Imf::InputFile& file, std::uintmax_t file_bytes) {
    const Imf::Header& header = file.header();
    Result<Layout> found = layout_of(header);
    if (!found) return found.error();
    const Layout& layout = found.value();

    const Imath::Box2i window = header.dataWindow();
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
    if (least_stored > largest_compression(header.compression()) * static_cast<double>(file_bytes))
        return input_error(fmt::format("promises {} x {} pixels, more than the file can hold", width, height),
                           "copy or render it again");

    StokesImage image;
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    image.wavelengths_nm = exact_wavelengths(header, layout.stokes[0]);
    const std::size_t pixels = image.pixel_count();
    image.stokes.resize(pixels * image.wavelengths_nm.size());

    PlaneReader reader(image.width);
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
    if (layout.samples) {
        image.samples.resize(pixels);
        reader.add_count(*layout.samples, image.samples);
    }
    if (layout.failures) {
        image.failures.resize(pixels);
        reader.add_count(*layout.failures, image.failures);
    }
    reader.read(file);

    const std::vector<double> brightest = parse_numbers(text_attribute(header, exr::brightest_attribute));
    if (brightest.size() == image.wavelengths_nm.size()) image.brightest = brightest;
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
    if (const std::string complaint = exr_header_complaint(path); !complaint.empty())
        return input_error("is damaged or truncated: " + complaint, "copy or render it again");
    return std::nullopt;
}

}  // namespace

Result<StokesImage> read_exr(const std::filesystem::path& path) {
    const auto located = [&path](Error error) {
        error.place.file = path.string();
        return error;
    };
    if (const auto problem = file_problem(path)) return located(*problem);
    try {
        Imf::InputFile file(path.c_str());
        if (!file.isComplete()) {
            return located(
                input_error("is incomplete: some scan lines are missing", "was the program that wrote it stopped?"));
        }
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
