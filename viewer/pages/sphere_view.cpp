// SPDX-License-Identifier: Apache-2.0
#include "viewer/pages/sphere_view.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"

namespace pol {

DVec3 SphereView::seen(const DVec3& s) const {
    const double cl = std::cos(longitude);
    const double sl = std::sin(longitude);
    const double cb = std::cos(latitude);
    const double sb = std::sin(latitude);
    const DVec3 towards(cb * cl, cb * sl, sb);
    const DVec3 right(-sl, cl, 0.0);
    const DVec3 up = glm::cross(towards, right);
    return {glm::dot(s, right), glm::dot(s, up), glm::dot(s, towards)};
}

void SphereView::drag(const DVec2& by) {
    longitude -= by.x;
    latitude = std::clamp(latitude + by.y, -0.5 * pi, 0.5 * pi);
}

std::array<SphereLabel, 6> sphere_labels(const Convention& convention) {
    const bool right_is_up = convention.positive_s3 == PositiveS3::right;
    return {{{{1.0, 0.0, 0.0}, "H"},
             {{-1.0, 0.0, 0.0}, "V"},
             {{0.0, 1.0, 0.0}, "+45"},
             {{0.0, -1.0, 0.0}, "-45"},
             {{0.0, 0.0, 1.0}, right_is_up ? "R" : "L"},
             {{0.0, 0.0, -1.0}, right_is_up ? "L" : "R"}}};
}

std::optional<SpherePoint> sphere_point(const Stokes<double>& light) {
    const DVec3 place = DVec3(light.s1, light.s2, light.s3) / light.s0;
    if (!(light.s0 > 0.0) || !std::isfinite(place.x + place.y + place.z)) return std::nullopt;
    SpherePoint point;
    point.place = place;
    point.intensity = light.s0;
    return point;
}

std::vector<SpherePoint> sphere_points(const ShownPicture& shown, std::size_t band, const TileRect& region,
                                       std::size_t most) {
    // The same step both ways keeps the sample a grid.
    const double share = static_cast<double>(region.pixel_count()) / static_cast<double>(most);
    const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(share))));
    std::vector<SpherePoint> points;
    if (shown.known(band) != StokesComponents::all()) return points;
    for (int y = region.y0; y < region.y1; y += step) {
        for (int x = region.x0; x < region.x1; x += step) {
            auto point = sphere_point(shown.stokes(band, shown.picture().pixel(x, y)));
            if (!point) continue;
            point->band = band;
            point->pixel = PixelAddress{x, y};
            points.push_back(*point);
        }
    }
    return points;
}

std::vector<SpherePoint> sphere_points(const Explanation& explanation, const Polarimeter& polarimeter,
                                       const Convention& convention, std::size_t most) {
    std::vector<SpherePoint> points;
    for (const int leaf : explanation.tree.leaves) {
        const RayTreeNode& node = explanation.tree.nodes[static_cast<std::size_t>(leaf)];
        if (points.size() == most) break;
        auto point =
            sphere_point(convention.stokes(polarimeter.empty() ? node.share : polarimeter.mueller() * node.share));
        if (!point) continue;
        point->band = static_cast<std::size_t>(explanation.wavelength);
        point->node = leaf;
        points.push_back(*point);
    }
    return points;
}

std::vector<bool> pixels_inside(const ShownPicture& shown, std::size_t band, const TileRect& region,
                                const SphereView& view, const std::vector<DVec2>& polygon, bool front_only) {
    const StokesImage& picture = shown.picture();
    std::vector<bool> marked(picture.pixel_count());
    if (shown.known(band) != StokesComponents::all()) return marked;
    for (int y = region.y0; y < region.y1; ++y) {
        for (int x = region.x0; x < region.x1; ++x) {
            const std::size_t pixel = picture.pixel(x, y);
            const auto point = sphere_point(shown.stokes(band, pixel));
            if (!point) continue;
            const DVec3 seen = view.seen(point->place);
            marked[pixel] = (!front_only || seen.z >= 0.0) && is_inside(polygon, {seen.x, seen.y});
        }
    }
    return marked;
}

bool is_inside(const std::vector<DVec2>& polygon, const DVec2& p) {
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const DVec2& a = polygon[i];
        const DVec2& b = polygon[j];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

}  // namespace pol
