// SPDX-License-Identifier: Apache-2.0
#include "geometry/brilliant.h"

#include <cmath>
#include <string>
#include <vector>

#include "core/units.h"
#include "geometry/complaint.h"
#include "geometry/polytope.h"

namespace pol {
namespace {

constexpr double sixteenth = pi / 8.0;

DVec3 at(double radius, int sixteenths, double z) {
    const double azimuth = sixteenths * sixteenth;
    return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
}

// Plane through three points, counter-clockwise seen from outside.
Plane through(const DVec3& a, const DVec3& b, const DVec3& c) {
    const DVec3 normal = unit(cross(b - a, c - a));
    return {normal, dot(normal, (a + b + c) / 3.0)};
}

// Plane whose slope faces `sixteenths`, through `p`; `slope` from the horizontal, `up` +1 (crown) or -1 (pavilion).
Plane sloped(double slope, int sixteenths, double up, const DVec3& p) {
    const DVec3 outward = at(std::sin(slope), sixteenths, up * std::cos(slope));
    return {outward, dot(outward, p)};
}

Result<Done> check(const BrilliantShape& s) {
    const auto within = [](double x, double low, double high) { return x > low && x < high; };
    const auto bad = [](const char* field, const char* what, const char* hint) { return complaint(field, what, hint); };
    if (!(s.diameter > 0.0) || !std::isfinite(s.diameter)) {
        return bad("diameter", "must be positive and finite", "lengths are in scene units, for example 2");
    }
    if (!within(s.table_ratio, 0.0, 1.0)) return bad("table_ratio", "must lie between 0 and 1", "0.57 is usual");
    if (!within(s.crown_angle, 0.0, pi / 2.0)) {
        return bad("crown_angle", "must lie between 0 and 90 degrees", "34.5 degrees is usual");
    }
    if (!within(s.pavilion_angle, 0.0, pi / 2.0)) {
        return bad("pavilion_angle", "must lie between 0 and 90 degrees", "40.75 degrees is usual");
    }
    if (!(s.girdle_ratio > 0.0) || !std::isfinite(s.girdle_ratio)) {
        return bad("girdle_ratio", "must be positive and finite", "0.03 is usual; a knife edge has no girdle facets");
    }
    if (!within(s.star_length, 0.0, 1.0)) return bad("star_length", "must lie between 0 and 1", "0.55 is usual");
    if (!within(s.lower_half_length, 0.0, 1.0)) {
        return bad("lower_half_length", "must lie between 0 and 1", "0.77 is usual");
    }
    return Done{};
}

}  // namespace

Result<Mesh> make_brilliant(const BrilliantShape& s) {
    POL_TRY_DONE(check(s));
    const double radius = 0.5 * s.diameter;
    const double table_radius = radius * s.table_ratio;
    const double top = 0.5 * s.girdle_ratio * s.diameter;
    const double bottom = -top;
    const double crown_rise = std::tan(s.crown_angle);
    const double pavilion_rise = std::tan(s.pavilion_angle);
    const double table = top + (radius - table_radius) * crown_rise;
    const double half_step = std::cos(sixteenth);

    // Stars end, and upper halves begin, on the edge between two bezels: below the table only if far enough out.
    const double table_edge = table_radius * half_step;
    const double star_radius = table_edge + s.star_length * (radius - table_edge);
    const double star_z = top + (radius - star_radius * half_step) * crown_rise;
    if (!(star_radius * half_step > table_radius)) {
        return complaint("star_length", "the stars end inside the table",
                         "make star_length larger or table_ratio smaller");
    }
    const double lower_radius = radius * (1.0 - s.lower_half_length);
    const double lower_z = bottom - (radius - lower_radius * half_step) * pavilion_rise;

    std::vector<Plane> planes{{{0.0, 0.0, 1.0}, table}};
    for (int k = 0; k < 16; k += 2) planes.push_back(sloped(s.crown_angle, k, 1.0, at(radius, k, top)));
    for (int k = 0; k < 16; k += 2) {
        planes.push_back(
            through(at(table_radius, k, table), at(star_radius, k + 1, star_z), at(table_radius, k + 2, table)));
    }
    for (int k = 0; k < 16; ++k) {
        const int star = k % 2 == 0 ? k + 1 : k;
        planes.push_back(through(at(radius, k, top), at(radius, k + 1, top), at(star_radius, star, star_z)));
    }
    for (int k = 0; k < 16; ++k) {
        planes.push_back(through(at(radius, k, bottom), at(radius, k + 1, bottom), at(radius, k, top)));
    }
    for (int k = 0; k < 16; ++k) {
        const int meet = k % 2 == 0 ? k + 1 : k;
        planes.push_back(through(at(radius, k + 1, bottom), at(radius, k, bottom), at(lower_radius, meet, lower_z)));
    }
    for (int k = 0; k < 16; k += 2) planes.push_back(sloped(s.pavilion_angle, k, -1.0, at(radius, k, bottom)));

    Result<Mesh> mesh = mesh_from_planes(planes);
    if (mesh) return mesh;
    return complaint("", "these proportions leave a facet without area: " + mesh.error().what,
                     "stay near table 0.57, crown 34.5, pavilion 40.75 degrees, star 0.55, lower half 0.77");
}

}  // namespace pol
