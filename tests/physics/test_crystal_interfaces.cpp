// SPDX-License-Identifier: Apache-2.0
// Crystals beyond facts T38 and T39, as whole pictures, and the indices of a biaxial one (T40).
#include "io/scenes/index_file.h"
#include "physics/crystal_scene.h"

namespace pol::test {
namespace {

/// A calcite jewel in uniform surroundings, as few pixels as show all of its facets.
Scene jewel_in_a_furnace() {
    return scene_of(
        "camera: {position: [0.35, -4, 3.2], target: [0, 0, -0.1], fov: 32}\n"
        "background: 1\nrender: {size: [12, 12], residual: 0.05, node_budget: 20000}\n"
        "media: {crystal: " +
        calcite({1.0, 2.0, 3.0}) +
        "}\nobjects:\n  - {name: stone, shape: {brilliant: {diameter: 2}}, medium: crystal}\n");
}

// J = L/2 for what was traced and something between 0 and residual L for what was not (CUTTING.md 1.2). Rounding:
// thousands of leaves whose weights, 1 in all, passed through some 10 surfaces.
TEST(CrystalInAFurnace, T38IsInvisibleAndUnpolarizedButForItsResidual) {
    const StokesImage image = render(jewel_in_a_furnace());
    double least_open = 1.0;
    for (std::size_t p = 0; p < image.pixel_count(); ++p) {
        const double residual = image.plane_value(image.residual, 0, p);
        EXPECT_LE(residual, 0.05);
        EXPECT_EQ(image.plane_value(image.tail, 0, p), 0.0);
        EXPECT_NEAR(image.at(0, p).s0, 1.0 - residual, 1e-12);
        EXPECT_LE(polarized_part(image.at(0, p)), residual + 1e-12);
        least_open = std::min(least_open, residual);
    }
    EXPECT_EQ(least_open, 0.0);  // beside the jewel
    EXPECT_GT(image.plane_value(image.residual, 0, image.pixel(6, 6)), 0.0);
}

// The parent's weight at the surface is what its children carry; the tree is what the picture is made of.
TEST(CrystalInAFurnace, T39ConservesEnergyAtEveryInterfaceOfAPicture) {
    const auto plan = plan_of(jewel_in_a_furnace());
    int interfaces = 0;
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x) {
            const Explanation e = explain(*plan, x, y, 0, 0);
            EXPECT_TRUE(e.exact());
            EXPECT_EQ(e.result.failures, 0U);
            EXPECT_NEAR(e.result.resolved + e.result.absorbed + e.result.residual, 1.0, 1e-11);
            for (const RayTreeNode& node : e.tree.nodes) {
                if (node.reason || node.children.empty()) continue;
                double sum = 0.0;
                for (const int child : node.children) sum += e.tree.nodes[static_cast<std::size_t>(child)].start.weight;
                ASSERT_NEAR(sum / node.end.weight, 1.0, 1e-11);
                ++interfaces;
            }
        }
    EXPECT_GT(interfaces, 1000);
}

// Biaxial media are not rendered; the indices of KTP that ship with the program must still give its optic axes:
// tan^2 V = eps_z (eps_y - eps_x)/(eps_x (eps_z - eps_y)) from z, and the cone of internal conical refraction.
TEST(BiaxialIndices, T40OfKtpGiveItsOpticAxesAndCone) {
    const auto eps_at_d = [](const char* record) {
        const auto index = load_index(record, POL_ASSETS);
        EXPECT_TRUE(index) << record;
        const auto n = index_at(index.value(), 589.3);
        EXPECT_TRUE(n) << record;
        return n.value().n * n.value().n;
    };
    const double x = eps_at_d("ktp-alpha");
    const double y = eps_at_d("ktp-beta");
    const double z = eps_at_d("ktp-gamma");
    EXPECT_NEAR(degrees(std::atan(std::sqrt(z * (y - x) / (x * (z - y))))), 18.47219, printed(5));
    EXPECT_NEAR(degrees(std::atan(y * std::sqrt((1.0 / x - 1.0 / y) * (1.0 / y - 1.0 / z)))), 1.90721, printed(5));
}

}  // namespace
}  // namespace pol::test
