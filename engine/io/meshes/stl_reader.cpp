// SPDX-License-Identifier: Apache-2.0
// STL, ascii and binary. The normals in the file are not read: the order of the corners says the same.
#include <cmath>
#include <string>
#include <utility>

#include "io/meshes/polygon_soup.h"

namespace pol {
namespace {

constexpr std::size_t header_size = 84;
constexpr std::size_t record_size = 50;

void close_polygon(PolygonSoup& soup) {
    for (std::size_t k = 3; k > 0; --k) soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size() - k));
    soup.last.push_back(static_cast<std::uint32_t>(soup.corners.size()));
}

Result<PolygonSoup> read_binary(std::string_view bytes, std::size_t count) {
    PolygonSoup soup;
    soup.vertices.reserve(3 * count);
    soup.corners.reserve(3 * count);
    soup.last.reserve(count);
    for (std::size_t t = 0; t < count; ++t) {
        for (std::size_t corner = 1; corner <= 3; ++corner) {
            DVec3 p(0.0);
            for (int axis = 0; axis < 3; ++axis) {
                const std::size_t offset =
                    header_size + t * record_size + 12 * corner + 4 * static_cast<std::size_t>(axis);
                p[axis] = static_cast<double>(number_at<float>(bytes, offset, std::endian::little));
                if (!std::isfinite(p[axis])) {
                    return mesh_error_at_byte(
                        "triangle " + std::to_string(t) + ", corner " + std::to_string(corner - 1) + " is not finite",
                        offset, "export the model again");
                }
            }
            soup.vertices.push_back(p);
        }
        close_polygon(soup);
    }
    return soup;
}

std::string lower_case(std::string_view word) {
    std::string result(word);
    for (char& c : result) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    return result;
}

// Words, not lines: some programs write a whole facet in one line. Keywords in capitals are in circulation.
Result<PolygonSoup> read_ascii(std::string_view bytes) {
    const char* const hint = "inside a solid: facet normal ... outer loop, three times vertex x y z, endloop, endfacet";
    PolygonSoup soup;
    TextCursor cursor(bytes);
    int corners = 0;
    bool in_solid = false;
    bool in_normal = false;
    for (std::string_view word = cursor.take_word(); !word.empty(); word = cursor.take_word()) {
        const int number = cursor.line();
        const std::string keyword = lower_case(word);
        const bool was_in_normal = std::exchange(in_normal, false);
        if (keyword == "solid") {
            in_solid = true;
            cursor.take_line();  // a name of any words
        } else if (!in_solid) {
            return mesh_error(quoted(word) + " stands outside a solid", number, "a text STL file begins with: solid");
        } else if (keyword == "facet") {
            in_normal = true;
        } else if (keyword == "vertex") {
            DVec3 p(0.0);
            for (int axis = 0; axis < 3; ++axis) {
                const std::string_view given = cursor.take_word();
                const std::optional<double> x = finite_number(given);
                if (!x) return mesh_error(quoted(given) + " is not a finite number", number, hint);
                p[axis] = *x;
            }
            soup.vertices.push_back(p);
            ++corners;
        } else if (keyword == "endloop") {
            if (corners != 3) return mesh_error("a facet needs three vertices", number, hint);
            corners = 0;
            close_polygon(soup);
            soup.line.push_back(static_cast<std::uint32_t>(number));
            if (soup.last.size() > most_triangles) {
                return mesh_error("more than 10 million triangles", number, "simplify the model");
            }
        } else if (keyword == "endsolid") {
            in_solid = false;
            cursor.take_line();
        } else if (keyword != "outer" && keyword != "loop" && keyword != "endfacet") {
            if (!was_in_normal) return mesh_error(quoted(word) + " is not an STL keyword", number, hint);
            in_normal = true;
        }
    }
    if (corners != 0 || in_solid) return mesh_error("the file ends inside a solid", cursor.line(), "is it cut short?");
    return soup;
}

}  // namespace

Result<PolygonSoup> read_stl(std::string_view bytes) {
    // Some binary files begin with "solid" too: only the size tells, and the zeros in the count of one that is cut.
    if (bytes.size() >= header_size) {
        const std::size_t count = number_at<std::uint32_t>(bytes, 80, std::endian::little);
        if (bytes.size() == header_size + record_size * count) {
            if (count > most_triangles) {
                return mesh_error_at_byte("more than 10 million triangles", 80, "simplify the model");
            }
            return read_binary(bytes, count);
        }
    }
    if (bytes.substr(0, header_size).find('\0') == std::string_view::npos) return read_ascii(bytes);
    return mesh_error_at_byte("the number of triangles does not fit the size of the file", 80,
                              "a binary STL file has 84 + 50 x triangles bytes; is it cut short?");
}

}  // namespace pol
