// SPDX-License-Identifier: Apache-2.0
// The list of paths: filters against a walk from every leaf to the camera.
#include <gtest/gtest.h>

#include <cstdio>

#include "support/lit_trees.h"
#include "support/shipped_scenes.h"
#include "tracer/tree_names.h"
#include "viewer/pages/branch_page.h"
#include "viewer/pages/path_list.h"

namespace pol {
namespace {

struct Tree {
    std::shared_ptr<const Plan> plan;
    std::shared_ptr<const Explanation> explanation;
    [[nodiscard]] const RayTreeNode& node(int i) const { return explanation->tree.nodes[static_cast<std::size_t>(i)]; }
};

Tree tree_of(const std::string& scene, double x, double y) {
    Tree tree;
    tree.plan = test::plan_of(test::shipped_scene(scene));
    const RenderSettings& settings = tree.plan->settings;
    tree.explanation = std::make_shared<const Explanation>(
        explain(*tree.plan, static_cast<int>(x * settings.width), static_cast<int>(y * settings.height), 0, 0));
    return tree;
}

PathList list_of(const Tree& tree) {
    PathList list;
    list.set_tree(tree.plan, tree.explanation);
    return list;
}

/// Counts the leaves for which `wanted` holds for some branch, or for all, on the way to the camera.
template <class Wanted>
PathCount some_on_the_way(const Tree& tree, const Wanted& wanted) {
    PathCount count;
    for (const int leaf : tree.explanation->tree.leaves) {
        bool found = false;
        for (int i = leaf; i >= 0; i = tree.node(i).parent) found |= wanted(i);
        if (!found) continue;
        ++count.leaves;
        count.s0 += tree.node(leaf).light.s0;
        count.weight += tree.node(leaf).end.weight;
    }
    return count;
}

void expect_same(const PathCount& a, const PathCount& b) {
    EXPECT_EQ(a.leaves, b.leaves);
    EXPECT_EQ(a.s0, b.s0);
    EXPECT_EQ(a.weight, b.weight);
}

const std::vector<Tree>& trees() {
    static const std::vector<Tree> all{tree_of("cube-calcite", 0.5, 0.47), tree_of("paper-calcite-polarized", 0.5, 0.6),
                                       tree_of("wollaston", 0.4, 0.5), tree_of("cube-glass", 0.5, 0.47)};
    return all;
}

TEST(PathList, ListsEveryLeafWithoutAFilter) {
    for (const Tree& tree : trees()) {
        PathList list = list_of(tree);
        EXPECT_EQ(list.shown().leaves, tree.explanation->tree.leaves.size());
        EXPECT_EQ(list.shown().s0, tree.explanation->leaf_sum.s0);
        list.open_all(true);
        EXPECT_EQ(list.rows().size(), tree.explanation->tree.nodes.size());
        list.open_all(false);
        EXPECT_EQ(list.rows().size(), 1U);
    }
}

TEST(PathList, FiltersAgreeWithAWalkToTheCamera) {
    for (const Tree& tree : trees()) {
        PathList list = list_of(tree);
        PathFilter filter;
        filter.total_reflection = true;
        list.set_filter(filter);
        expect_same(list.shown(), some_on_the_way(tree, [&](int i) {
                        return is_total_reflection(*tree.plan, *tree.explanation, i);
                    }));
        for (int body = 0; body < tree.plan->solid_count() + 1; ++body) {
            filter = {};
            filter.body = body;
            list.set_filter(filter);
            expect_same(list.shown(), some_on_the_way(tree, [&](int i) {
                            const RayTreeNode& n = tree.node(i);
                            const auto region = static_cast<std::size_t>(n.start.region);
                            return (n.arrived && n.crossing.body == body) || tree.plan->regions[region].owner == body;
                        }));
        }
        filter = {};
        filter.not_followed = true;
        list.set_filter(filter);
        double unresolved = 0.0;
        for (const int leaf : tree.explanation->tree.leaves)
            if (is_not_followed(*tree.node(leaf).reason) && !tree.node(leaf).estimated)
                unresolved += tree.node(leaf).end.weight;
        EXPECT_LE(unresolved, list.shown().weight * (1.0 + 1e-12));
        EXPECT_EQ(list.shown().s0, 0.0) << "what was not followed to a source brings no light";
    }
}

TEST(PathList, SharesOfComplementaryFiltersAddUp) {
    for (const Tree& tree : trees()) {
        PathList list = list_of(tree);
        PathFilter filter;
        filter.only_e = true;
        list.set_filter(filter);
        const PathCount only_e = list.shown();
        const auto mode = [&](int leaf, WaveKind kind) {
            for (int i = leaf; i >= 0; i = tree.node(i).parent)
                if (tree.node(i).start.wave.kind == kind) return true;
            return false;
        };
        std::size_t others = 0;
        double s0 = only_e.s0;
        for (const int leaf : tree.explanation->tree.leaves) {
            if (mode(leaf, WaveKind::extraordinary) && !mode(leaf, WaveKind::ordinary)) continue;
            ++others;
            s0 += tree.node(leaf).light.s0;
        }
        EXPECT_EQ(only_e.leaves + others, list.all().leaves);
        EXPECT_NEAR(s0, list.all().s0, 1e-14);

        filter = {};
        filter.bright = true;
        list.set_filter(filter);
        EXPECT_LE(list.shown().leaves, 100U) << "each of them brings a hundredth";
        std::size_t bright = 0;
        for (const int leaf : tree.explanation->tree.leaves)
            if (tree.node(leaf).light.s0 >= 0.01 * tree.explanation->sample_light.s0) ++bright;
        ASSERT_GT(tree.explanation->sample_light.s0, 0.0);
        EXPECT_EQ(list.shown().leaves, bright);
        EXPECT_LE(list.shown().s0, list.all().s0 * (1.0 + 1e-12));
    }
}

TEST(PathList, RowsAreSortedAndLeadToListedLeaves) {
    PathList list = list_of(trees()[0]);
    PathFilter filter;
    filter.only_e = true;
    list.set_filter(filter);
    list.open_all(true);
    std::vector<double> last_weight(1, 2.0);
    std::size_t leaves = 0;
    for (const PathList::Row& row : list.rows()) {
        const RayTreeNode& node = trees()[0].node(row.branch);
        last_weight.resize(static_cast<std::size_t>(row.indent) + 1, 2.0);
        EXPECT_LE(node.start.weight, last_weight.back()) << "heaviest first, branch " << row.branch;
        last_weight.back() = node.start.weight;
        EXPECT_TRUE(list.listed(row.branch));
        if (node.reason) ++leaves;
    }
    EXPECT_EQ(leaves, list.shown().leaves);
}

TEST(PathList, ASelectedBranchGetsARow) {
    PathList list = list_of(trees()[0]);
    list.open_all(false);
    const int last = trees()[0].explanation->tree.leaves.back();
    EXPECT_FALSE(list.row_of(last));
    list.reveal(last);
    ASSERT_TRUE(list.row_of(last));
    EXPECT_EQ(list.rows()[*list.row_of(last)].branch, last);
}

TEST(TotalReflection, IsFoundInTheRhombAndNotAtMetal) {
    const auto count = [](const Tree& tree) {
        int total = 0;
        for (int i = 0; i < static_cast<int>(tree.explanation->tree.nodes.size()); ++i)
            total += is_total_reflection(*tree.plan, *tree.explanation, i) ? 1 : 0;
        return total;
    };
    const Tree rhomb = tree_of("fresnel-rhomb", 0.5, 0.5);
    int on_the_brightest = 0;
    int brightest = rhomb.explanation->tree.leaves.front();
    for (const int leaf : rhomb.explanation->tree.leaves)
        if (rhomb.node(leaf).light.s0 > rhomb.node(brightest).light.s0) brightest = leaf;
    for (int i = brightest; i >= 0; i = rhomb.node(i).parent)
        on_the_brightest += is_total_reflection(*rhomb.plan, *rhomb.explanation, i) ? 1 : 0;
    EXPECT_EQ(on_the_brightest, 2);
    const Tree metal = tree_of("metal-spheres", 0.5, 0.55);
    ASSERT_GT(metal.explanation->tree.nodes.size(), 1U) << "the ray must meet a sphere";
    EXPECT_EQ(count(metal), 0);
}

/// What a copy of the row `name` says.
std::string copied(const PageGroup& page, const std::string& name) {
    for (const PageRow& row : page.rows)
        if (row.name == name) return row.exact;
    ADD_FAILURE() << "no row " << name;
    return {};
}

double number_of(const PageGroup& page, const std::string& name) {
    return std::stod(copied(page, name));
}

DVec3 vector_of(const PageGroup& page, const std::string& name) {
    DVec3 v(0.0);
    EXPECT_EQ(std::sscanf(copied(page, name).c_str(), "(%lf, %lf, %lf)", &v.x, &v.y, &v.z), 3) << name;
    return v;
}

Complex<double> complex_of(const PageGroup& page, const std::string& name) {
    Complex<double> z;
    char sign = '+';
    EXPECT_EQ(std::sscanf(copied(page, name).c_str(), "%lf %c %lf", &z.re, &sign, &z.im), 3) << name;
    if (sign == '-') z.im = -z.im;
    return z;
}

TEST(BranchPage, HasTheLightOfTheClosedFormInARightHandedFrame) {
    test::for_each_lit_branch(
        [](const Plan& plan, const Explanation& e, int branch, const test::BranchLight& expected) {
            const PageGroup page = make_branch_page(plan, e, branch);
            const DVec3 e1 = vector_of(page, "E1");
            const DVec3 e2 = vector_of(page, "E2");
            EXPECT_EQ(vector_of(page, "E1 x E2"), -vector_of(page, "ray"));
            EXPECT_NEAR(dot(cross(e1, e2), vector_of(page, "E1 x E2")), 1.0, test::lit_rounding);
            const Stokes<double> light{number_of(page, "light S0"), number_of(page, "light S1"),
                                       number_of(page, "light S2"), number_of(page, "light S3")};
            test::expect_stokes(test::seen_from(light, e1, e2, expected.x), expected.light, test::lit_rounding);
            const CoherenceMatrix<double> j{number_of(page, "light J11"), number_of(page, "light J22"),
                                            complex_of(page, "light J12")};
            test::expect_stokes(to_stokes(j), light, test::eps);
            EXPECT_EQ(copied(page, "light in"), "E1, E2: receiver's view, S3 > 0 right, exp(-i\u03c9t)");
            const double s3 = expected.light.s3;
            const std::string hand = copied(page, "light is");
            EXPECT_EQ(hand == "right", s3 > 1e-12) << hand;
            EXPECT_EQ(hand == "left", s3 < -1e-12) << hand;
            Throughput<double> m;
            m.m[0][0] = complex_of(page, "M x1");
            m.m[1][0] = complex_of(page, "M y1");
            if (e.tree.nodes[static_cast<std::size_t>(branch)].start.wave.kind == WaveKind::pair) {
                m.m[0][1] = complex_of(page, "M x2");
                m.m[1][1] = complex_of(page, "M y2");
            }
            test::expect_stokes(m.gather(j),
                                {number_of(page, "share S0"), number_of(page, "share S1"), number_of(page, "share S2"),
                                 number_of(page, "share S3")},
                                test::lit_rounding);
        });
}

TEST(BranchPage, CallsATotalReflectionAndAnEndAsExplainDoes) {
    const Tree rhomb = tree_of("fresnel-rhomb", 0.5, 0.5);
    int total = 0;
    for (int i = 0; i < static_cast<int>(rhomb.explanation->tree.nodes.size()); ++i) {
        const PageGroup page = make_branch_page(*rhomb.plan, *rhomb.explanation, i);
        const std::string word = interaction_of(*rhomb.plan, *rhomb.explanation, i);
        EXPECT_EQ(copied(page, "interaction").substr(0, word.size()), word);
        total += word == "totally reflected" ? 1 : 0;
        const auto& reason = rhomb.node(i).reason;
        if (!reason) continue;
        EXPECT_EQ(copied(page, "ended"), name_of(*reason));
        if (is_not_followed(*reason)) {
            EXPECT_EQ(branch_end(*rhomb.plan, *rhomb.explanation, i), name_of(*reason));
        }
    }
    EXPECT_GE(total, 2) << "a rhomb reflects totally twice";
}

}  // namespace
}  // namespace pol
