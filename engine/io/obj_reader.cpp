// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ, the part that says where surfaces are: v and f. Own reader, since tinyobjloader 2.0 turns a number
// that it cannot read into 0 without a word.
#include <limits>
#include <string>

#include "io/polygon_soup.h"

namespace pol {
namespace {

// Lines that say nothing about the shape.
bool is_decoration(std::string_view keyword) {
    for (const char* known : {"vn", "vt", "vp", "g", "o", "s", "usemtl", "mtllib", "l", "p", "usemap", "maplib"}) {
        if (keyword == known) return true;
    }
    return keyword.empty() || keyword.front() == '#';
}

std::string quoted(std::string_view word) {
    return "'" + std::string(word.substr(0, 40)) + "'";
}

}  // namespace

Result<PolygonSoup> read_obj(std::string_view bytes) {
    PolygonSoup soup;
    TextCursor cursor(bytes);
    while (!cursor.at_end()) {
        const int number = cursor.line();
        std::string_view line = cursor.take_line();
        const std::string_view keyword = take_word_of(line);
        if (keyword == "v") {
            DVec3 p(0.0);
            for (int axis = 0; axis < 3; ++axis) {
                const std::string_view word = take_word_of(line);
                const std::optional<double> x = finite_number(word);
                if (!x) return mesh_error(quoted(word) + " is not a finite number", number, "a vertex is: v x y z");
                p[axis] = *x;
            }
            soup.vertices.push_back(p);
        } else if (keyword == "f") {
            const auto defined = static_cast<std::int64_t>(soup.vertices.size());
            std::size_t corners = 0;
            for (std::string_view word = take_word_of(line); !word.empty(); word = take_word_of(line), ++corners) {
                // "12", "12/3", "12//4" or "12/3/4"; negative counts back from the latest vertex.
                const std::optional<std::int64_t> index = whole_number(word.substr(0, word.find('/')));
                if (!index || *index == 0 || *index < -defined || *index > std::numeric_limits<std::int32_t>::max()) {
                    return mesh_error(quoted(word) + " names no vertex", number,
                                      "a face is: f 1 2 3, with vertices counted from 1");
                }
                soup.corners.push_back(static_cast<std::uint32_t>(*index > 0 ? *index - 1 : defined + *index));
            }
            if (corners < 3) return mesh_error("a face with fewer than 3 corners", number, "a face is: f 1 2 3");
            soup.last.push_back(static_cast<std::uint32_t>(soup.corners.size()));
            soup.line.push_back(static_cast<std::uint32_t>(number));
            if (soup.corners.size() > 3 * most_triangles) {
                return mesh_error("more than 10 million triangles", number, "simplify the model");
            }
        } else if (!is_decoration(keyword)) {
            return mesh_error(quoted(keyword) + " is not an OBJ keyword", number,
                              "is this a Wavefront OBJ file of polygons?");
        }
    }
    return soup;
}

}  // namespace pol
