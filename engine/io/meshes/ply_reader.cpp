// SPDX-License-Identifier: Apache-2.0
// PLY (G. Turk, 1994): ascii, binary little endian, binary big endian. Elements and properties that say nothing about
// the surface are stepped over.
#include <cmath>
#include <string>
#include <utility>

#include "core/result.h"
#include "io/meshes/polygon_soup.h"

namespace pol {
namespace {

enum class Scalar { i8, u8, i16, u16, i32, u32, f32, f64 };

std::optional<Scalar> scalar_named(std::string_view name) {
    constexpr std::pair<const char*, Scalar> names[] = {
        {"char", Scalar::i8},   {"uchar", Scalar::u8},   {"short", Scalar::i16},   {"ushort", Scalar::u16},
        {"int", Scalar::i32},   {"uint", Scalar::u32},   {"float", Scalar::f32},   {"double", Scalar::f64},
        {"int8", Scalar::i8},   {"uint8", Scalar::u8},   {"int16", Scalar::i16},   {"uint16", Scalar::u16},
        {"int32", Scalar::i32}, {"uint32", Scalar::u32}, {"float32", Scalar::f32}, {"float64", Scalar::f64}};
    for (const auto& [known, type] : names) {
        if (name == known) return type;
    }
    return std::nullopt;
}

std::size_t size_of(Scalar type) {
    switch (type) {
        case Scalar::i8:
        case Scalar::u8:
            return 1;
        case Scalar::i16:
        case Scalar::u16:
            return 2;
        case Scalar::i32:
        case Scalar::u32:
        case Scalar::f32:
            return 4;
        case Scalar::f64:
            return 8;
    }
    return 8;
}

struct Property {
    std::string name;
    Scalar type{};
    std::optional<Scalar> length;  // a list, and the type of its length
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};

enum class Format { ascii, little, big };

struct Header {
    Format format{};
    std::vector<Element> elements;
    std::size_t end = 0;  // where the data begin
    int line = 1;
};

Result<Header> read_header(std::string_view bytes) {
    Header header;
    TextCursor cursor(bytes);
    std::string_view magic = cursor.take_line();
    if (take_word_of(magic) != "ply" || !take_word_of(magic).empty())
        return mesh_error("this is not a PLY file", 1, "its first line must be: ply");
    // Where lines end in \r alone, a \n after the header is data.
    const bool lone_return = bytes[cursor.position() - 1] == '\r';
    bool has_format = false;
    while (!cursor.at_end()) {
        const int number = cursor.line();
        std::string_view line = cursor.take_line();
        const std::string_view keyword = take_word_of(line);
        if (keyword == "end_header") {
            if (!has_format) return mesh_error("the header names no format", number, "for example: format ascii 1.0");
            header.end = cursor.position();
            if (lone_return && bytes[header.end - 1] == '\n') --header.end;
            header.line = cursor.line();
            return header;
        }
        if (keyword == "format") {
            const std::string_view name = take_word_of(line);
            has_format = true;
            if (name == "ascii")
                header.format = Format::ascii;
            else if (name == "binary_little_endian")
                header.format = Format::little;
            else if (name == "binary_big_endian")
                header.format = Format::big;
            else
                return mesh_error("unknown format", number, "ascii, binary_little_endian or binary_big_endian");
        } else if (keyword == "element") {
            Element element;
            element.name = take_word_of(line);
            const auto count = whole_number(take_word_of(line));
            // Each row takes at least one byte.
            if (!count || *count < 0 || static_cast<std::size_t>(*count) > bytes.size()) {
                return mesh_error("element " + element.name + " has a count that the file cannot hold", number,
                                  "is the file cut short?");
            }
            element.count = static_cast<std::size_t>(*count);
            header.elements.push_back(std::move(element));
        } else if (keyword == "property") {
            if (header.elements.empty()) return mesh_error("a property before any element", number, "see the format");
            Property property;
            std::string_view type = take_word_of(line);
            if (type == "list") {
                property.length = scalar_named(take_word_of(line));
                if (!property.length || *property.length == Scalar::f32 || *property.length == Scalar::f64) {
                    return mesh_error("unknown type of a list's length", number, "for example uchar");
                }
                type = take_word_of(line);
            }
            const auto scalar = scalar_named(type);
            property.name = take_word_of(line);
            if (!scalar || property.name.empty()) {
                return mesh_error("unknown property", number, "for example: property float x");
            }
            property.type = *scalar;
            header.elements.back().properties.push_back(std::move(property));
        } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
            return mesh_error("'" + std::string(keyword.substr(0, 40)) + "' does not belong in a header", number,
                              "format, element, property, comment or end_header");
        }
    }
    return mesh_error("the header does not end", cursor.line(), "it must end with: end_header");
}

// Numbers of the body, one after the other, text or binary.
class Body {
public:
    Body(std::string_view bytes, const Header& header)
        : bytes_(bytes), format_(header.format), at_(header.end), text_(bytes, header.end, header.line) {}

    // Steps over a number, of which a text file need only hold a word: -nan(ind) and 1.#QNAN are no numbers of ours.
    bool skip(Scalar type) {
        if (format_ == Format::ascii) return !text_.take_word().empty();
        if (bytes_.size() - at_ < size_of(type)) return false;
        at_ += size_of(type);
        return true;
    }

