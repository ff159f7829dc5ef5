// SPDX-License-Identifier: Apache-2.0
// The paths of a pixel's tree as lines in space, and the light on one of them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "tracer/tree_names.h"
#include "viewer/space/space_view.h"

namespace pol {

struct PathSegment {
    SpaceLine line;  ///< from where the backward ray left to where it arrived
    PathKind kind{};
    double weight = 0.0;  ///< share of the pixel's throughput, 0 to 1
    int node = -1;        ///< index into RayTree::nodes
};

/// Segments of the `most` heaviest branches, heaviest last (on top). A branch that met nothing is `open_length` long,
/// one that was not followed a tenth of it.
std::vector<PathSegment> path_segments(const RayTree& tree, double open_length, std::size_t most);

/// Segment on screen nearest to `at`, no farther away than `reach` points; of those that are hit (nearer than three
/// points) and of equally near ones the one drawn on top. Returns its node.
std::optional<int> node_at(std::span<const PathSegment> segments, const SpaceView& view, const DVec2& size,
                           const DVec2& at, double reach);

/// The tip of the electric field of the polarized part of the light on a branch, over one period.
struct FieldFigure {
    DVec3 center{};
    DVec3 x{};  ///< axes E1, E2 of the light, as long as the figure is high; y is 0 for a mode
    DVec3 y{};
    std::vector<DVec3> tips;  ///< in the order of time, closed; empty for unpolarized light
};

/// In the frame of the branch's light, in the middle of its line or three radii before its end, at most `radius` large:
/// sqrt(degree of polarization) of it. Empty if the light is not known (random tail) or if there is none.
std::optional<FieldFigure> field_figure(const RayTreeNode& node, const SpaceLine& line, double radius);

}  // namespace pol
