// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ, the part that says where surfaces are: v and f. Own reader, since tinyobjloader 2.0 turns a number
// that it cannot read into 0 without a word.
#include <algorithm>
#include <limits>
#include <span>
#include <string>

#include "io/meshes/polygon_soup.h"

namespace pol {
namespace {

// Keywords of the format ("Object Files", Wavefront, 1995) that say nothing about polygons: names, normals, textures,
// display, points, lines, and the bodies of free-form curves.
constexpr std::string_view decorations[] = {
    "vn",     "vt",     "vp",     "g",      "s",        "mg",        "o",          "p",      "l",
    "mtllib", "usemtl", "maplib", "usemap", "bevel",    "c_interp",  "lod",        "ctech",  "stech",
    "parm",   "trim",   "hole",   "scrv",   "d_interp", "trace_obj", "shadow_obj", "cstype", "deg",
    "bmat",   "step",   "curv",   "sp",     "end",      "con",       "curv2",      "cdc",    "res"};

// Keywords that bring surfaces of another kind, or from elsewhere: without them the shape is another one.
constexpr std::string_view other_surfaces[] = {"surf", "bsp", "bzp", "cdp", "call", "csh"};

bool is_one_of(std::span<const std::string_view> keywords, std::string_view word) {
    return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

// The next line without its comment, and joined to the one after it where it ends in a backslash. A backslash that
// ends a comment (a path, say) joins nothing: the line after it would be lost.
void take_statement(TextCursor& cursor, std::string& statement) {
    statement.clear();
    while (!cursor.at_end()) {
        std::string_view line = cursor.take_line();
        line = line.substr(0, line.find('#'));
        const std::size_t last = line.find_last_not_of(" \t");
        if (last == std::string_view::npos || line[last] != '\\') {
            statement += line;
            return;
        }
        statement += line.substr(0, last);
        statement += ' ';
    }
}

}  // namespace

Result<PolygonSoup> read_obj(std::string_view bytes) {
    PolygonSoup soup;
    TextCursor cursor(bytes);
    std::string statement;
    while (!cursor.at_end()) {
        const int number = cursor.line();
        take_statement(cursor, statement);
        std::string_view line = statement;
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
        } else if (keyword == "f" || keyword == "fo") {  // fo: how version 2 wrote a face
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
        } else if (is_one_of(other_surfaces, keyword)) {
            return mesh_error(quoted(keyword) + " is not read: only polygons in the file itself are", number,
                              "convert the model to one mesh of polygons");
        } else if (!keyword.empty() && !is_one_of(decorations, keyword)) {
            return mesh_error(quoted(keyword) + " is not an OBJ keyword", number,
                              "is this a Wavefront OBJ file of polygons?");
        }
    }
    return soup;
}

}  // namespace pol
