// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "viewer/session/preferences.h"
#include "viewer/viewer_files.h"

namespace pol {
namespace {

TEST(Preferences, ReadBackAsTheyWereWritten) {
    const test::TemporaryFolder folder;
    Preferences written;
    written.theme = Theme::light;
    written.ui_scale = 1.5;
    written.layout = {300.0, 500.0, 0.25};
    written.quantity = Quantity::azimuth;
    written.style = MapStyle::wilkie;
    written.recent_files = {"/a/b.yaml", "/c/d.exr"};
    ASSERT_TRUE(write_preferences(written, folder / "new/folder/preferences.json"));
    const auto read = read_preferences(folder / "new/folder/preferences.json");
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value().theme, written.theme);
    EXPECT_EQ(read.value().ui_scale, written.ui_scale);
    EXPECT_EQ(read.value().layout, written.layout);
    EXPECT_EQ(read.value().quantity, written.quantity);
    EXPECT_EQ(read.value().style, written.style);
    EXPECT_EQ(read.value().recent_files, written.recent_files);
}

TEST(Preferences, AFolderThatCannotBeMadeIsNamed) {
    const test::TemporaryFolder folder;
    test::write_text(folder / "file", "not a folder");
    const auto written = write_preferences({}, folder / "file/polariscope/preferences.json");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().place.file, folder / "file/polariscope");
    EXPECT_NE(written.error().what.find("Not a directory"), std::string::npos) << written.error().what;
}

TEST(Preferences, AreTheUsualOnesWithoutAFile) {
    const test::TemporaryFolder folder;
    const auto read = read_preferences(folder / "none.json");
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value().layout, Layout{});
}

TEST(Preferences, ABrokenFileIsAnErrorAndNoHarm) {
    const test::TemporaryFolder folder;
    for (const char* text : {"", "{", "[]", "3", "{\"recent_files\": [1]}", "{\"layout\": 3}", "{\"theme\": []}",
                             "{\"ui_scale\": \"big\"}", "\xff\xfe"}) {
        test::write_text(folder / "p.json", text);
        EXPECT_FALSE(read_preferences(folder / "p.json")) << text;
    }
}

TEST(Preferences, NumbersOutOfRangeAndUnknownKeysAreIgnored) {
    const test::TemporaryFolder folder;
    test::write_text(
        folder / "p.json",
        R"({"layout": {"left_width": -5, "upper_share": 1e300}, "ui_scale": 99, "map": "nothing", "new": 1})");
    const auto read = read_preferences(folder / "p.json");
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value().layout, Layout{});
    EXPECT_EQ(read.value().ui_scale, 0.0);
    EXPECT_EQ(read.value().quantity, Quantity::color);
}

}  // namespace
}  // namespace pol
