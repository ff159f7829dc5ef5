// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "scene/node_budget.h"

namespace pol {
namespace {

Scene stones(const Matter& matter, int count, SampleMode mode) {
    Scene scene;
    scene.media.push_back({"matter", matter, {}});
    for (int i = 0; i < count; ++i)
        scene.objects.push_back({"stone", SphereShape{}, DMat4(1.0), FilledWith{"matter"}, {}, {}});
    scene.render.mode = mode;
    return scene;
}

const Matter glass = IsotropicMedium{ConstantIndex{{1.5, 0.0}}, {}};
const Matter equal_indices = UniaxialMedium{ConstantIndex{{1.5, 0.0}}, ConstantIndex{{1.5, 0.0}}, {0.0, 0.0, 1.0}};
const Matter crystal = UniaxialMedium{ConstantIndex{{1.6, 0.0}}, ConstantIndex{{1.5, 0.0}}, {0.0, 0.0, 1.0}};

TEST(NodeBudget, IsSmallWhereTreesBranchAndThePixelAveragesItsTails) {
    EXPECT_EQ(usual_node_budget(stones(crystal, 1, SampleMode::area)), 12);
    EXPECT_EQ(usual_node_budget(stones(crystal, 1, SampleMode::point)), 1000);
    EXPECT_EQ(usual_node_budget(stones(glass, 2, SampleMode::area)), 12) << "from one stone into the other and back";
    EXPECT_EQ(usual_node_budget(stones(glass, 1, SampleMode::area)), 1000) << "one open branch at a time";
    EXPECT_EQ(usual_node_budget(stones(equal_indices, 1, SampleMode::area)), 1000) << "a crystal that is glass";
    Scene behind_a_foil = stones(glass, 1, SampleMode::area);
    behind_a_foil.objects.push_back({"foil", RectangleShape{}, DMat4(1.0), Sheet{}, {}, {}});
    EXPECT_EQ(usual_node_budget(behind_a_foil), 12);
}

TEST(NodeBudget, IsThatOfTheSceneIfItHasOneAndNoneBesideADepthLimit) {
    Scene scene = stones(crystal, 1, SampleMode::area);
    scene.render.node_budget = 7;
    EXPECT_EQ(node_budget_in_force(scene), 7);
    scene.render.cut_by_depth_alone(9);
    EXPECT_EQ(node_budget_in_force(scene), RenderSettings::whole_tree);
}

}  // namespace
}  // namespace pol
