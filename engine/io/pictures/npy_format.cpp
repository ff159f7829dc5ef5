// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/npy_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <optional>
#include <utility>

#include "io/pictures/picture_reading.h"

namespace pol {

namespace {

/// The few forms of a Python literal that such a header has.
class DictReader {
public:
    explicit DictReader(std::string_view text) : text_(text) {}

    /// Skips blanks; takes `c` if it comes next.
    bool take(char c) {
        skip();
        if (text_.empty() || text_.front() != c) return false;
        text_.remove_prefix(1);
        return true;
    }
    bool take(std::string_view word) {
        skip();
        if (!text_.starts_with(word)) return false;
        text_.remove_prefix(word.size());
        return true;
    }
    [[nodiscard]] bool at_end() {
        skip();
        return text_.empty();
    }
    [[nodiscard]] bool at_list() {
        skip();
        return text_.starts_with('[');
    }
    std::optional<std::string> text() {
        const char quote = take('\'') ? '\'' : take('"') ? '"' : '\0';
        const std::size_t end = quote == '\0' ? std::string_view::npos : text_.find(quote);
        if (end == std::string_view::npos) return std::nullopt;
        std::string value(text_.substr(0, end));
        text_.remove_prefix(end + 1);
        return value;
    }
    std::optional<ArrayShape> shape() {
        if (!take('(')) return std::nullopt;
        ArrayShape shape;
        bool more = true;
        while (!take(')')) {
            std::uint64_t length = 0;
            skip();
            const auto [end, status] = std::from_chars(text_.data(), text_.data() + text_.size(), length);
            if (status != std::errc() || !more) return std::nullopt;
            text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
            static_cast<void>(take('L'));  // Python 2
            shape.push_back(length);
            more = take(',');
        }
        return shape;
    }

private:
    void skip() {
        const std::size_t blanks = std::min(text_.find_first_not_of(" \t\n\r"), text_.size());
        text_.remove_prefix(blanks);
    }
    std::string_view text_;
};

Error damaged_header() {
    return input_error("has a damaged header: it is not as numpy writes it", "save it again with numpy.save");
}

Result<NpyHeader> parse_dict(std::string_view text) {
    DictReader reader(text);
    std::optional<std::string> descr;
    std::optional<bool> fortran_order;
    std::optional<ArrayShape> shape;
    if (!reader.take('{')) return damaged_header();
    bool more = true;
    while (!reader.take('}')) {
        const std::optional<std::string> key = reader.text();
        if (!more || !key || !reader.take(':')) return damaged_header();
        if (*key == "descr" && !descr) {
            if (reader.at_list())
                return input_error("holds records, numbers with names of their own",
                                   "save one array for each of them, or one array of numbers");
            descr = reader.text();
            if (!descr) return damaged_header();
        } else if (*key == "fortran_order" && !fortran_order) {
            fortran_order = reader.take(std::string_view("True"));
            if (!*fortran_order && !reader.take(std::string_view("False"))) return damaged_header();
        } else if (*key == "shape" && !shape) {
            shape = reader.shape();
            if (!shape) return damaged_header();
        } else {
            return damaged_header();
        }
        more = reader.take(',');
    }
    if (!descr || !fortran_order || !shape || !reader.at_end()) return damaged_header();
    return NpyHeader{*descr, *fortran_order, *shape};
}

}  // namespace

Result<NpyHeader> read_npy_header(ByteSource& bytes) {
    std::array<char, 8> begin{};
    if (!bytes.read(begin.data(), begin.size()) || std::string_view(begin.data(), npy_magic.size()) != npy_magic)
        return input_error("is not an array of numpy", "save it with numpy.save");
    const auto version = static_cast<unsigned char>(begin[6]);
    if (version < 1 || version > 3)
        return input_error(fmt::format("is an array of numpy's format {}, which is younger than this program", version),
                           "save it with version=(1, 0)");
    std::array<char, 4> length_bytes{};
    const std::size_t count = version == 1 ? 2 : 4;
    if (!bytes.read(length_bytes.data(), count)) return damaged_header();
    std::uint32_t length = 0;
    for (std::size_t i = count; i-- > 0;) length = length << 8U | static_cast<unsigned char>(length_bytes[i]);
    constexpr std::uint32_t longest = 1U << 16U;
    if (length > longest || length > bytes.left()) return damaged_header();
    std::string text(length, '\0');
    if (!bytes.read(text.data(), text.size())) return damaged_header();
    return parse_dict(text);
}

Result<NumberFormat> number_format(const NpyHeader& header) {
    using Kind = NumberFormat::Kind;
    std::string_view type = header.descr;
    NumberFormat format{Kind::float32, std::endian::native};
    if (type.starts_with('<')) format.order = std::endian::little;
    if (type.starts_with('>')) format.order = std::endian::big;
    if (!type.empty() && std::string_view("<>=|").find(type.front()) != std::string_view::npos) type.remove_prefix(1);
    constexpr std::array<std::pair<std::string_view, Kind>, 5> known{{{"f2", Kind::float16},
                                                                      {"f4", Kind::float32},
                                                                      {"f8", Kind::float64},
                                                                      {"u1", Kind::unsigned8},
                                                                      {"u2", Kind::unsigned16}}};
    for (const auto& [name, kind] : known) {
        if (type != name) continue;
        format.kind = kind;
        return format;
    }
    if (type.starts_with('O'))
        return input_error("holds Python objects (a pickle), which would run code of the file",
                           "save numbers: numpy.save(file, array.astype('f4'), allow_pickle=False)");
    const std::string_view what = type.starts_with('c')                            ? "complex numbers"
                                  : type.starts_with('U') || type.starts_with('S') ? "text"
                                  : type.starts_with('V')                          ? "records"
                                                                                   : "numbers";
    return input_error(fmt::format("holds {} of type '{}'", what, header.descr),
                       "f2, f4, f8, u1 and u2 are read: numpy.save(file, array.astype('f4'))");
}

Result<Done> check_promise(const NpyHeader& header, const NumberFormat& format, const ByteSource& bytes) {
    const std::optional<std::uint64_t> count = number_count(header.shape);
    if (!count || *count > bytes.left() / format.bytes())
        return input_error(fmt::format("promises an array of shape {}, but only {} bytes follow",
                                       shape_text(header.shape), bytes.left()),
                           "copy or save it again");
    return Done{};
}

std::string npy_header(std::string_view descr, const ArrayShape& shape) {
    std::string dict =
        fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", descr, shape_text(shape));
    constexpr std::size_t before = 10;
    constexpr std::size_t multiple = 64;
    dict.append((multiple - (before + dict.size() + 1) % multiple) % multiple, ' ');
    dict += '\n';
    std::string text(npy_magic);
    text += '\x01';
    text += '\0';
    text += static_cast<char>(dict.size() & 0xffU);
    text += static_cast<char>(dict.size() >> 8U);
    return text + dict;
}

}  // namespace pol
