// SPDX-License-Identifier: Apache-2.0
// The 3-D view without a screen: where points lie, which edges a solid hides, which branch a click means.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/shapes.h"
#include "io/scenes/scene_file.h"
#include "plan/compile.h"
#include "support/lit_trees.h"
#include "viewer/space/space_paths.h"
#include "viewer/space/space_view.h"
#include "viewer/space/space_wireframe.h"

namespace pol {
namespace {

const DVec2 panel(400.0, 300.0);

/// From (3, 0, 0) towards the origin, z up.
SpaceView from_x() {
    SpaceView view = SpaceView::around({0.0, 0.0, 0.0}, 1.0, {3.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
    view.zoom(view.distance() / 3.0);
    return view;
}

TEST(SpaceView, PutsPointsWhereAPinholeCameraSeesThem) {
    const SpaceView view = from_x();
    EXPECT_NEAR(glm::length(view.eye() - DVec3(3.0, 0.0, 0.0)), 0.0, 1e-12);
    // 20 degrees up are half of the shorter side of the panel. With x towards the eye and z up, y is to the right.
    const double scale = 150.0 / std::tan(20.0 * pi / 180.0);
    for (const DVec3& p : {DVec3(0.0, 0.0, 0.0), DVec3(0.0, 0.5, 0.0), DVec3(1.0, -0.2, 0.7), DVec3(-2.0, 0.3, -0.4)}) {
        const auto at = view.project(p, panel);
        ASSERT_TRUE(at);
        EXPECT_NEAR(at->depth, 3.0 - p.x, 1e-12);
        EXPECT_NEAR(at->at.x, 200.0 + scale * p.y / (3.0 - p.x), 1e-9);
        EXPECT_NEAR(at->at.y, 150.0 - scale * p.z / (3.0 - p.x), 1e-9);
    }
    EXPECT_FALSE(view.project(DVec3(4.0, 0.0, 0.0), panel)) << "behind the eye";
}

TEST(SpaceView, KeepsTheVisiblePartOfALineThatGoesBehindTheEye) {
    const SpaceView view = from_x();
    const auto ends = view.project(SpaceLine{{0.0, 1.0, 0.0}, {6.0, 1.0, 0.0}}, panel);
    ASSERT_TRUE(ends);
    EXPECT_NEAR(ends->first.at.x, view.project(DVec3(0.0, 1.0, 0.0), panel)->at.x, 1e-9);
    EXPECT_GT(ends->second.at.x, 1000.0);
    EXPECT_FALSE(view.project(SpaceLine{{4.0, 1.0, 0.0}, {6.0, 1.0, 0.0}}, panel));
}

TEST(SpaceView, PanMovesTheTargetWithTheMouseAndZoomGoesNearer) {
    SpaceView view = from_x();
    view.pan({30.0, -20.0}, panel);
    const auto at = view.project(DVec3(0.0, 0.0, 0.0), panel);
    EXPECT_NEAR(at->at.x, 230.0, 1e-9);
    EXPECT_NEAR(at->at.y, 130.0, 1e-9);
    view = from_x();
    view.zoom(2.0);
    EXPECT_NEAR(glm::length(view.eye()), 1.5, 1e-12);
    view.orbit({300.0, 0.0});
    EXPECT_NEAR(std::abs(view.eye().y), 1.5, 1e-12) << "300 points are a quarter of a turn";
}

Plan plan_with(std::variant<HalfSpaceSolid, Sphere, MeshBody> shape) {
    Plan plan;
    plan.length_scale = 2.0;
    plan.solids.push_back({"solid", 0, 0, std::nullopt, std::move(shape), {}, {}, {}});
    return plan;
}

/// The cube from -1 to 1.
Plan cube_plan() {
    const Plane faces[] = {{{1.0, 0.0, 0.0}, 1.0},  {{-1.0, 0.0, 0.0}, 1.0}, {{0.0, 1.0, 0.0}, 1.0},
                           {{0.0, -1.0, 0.0}, 1.0}, {{0.0, 0.0, 1.0}, 1.0},  {{0.0, 0.0, -1.0}, 1.0}};
    return plan_with(HalfSpaceSolid::from_planes(faces).value());
}

// From in front of a corner one sees nine edges of a cube; the three that meet in the far corner are hidden.
TEST(SpaceWireframe, HidesTheThreeFarEdgesOfACube) {
    const Plan plan = cube_plan();
    const DVec3 eye(5.0, 4.0, 3.0);
    const auto bodies = body_lines(plan);
    ASSERT_EQ(bodies.size(), 1U);
    ASSERT_EQ(bodies[0].edges.size(), 12U);
    const DVec3 far_corner(-1.0, -1.0, -1.0);
    int hidden = 0;
    for (const SpaceLine& edge : bodies[0].edges) {
        const auto pieces = pieces_of(edge, plan, eye);
        ASSERT_EQ(pieces.size(), 1U);
        const bool meets_far_corner =
            glm::length(edge.a - far_corner) < 1e-9 || glm::length(edge.b - far_corner) < 1e-9;
        EXPECT_EQ(pieces[0].hidden, meets_far_corner);
        hidden += pieces[0].hidden ? 1 : 0;
    }
    EXPECT_EQ(hidden, 3);
}

// The cube's shadow on a line behind it: rays from (4, 0, 0) past the edges of the front face, x = 1, y = +-1.
TEST(SpaceWireframe, CutsALineWhereTheCubesShadowEnds) {
    const auto pieces = pieces_of({{-2.0, -5.0, 0.0}, {-2.0, 5.0, 0.0}}, cube_plan(), {4.0, 0.0, 0.0});
    ASSERT_EQ(pieces.size(), 3U);
    EXPECT_FALSE(pieces[0].hidden);
    EXPECT_TRUE(pieces[1].hidden);
    EXPECT_FALSE(pieces[2].hidden);
    EXPECT_NEAR(pieces[1].line.a.y, -2.0, 1e-4);
    EXPECT_NEAR(pieces[1].line.b.y, 2.0, 1e-4);
    const auto in_front = pieces_of({{2.0, -5.0, 0.0}, {2.0, 5.0, 0.0}}, cube_plan(), {4.0, 0.0, 0.0});
    ASSERT_EQ(in_front.size(), 1U);
    EXPECT_FALSE(in_front[0].hidden);
}

// Tangents from (2, 0, 0) to the unit ball leave at 30 degrees to the axis.
TEST(SpaceWireframe, CutsALineWhereTheBallsShadowEnds) {
    const Plan plan = plan_with(Sphere{{0.0, 0.0, 0.0}, 1.0});
    const DVec3 eye(2.0, 0.0, 0.0);
    const auto pieces = pieces_of({{-1.0, -6.0, 0.0}, {-1.0, 6.0, 0.0}}, plan, eye);
    ASSERT_EQ(pieces.size(), 3U);
    EXPECT_TRUE(pieces[1].hidden);
    EXPECT_NEAR(pieces[1].line.a.y, -std::sqrt(3.0), 1e-4);
    EXPECT_NEAR(pieces[1].line.b.y, std::sqrt(3.0), 1e-4);
    for (const SpaceLine& line : ball_outline(Sphere{{0.0, 0.0, 0.0}, 1.0}, eye)) {
        EXPECT_NEAR(glm::length(line.a), 1.0, 1e-12);
        EXPECT_NEAR(dot(unit(line.a - eye), line.a), 0.0, 1e-12) << "lines of sight touch the ball there";
    }
}

class Paths : public testing::Test {
protected:
    void SetUp() override {
        const auto scene = load_scene(std::filesystem::path(POL_ASSETS) / "scenes" / "cube-calcite.yaml");
        ASSERT_TRUE(scene) << to_string(scene.error());
        const auto compiled = compile(scene.value());
        ASSERT_TRUE(compiled) << to_string(compiled.error());
        plan_ = compiled.value();
        explanation_ = explain(*plan_, plan_->settings.width / 2, plan_->settings.height / 2, 0, 0);
    }
    std::shared_ptr<const Plan> plan_;
    Explanation explanation_;
};

TEST_F(Paths, AreTheBranchesOfTheTreeHeaviestOnTop) {
    const auto segments = path_segments(explanation_.tree, 10.0, 40);
    ASSERT_EQ(segments.size(), std::min<std::size_t>(40, explanation_.tree.nodes.size()));
    EXPECT_EQ(segments.back().node, 0);
    EXPECT_EQ(segments.back().kind, PathKind::camera);
    EXPECT_EQ(segments.back().line.a, explanation_.task.ray.origin);
    bool has_ordinary = false;
    bool has_extraordinary = false;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        EXPECT_LE(segments[i == 0 ? 0 : i - 1].weight, segments[i].weight);
        const RayTreeNode& node = explanation_.tree.nodes[static_cast<std::size_t>(segments[i].node)];
        if (node.parent >= 0) {
            const RayTreeNode& parent = explanation_.tree.nodes[static_cast<std::size_t>(node.parent)];
            EXPECT_NEAR(glm::length(segments[i].line.a - parent.end.origin), 0.0, 1e-9)
                << "begins where its parent ends";
        }
        has_ordinary = has_ordinary || segments[i].kind == PathKind::ordinary;
        has_extraordinary = has_extraordinary || segments[i].kind == PathKind::extraordinary;
    }
    EXPECT_TRUE(has_ordinary);
    EXPECT_TRUE(has_extraordinary);
}

TEST_F(Paths, AClickOnASegmentFindsItsBranch) {
    const auto segments = path_segments(explanation_.tree, 10.0, 5);
    const BoundingBall ball = scene_ball(body_lines(*plan_), *plan_);
    const SpaceView view =
        SpaceView::around(ball.center, ball.radius, ball.center + DVec3(1.0, 2.0, 0.5), {0.0, 1.0, 0.0});
    for (const PathSegment& segment : segments) {
        const auto ends = view.project(segment.line, panel);
        ASSERT_TRUE(ends);
        const DVec2 at = 0.4 * ends->first.at + 0.6 * ends->second.at;
        const auto found = node_at(segments, view, panel, at, 6.0);
        ASSERT_TRUE(found);
        // Another branch may lie on the very same line; then it is the one on top.
        if (*found == segment.node) continue;
        const auto other =
            std::find_if(segments.begin(), segments.end(), [&](const PathSegment& s) { return s.node == *found; });
        EXPECT_GE(other->weight, segment.weight);
    }
    EXPECT_FALSE(node_at(segments, view, panel, {-500.0, -500.0}, 6.0));
}

RayTreeNode camera_branch(const Stokes<double>& light) {
    RayTreeNode node;
    node.start.wave.ray = {0.0, 0.0, -1.0};
    node.start.wave.k = {0.0, 0.0, -1.0};
    node.start.wave.field[0] = {1.0, 0.0, 0.0};
    node.start.wave.field[1] = {0.0, 1.0, 0.0};
    node.arriving = to_coherence(light);
    return node;
}

// Right-handed: the field turns clockwise for the receiver, who looks along the backward ray, here -z.
TEST(FieldFigure, TurnsClockwiseForTheReceiverOfRightHandedLight) {
    for (const double handedness : {1.0, -1.0}) {
        const RayTreeNode node = camera_branch({1.0, 0.0, 0.0, handedness});
        const auto figure = field_figure(node, {{0.0, 0.0, 0.0}, {0.0, 0.0, -2.0}}, 0.5);
        ASSERT_TRUE(figure);
        EXPECT_EQ(figure->center, DVec3(0.0, 0.0, -1.0));
        for (std::size_t i = 0; i + 1 < figure->tips.size(); ++i) {
            const DVec3 now = figure->tips[i] - figure->center;
            const DVec3 next = figure->tips[i + 1] - figure->center;
            EXPECT_NEAR(glm::length(now), 0.5 / std::sqrt(2.0), 1e-12) << "circular";
            EXPECT_GT(dot(cross(now, next), node.start.wave.ray) * handedness, 0.0);
        }
    }
}

TEST(FieldFigure, LiesAlongTheAzimuthOfLinearLightAndVanishesWithoutPolarization) {
    const auto diagonal = field_figure(camera_branch({1.0, 0.0, 1.0, 0.0}), {{}, {0.0, 0.0, -2.0}}, 0.5);
    ASSERT_TRUE(diagonal);
    for (const DVec3& tip : diagonal->tips) EXPECT_NEAR(tip.x, tip.y, 1e-12);
    EXPECT_NEAR(glm::length(diagonal->tips[0] - diagonal->center), 0.5, 1e-12);
    const auto natural = field_figure(camera_branch({1.0, 0.0, 0.0, 0.0}), {{}, {0.0, 0.0, -2.0}}, 0.5);
    ASSERT_TRUE(natural);
    EXPECT_TRUE(natural->tips.empty());
    EXPECT_FALSE(field_figure(RayTreeNode{}, {}, 0.5)) << "light that is not known";
}

// The tips are Re[v exp(-i omega t)]: v is their first Fourier coefficient, v v^H the polarized part of the light,
// whose power is its share of S0.
TEST(FieldFigure, IsTheEllipseOfTheClosedFormOnEveryBranch) {
    constexpr double radius = 0.5;
    test::for_each_lit_branch([](const Plan&, const Explanation& e, int branch, const test::BranchLight& expected) {
        const RayTreeNode& node = e.tree.nodes[static_cast<std::size_t>(branch)];
        const auto figure = field_figure(node, {node.start.origin, node.start.origin + node.start.wave.ray}, radius);
        ASSERT_EQ(figure.has_value(), expected.light.s0 > 1e-12);
        if (!figure) return;
        const DVec3 k = -node.start.wave.ray;
        const DVec3 y = cross(k, expected.x);
        JonesVector<double> v;
        const auto count = static_cast<double>(figure->tips.size());
        for (std::size_t i = 0; i < figure->tips.size(); ++i) {
            const DVec3 tip = (figure->tips[i] - figure->center) / radius;
            EXPECT_NEAR(dot(tip, k), 0.0, test::lit_rounding) << "across the light";
            const Complex<double> phase = unit_phase(2.0 * pi * static_cast<double>(i) / count);
            v.x += (2.0 / count * dot(tip, expected.x)) * phase;
            v.y += (2.0 / count * dot(tip, y)) * phase;
        }
        const Stokes<double> share = (1.0 / expected.light.s0) * expected.light;
        // Of light near a pole of the figure's formula, sqrt(p +- s1), half of the digits are left.
        test::expect_stokes(to_stokes(CoherenceMatrix<double>::outer(v)),
                            {polarized_part(share), share.s1, share.s2, share.s3}, 1e-7);
    });
}

}  // namespace
}  // namespace pol
