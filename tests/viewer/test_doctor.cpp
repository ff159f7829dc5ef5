// SPDX-License-Identifier: Apache-2.0
// The convention doctor in the window: what it says of two pictures, and taking its advice.
#include <gtest/gtest.h>

#include <cmath>

#include "known_picture.h"
#include "viewer/commands/commands.h"
#include "viewer/widgets/widget_map.h"
#include "window_without_gl.h"

namespace pol {
namespace {

/// Light whose three components vary independently, so that every sign can be told.
StokesImage varied_picture() {
    StokesImage image = known_picture(64, 48);
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            for (std::size_t b = 0; b < 2; ++b) {
                image.stokes[b * image.pixel_count() + image.pixel(x, y)] = {
                    1.0 + 0.5 * std::sin(0.3 * x) * std::cos(0.2 * y), 0.4 * std::sin(0.5 * x + 0.1 * y),
                    0.4 * std::cos(0.17 * x - 0.4 * y), 0.3 * std::sin(0.11 * x * 0.2 * y + 0.7)};
            }
        }
    }
    return image;
}

class Doctor : public testing::Test {
protected:
    void SetUp() override {
        map.text_log = "/dev/null";
        ImGui::GetIO().UserData = &map;
        StokesImage image = varied_picture();
        session.open_picture(image, "ours");
        session.set_reference();
        for (Stokes<double>& s : image.stokes) s.s3 = -s.s3;
        session.open_picture(image, "theirs");
    }
    WindowWithoutGl window;
    Session& session = window.session;
    WidgetMap map;
};

TEST_F(Doctor, FindsTheOtherHandednessAndTakesTheNumbersForIt) {
    const auto advice = session.convention_advice();
    ASSERT_TRUE(advice) << to_string(advice.error());
    ASSERT_TRUE(advice.value().adopt) << advice.value().verdict;
    EXPECT_EQ(*advice.value().adopt, (StokesConvention{true, false, 0.0})) << advice.value().verdict;
    EXPECT_TRUE(run_command(session, {letter('V')}));
    EXPECT_NE(session.log().lines().back().text.find(advice.value().verdict), std::string::npos);
    EXPECT_FALSE(session.current()->chosen_convention());
    EXPECT_TRUE(run_command(session, {letter('V'), false, true}));
    EXPECT_EQ(session.current()->chosen_convention(), (StokesConvention{true, false, 0.0}));
    const auto open = session.documents();
    EXPECT_EQ(open[1]->picture().stokes, open[0]->picture().stokes) << "now they are the same numbers";
    const auto again = session.convention_advice();
    ASSERT_TRUE(again);
    EXPECT_FALSE(again.value().adopt) << again.value().verdict;
}

TEST_F(Doctor, AnswersAndIsObeyedByButtons) {
    window.draw(3);
    const auto click = [&](const std::string& name) {
        ASSERT_TRUE(map.rects.contains(name)) << name;
        window.click(map.rects.at(name).origin + 0.5 * map.rects.at(name).size);
        window.draw(2);
    };
    ASSERT_NO_FATAL_FAILURE(click("tab Compare"));
    ASSERT_NO_FATAL_FAILURE(click("button Ask the convention doctor"));
    ASSERT_NO_FATAL_FAILURE(click("button Take them for that"));
    EXPECT_EQ(session.current()->chosen_convention(), (StokesConvention{true, false, 0.0}));
}

TEST_F(Doctor, NeedsTwoPictures) {
    session.step_document(1);
    ASSERT_FALSE(session.convention_advice());
    EXPECT_NE(session.convention_advice().error().what.find("the reference itself"), std::string::npos);
    session.ask_doctor(true);
    EXPECT_FALSE(session.current()->chosen_convention());
    session.close_document(session.reference());
    EXPECT_FALSE(session.convention_advice());
}

}  // namespace
}  // namespace pol
