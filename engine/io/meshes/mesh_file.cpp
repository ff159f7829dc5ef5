// SPDX-License-Identifier: Apache-2.0
#include "io/meshes/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/result.h"
#include "geometry/mesh_check.h"
#include "geometry/polygon_cut.h"
#include "io/files/input_file.h"
#include "io/meshes/polygon_soup.h"

namespace pol {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 32U;

Result<Mesh> meshed(PolygonSoup soup) {
    std::vector<Triangle> triangles;
    std::vector<DVec3> corners;
    std::uint32_t start = 0;
    for (std::size_t polygon = 0; polygon < soup.last.size(); ++polygon) {
        const auto ring = std::span(soup.corners).subspan(start, soup.last[polygon] - start);
        start = soup.last[polygon];
        const int line = soup.line.empty() ? 0 : static_cast<int>(soup.line[polygon]);
        for (const std::uint32_t v : ring) {
            if (v < soup.vertices.size()) continue;
            return mesh_error("face " + std::to_string(polygon) + " uses vertex " + std::to_string(v) + " of " +
                                  std::to_string(soup.vertices.size()) + " (counted from 0)",
                              line, "is the file cut short?");
        }
        if (ring.size() == 3) {
            triangles.push_back({ring[0], ring[1], ring[2]});
            continue;
        }
        corners.clear();
        for (const std::uint32_t v : ring) corners.push_back(soup.vertices[v]);
        const Result<std::vector<Triangle>> cut = cut_polygon(corners);
        if (!cut) return mesh_error("face " + std::to_string(polygon) + " " + cut.error().what, line, cut.error().hint);
        for (const auto& [a, b, c] : cut.value()) triangles.push_back({ring[a], ring[b], ring[c]});
    }
    return mesh_from_triangles(std::move(soup.vertices), std::move(triangles));
}

Result<PolygonSoup> read_soup(const std::filesystem::path& path, const std::string& bytes) {
    std::string kind = path.extension().string();
    std::transform(kind.begin(), kind.end(), kind.begin(),
                   [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    if (bytes.empty()) return mesh_error("the file is empty", 0, "export the model again");
    if (kind == ".obj") return read_obj(bytes);
    if (kind == ".ply") return read_ply(bytes);
    if (kind == ".stl") return read_stl(bytes);
    if (kind == ".gltf" || kind == ".glb") return read_gltf(bytes, path.parent_path());
    return mesh_error("unknown kind of mesh file '" + kind + "'", 0, "use .obj, .ply, .stl, .gltf or .glb");
}

// By its byte order mark. Some shells write what a program prints like this.
bool is_utf16(std::string_view bytes) {
    return bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff");
}

Error located(Error error, const std::filesystem::path& path) {
    error.place.file = path.string();
    return error;
}

}  // namespace

Result<Mesh> load_mesh(const std::filesystem::path& path) {
    try {
        POL_TRY(const auto bytes, read_input_file(path, largest_file));
        Result<PolygonSoup> soup = read_soup(path, bytes);
        if (!soup && is_utf16(bytes))
            return located(mesh_error("the file is UTF-16 text", 1, "save it as UTF-8"), path);
        if (!soup) return located(soup.error(), path);
        Result<Mesh> mesh = meshed(std::move(soup).value());
        if (!mesh) return located(mesh.error(), path);
        return mesh;
    } catch (const std::exception& problem) {
        return located(mesh_error(std::string("cannot be read: ") + problem.what(), 0, "is there enough memory?"),
                       path);
    }
}

}  // namespace pol
