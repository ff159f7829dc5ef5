// SPDX-License-Identifier: Apache-2.0
// The panel that says what is known of a picture beside its pixels, and the panels that grey what was not measured.
#include <gtest/gtest.h>
#include <imgui.h>

#include "viewer/foreign_picture.h"
#include "viewer/panels/hover_readout.h"
#include "viewer/panels/picture_header.h"
#include "viewer/panels/pixel_panel.h"
#include "viewer/panels/scene_panel.h"
#include "viewer/panels/sphere_panel.h"
#include "viewer/widgets/widget_map.h"
#include "viewer/window_without_gl.h"

namespace pol {
namespace {

class HeaderPanel : public testing::Test {
protected:
    HeaderPanel() { window.session.open_picture(foreign_picture(), "room"); }
    template <class Panel>
    std::string shown(Panel& panel) {
        const auto draw = [&] { panel.draw(window.session, window.wishes); };
        window.text_of(draw);
        return window.text_of(draw);
    }
    void expect_in(const std::string& text, const std::string& part) {
        EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
    }
    WindowWithoutGl window;
};

TEST_F(HeaderPanel, SaysEverythingThatTheReaderFoundOut) {
    ScenePanel panel;
    const std::string text = shown(panel);
    for (const char* part : {"room", "Mitsuba 3, rgb", "16 x 12 pixels from 100,20 of 640 x 480",
                             "R, G (S3 was not measured)", "16-bit floats", "right-handed", "image right",
                             "Azimuth is counted from image right.", "The labels were shifted by one channel."})
        expect_in(text, part);
    EXPECT_EQ(text.find("As the reader took them"), std::string::npos);
    window.session.take_numbers_for(window.session.current(), StokesConvention{true, false, 90.0});
    const std::string changed = shown(panel);
    for (const char* part : {"left-handed", "image up", "You chose this.", "As the reader took them"})
        expect_in(changed, part);
}

TEST_F(HeaderPanel, AChoiceInTheListChangesWhatTheNumbersAreTakenFor) {
    WidgetMap map;
    map.text_log = "/dev/null";
    ImGui::GetIO().UserData = &map;
    const auto click = [&](const std::string& name) {
        window.draw(3);
        ASSERT_TRUE(map.rects.contains(name)) << name;
        const ViewRect& rect = map.rects.at(name);
        window.click(rect.origin + 0.5 * rect.size);
    };
    ASSERT_NO_FATAL_FAILURE(click("tab Picture"));
    ASSERT_NO_FATAL_FAILURE(click("assumed S3 > 0 is"));
    // The second entry of the list that is open now.
    const ViewRect rect = map.rects.at("assumed S3 > 0 is");
    window.click(rect.origin + DVec2(20.0, 2.6 * rect.size.y));
    window.draw(3);
    ImGui::GetIO().UserData = nullptr;
    ASSERT_TRUE(window.session.current()->chosen_convention());
    EXPECT_TRUE(window.session.current()->chosen_convention()->left_handed);
}

TEST_F(HeaderPanel, NumbersOfTheFileAreNamedByWhatTheyLost) {
    EXPECT_EQ(stored_text({16, ""}), "16-bit floats: off by at most 0.049 % each");
    EXPECT_NE(stored_text({32, "B44"}).find("B44"), std::string::npos);
    EXPECT_EQ(stored_text({32, "", 0.5}), "from whole numbers, 0.5 apart: each off by at most half of it");
    EXPECT_EQ(size_text(known_picture()), "16 x 12 pixels");
}

TEST_F(HeaderPanel, HoverAndInspectorAndSphereSayThatS3WasNotMeasured) {
    window.session.choose_band(1);
    window.session.pin({4, 8});
    window.session.update();
    const std::string hover = window.text_of([&] { draw_hover_readout(window.session); });
    expect_in(hover, "S3 not measured");
    expect_in(hover, "x 104  y 28");
    EXPECT_EQ(hover.find("not traced"), std::string::npos);
    PixelPanel pixel;
    expect_in(shown(pixel), "S3 was not measured: the ellipse is not known.");
    SpherePanel sphere;
    expect_in(shown(sphere), "1 point;");  // of R, which has S3
}

}  // namespace
}  // namespace pol
