// SPDX-License-Identifier: Apache-2.0
#include "io/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <exception>
#include <span>
#include <string>
#include <utility>

#include "geometry/mesh_check.h"
#include "io/input_file.h"
#include "io/polygon_soup.h"

namespace pol {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 32U;

// Smallest area of the fan from corner `apex`, counted negative where a triangle is turned over.
double worst_area(const PolygonSoup& soup, std::span<const std::uint32_t> ring, std::size_t apex, const DVec3& normal) {
    double worst = HUGE_VAL;
    for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
        const DVec3& a = soup.vertices[ring[apex]];
        const DVec3& b = soup.vertices[ring[(apex + k) % ring.size()]];
        const DVec3& c = soup.vertices[ring[(apex + k + 1) % ring.size()]];
        worst = std::min(worst, dot(normal, cross(b - a, c - a)));
    }
    return worst;
}

// The fan whose thinnest triangle is the largest: corners in the middle of a side then make no empty triangles.
std::size_t best_apex(const PolygonSoup& soup, std::span<const std::uint32_t> ring) {
    constexpr std::size_t most_tried = 64;
    DVec3 normal(0.0);
    for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
        normal +=
            cross(soup.vertices[ring[k]] - soup.vertices[ring[0]], soup.vertices[ring[k + 1]] - soup.vertices[ring[0]]);
    }
    std::size_t best = 0;
    double best_area = worst_area(soup, ring, 0, normal);
    for (std::size_t apex = 1; apex < std::min(ring.size(), most_tried); ++apex) {
        const double area = worst_area(soup, ring, apex, normal);
        if (area > best_area) {
            best = apex;
            best_area = area;
        }
    }
    return best;
}

Result<Mesh> meshed(PolygonSoup soup) {
    std::vector<Triangle> triangles;
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
        const std::size_t apex = ring.size() == 3 ? 0 : best_apex(soup, ring);
        for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
            triangles.push_back({ring[apex], ring[(apex + k) % ring.size()], ring[(apex + k + 1) % ring.size()]});
        }
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

Error located(Error error, const std::filesystem::path& path) {
    error.place.file = path.string();
    return error;
}

}  // namespace

Result<Mesh> load_mesh(const std::filesystem::path& path) {
    try {
        const Result<std::string> bytes = read_input_file(path, largest_file);
        if (!bytes) return bytes.error();
        Result<PolygonSoup> soup = read_soup(path, bytes.value());
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
