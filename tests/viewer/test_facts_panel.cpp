// SPDX-License-Identifier: Apache-2.0
// The menu of facts and the page of a fact, without GL.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <string>
#include <thread>

#include "verify/facts/fact.h"
#include "viewer/commands/command_actions.h"
#include "viewer/pages/fact_page.h"
#include "viewer/panels/fact_panel.h"
#include "viewer/viewer_files.h"
#include "viewer/widgets/widget_map.h"
#include "viewer/window_without_gl.h"

namespace pol {
namespace {

void expect_says(const std::string& text, const std::string& what) {
    EXPECT_NE(text.find(what), std::string::npos) << "no '" << what << "' in\n" << text;
}

/// Waits for the tree of the pinned pixel.
void explain_pin(Session& session) {
    session.update();
    for (int i = 0; i < 5000 && session.explanation() == nullptr; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        session.update();
    }
    ASSERT_NE(session.explanation(), nullptr) << session.explanation_status().problem;
}

class FactsPanel : public testing::Test {
protected:
    std::string panel_text() {
        return window.text_of([&] { draw_fact_panel(window.session, window.wishes); });
    }
    /// Opens "45 degrees" of T9: a prism of index 1.5 whose total reflection has tan delta = 0.75, ellipticity 1/3.
    void open_t9() {
        ASSERT_TRUE(session.open_fact(t9, 2));
        ASSERT_EQ(t9.views[2].name, "45 degrees");
        explain_pin(session);
    }

    WindowWithoutGl window;
    Session& session = window.session;
    const verify::Fact& t9 = *verify::find_fact("T9");
};

TEST_F(FactsPanel, ShowsExpectedAndMeasuredAtThePinnedPixel) {
    open_t9();
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{t9.views[2].x, t9.views[2].y}));
    const std::string text = panel_text();
    expect_says(text, t9.sentence);
    expect_says(text, t9.source);
    expect_says(text, "ellipticity pass");
    expect_says(text, "expected | 0.33333333333");
    expect_says(text, "measured | 0.33333333333");
    expect_says(text, "measured | 36.869897646 deg");  // atan 0.75
    expect_says(text, "four surfaces, in degrees");
    EXPECT_EQ(text.find("FAIL"), std::string::npos) << text;
    for (const FactRow& row : make_fact_page(session).rows) EXPECT_EQ(row.reading->view, 2U);
}

TEST_F(FactsPanel, AnEditIsMeasuredAndItsUndoToo) {
    open_t9();
    Scene scene = session.current()->scene();
    std::get<IsotropicMedium>(scene.media.at(0).matter).index = ConstantIndex{{1.6, 0.0}};
    ASSERT_TRUE(session.current()->edit(scene, "index of glass"));
    explain_pin(session);
    // 2 atan(cos i sqrt(sin^2 i - 1/n^2)/sin^2 i) at n = 1.6 and 45 degrees: tan(delta/2) = sqrt(1 - 2/2.56).
    const double half = std::atan(std::sqrt(1.0 - 2.0 / 2.56));
    const FactPage page = make_fact_page(session);
    ASSERT_TRUE(page.rows.at(0).result);
    EXPECT_NEAR(page.rows[0].result->measured, std::tan(half), 1e-12);
    expect_says(panel_text(), "ellipticity FAIL");
    ASSERT_TRUE(session.undo());
    explain_pin(session);
    expect_says(panel_text(), "ellipticity pass");
}

TEST_F(FactsPanel, ElsewhereItSaysWhichPixelTheFactIsAbout) {
    open_t9();
    session.pin({3, 4});
    explain_pin(session);
    const std::string text = panel_text();
    expect_says(text, "pixel 16,16");
    EXPECT_EQ(text.find("measured"), std::string::npos) << text;
    session.pin_fact();
    explain_pin(session);
    expect_says(panel_text(), "measured");
}

TEST_F(FactsPanel, TheFactGoesWithItsDocument) {
    open_t9();
    ASSERT_TRUE(session.open_fact(*verify::find_fact("T1"), 0));
    session.step_document(-1);
    expect_says(panel_text(), t9.sentence);
    session.step_document(1);
    expect_says(panel_text(), verify::find_fact("T1")->sentence);
}

TEST_F(FactsPanel, AFactThatIsOpenIsShownAgainUnlessItWasEdited) {
    open_t9();
    const Document* first = session.current();
    ASSERT_TRUE(session.open_fact(t9, 1));
    ASSERT_TRUE(session.open_fact(t9, 2));
    EXPECT_EQ(session.documents().size(), 2U);
    EXPECT_EQ(session.current(), first);
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{t9.views[2].x, t9.views[2].y}));
    Scene scene = first->scene();
    scene.camera.horizontal_fov *= 0.5;
    ASSERT_TRUE(session.current()->edit(std::move(scene), "fov"));
    ASSERT_TRUE(session.open_fact(t9, 2));
    EXPECT_EQ(session.documents().size(), 3U);
}

TEST_F(FactsPanel, EveryViewOpensAndPasses) {
    std::size_t opened = 0;
    for (const verify::Fact& fact : verify::facts()) {
        EXPECT_EQ(fact.views.empty(), !fact.not_modelled.empty()) << fact.id;
        for (std::size_t view = 0; view < fact.views.size(); ++view, ++opened) {
            ASSERT_TRUE(session.open_fact(fact, view)) << fact.id << ": " << session.log().lines().back().text;
            EXPECT_FALSE(session.current()->dirty());
            session.current()->set_paused(true);
            explain_pin(session);
            const FactPage page = make_fact_page(session);
            EXPECT_EQ(page.trouble, "") << fact.id;
            for (const FactRow& row : page.rows) {
                ASSERT_TRUE(row.result) << fact.id;
                EXPECT_EQ(row.result->verdict, verify::Verdict::pass) << fact.id << " " << label(fact, *row.reading);
            }
            session.close_document();
        }
    }
    EXPECT_GT(opened, 58U);
}

TEST_F(FactsPanel, SavingWritesAFileThatWasNotThere) {
    const test::WorkingFolder folder;
    test::write_text("T9-3.yaml", "precious");
    ASSERT_TRUE(session.open_fact(t9, 2));
    EXPECT_TRUE(action::save_scene(session));
    EXPECT_EQ(session.current()->path().filename(), "T9-3-2.yaml");
    EXPECT_EQ(std::filesystem::file_size("T9-3.yaml"), 8U);
    EXPECT_TRUE(session.reload());
    EXPECT_TRUE(session.current()->fact());
}

TEST_F(FactsPanel, TheMenuOpensAFactAndItsPage) {
    WidgetMap map;
    map.text_log = "/dev/null";
    ImGui::GetIO().UserData = &map;
    const auto click = [&](const std::string& name) {
        window.draw(3);
        ASSERT_TRUE(map.rects.contains(name)) << name;
        const ViewRect& rect = map.rects.at(name);
        window.click(rect.origin + 0.5 * rect.size);
    };
    click("menu Facts");
    click("facts from T1");
    click("fact T9");
    click("fact T9 view 3");
    ASSERT_NE(session.current(), nullptr);
    EXPECT_EQ(session.current()->name(), "T9-3.yaml");
    EXPECT_EQ(session.current()->fact()->fact, &t9);
    window.draw(3);
    EXPECT_TRUE(map.rects.contains("tab Fact"));
    // The page itself is what is shown: it has the button.
    session.pin({3, 4});
    window.draw(3);
    click("button Pin it");
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{16, 16}));
}

}  // namespace
}  // namespace pol
