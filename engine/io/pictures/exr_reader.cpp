// SPDX-License-Identifier: Apache-2.0
#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfHeader.h>
#include <ImfMultiPartInputFile.h>
#include <ImfStringAttribute.h>
#include <ImfTestFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <map>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"
#include "io/pictures/exr_file.h"
#include "io/pictures/exr_header.h"
#include "io/pictures/exr_layout.h"
#include "io/pictures/exr_origin.h"
#include "io/pictures/exr_parts.h"
#include "io/pictures/exr_picture.h"
#include "io/pictures/exr_planes.h"
#include "io/pictures/picture_reading.h"

namespace pol {
namespace {

/// Most by which OpenEXR shrinks the numbers of a picture: zlib by 1032, PIZ by 410; the DWA kinds keep one of 64
/// numbers and then use zlib.
double largest_compression(Imf::Compression kind) {
    return kind == Imf::DWAA_COMPRESSION || kind == Imf::DWAB_COMPRESSION ? 0x1p18 : 2048.0;
}

/// All that is known before a pixel is read.
struct Plan {
    exr::Layout layout;
    std::map<std::string, int> located;  ///< part of each channel
    StokesImage image;                   ///< without planes
    double bytes = 0.0;
};

void set_windows(StokesImage& image, const Imath::Box2i& data, const Imath::Box2i& display) {
    image.left = data.min.x - display.min.x;
    image.top = data.min.y - display.min.y;
    if (data == display) return;
    image.whole_width = display.max.x - display.min.x + 1;
    image.whole_height = display.max.y - display.min.y + 1;
}

std::map<std::string, std::string> attributes_of(const Imf::Header& header) {
    std::map<std::string, std::string> attributes;
    const std::string_view prefix = exr::attribute_prefix;
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
        const std::string name = attribute.name();
        if (!name.starts_with(prefix) || name == exr::wavelengths_attribute || name == exr::brightest_attribute ||
            exr::is_own_attribute(name))
            continue;
        const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
        if (text != nullptr) attributes.emplace(name.substr(prefix.size()), text->value());
    }
    return attributes;
}

Result<Plan> plan_of(const Imf::MultiPartInputFile& file, std::uintmax_t file_bytes, const exr::Wish& wish) {
    const exr::Parts parts(file);
    Plan plan;
    POL_TRY(plan.layout, exr::layout_of(parts, wish));
    const exr::Layout& layout = plan.layout;
    const std::vector<std::string> channels = layout.channels();
    POL_TRY(plan.located, parts.locate(channels));
    double compression = 0.0;
    for (const auto& [channel, part] : plan.located) {
        if (!file.partComplete(part))
            return input_error("is incomplete: some scan lines are missing", "was the program that wrote it stopped?");
        compression = std::max(compression, largest_compression(parts.header(part).compression()));
    }

    const Imf::Header& header = parts.header(plan.located.at(channels.front()));
    const Imath::Box2i& window = header.dataWindow();
    const double width = double{1} + window.max.x - window.min.x;
    const double height = double{1} + window.max.y - window.min.y;
    const auto bands = static_cast<double>(layout.stokes.bands.size());
    const auto shares = static_cast<double>(layout.residual.size() + layout.tail.size());
    const double stokes_planes = bands + static_cast<double>(layout.sampling_error.size());
    plan.bytes = width * height * (stokes_planes * sizeof(Stokes<double>) + (shares + 1.0) * sizeof(double));
    if (plan.bytes > max_picture_bytes) {
        return input_error(fmt::format("a picture of {} x {} pixels and {} bands is too large ({:.3g} GiB)", width,
                                       height, bands, plan.bytes / 0x1p30),
                           fmt::format("at most {:.0f} GiB", max_picture_bytes / 0x1p30));
    }
    const auto stokes_channels = static_cast<double>(layout.stokes_channels().size());
    const double least_stored = width * height * stokes_channels * 2.0;  // half floats
    if (least_stored > compression * static_cast<double>(file_bytes))
        return input_error(fmt::format("promises {} x {} pixels, more than the file can hold", width, height),
                           "copy or render it again");

    StokesImage& image = plan.image;
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    set_windows(image, window, header.displayWindow());
    image.stored = exr::with_earlier(parts.stored(layout.stokes_channels()), parts);
    for (const BandChannels& channel : layout.stokes.bands) image.bands.push_back(channel.band);
    image.origin = layout.stokes.origin;
    const std::vector<double> brightest = exr::parse_numbers(parts.text(exr::brightest_attribute));
    if (brightest.size() == image.bands.size()) image.brightest = brightest;
    image.attributes = attributes_of(header);
    return plan;
}

void add_shares(exr::PlaneReader& reader, const std::vector<std::string>& channels, std::size_t pixels,
                std::vector<double>& planes) {
    planes.resize(channels.size() * pixels);
    for (std::size_t c = 0; c < channels.size(); ++c) {
        const std::size_t offset = c * pixels;
        reader.add(channels[c], [&planes, offset](std::size_t pixel, double value) { planes[offset + pixel] = value; });
    }
}

/// The channels of band `band`; those without a name stay 0.
void add_band(exr::PlaneReader& reader, const std::array<std::string, 4>& names, std::size_t offset, bool left_handed,
              std::vector<Stokes<double>>& planes) {
    for (std::size_t s = 0; s < names.size(); ++s) {
        if (names[s].empty()) continue;
        const auto component = exr::stokes_layers[s].component;
        const double sign = s == 3 && left_handed ? -1.0 : 1.0;
        reader.add(names[s], [&planes, component, sign, offset](std::size_t pixel, double value) {
            planes[offset + pixel].*component = sign * value;
        });
    }
}

Result<StokesImage> read_planes(Imf::MultiPartInputFile& file, Plan plan, const ReadProgress& progress) {
    const exr::Layout& layout = plan.layout;
    StokesImage image = std::move(plan.image);
    const std::size_t pixels = image.pixel_count();
    exr::PlaneReader reader(image.width, image.height, plan.located);
    image.stokes.resize(pixels * image.bands.size());
    for (std::size_t b = 0; b < layout.stokes.bands.size(); ++b)
        add_band(reader, layout.stokes.bands[b].names, b * pixels, layout.left_handed, image.stokes);
    image.sampling_error.resize(pixels * layout.sampling_error.size());
    for (std::size_t b = 0; b < layout.sampling_error.size(); ++b)
        add_band(reader, layout.sampling_error[b], b * pixels, false, image.sampling_error);
    add_shares(reader, layout.residual, pixels, image.residual);
    add_shares(reader, layout.tail, pixels, image.tail);
    for (const std::string& name : layout.counts) {
        std::vector<std::uint32_t>& plane = name == "samples" ? image.samples : image.failures;
        plane.resize(pixels);
        reader.add_count(name, plane);
    }
    if (!reader.read(file, progress)) return was_stopped();
    if (layout.stokes.may_be_mono) merge_equal_colors(image);
    if (layout.convention)
        for (Stokes<double>& s : image.stokes) s = layout.convention->to_ours(s);
    return image;
}

std::optional<Error> exr_problem(const std::filesystem::path& path) {
    if (auto problem = picture_file_problem(path)) return problem;
    if (!Imf::isOpenExrFile(path.c_str()))
        return input_error("is not an EXR file", "name a picture that polariscope render wrote");
    return exr_header_problem(path);
}

/// What `use(file)` gives of the opened file, with the path in its error.
template <class Use>
auto opened(const std::filesystem::path& path, Use use) -> decltype(use(std::declval<Imf::MultiPartInputFile&>())) {
    const auto located = [&path](Error error) {
        error.place.file = path.string();
        return error;
    };
    if (const auto problem = exr_problem(path)) return located(*problem);
    try {
        Imf::MultiPartInputFile file(path.c_str());
        auto used = use(file);
        if (!used) return located(used.error());
        return used;
    } catch (const std::bad_alloc&) {
        return located(input_error("is too large for the memory of this machine", "look at it on a larger one"));
    } catch (const std::exception& exception) {
        return located(
            input_error(fmt::format("is damaged or truncated: {}", exception.what()), "copy or render it again"));
    }
}

}  // namespace

