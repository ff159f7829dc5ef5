// SPDX-License-Identifier: Apache-2.0
// Pictures of other programs grow in the window.
#include <gtest/gtest.h>

#include <chrono>
#include <numeric>
#include <span>

#include "io/live_client.h"
#include "viewer/foreign_picture.h"
#include "viewer/session/exports.h"

namespace pol {
namespace {

using test::LiveClient;
using test::soon;

const std::vector<std::string> stokes_channels{"S0", "S1", "S2", "S3"};

class LiveSession : public testing::Test {
protected:
    void SetUp() override {
        LiveAddress any;
        any.port = 0;
        ASSERT_TRUE(session.listen(any, {}));
        client.emplace(session.listener()->address().port);
    }
    void create(const std::string& name, int width, int height, bool grab_focus = false) {
        client->send(tev::encode(tev::CreateImage{grab_focus, name, width, height, stokes_channels}));
    }
    /// Light of S0 = 2 and the given S1 to S3 everywhere in the rectangle.
    void update(const std::string& name, const TileRect& rect, float s1, float s2, float s3) {
        std::vector<float> numbers;
        for (const float value : {2.0F, s1, s2, s3}) numbers.insert(numbers.end(), rect.pixel_count(), value);
        client->send(tev::encode_planes(name, stokes_channels, rect, numbers));
    }
    /// Frames until it is so.
    void wait_until(const std::function<bool()>& is_so) {
        ASSERT_TRUE(soon([&] {
            session.update();
            return is_so();
        }));
    }
    [[nodiscard]] const Stokes<double>& pixel(int x, int y) const {
        const StokesImage& picture = session.current()->picture();
        return picture.at(0, picture.pixel(x, y));
    }
    Session session;
    std::optional<LiveClient> client;
};

TEST_F(LiveSession, ADocumentGrowsTileByTileAndSaysWhichPartsAreNew) {
    create("render", 40, 30);
    wait_until([&] { return session.current() != nullptr; });
    EXPECT_EQ(session.current()->name(), "render");
    EXPECT_TRUE(session.current()->path().empty());
    const std::uint64_t version = session.current()->picture_version();
    update("render", {8, 4, 16, 12}, 1.0F, 0.5F, -0.25F);
    wait_until([&] { return session.current()->picture_version() != version; });
    EXPECT_EQ(pixel(8, 4), (Stokes<double>{2.0, 1.0, 0.5, -0.25}));
    EXPECT_EQ(pixel(7, 4), (Stokes<double>{}));
    const auto changes = session.current()->changes_since(version);
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_EQ(changes[0], (TileRect{8, 4, 16, 12}));
    EXPECT_TRUE(session.current()->growing());
    // The map behind the histogram follows, and is complete soon after the last tile.
    session.show(Quantity::dolp);
    wait_until([&] {
        return session.shown_map().complete() &&
               session.shown_map().summary().state[static_cast<std::size_t>(PixelState::defined)] == 64;
    });
    wait_until([&] { return !session.current()->growing(); });
}

TEST_F(LiveSession, WhatTheUserTakesTheNumbersForHoldsForWhatComesAndIsRemembered) {
    create("render", 8, 8);
    wait_until([&] { return session.current() != nullptr; });
    update("render", {0, 0, 8, 8}, 1.0F, 0.5F, 0.25F);
    wait_until([&] { return pixel(0, 0).s0 == 2.0; });
    const StokesConvention chosen{true, false, 0.0};
    session.take_numbers_for(session.current(), chosen);
    EXPECT_EQ(pixel(0, 0).s3, -0.25);
    update("render", {0, 0, 4, 4}, 1.0F, 0.5F, 0.75F);
    wait_until([&] { return pixel(0, 0).s3 == -0.75; });
    EXPECT_EQ(pixel(7, 7).s3, -0.25);
    // The program says what its numbers are: the user knows better.
    client->send(tev::encode(tev::Attributes{"render", {{"polarisationHandedness", "right"}, {"samples", "12"}}}));
    wait_until([&] { return session.current()->picture().attributes.contains("samples"); });
    EXPECT_EQ(pixel(0, 0).s3, -0.75);
    // A new picture of that name, and one in another session.
    create("render", 16, 8);
    wait_until([&] { return session.current()->picture().width == 16; });
    EXPECT_EQ(session.documents().size(), 1U);
    EXPECT_EQ(session.current()->chosen_convention(), chosen);
    session.close_document();
    create("render", 8, 8);
    wait_until([&] { return session.current() != nullptr; });
    EXPECT_EQ(session.current()->chosen_convention(), chosen);
}

TEST_F(LiveSession, WhatIsOnScreenStaysUnlessTheProgramAsksForIt) {
    open_picture(session, known_picture());
    const Document* mine = session.current();
    create("quiet", 8, 8);
    wait_until([&] { return session.documents().size() == 2; });
    EXPECT_EQ(session.current(), mine);
    create("loud", 8, 8, true);
    wait_until([&] { return session.documents().size() == 3; });
    EXPECT_EQ(session.current()->name(), "loud");
}

TEST_F(LiveSession, AClosedPictureGoesAndUpdatesOfItChangeNothing) {
    create("render", 8, 8);
    wait_until([&] { return session.current() != nullptr; });
    session.close_document();
    update("render", {0, 0, 8, 8}, 1.0F, 0.5F, 0.25F);
    create("other", 8, 8);
    wait_until([&] { return session.current() != nullptr; });
    EXPECT_EQ(session.current()->name(), "other");
    EXPECT_EQ(session.documents().size(), 1U);
    client->send(tev::encode(tev::CloseImage{"other"}));
    wait_until([&] { return session.documents().empty(); });
}

TEST_F(LiveSession, MalformedMessagesAreALineInTheLogAndNothingElse) {
    create("render", 8, 8);
    wait_until([&] { return session.current() != nullptr; });
    const std::size_t lines = session.log().lines().size();
    const std::uint64_t version = session.current()->picture_version();
    update("render", {4, 4, 12, 12}, 1.0F, 0.5F, 0.25F);  // leaves the picture
    wait_until([&] { return session.log().lines().size() > lines; });
    EXPECT_EQ(session.current()->picture_version(), version);
    // Control characters of a name do not reach the window.
    create("a\nb", 8, 8);
    wait_until([&] { return session.documents().size() == 2; });
    EXPECT_EQ(session.documents()[1]->name(), "a?b");
}

TEST_F(LiveSession, PicturesStayWhenTheWindowListensNoMore) {
    create("render", 8, 8);
    wait_until([&] { return session.current() != nullptr; });
    session.stop_listening();
    EXPECT_EQ(session.listener(), nullptr);
    EXPECT_EQ(session.documents().size(), 1U);
    session.update();
    session.close_document();
    EXPECT_TRUE(session.documents().empty());
}

TEST_F(LiveSession, APictureThatOneWindowSendsAnotherOneShows) {
    Session other;
    open_picture(other, known_picture());
    send_picture(other, session.listener()->address());
    wait_until([&] {
        other.update();
        return session.current() != nullptr && other.exports().idle();
    });
    EXPECT_EQ(other.log().lines().back().severity, Severity::note) << other.log().lines().back().text;
    const StokesImage& sent = other.current()->picture();
    wait_until([&] { return session.current()->picture().stokes == sent.stokes; });
    EXPECT_EQ(session.current()->picture().bands, sent.bands);
    EXPECT_EQ(session.current()->name(), other.current()->name());
}

TEST(LiveSending, ToNobodyIsAnErrorInTheLog) {
    Session session;
    open_picture(session, known_picture());
    LiveAddress nobody;
    nobody.unix_path = "/nowhere/at/all";
    send_picture(session, nobody);
    ASSERT_TRUE(soon([&] {
        session.update();
        return session.exports().idle();
    }));
    EXPECT_EQ(session.log().lines().back().severity, Severity::error);
}

// 200 tiles of 128 x 128 and four channels a second, in frames of a twentieth of a second: 10 tiles each.
TEST_F(LiveSession, TakesTheTilesOfAFastRenderInAFractionOfTheirTime) {
    create("render", 1920, 1080);
    wait_until([&] { return session.current() != nullptr; });
    using Clock = std::chrono::steady_clock;
    double longest_s = 0.0;
    double all_s = 0.0;
    const std::uint64_t version = session.current()->picture_version();
    std::uint64_t sent = 0;
    const auto frame = [&] {
        const auto begin = Clock::now();
        session.update();
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        longest_s = std::max(longest_s, seconds);
        all_s += seconds;
    };
    for (int burst = 0; burst < 20; ++burst) {
        for (int tile = 0; tile < 10; ++tile, ++sent) {
            const int x = static_cast<int>(sent) % 14 * 128;
            const int y = static_cast<int>(sent) / 14 % 8 * 128;
            update("render", {x, y, x + 128, y + 128}, 1.0F, 0.5F, 0.25F);
        }
        frame();
    }
    ASSERT_TRUE(soon([&] {
        frame();
        return session.current()->picture_version() - version == sent;
    }));
    RecordProperty("longest_frame_ms", static_cast<int>(1000.0 * longest_s));
    RecordProperty("all_ms", static_cast<int>(1000.0 * all_s));
    EXPECT_LT(all_s, 20.0);  // a busy machine under a sanitizer; alone, 0.1 s
}

}  // namespace
}  // namespace pol
