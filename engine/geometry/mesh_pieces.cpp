// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace pol {
namespace {

double largest_of(const DVec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

bool is_float(double x) {
    return std::abs(x) <= static_cast<double>(std::numeric_limits<float>::max()) &&
           static_cast<double>(static_cast<float>(x)) == x;
}

// Half the distance between numbers of so many bits near x.
double half_ulp(double x, int bits) {
    return x == 0.0 ? 0.0 : std::ldexp(1.0, std::ilogb(x) - bits);
}

// Kept vertices of one tolerance. They are at least that far apart, so a cell of twice the size holds few.
class Grid {
public:
    explicit Grid(double tolerance) : tolerance_(tolerance) {}

    void add(const DVec3& p, std::uint32_t vertex) { cells_[cell_of(p)].push_back(vertex); }

    std::uint32_t lowest_near(const DVec3& p, double radius, const std::vector<DVec3>& kept, std::uint32_t none) const {
        // Nothing so far out has so small a tolerance, and cell numbers would overflow.
        if (largest_of(p) > 1e16 * tolerance_) return none;
        const Cell low = cell_of(p - DVec3(radius));
        const Cell high = cell_of(p + DVec3(radius));
        std::uint32_t found = none;
        for (std::int64_t x = low.x; x <= high.x; ++x) {
            for (std::int64_t y = low.y; y <= high.y; ++y) {
                for (std::int64_t z = low.z; z <= high.z; ++z) {
                    const auto cell = cells_.find({x, y, z});
                    if (cell == cells_.end()) continue;
                    for (const std::uint32_t v : cell->second) {
                        if (glm::distance(kept[v], p) <= radius) found = std::min(found, v);
                    }
                }
            }
        }
        return found;
    }

private:
    struct Cell {
        std::int64_t x, y, z;
        bool operator==(const Cell&) const = default;
    };
    struct CellHash {
        std::size_t operator()(const Cell& c) const {
            const auto u = [](std::int64_t i) { return static_cast<std::uint64_t>(i); };
            return u(c.x) * 0x9e3779b97f4a7c15ULL ^ u(c.y) * 0xc2b2ae3d27d4eb4fULL ^ u(c.z) * 0x165667b19e3779f9ULL;
        }
    };
    Cell cell_of(const DVec3& p) const {
        const auto index = [this](double x) { return static_cast<std::int64_t>(std::floor(x / (2.0 * tolerance_))); };
        return {index(p.x), index(p.y), index(p.z)};
    }

    double tolerance_;
    std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells_;
};

}  // namespace

std::vector<std::uint32_t> pieces_of(const std::vector<DVec3>& vertices,
                                     std::span<const std::array<std::uint32_t, 3>> triangles) {
    std::vector<std::uint32_t> parent(vertices.size());
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&](std::uint32_t v) {
        while (parent[v] != v) v = parent[v] = parent[parent[v]];
        return v;
    };
    // The lower number stays the root, so pieces are numbered by their first vertices.
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
        const std::uint32_t low = std::min(root(a), root(b));
        parent[root(a)] = parent[root(b)] = low;
    };
    for (const auto& t : triangles) {
        join(t[0], t[1]);
        join(t[1], t[2]);
    }
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto place = [&](std::uint32_t v) { return std::tie(vertices[v].x, vertices[v].y, vertices[v].z); };
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return place(a) < place(b); });
    for (std::size_t i = 1; i < order.size(); ++i) {
        if (place(order[i - 1]) == place(order[i])) join(order[i - 1], order[i]);
    }
    std::vector<std::uint32_t> piece(vertices.size());
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < vertices.size(); ++v) piece[v] = root(v) == v ? count++ : piece[root(v)];
    return piece;
}

Precision::Precision(const std::vector<DVec3>& vertices, std::span<const std::array<std::uint32_t, 3>> triangles)
    : piece_(pieces_of(vertices, triangles)) {
    const std::size_t count = piece_.empty() ? 0 : *std::max_element(piece_.begin(), piece_.end()) + std::size_t{1};
    std::vector<DVec3> low(count, DVec3(std::numeric_limits<double>::infinity()));
    std::vector<DVec3> high(count, DVec3(-std::numeric_limits<double>::infinity()));
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const DVec3& p = vertices[v];
        low[piece_[v]] = glm::min(low[piece_[v]], p);
        high[piece_[v]] = glm::max(high[piece_[v]], p);
        float32_ = float32_ && is_float(p.x) && is_float(p.y) && is_float(p.z);
    }
    for (std::size_t i = 0; i < count; ++i) size_.push_back(0.5 * glm::length(high[i] - low[i]));
}

double Precision::rounding(const DVec3& p) const {
    const int bits = float32_ ? 24 : 53;
    return std::sqrt(length2(DVec3(half_ulp(p.x, bits), half_ulp(p.y, bits), half_ulp(p.z, bits))));
}

std::vector<std::uint32_t> weld(const std::vector<DVec3>& vertices, const std::vector<double>& tolerances,
                                std::vector<DVec3>& kept) {
    std::map<int, Grid> grids;  // by exponent of the tolerance
    std::vector<std::uint32_t> target;
    target.reserve(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const DVec3& p = vertices[i];
        // The smallest double keeps a lone vertex in the origin, which has no size.
        const int exponent = std::ilogb(std::max(tolerances[i], std::numeric_limits<double>::min()));
        const auto none = static_cast<std::uint32_t>(kept.size());
        std::uint32_t found = none;
        for (const auto& [own, grid] : grids) {
            const double radius = std::ldexp(1.0, std::min(own, exponent));
            found = std::min(found, grid.lowest_near(p, radius, kept, none));
        }
        if (found == none) {
            kept.push_back(p);
            grids.try_emplace(exponent, std::ldexp(1.0, exponent)).first->second.add(p, found);
        }
        target.push_back(found);
    }
    return target;
}

}  // namespace pol
