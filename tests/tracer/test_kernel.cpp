// SPDX-License-Identifier: Apache-2.0
// Which kernel a plan is traced with: its media say, and nobody else can.
#include <gtest/gtest.h>

#include <type_traits>

#include "support/render_scene.h"
#include "tracer/observers.h"
#include "tracer/sample_task.h"
#include "tracer/trace_sample.h"

namespace pol {
namespace {

// A calcite cube that is traced as glass shows 0.00266 where it should show 0.00119, and nothing fails: it must not
// compile.
static_assert(!std::is_constructible_v<PlanForKernel<false, false>, const Plan&>);
static_assert(!std::is_constructible_v<PlanForKernel<false, false>, PlanForKernel<true, false>>);
static_assert(!std::is_constructible_v<Tracer<false, false, Silent>, const Plan&, Silent&>);
static_assert(!std::is_constructible_v<Tracer<false, false, Silent>, PlanForKernel<true, false>, Silent&>);
static_assert(std::is_constructible_v<Tracer<true, false, Silent>, PlanForKernel<true, false>, Silent&>);

Scene cube_of(const std::string& medium) {
    return test::scene_of(R"(
camera: {position: [1.1, -3.7, 1.9], target: [0, 0, 0], fov: 20}
background: 0.3
render: {size: [8, 8], wavelengths: [500, 600]}
media: {matter: )" + medium +
                          R"(}
objects:
  - {name: cube, shape: {box: {size: 1}}, medium: matter}
  - {name: lamp, shape: {rectangle: {size: 0.7}}, transform: [{translate: [0, 0, -0.8]}], emission: {radiance: 1}}
)");
}

struct Case {
    const char* medium;
    Kernel kernel;
};

TEST(Kernel, IsWhatTheMediaNeed) {
    for (const Case& one : {Case{"1.5", {false, false}}, Case{"{index: 1.5, absorption: 2}", {false, true}},
                            Case{"{crystal: calcite}", {true, false}},
                            Case{"{ordinary: 1.6, extraordinary: 1.5, axis: [1, 2, 3], "
                                 "absorption_o: 1, absorption_e: 0}",
                                 {true, true}},
                            Case{"{ordinary: 1.5, extraordinary: 1.5, axis: [1, 2, 3]}", {false, false}}}) {
        const auto plan = test::plan_of(cube_of(one.medium));
        EXPECT_EQ(plan->kernel(), one.kernel) << one.medium;
        EXPECT_EQ(plan->features.kernel, to_string(one.kernel));
    }
}

// Otherwise the cube would be glass at 600 nm for the sake of 500 nm, or the other way round.
TEST(Kernel, IsThatOfTheWavelengthThatNeedsMost) {
    for (const char* ordinary :
         {"[[400, 1.5], [500, 1.5], [600, 1.6], [700, 1.6]]", "[[400, 1.6], [500, 1.6], [600, 1.5], [700, 1.5]]"}) {
        const auto plan = test::plan_of(
            cube_of("{ordinary: {table: " + std::string(ordinary) + "}, extraordinary: 1.5, axis: [1, 2, 3]}"));
        EXPECT_TRUE(plan->kernel().anisotropic) << ordinary;
    }
}

TEST(Kernel, OfACalciteCubeMakesTheLightOfPictureAndExplanation) {
    const auto plan = test::plan_of(cube_of("{crystal: calcite}"));
    const StokesImage picture = test::render(plan);
    const StokesImage glass = test::render(cube_of("1.66"));
    double difference = 0.0;
    for (int pixel = 0; pixel < 64; ++pixel) {
        const int x = pixel % 8;
        const int y = pixel / 8;
        const int group = plan->group_of_wavelength[1];
        Stokes<double> light;
        const TraceResult result = trace_sample(*plan, sample_task(*plan, x, y, 0, group), {&light, 1});
        EXPECT_EQ(result.failures, 0U);
        EXPECT_EQ(light, picture.at(1, picture.pixel(x, y)));
        EXPECT_EQ(light, explain(*plan, x, y, 0, 1).leaf_sum);
        difference = std::max(difference, std::abs(light.s1 - glass.at(1, glass.pixel(x, y)).s1));
    }
    EXPECT_GT(difference, 1e-2) << "the cube shows what glass would";
}

}  // namespace
}  // namespace pol