    // Nothing at the end or where there is no number.
    std::optional<double> take(Scalar type) {
        if (format_ == Format::ascii) return finite_number(text_.take_word());
        if (bytes_.size() - at_ < size_of(type)) return std::nullopt;
        const std::size_t here = std::exchange(at_, at_ + size_of(type));
        const std::endian order = format_ == Format::little ? std::endian::little : std::endian::big;
        switch (type) {
            case Scalar::i8:
                return number_at<std::int8_t>(bytes_, here, order);
            case Scalar::u8:
                return number_at<std::uint8_t>(bytes_, here, order);
            case Scalar::i16:
                return number_at<std::int16_t>(bytes_, here, order);
            case Scalar::u16:
                return number_at<std::uint16_t>(bytes_, here, order);
            case Scalar::i32:
                return number_at<std::int32_t>(bytes_, here, order);
            case Scalar::u32:
                return number_at<std::uint32_t>(bytes_, here, order);
            case Scalar::f32:
                return static_cast<double>(number_at<float>(bytes_, here, order));
            case Scalar::f64:
                return number_at<double>(bytes_, here, order);
        }
        return std::nullopt;
    }

    bool at_end() {
        if (format_ != Format::ascii) return at_ == bytes_.size();
        TextCursor rest = text_;
        return rest.take_word().empty();
    }

    int line() const { return format_ == Format::ascii ? text_.line() : 0; }

    Error error(const std::string& what, std::string hint) const {
        if (format_ == Format::ascii) return mesh_error(what, text_.line(), std::move(hint));
        return mesh_error_at_byte(what, at_, std::move(hint));
    }

private:
    std::string_view bytes_;
    Format format_;
    std::size_t at_;
    TextCursor text_;
};

// One row of `element` into `soup`.
std::optional<Error> read_row(Body& body, const Element& element, std::size_t row, PolygonSoup& soup) {
    const auto name = [&] { return element.name + " " + std::to_string(row); };
    const auto ends_in = [&](const Property& property) {
        return body.error(name() + ", " + property.name + ": the file ends here", "is it cut short?");
    };
    const bool is_vertex = element.name == "vertex";
    DVec3 p(0.0);
    for (const Property& property : element.properties) {
        if (!property.length) {
            const int axis = is_vertex && property.name.size() == 1 ? property.name[0] - 'x' : -1;
            if (axis < 0 || axis > 2) {
                if (!body.skip(property.type)) return ends_in(property);
                continue;
            }
            const auto value = body.take(property.type);
            if (!value)
                return body.error(name() + ", " + property.name + ": not a finite number, or the file ends here",
                                  "is the file cut short?");
            if (!std::isfinite(*value)) return body.error(name() + " is not finite", "export the model again");
            p[axis] = *value;
            continue;
        }
        const auto length = body.take(*property.length);
        const bool wanted =
            element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index");
        if (!length || *length < 0.0 || *length != std::floor(*length) || (wanted && *length < 3.0)) {
            return body.error(name() + ": bad number of corners, or the file ends here",
                              "faces have 3 corners or more");
        }
        for (double k = 0.0; k < *length; k += 1.0) {
            if (!wanted) {
                if (!body.skip(property.type)) return ends_in(property);
                continue;
            }
            const auto value = body.take(property.type);
            if (!value) return ends_in(property);
            if (!(*value >= 0.0) || *value > 4294967295.0 || *value != std::floor(*value)) {
                return body.error(name() + ": a corner is not a vertex number", "vertices count from 0");
            }
            soup.corners.push_back(static_cast<std::uint32_t>(*value));
        }
        if (!wanted) continue;
        soup.last.push_back(static_cast<std::uint32_t>(soup.corners.size()));
        if (body.line() > 0) soup.line.push_back(static_cast<std::uint32_t>(body.line()));
        if (soup.corners.size() > 3 * most_triangles) {
            return body.error("more than 10 million triangles", "simplify the model");
        }
    }
    if (is_vertex) soup.vertices.push_back(p);
    return std::nullopt;
}

}  // namespace

Result<PolygonSoup> read_ply(std::string_view bytes) {
    POL_TRY(const auto header, read_header(bytes));
    PolygonSoup soup;
    Body body(bytes, header);
    for (const Element& element : header.elements) {
        if (element.name == "vertex") {
            for (const char* axis : {"x", "y", "z"}) {
                bool found = false;
                for (const Property& p : element.properties) found = found || (p.name == axis && !p.length);
                if (!found) {
                    return mesh_error(std::string("vertices have no property ") + axis, 0, "a vertex has x, y and z");
                }
            }
        }
        if (element.name == "tristrips" && element.count > 0)
            return mesh_error("triangle strips (tristrips) are not read", 0, "export faces instead");
        if (element.properties.empty()) continue;
        for (std::size_t row = 0; row < element.count; ++row) {
            if (const auto problem = read_row(body, element, row, soup)) return *problem;
        }
    }
    if (!body.at_end()) return body.error("data after the last element", "do the counts in the header fit?");
    return soup;
}

}  // namespace pol
