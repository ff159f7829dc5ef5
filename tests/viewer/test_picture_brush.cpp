// SPDX-License-Identifier: Apache-2.0
// Histogram and polarimeter, by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/units.h"
#include "known_picture.h"
#include "viewer/panels/histogram_panel.h"
#include "viewer/panels/polarimeter_panel.h"
#include "viewer/shown/histogram.h"
#include "viewer/widgets/dial.h"
#include "window_without_gl.h"

namespace pol {
namespace {

/// Draws `panel` in a window at the origin, 300 points wide, without a title.
template <class Panel>
void draw_alone(const Panel& panel) {
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize({300.0F, 700.0F});
    ImGui::Begin("alone", nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove);
    panel();
    ImGui::End();
    ImGui::Render();
}

TEST(Histogram, CountsEveryDefinedValueOnce) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    session.show(Quantity::dop);
    session.finish_shown_map();
    const Histogram all = histogram_of(session.shown_map(), {0.0, 1.0}, 12);
    EXPECT_EQ(std::accumulate(all.bins.begin(), all.bins.end(), std::size_t{0}), 192u);
    EXPECT_EQ(all.above, 0u) << "the bottom row is fully polarized but for the rounding of the file";
    const Histogram part = histogram_of(session.shown_map(), {0.25, 0.75}, 5);
    std::size_t counted = std::accumulate(part.bins.begin(), part.bins.end(), std::size_t{0});
    EXPECT_EQ(counted + part.below + part.above, 192u);
    EXPECT_EQ(part.below, 48u) << "rows 0, 1 and 2 of 11";
    EXPECT_EQ(part.above, 48u);
}

TEST(HistogramPanel, ABrushMarksExactlyThePixelsInRange) {
    WindowWithoutGl window;
    ASSERT_NO_FATAL_FAILURE(open_picture(window.session, known_picture()));
    window.session.show(Quantity::dop);
    window.session.update();
    HistogramPanel panel;
    const auto draw = [&] {
        draw_alone([&] { panel.draw(window.session, window.wishes); });
        window.wishes.fulfil(window.session);
    };
    const float left = ImGui::GetStyle().WindowPadding.x;
    const float width = 300.0F - 2.0F * left;
    const auto x_of = [&](double value) { return static_cast<float>(std::floor(left + value * width)); };
    test::put_mouse({x_of(0.3), 40.0F});
    draw();
    draw();
    test::hold_button(0, true);
    draw();
    test::put_mouse({x_of(0.6), 40.0F});
    draw();
    test::hold_button(0, false);
    draw();
    const double low = (x_of(0.3) - left) / width;
    const double high = (x_of(0.6) - left) / width;
    const std::vector<bool>& marked = window.session.selection().marked;
    ASSERT_EQ(marked.size(), 192u);
    for (std::size_t pixel = 0; pixel < marked.size(); ++pixel) {
        const double value = window.session.shown_map().values()[pixel];
        EXPECT_EQ(marked[pixel], value >= low && value <= high) << value;
    }
    EXPECT_EQ(std::count(marked.begin(), marked.end(), true), 48) << "rows 4, 5 and 6 of 11";

    test::hold_button(0, true);
    draw();
    test::hold_button(0, false);
    draw();
    EXPECT_TRUE(window.session.selection().marked.empty()) << "a click takes the marks away";
}

TEST(HistogramPanel, StatesAreCountedApartAndMarkedByAClick) {
    WindowWithoutGl window;
    StokesImage image = known_picture();
    image.stokes[77].s0 = std::numeric_limits<double>::quiet_NaN();
    ASSERT_NO_FATAL_FAILURE(open_picture(window.session, image));
    window.session.show(Quantity::azimuth);
    window.session.update();
    HistogramPanel panel;
    const std::string text = window.text_of([&] { panel.draw(window.session, window.wishes); });
    EXPECT_NE(text.find("undefined: 16 pixels"), std::string::npos) << text;
    EXPECT_NE(text.find("not a number: 1 pixels"), std::string::npos) << text;
    const auto marked = pixels_of(window.session.shown_map(), PixelState::not_a_number);
    EXPECT_TRUE(marked[77]);
    EXPECT_EQ(std::count(marked.begin(), marked.end(), true), 1);
}

TEST(Dial, TurnsTheAxisTowardsTheMouse) {
    WindowWithoutGl window;
    double axis = 0.0;
    const auto draw = [&] { draw_alone([&] { axis_dial("dial", axis, 60.0F); }); };
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    const ImVec2 center(padding.x + 30.0F, padding.y + 30.0F);
    test::put_mouse({center.x + 20.0F, center.y});
    draw();
    draw();
    test::hold_button(0, true);
    draw();
    test::put_mouse({center.x + 20.0F, center.y - 20.0F});
    draw();
    EXPECT_NEAR(degrees(axis), 45.0, 1e-6) << "up on screen is counter-clockwise";
    test::put_mouse({center.x - 20.0F, center.y - 20.0F});
    draw();
    EXPECT_NEAR(degrees(axis), 135.0, 1e-6);
    test::put_mouse({center.x - 20.0F, center.y + 20.0F});
    draw();
    EXPECT_NEAR(degrees(axis), 45.0, 1e-6) << "an axis has no arrow";
    test::hold_shift(true);
    draw();
    test::put_mouse({center.x + 20.0F, center.y - 13.0F});
    draw();
    EXPECT_NEAR(degrees(axis), 30.0, 1e-6);
}

// Each analyzer passes its own state in full and blocks the opposite one.
TEST(Polarimeter, TheStandardAnalyzersPassTheirState) {
    const std::vector<Stokes<double>> states{{1, 1, 0, 0},  {1, -1, 0, 0}, {1, 0, 1, 0},
                                             {1, 0, -1, 0}, {1, 0, 0, 1},  {1, 0, 0, -1}};
    ASSERT_EQ(standard_analyzers().size(), states.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
        const MuellerMatrix<double> train = standard_analyzers()[i].polarimeter.mueller();
        EXPECT_EQ(standard_analyzers()[i].passes, states[i]);
        EXPECT_NEAR((train * states[i]).s0, 1.0, 1e-12) << i;
        EXPECT_NEAR((train * states[i ^ 1U]).s0, 0.0, 1e-12) << i;
    }
}

TEST(PolarimeterPanel, ShowsTheMuellerMatrixOfTheTrain) {
    WindowWithoutGl window;
    ASSERT_NO_FATAL_FAILURE(open_picture(window.session, known_picture()));
    EXPECT_NE(window.text_of([&] { draw_polarimeter_panel(window.session, window.wishes); })
                  .find("The light arrives as it is."),
              std::string::npos);
    window.session.set_polarimeter({{{PolarimeterElementKind::polarizer, true, 0.0, 0.0}}});
    const std::string text = window.text_of([&] { draw_polarimeter_panel(window.session, window.wishes); });
    EXPECT_NE(text.find("polarizer"), std::string::npos);
    EXPECT_NE(text.find("0.500"), std::string::npos) << text;
    // At 30 degrees from image right S2 of what it passes is sin(60 degrees)/2 = 0.433, seen from the source its
    // opposite.
    window.session.set_polarimeter({{{PolarimeterElementKind::polarizer, true, radians(30.0), 0.0}}});
    EXPECT_EQ(window.text_of([&] { draw_polarimeter_panel(window.session, window.wishes); }).find("-0.433"),
              std::string::npos);
    window.session.change_view().convention.viewpoint = Viewpoint::source;
    EXPECT_NE(window.text_of([&] { draw_polarimeter_panel(window.session, window.wishes); }).find("-0.433"),
              std::string::npos);
}

}  // namespace
}  // namespace pol
