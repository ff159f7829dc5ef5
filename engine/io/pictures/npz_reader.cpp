// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/join.h"
#include "io/pictures/convention_text.h"
#include "io/pictures/npy_format.h"
#include "io/pictures/npz_format.h"
#include "io/pictures/picture_reading.h"
#include "io/pictures/stokes_channels.h"
#include "io/pictures/stored_precision.h"
#include "io/pictures/zip_archive.h"

namespace pol {

namespace {

/// An array of the archive, of which the header is read.
struct Member {
    NpyHeader header;
    std::unique_ptr<ByteSource> bytes;
};

/// An entry ends with its array. Its checksum is known when all of it is read: a header that were damaged to be shorter
/// would shift all numbers.
Result<Done> check_end(const ByteSource& bytes) {
    if (bytes.left() == 0) return Done{};
    return input_error("has bytes behind its numbers: it is damaged", "copy or save it again");
}

class Archive {
public:
    static Result<Archive> open(const std::filesystem::path& path) {
        POL_TRY(const std::vector<ZipEntry> entries, read_zip_directory(path));
        Archive archive;
        archive.path_ = path;
        for (const ZipEntry& entry : entries) {
            constexpr std::string_view ending = ".npy";
            if (entry.name.ends_with(ending))
                archive.entries_.emplace(entry.name.substr(0, entry.name.size() - ending.size()), entry);
        }
        if (archive.entries_.empty())
            return input_error("is an archive without arrays of numpy", "save them with numpy.savez");
        return archive;
    }

