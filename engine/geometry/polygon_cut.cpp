// SPDX-License-Identifier: Apache-2.0
#include "geometry/polygon_cut.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "geometry/complaint.h"

namespace pol {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Half a second or so; lettering that is cut out of a face stays below.
constexpr std::size_t most_corners = 10'000;

/// How far corners may lie off the plane: by a thousandth of the width, or by half a unit of the sixth digit of the
/// coordinates, which is all that many programs write, but not by more than a few hundredths.
double flatness(double width, double largest_coordinate) {
    return std::clamp(5e-6 * largest_coordinate, 1e-3 * width, 3e-2 * width);
}

/// Of the largest coordinate: corners nearer to each other are one, as the sine of pi and 0 are at the pole of a
/// sphere.
constexpr double same_place = 1e-12;

Error broken(std::string what) {
    return complaint("", std::move(what), "cut it into simple faces or triangles in a modeling program");
}

std::string corner_text(const DVec3& p) {
    char buffer[96];
    std::snprintf(buffer, sizeof buffer, "(%.6g, %.6g, %.6g)", p.x, p.y, p.z);
    return buffer;
}

double cross2(const DVec2& u, const DVec2& v) {
    return u.x * v.y - u.y * v.x;
}

/// Sign of the turn at b on the way from a to c, + to the left; 0 if rounding hides it (J. R. Shewchuk, Discrete
/// Comput. Geom. 18, 1997: the error of the determinant is below 3.4e-16 of the sum of its terms).
int turn(const DVec2& a, const DVec2& b, const DVec2& c) {
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double error = 3.4e-16 * (std::abs(left) + std::abs(right));
    return left - right > error ? 1 : left - right < -error ? -1 : 0;
}

bool in_box(const DVec2& a, const DVec2& b, const DVec2& p) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

enum class Contact { none, touch, cross };

/// Of the segments a-b and c-d.
Contact contact(const DVec2& a, const DVec2& b, const DVec2& c, const DVec2& d) {
    if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
        std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
        return Contact::none;
    const int at_c = turn(a, b, c);
    const int at_d = turn(a, b, d);
    const int at_a = turn(c, d, a);
    const int at_b = turn(c, d, b);
    if (at_c * at_d < 0 && at_a * at_b < 0) return Contact::cross;
    const bool touch = (at_c == 0 && in_box(a, b, c)) || (at_d == 0 && in_box(a, b, d)) ||
                       (at_a == 0 && in_box(c, d, a)) || (at_b == 0 && in_box(c, d, b));
    return touch ? Contact::touch : Contact::none;
}

/// From the first corner to the one furthest from it, and to the one furthest from the line through both.
std::pair<DVec3, DVec3> widest_corner(std::span<const DVec3> corners) {
    const auto furthest = [&](const auto& distance) {
        return *std::max_element(corners.begin(), corners.end(),
                                 [&](const DVec3& p, const DVec3& q) { return distance(p) < distance(q); });
    };
    const DVec3& first = corners[0];
    const DVec3 along = furthest([&](const DVec3& p) { return length2(p - first); }) - first;
    return {along, furthest([&](const DVec3& p) { return length2(cross(along, p - first)); }) - first};
}

/// Ear clipping (G. H. Meisters, Amer. Math. Monthly 82, 1975), the best ear first: the one whose cut leaves the widest
/// gap to all that is left, so that corners in the middle of a side make no empty triangles.
class EarClipper {
public:
    /// `outline`: simple, counter-clockwise.
    explicit EarClipper(std::span<const DVec2> outline) : p_(outline) {
        const auto count = static_cast<std::uint32_t>(p_.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            next_.push_back((i + 1) % count);
            before_.push_back((i + count - 1) % count);
        }
        for (std::uint32_t i = 0; i < count; ++i) gap_.push_back(gap_at(i));
    }

    std::vector<Triangle> cut() {
        std::vector<Triangle> triangles;
        std::uint32_t start = 0;
        for (std::size_t left = p_.size(); left > 2; --left) {
            std::uint32_t ear = start;
            for (std::uint32_t i = next_[start]; i != start; i = next_[i]) {
                if (gap_[i] > gap_[ear]) ear = i;
            }
            if (!(gap_[ear] > 0.0)) break;
            const std::uint32_t a = before_[ear];
            const std::uint32_t c = next_[ear];
            triangles.push_back({a, ear, c});
            next_[a] = c;
            before_[c] = a;
            start = c;
            gap_[a] = gap_at(a);
            gap_[c] = gap_at(c);
        }
        return triangles;
    }

private:
    /// Least of the ear's height and the distances of all other corners from its cut; 0 if `ear` is none.
    double gap_at(std::uint32_t ear) const {
        const DVec2& a = p_[before_[ear]];
        const DVec2& b = p_[ear];
        const DVec2& c = p_[next_[ear]];
        if (turn(a, b, c) <= 0) return 0.0;
        const double longest = std::sqrt(std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)}));
        double gap = cross2(b - a, c - a) / longest;
        const DVec2 along = c - a;
        for (std::uint32_t i = next_[next_[ear]]; i != before_[ear]; i = next_[i]) {
            const DVec2& p = p_[i];
            if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return 0.0;
            const double share = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
            gap = std::min(gap, glm::distance(p, a + share * along));
        }
        return gap;
    }

    std::span<const DVec2> p_;
    std::vector<std::uint32_t> next_, before_;
    std::vector<double> gap_;
};

