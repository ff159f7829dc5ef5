// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "tracer/step.h"

namespace pol {
namespace {

DVec3 random_direction(std::uint32_t i, std::uint32_t dimension) {
    const RandomKey key{7, i, 0, 0};
    const double z = 2.0 * random_unit(key, dimension) - 1.0;
    const double phi = 6.283185307179586 * random_unit(key, dimension + 1);
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

// On a face turned anyhow, rays from head-on to 0.1 rad: reflected and transmitted weights add to 1. s may lean out of
// the wave front by 1.5e-16 / sin for sin > 1e-8, which costs 2e-16; a dozen operations on numbers of order 1 cost
// 1e-16 each.
TEST(Step, SharesOutAllEnergyHoweverCloseToTheNormalTheRayIs) {
    const Dielectric<double> air = make_isotropic(1.0);
    const Dielectric<double> glass = make_isotropic(1.5);
    Branches branches;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const DVec3 normal = random_direction(i, 0);
        const double tilt = i % 20 == 0 ? 0.0 : std::pow(10.0, -static_cast<double>(i % 20));
        Node node;
        node.wave.ray = unit(normal + tilt * random_direction(i, 2));
        node.wave.field[0] = any_perpendicular(node.wave.ray);
        node.wave.field[1] = cross(node.wave.ray, node.wave.field[0]);
        node.throughput = Throughput<double>::identity();
        node.weight = 1.0;
        cross_isotropic_boundary(node, i % 2 == 0 ? air : glass, i % 2 == 0 ? glass : air, normal, branches);
        ASSERT_EQ(branches.count, 2) << i;
        ASSERT_NEAR(branches.node[0].weight + branches.node[1].weight, 1.0, 3e-15) << "tilt " << tilt;
        for (const Node* child : {&branches.node[0], &branches.node[1]}) {
            ASSERT_NEAR(dot(child->wave.field[0], child->wave.field[1]), 0.0, 1e-15) << tilt;
            ASSERT_NEAR(dot(child->wave.field[1], child->wave.ray), 0.0, 1e-15) << tilt;
        }
    }
}

}  // namespace
}  // namespace pol