    [[nodiscard]] bool has(std::string_view key) const { return entries_.count(std::string(key)) > 0; }
    [[nodiscard]] std::vector<std::string> keys() const {
        std::vector<std::string> names;
        for (const auto& [key, entry] : entries_) names.push_back(key);
        return names;
    }
    /// Requires: has(key).
    [[nodiscard]] Result<Member> member(std::string_view key) const {
        auto bytes = open_zip_entry(path_, entries_.at(std::string(key)));
        auto header = read_npy_header(*bytes);
        if (!header) return of_key(key, header.error());
        return Member{header.value(), std::move(bytes)};
    }
    /// What an error is about.
    static Error of_key(std::string_view key, Error error) {
        error.field = key;
        return error;
    }
    /// All numbers of an array of this shape. Requires: has(key).
    [[nodiscard]] Result<std::vector<double>> numbers(std::string_view key,
                                                      const std::vector<ArrayShape>& shapes) const {
        POL_TRY(Member found, member(key));
        const auto format = number_format(found.header);
        if (!format) return of_key(key, format.error());
        const bool known = std::find(shapes.begin(), shapes.end(), found.header.shape) != shapes.end();
        if (!known || found.header.fortran_order)
            return of_key(key,
                          input_error(fmt::format("has the shape {}{}", shape_text(found.header.shape),
                                                  known ? " in Fortran order" : ", which does not fit the picture"),
                                      fmt::format("{} in C order", shape_text(shapes.front()))));
        if (const auto promise = check_promise(found.header, format.value(), *found.bytes); !promise)
            return of_key(key, promise.error());
        std::vector<double> all(static_cast<std::size_t>(*number_count(found.header.shape)));
        std::vector<char> bytes(format.value().bytes());
        for (double& number : all) {
            if (!found.bytes->read(bytes.data(), bytes.size()))
                return of_key(key, input_error("ends too early, or is damaged", "copy or save it again"));
            number = format.value().at(bytes.data());
        }
        if (const auto end = check_end(*found.bytes); !end) return of_key(key, end.error());
        return all;
    }
    /// The texts of an array of unicode text, '<U12', of no or one axis. Requires: has(key).
    [[nodiscard]] Result<std::vector<std::string>> texts(std::string_view key) const;

private:
    std::filesystem::path path_;
    std::map<std::string, ZipEntry> entries_;
};

/// UTF-8 (RFC 3629); no text for what is no character.
void append_character(std::string& text, std::uint32_t code) {
    const auto add = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        add(code);
    } else if (code < 0x800) {
        add(0xc0U | code >> 6U);
        add(0x80U | (code & 0x3fU));
    } else if (code < 0x10000) {
        add(0xe0U | code >> 12U);
        add(0x80U | (code >> 6U & 0x3fU));
        add(0x80U | (code & 0x3fU));
    } else if (code < 0x110000) {
        add(0xf0U | code >> 18U);
        add(0x80U | (code >> 12U & 0x3fU));
        add(0x80U | (code >> 6U & 0x3fU));
        add(0x80U | (code & 0x3fU));
    }
}

Result<std::vector<std::string>> Archive::texts(std::string_view key) const {
    POL_TRY(const Member found, member(key));
    const auto wrong = [key] {
        return of_key(key, input_error("is not text", "numpy.array('text') or numpy.array(['R', 'G', 'B'])"));
    };
    constexpr std::size_t longest = 1000;
    const std::string& type = found.header.descr;
    std::size_t length = 0;
    if (!type.starts_with("<U") || type.size() > 6 || found.header.shape.size() > 1) return wrong();
    for (const char digit : type.substr(2)) {
        if (digit < '0' || digit > '9') return wrong();
        length = 10 * length + static_cast<std::size_t>(digit - '0');
    }
    const std::uint64_t count = found.header.shape.empty() ? 1 : found.header.shape.front();
    if (length > longest || count > longest || length * count * 4 > found.bytes->left()) return wrong();
    std::vector<std::string> all;
    for (std::uint64_t i = 0; i < count; ++i) {
        std::string& text = all.emplace_back();
        for (std::size_t c = 0; c < length; ++c) {
            std::array<char, 4> bytes{};
            if (!found.bytes->read(bytes.data(), bytes.size())) return wrong();
            std::uint32_t code = 0;
            for (std::size_t b = 4; b-- > 0;) code = code << 8U | static_cast<unsigned char>(bytes[b]);
            if (code != 0) append_character(text, code);
        }
    }
    return all;
}

/// The names of four planes, S3 last, which may be missing.
constexpr std::array<std::array<std::string_view, 4>, 4> plane_names{
    {{"s0", "s1", "s2", "s3"}, {"S0", "S1", "S2", "S3"}, {"I", "Q", "U", "V"}, {"i", "q", "u", "v"}}};

/// Keys of the planes, or of the one array that has all.
Result<std::vector<std::string>> stokes_keys(const Archive& archive) {
    std::vector<std::vector<std::string>> found;
    for (const auto& names : plane_names) {
        if (!archive.has(names[0])) continue;
        std::vector<std::string> keys;
        for (const std::string_view name : names)
            if (archive.has(name)) keys.emplace_back(name);
        const bool linear = archive.has(names[1]) && archive.has(names[2]);
        if (!linear)
            return input_error(fmt::format("has {}, but not both of {} and {}", names[0], names[1], names[2]),
                               "S0, S1 and S2 belong together");
        found.push_back(std::move(keys));
    }
    for (const std::string_view name : {npz::stokes, std::string_view("arr_0")})
        if (archive.has(name)) found.push_back({std::string(name)});
    if (found.empty())
        return input_error(
            fmt::format("has no array that is known as a Stokes picture, only {}", join(archive.keys(), ", ")),
            "name the arrays s0, s1, s2 and s3, or one array stokes");
    if (found.size() > 1)
        return input_error(fmt::format("can be read by {} or by {}", join(found[0], ", "), join(found[1], ", ")),
                           "save only one of them");
    return found.front();
}

Result<UnfilledPicture> open_planes(const Archive& archive, const std::vector<std::string>& keys) {
    struct Plane {
        NumberFormat format;
        ArrayLayout layout;
        bool fortran_order = false;
        std::shared_ptr<ByteSource> bytes;
        std::string key;
    };
    std::vector<Plane> planes;
    for (unsigned component = 0; component < keys.size(); ++component) {
        const std::string& key = keys[component];
        POL_TRY(Member member, archive.member(key));
        const auto format = number_format(member.header);
        if (!format) return Archive::of_key(key, format.error());
        if (const auto promise = check_promise(member.header, format.value(), *member.bytes); !promise)
            return Archive::of_key(key, promise.error());
        auto layout = plane_layout(member.header.shape, component);
        if (!layout) return Archive::of_key(key, layout.error());
        Plane plane{format.value(), std::move(layout).value(), member.header.fortran_order, std::move(member.bytes),
                    key};
        const StokesImage& image = plane.layout.image;
        if (!planes.empty()) {
            const StokesImage& first = planes.front().layout.image;
            if (image.width != first.width || image.height != first.height || image.bands.size() != first.bands.size())
                return Archive::of_key(key, input_error(fmt::format("has another shape than {}", keys.front()),
                                                        "the planes of a picture have one size"));
        }
        planes.push_back(std::move(plane));
    }
    StokesImage image = planes.front().layout.image;
    for (Band& band : image.bands) band.known = keys.size() == 3 ? StokesComponents::linear() : StokesComponents::all();
    const auto coarsest = std::max_element(planes.begin(), planes.end(), [](const Plane& a, const Plane& b) {
        return a.format.is_whole() < b.format.is_whole() ||
               (a.format.is_whole() == b.format.is_whole() && a.format.bytes() > b.format.bytes());
    });
    note_precision(image, coarsest->format);
    image.origin.layout = fmt::format("arrays {}", join(keys, ", "));
    image.origin.assumed.emplace_back(assumed_frame);
    return UnfilledPicture{
        image, [planes](StokesImage& target, const ReadProgress& progress) -> Result<Done> {
            for (std::size_t i = 0; i < planes.size(); ++i) {
                const auto share = [&](double done) {
                    return progress((static_cast<double>(i) + done) / static_cast<double>(planes.size()));
                };
                const Plane& plane = planes[i];
                const auto read = read_numbers(*plane.bytes, plane.format, plane.layout, plane.fortran_order, target,
                                               progress ? ReadProgress(share) : ReadProgress());
                if (!read) return Archive::of_key(plane.key, read.error());
                if (const auto end = check_end(*plane.bytes); !end) return Archive::of_key(plane.key, end.error());
            }
            return Done{};
        }};
}

/// Names and wavelengths of the bands. `image` has as many bands as the array.
Result<Done> read_bands(const Archive& archive, StokesImage& image) {
    std::vector<double> wavelengths(image.bands.size(), std::nan(""));
    if (archive.has(npz::wavelengths)) {
        POL_TRY(wavelengths, archive.numbers(npz::wavelengths, {{image.bands.size()}}));
    }
    std::vector<std::string> names(image.bands.size());
    if (archive.has(npz::bands)) {
        POL_TRY(names, archive.texts(npz::bands));
        if (names.size() != image.bands.size())
            return Archive::of_key(
                npz::bands, input_error(fmt::format("has {} names for {} bands", names.size(), image.bands.size()),
                                        "one for each band"));
    }
    double last = 0.0;
    for (std::size_t b = 0; b < image.bands.size(); ++b) {
        Band& band = image.bands[b];
        if (!std::isnan(wavelengths[b])) {
            // Ascending, as StokesImage has them.
            if (!(wavelengths[b] > last) || !std::isfinite(wavelengths[b]))
                return Archive::of_key(npz::wavelengths,
                                       input_error("are not positive and ascending", "sort the bands by wavelength"));
            last = wavelengths[b];
            band.wavelength_nm = wavelengths[b];
            band.name.clear();
        } else if (!names[b].empty()) {
            band.name = names[b];
        }
    }
    return Done{};
}

/// The Stokes vectors of planes (n, H, W, 4) or (n, H, W, 3).
std::vector<Stokes<double>> as_vectors(const std::vector<double>& numbers, std::size_t length) {
    std::vector<Stokes<double>> vectors;
    vectors.reserve(numbers.size() / length);
    for (std::size_t i = 0; i < numbers.size(); i += length)
        vectors.push_back({numbers[i], numbers[i + 1], numbers[i + 2], length == 4 ? numbers[i + 3] : 0.0});
    return vectors;
}

Result<Done> read_companions(const Archive& archive, std::uint64_t length, StokesImage& image) {
    const auto height = static_cast<std::uint64_t>(image.height);
    const auto width = static_cast<std::uint64_t>(image.width);
    const std::uint64_t bands = image.bands.size();
    const std::vector<ArrayShape> shapes{{height, width}, {bands, height, width}};
    for (const auto& [key, plane] : {std::pair{npz::residual, &image.residual}, std::pair{npz::tail, &image.tail}})
        if (archive.has(key)) {
            POL_TRY(*plane, archive.numbers(key, shapes));
        }
    if (archive.has(npz::sampling_error)) {
        POL_TRY(const std::vector<double> errors,
                archive.numbers(npz::sampling_error, {{bands, height, width, length}}));
        image.sampling_error = as_vectors(errors, static_cast<std::size_t>(length));
    }
    return Done{};
}

Result<UnfilledPicture> open_array(Archive archive, const std::string& key, std::string_view asked) {
    POL_TRY(Member member, archive.member(key));
    const auto format = number_format(member.header);
    if (!format) return Archive::of_key(key, format.error());
    if (const auto promise = check_promise(member.header, format.value(), *member.bytes); !promise)
        return Archive::of_key(key, promise.error());
    // With its bands named beside it, an array of four axes is what polariscope convert wrote.
    const bool is_ours = member.header.shape.size() == 4 && (archive.has(npz::wavelengths) || archive.has(npz::bands));
    auto layout = array_layout(member.header.shape, asked.empty() && is_ours ? "nhwc" : asked);
    if (!layout) return Archive::of_key(key, layout.error());
    StokesImage& image = layout.value().image;
    note_precision(image, format.value());
    image.origin.layout = fmt::format("{}, {}", key, image.origin.layout);
    if (is_ours) {
        POL_TRY_DONE(read_bands(archive, image));
    }
    if (archive.has(npz::convention)) {
        POL_TRY(const std::vector<std::string> text, archive.texts(npz::convention));
        const auto convention = text.size() == 1 ? convention_of(text.front()) : std::nullopt;
        if (!convention)
            return Archive::of_key(npz::convention, input_error("is none that polariscope convert writes",
                                                                "leave it out and say --from-handedness, ..."));
        image.origin.convention = *convention;
        image.origin.assumed.clear();
    }
    StokesImage known = image;
    return UnfilledPicture{std::move(known),
                           [archive = std::move(archive), bytes = std::shared_ptr<ByteSource>(std::move(member.bytes)),
                            number = format.value(), found = std::move(layout).value(), header = member.header, is_ours,
                            key](StokesImage& target, const ReadProgress& progress) -> Result<Done> {
                               const auto read =
                                   read_numbers(*bytes, number, found, header.fortran_order, target, progress);
                               if (!read) return Archive::of_key(key, read.error());
                               if (const auto end = check_end(*bytes); !end) return Archive::of_key(key, end.error());
                               if (found.may_be_mono) merge_equal_colors(target);
                               for (Stokes<double>& s : target.stokes) s = target.origin.convention.to_ours(s);
                               if (is_ours) return read_companions(archive, header.shape.back(), target);
                               return Done{};
                           }};
}

}  // namespace

Result<UnfilledPicture> open_npz(const std::filesystem::path& path, std::string_view layout) {
    POL_TRY(Archive archive, Archive::open(path));
    POL_TRY(const std::vector<std::string> keys, stokes_keys(archive));
    if (keys.size() == 1) return open_array(std::move(archive), keys.front(), layout);
    if (!layout.empty())
        return usage_error("the layout of an archive of planes is known by their names", "leave --layout out");
    return open_planes(archive, keys);
}

}  // namespace pol
