// SPDX-License-Identifier: Apache-2.0
// One file for each Stokes component: arrays of numpy of two axes, or of three for R, G and B.
#include <fmt/format.h>

#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "io/pictures/npy_format.h"
#include "io/pictures/picture_reading.h"
#include "io/pictures/stored_precision.h"

namespace pol {

namespace {

struct Component {
    std::filesystem::path path;
    NpyHeader header;
    NumberFormat format;
    ArrayLayout layout;
    std::shared_ptr<FileBytes> bytes;
};

Result<Component> open_component(const std::filesystem::path& path, unsigned component) {
    std::error_code failed;
    const std::uint64_t size = std::filesystem::file_size(path, failed);
    if (failed) return input_error("cannot be read", "check the path and its permissions");
    Component opened;
    opened.path = path;
    opened.bytes = std::make_shared<FileBytes>(path, 0, size);
    POL_TRY(opened.header, read_npy_header(*opened.bytes));
    POL_TRY(opened.format, number_format(opened.header));
    POL_TRY_DONE(check_promise(opened.header, opened.format, *opened.bytes));
    POL_TRY(opened.layout, plane_layout(opened.header.shape, component));
    return opened;
}

Error at(const std::filesystem::path& path, Error error) {
    if (error.place.file.empty()) error.place.file = path.string();
    return error;
}

}  // namespace

Result<UnfilledPicture> open_components(const PictureSource& source) {
    if (!source.layout.empty())
        return usage_error("components in files of their own have no other layout", "leave --layout or --stokes out");
    std::vector<Component> components;
    StokesComponents known;
    for (unsigned i = 0; i < source.stokes_files.size(); ++i) {
        const std::filesystem::path& path = source.stokes_files[i];
        if (path.empty()) continue;
        auto opened = open_component(path, i);
        if (!opened) return at(path, opened.error());
        components.push_back(std::move(opened).value());
        known = known.with(i);
        const StokesImage& first = components.front().layout.image;
        const StokesImage& image = components.back().layout.image;
        if (image.width != first.width || image.height != first.height || image.bands.size() != first.bands.size())
            return input_error(fmt::format("has another shape than {}", components.front().path.string()),
                               "the components of a picture have one size", path);
    }
    if (!known.has(0)) return usage_error("there is no file of S0", "without it no other component means anything");
    StokesImage image = components.front().layout.image;
    for (Band& band : image.bands) band.known = known;
    note_precision(image, components.front().format);
    for (const Component& component : components) {
        if (component.format.kind == NumberFormat::Kind::float16) image.stored.bits = 16;
        if (component.format.is_whole()) image.stored.spacing = 1.0;
    }
    image.origin.layout = "one file for each component";
    image.origin.assumed.emplace_back(assumed_frame);
    return UnfilledPicture{
        std::move(image), [components](StokesImage& target, const ReadProgress& progress) -> Result<Done> {
            for (std::size_t i = 0; i < components.size(); ++i) {
                const Component& one = components[i];
                const auto share = [&](double done) {
                    return progress((static_cast<double>(i) + done) / static_cast<double>(components.size()));
                };
                const auto read = read_numbers(*one.bytes, one.format, one.layout, one.header.fortran_order, target,
                                               progress ? ReadProgress(share) : ReadProgress());
                if (!read) return at(one.path, read.error());
            }
            return Done{};
        }};
}

}  // namespace pol
