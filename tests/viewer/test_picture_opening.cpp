// SPDX-License-Identifier: Apache-2.0
// Large pictures come into the window beside it; what is asked and remembered of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "io/pictures/exr_file.h"
#include "support/sanitizers.h"
#include "viewer/ambiguous_picture.h"
#include "viewer/known_picture.h"
#include "viewer/session/preferences.h"
#include "viewer/viewer_files.h"

namespace pol {
namespace {

using Clock = std::chrono::steady_clock;

/// More than is read at once.
StokesImage large_picture() {
    return known_picture(1024, 800);
}

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Frames until nothing is being read.
void wait_for_pictures(Session& session) {
    const auto begin = Clock::now();
    while (!session.readings().empty() && seconds_since(begin) < 60.0) {
        session.update();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_TRUE(session.readings().empty());
}

class PictureOpening : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(write_exr(large_picture(), large)); }
    const test::TemporaryFolder folder;
    const std::filesystem::path large = folder / "large.exr";
    Session session;
};

TEST_F(PictureOpening, WhatWasOnScreenStaysUntilThePictureIsThere) {
    open_picture(session, known_picture());
    const Document* before = session.current();
    ASSERT_TRUE(session.open(large));
    ASSERT_EQ(session.readings().size(), 1U);
    const PictureReading& reading = *session.readings()[0];
    EXPECT_EQ(reading.header().width, 1024);
    EXPECT_EQ(reading.header().bands, bands_at({500.0, 600.0}));
    EXPECT_GT(reading.header().bytes, read_at_once_bytes);
    session.update();
    EXPECT_EQ(session.documents().size(), session.readings().empty() ? 2U : 1U);
    ASSERT_TRUE(session.open(large)) << "the same one is on its way";
    EXPECT_LE(session.readings().size(), 1U);
    ASSERT_NO_FATAL_FAILURE(wait_for_pictures(session));
    ASSERT_EQ(session.documents().size(), 2U);
    EXPECT_NE(session.current(), before);
    EXPECT_EQ(session.current()->name(), "large.exr");
    const auto expected = read_exr(large);
    ASSERT_TRUE(expected);
    EXPECT_TRUE(session.current()->picture().stokes == expected.value().stokes);
    EXPECT_EQ(session.recent_files().front(), large);
}

TEST_F(PictureOpening, CancelLeavesTheWindowAsItWas) {
    open_picture(session, known_picture());
    ASSERT_TRUE(session.open(large));
    session.cancel_reading(session.readings()[0]);
    const auto begin = Clock::now();
    ASSERT_NO_FATAL_FAILURE(wait_for_pictures(session));
    EXPECT_LT(seconds_since(begin), 2.0 * test::slowdown);
    EXPECT_EQ(session.documents().size(), 1U);
    EXPECT_EQ(session.log().lines().back().text, "large.exr was not opened: cancelled");
    session.cancel_reading(nullptr);
}

TEST_F(PictureOpening, ClosingTheWindowDoesNotWaitForTheRest) {
    auto other = std::make_unique<Session>();
    ASSERT_TRUE(other->open(large));
    const auto begin = Clock::now();
    other.reset();
    EXPECT_LT(seconds_since(begin), 2.0 * test::slowdown);
}

TEST_F(PictureOpening, AFileThatBreaksOffIsAnErrorInTheLog) {
    std::filesystem::resize_file(large, std::filesystem::file_size(large) * 2 / 3);
    session.open(large);
    ASSERT_NO_FATAL_FAILURE(wait_for_pictures(session));
    EXPECT_TRUE(session.documents().empty());
    EXPECT_EQ(session.log().lines().back().severity, Severity::error);
}

TEST_F(PictureOpening, ALargePictureIsReadAgainBesideTheWindow) {
    ASSERT_TRUE(session.open(large));
    ASSERT_NO_FATAL_FAILURE(wait_for_pictures(session));
    StokesImage other = large_picture();
    for (auto& s : other.stokes) s = 2.0 * s;
    ASSERT_TRUE(write_exr(other, large));
    const double before = session.current()->picture().stokes[0].s0;
    ASSERT_TRUE(session.reload());
    EXPECT_EQ(session.current()->picture().stokes[0].s0, before);
    ASSERT_EQ(session.readings().size(), 1U);
    ASSERT_NO_FATAL_FAILURE(wait_for_pictures(session));
    EXPECT_EQ(session.current()->picture().stokes[0].s0, 2.0 * before);
    // One that is cancelled leaves the picture as it is, and is no problem.
    ASSERT_TRUE(session.reload());
    session.cancel_reading(session.readings()[0]);
    ASSERT_NO_FATAL_FAILURE(wait_for_pictures(session));
    EXPECT_EQ(session.current()->picture().stokes[0].s0, 2.0 * before);
    EXPECT_FALSE(session.current()->problem());
}

TEST(PictureConvention, IsRememberedForTheFileFromOneRunToTheNext) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(write_exr(known_picture(), folder / "a.exr"));
    ASSERT_TRUE(write_exr(known_picture(), folder / "b.exr"));
    const StokesConvention chosen{true, false, 30.0};
    {
        Session session;
        ASSERT_TRUE(session.open(folder / "a.exr"));
        session.take_numbers_for(session.current(), chosen);
        ASSERT_TRUE(write_preferences(preferences_of(session), folder / "preferences.json"));
    }
    Session session;
    const auto preferences = read_preferences(folder / "preferences.json");
    ASSERT_TRUE(preferences);
    apply(preferences.value(), session);
    ASSERT_TRUE(session.open(folder / "b.exr"));
    EXPECT_FALSE(session.current()->chosen_convention());
    ASSERT_TRUE(session.open(folder / "a.exr"));
    EXPECT_EQ(session.current()->chosen_convention(), chosen);
    EXPECT_NE(session.log().lines().back().text.find("what you chose before"), std::string::npos);
    // What the command line says goes first.
    PictureSource source;
    source.files = {folder / "a.exr"};
    ASSERT_TRUE(session.open(source, [](StokesConvention readers) {
        readers.y_down = true;
        return readers;
    }));
    EXPECT_EQ(session.current()->chosen_convention(), (StokesConvention{false, true, 0.0}));
    // The reader's own is nothing to remember.
    session.take_numbers_for(session.current(), std::nullopt);
    EXPECT_TRUE(session.chosen_conventions().empty());
}

TEST(PictureLayoutQuestion, TheWindowAsksWhichOfTwoLayoutsItIs) {
    const test::TemporaryFolder folder;
    test::write_ambiguous_picture(folder / "two.exr");
    Session session;
    ASSERT_TRUE(session.open(folder / "two.exr"));
    EXPECT_TRUE(session.documents().empty());
    ASSERT_EQ(session.window().question, Question::layout);
    ASSERT_TRUE(session.layout_question());
    const auto& layouts = session.layout_question()->layouts;
    for (const char* name : {"spectral", "bare"})
        EXPECT_NE(std::find(layouts.begin(), layouts.end(), name), layouts.end()) << name;
    session.answer_layout("spectral");
    EXPECT_EQ(session.window().question, Question::none);
    ASSERT_NE(session.current(), nullptr);
    EXPECT_EQ(session.current()->picture().bands, bands_at({580.0}));
    session.answer_layout("bare");  // nothing is asked
    EXPECT_EQ(session.documents().size(), 1U);
}

}  // namespace
}  // namespace pol