/// Twice the area, positive counter-clockwise.
double area2(std::span<const DVec2> p, std::span<const Triangle> triangles) {
    double sum = 0.0;
    for (const auto& [a, b, c] : triangles) sum += std::abs(cross2(p[b] - p[a], p[c] - p[a]));
    return sum;
}

double area2(std::span<const DVec2> outline) {
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < outline.size(); ++i)
        sum += cross2(outline[i] - outline[0], outline[i + 1] - outline[0]);
    return sum;
}

std::optional<Error> self_contact(std::span<const DVec2> outline, std::span<const DVec3> corners) {
    const std::size_t count = outline.size();
    for (std::size_t i = 0; i < count; ++i) {
        const DVec2& b = outline[(i + 1) % count];
        const DVec2& c = outline[(i + 2) % count];
        if (turn(outline[i], b, c) == 0 && dot(b - outline[i], c - b) < 0.0)
            return broken("runs back along its own side near " + corner_text(corners[(i + 1) % count]));
    }
    for (std::size_t i = 0; i < count; ++i) {
        const DVec2& a = outline[i];
        const DVec2& b = outline[(i + 1) % count];
        for (std::size_t j = i + 2; j < count && (j + 1) % count != i; ++j) {
            const Contact found = contact(a, b, outline[j], outline[(j + 1) % count]);
            if (found == Contact::none) continue;
            const std::string place = corner_text(corners[turn(a, b, outline[j]) == 0 ? j : (j + 1) % count]);
            if (found == Contact::cross) return broken("crosses itself near " + place);
            return broken("touches itself near " + place + ", as the outline of a face with a hole does");
        }
    }
    return std::nullopt;
}

}  // namespace

Result<std::vector<Triangle>> cut_polygon(std::span<const DVec3> given) {
    double largest = 0.0;
    for (const DVec3& p : given) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    std::vector<std::uint32_t> kept;
    std::vector<DVec3> corners;
    for (std::uint32_t i = 0; i < given.size(); ++i) {
        if (glm::distance(given[i], given[(i + 1) % given.size()]) <= same_place * largest) continue;
        kept.push_back(i);
        corners.push_back(given[i]);
    }
    if (corners.size() > most_corners) return broken("has more than 10000 corners");
    if (corners.size() < 3) return broken("has all its corners in one line");
    const auto [along, across] = widest_corner(corners);
    const DVec3 normal = cross(along, across);
    if (!std::isfinite(length2(normal))) return broken("is too large for its area to be calculated");
    const double width = std::sqrt(length2(normal) / length2(along));
    if (!(width > 1e-12 * glm::length(along))) return broken("has all its corners in one line");

    const DVec3 upward = unit(normal);
    double low = 0.0;
    double high = 0.0;
    for (const DVec3& p : corners) {
        const double height = dot(upward, p - corners[0]);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    if (0.5 * (high - low) > flatness(width, largest)) {
        char bend[32];
        std::snprintf(bend, sizeof bend, "%.3g", 0.5 * (high - low));
        return broken("is not flat: its corners lie up to " + std::string(bend) + " off any plane, near " +
                      corner_text(corners[0]));
    }

    // Without the coordinate that the normal is longest in: the others keep their bits.
    const DVec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::vector<DVec2> outline;
    for (const DVec3& p : corners) outline.emplace_back(p[(axis + 1) % 3], p[(axis + 2) % 3]);
    if (auto problem = self_contact(outline, corners)) return *problem;
    const double area = area2(outline);
    if (area < 0.0) {
        for (DVec2& p : outline) p.x = -p.x;
    }
    std::vector<Triangle> triangles = EarClipper(outline).cut();
    // Too little where rounding hid every ear.
    if (!(std::abs(area2(outline, triangles) - std::abs(area)) <= 1e-9 * std::abs(area)))
        return broken("cannot be cut into triangles near " + corner_text(corners[0]));
    for (Triangle& t : triangles) {
        for (std::uint32_t& v : t) v = kept[v];
    }
    return triangles;
}

}  // namespace pol