bool is_exr_file(const std::filesystem::path& path) {
    std::error_code status;
    return std::filesystem::is_regular_file(path, status) && Imf::isOpenExrFile(path.c_str());
}

namespace exr {

Result<Label> read_label(const std::filesystem::path& path) {
    return opened(path, [](Imf::MultiPartInputFile& file) -> Result<Label> {
        const Parts parts(file);
        return Label{parts.names(), parts.text("renderer"), parts.text(convention_attribute)};
    });
}

Result<PictureHeader> read_header(const std::filesystem::path& path, const Wish& wish) {
    return opened(path, [&](Imf::MultiPartInputFile& file) -> Result<PictureHeader> {
        POL_TRY(const Plan plan, plan_of(file, std::filesystem::file_size(path), wish));
        const StokesImage& image = plan.image;
        return PictureHeader{image.width, image.height, image.bands, image.origin,
                             static_cast<std::uintmax_t>(plan.bytes)};
    });
}

Result<StokesImage> read_one(const std::filesystem::path& path, const Wish& wish, const ReadProgress& progress) {
    return opened(path, [&](Imf::MultiPartInputFile& file) -> Result<StokesImage> {
        POL_TRY(Plan plan, plan_of(file, std::filesystem::file_size(path), wish));
        return read_planes(file, std::move(plan), progress);
    });
}

}  // namespace exr

Result<StokesImage> read_exr(const std::filesystem::path& path) {
    return exr::read_one(path, {}, {});
}

}  // namespace pol
