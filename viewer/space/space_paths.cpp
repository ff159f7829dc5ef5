// SPDX-License-Identifier: Apache-2.0
#include "viewer/space/space_paths.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/units.h"
#include "polarization/measures.h"

namespace pol {

std::vector<PathSegment> path_segments(const RayTree& tree, double open_length, std::size_t most) {
    const auto weight_of = [&](int node) { return tree.nodes[static_cast<std::size_t>(node)].start.weight; };
    std::vector<int> order(tree.nodes.size());
    std::iota(order.begin(), order.end(), 0);
    const auto kept = order.begin() + static_cast<std::ptrdiff_t>(std::min(most, order.size()));
    std::partial_sort(order.begin(), kept, order.end(),
                      [&](int a, int b) { return weight_of(a) != weight_of(b) ? weight_of(a) > weight_of(b) : a < b; });
    std::vector<PathSegment> segments;
    for (auto index = kept; index != order.begin();) {
        --index;
        const RayTreeNode& node = tree.nodes[static_cast<std::size_t>(*index)];
        const bool met_something = node.arrived && node.crossing.body >= 0;
        const PathKind kind = kind_of(node);
        const double length = kind == PathKind::not_followed ? 0.1 * open_length : open_length;
        const DVec3 end = met_something ? node.end.origin : node.start.origin + length * node.start.wave.ray;
        segments.push_back({{node.start.origin, end}, kind, node.start.weight, *index});
    }
    return segments;
}

std::optional<int> node_at(std::span<const PathSegment> segments, const SpaceView& view, const DVec2& size,
                           const DVec2& at, double reach) {
    std::optional<int> found;
    double least = reach;
    for (const PathSegment& segment : segments) {
        const auto ends = view.project(segment.line, size);
        if (!ends) continue;
        const DVec2 way = ends->second.at - ends->first.at;
        const double length2 = dot(way, way);
        const double t = length2 > 0.0 ? std::clamp(dot(at - ends->first.at, way) / length2, 0.0, 1.0) : 0.0;
        constexpr double hit = 3.0;
        const double distance = std::max(hit, glm::length(at - ends->first.at - t * way));
        if (distance > least) continue;
        least = distance;
        found = segment.node;
    }
    return found;
}

std::optional<FieldFigure> field_figure(const RayTreeNode& node, const SpaceLine& line, double radius) {
    if (!node.arriving) return std::nullopt;
    const Wave<double>& wave = node.start.wave;
    const bool is_mode = wave.mode_count() == 1;
    const Stokes<double> s = to_stokes(*node.arriving);
    if (!(s.s0 > 0.0)) return std::nullopt;

    FieldFigure figure;
    // A camera may be far away from what it looks at.
    const double length = glm::length(line.a - line.b);
    figure.center = line.b + (line.a - line.b) * (length > 6.0 * radius ? 3.0 * radius / length : 0.5);
    figure.x = radius * wave.field[0];
    if (!is_mode) figure.y = radius * wave.field[1];

    // Jones vector of the polarized part, |v|^2 = DoP, with a real x component.
    const double polarized = polarized_part(s);
    if (polarized <= noise_threshold(1000.0) * s.s0) return figure;
    const double x = std::sqrt(std::max(0.0, polarized + s.s1) / (2.0 * s.s0));
    const double y_size = std::sqrt(std::max(0.0, polarized - s.s1) / (2.0 * s.s0));
    // <E_x E_y*> = (S2 + i S3) / 2, so y lags behind x by this phase.
    const double phase = std::atan2(s.s3, s.s2);
    constexpr int steps = 64;
    for (int i = 0; i < steps; ++i) {
        const double time = 2.0 * pi * i / steps;
        // Re(v exp(-i omega t)) with v = (x, y exp(-i phase)).
        figure.tips.push_back(figure.center + x * std::cos(time) * figure.x +
                              y_size * std::cos(time + phase) * figure.y);
    }
    return figure;
}

}  // namespace pol
