// SPDX-License-Identifier: Apache-2.0
// The scene as lines in space, and which parts of them solids hide.
#pragma once

#include <optional>
#include <vector>

#include "core/vec.h"
#include "plan/plan.h"
#include "viewer/space/space_view.h"

namespace pol {

/// A part of a line that is hidden all along, or visible all along.
struct SpacePiece {
    SpaceLine line;
    bool hidden = false;
};

/// The visible form of one body of a plan (solids first, then surfaces).
struct BodyLines {
    int body = -1;
    std::vector<SpaceLine> edges;
    std::vector<DVec3> outline;  ///< closed polygon of an open surface; empty for others
};

/// Edges of every body: where facets meet; a ball has three great circles. Of a mesh, only edges that are sharper than
/// 10 degrees or have no neighbor, so that a smooth shape is not a solid color.
std::vector<BodyLines> body_lines(const Plan& plan);

/// The outline of a ball as `eye` sees it; empty if the eye is inside.
std::vector<SpaceLine> ball_outline(const Sphere& ball, const DVec3& eye);

/// Pieces of the line that convex solids of the plan hide from `eye`, and that they leave visible, from a to b. A solid
/// hides what lies behind it by more than a millionth of the scene, so its own front does not hide its edges.
std::vector<SpacePiece> pieces_of(const SpaceLine& line, const Plan& plan, const DVec3& eye);

/// Center and radius of a ball around the solids, or around everything if there are none.
struct BoundingBall {
    DVec3 center{};
    double radius = 1.0;
};
BoundingBall scene_ball(const std::vector<BodyLines>& bodies, const Plan& plan);

/// The optic axis of a solid, through its middle and a little out of it. Empty: not a crystal.
std::optional<SpaceLine> optic_axis(const Plan& plan, const BodyLines& body);

/// The camera's pyramid (perspective) or box (orthographic), `length` deep: the four corner rays and the far frame.
std::vector<SpaceLine> camera_lines(const Plan& plan, double length);

}  // namespace pol
