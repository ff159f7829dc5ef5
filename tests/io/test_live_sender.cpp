// SPDX-License-Identifier: Apache-2.0
#include "io/live/live_sender.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "io/live_client.h"

namespace pol {
namespace {

using test::listener_with;
using test::LiveViewer;
using test::soon;

/// Every number of it differs, and each is a float.
StokesImage picture_of(std::vector<Band> bands, int width, int height) {
    StokesImage image;
    image.width = width;
    image.height = height;
    image.bands = std::move(bands);
    double number = 1.0;
    for (std::size_t i = 0; i < image.bands.size() * image.pixel_count(); ++i, number += 4.0)
        image.stokes.push_back({number, number + 1.0, number + 2.0, number + 3.0});
    return image;
}

TEST(LiveSender, ChannelsAreNamedByTheBands) {
    using Names = std::vector<std::string>;
    EXPECT_EQ(live_channels({named_band("mono")}), (Names{"S0", "S1", "S2", "S3"}));
    EXPECT_EQ(live_channels({named_band("mono", StokesComponents::linear())}), (Names{"S0", "S1", "S2"}));
    EXPECT_EQ(live_channels({named_band("R"), named_band("G"), named_band("B")}),
              (Names{"R", "G", "B", "S0.R", "S0.G", "S0.B", "S1.R", "S1.G", "S1.B", "S2.R", "S2.G", "S2.B", "S3.R",
                     "S3.G", "S3.B"}));
    EXPECT_EQ(live_channels(bands_at({580.0})),
              (Names{"R", "G", "B", "S0.580,000000nm", "S1.580,000000nm", "S2.580,000000nm", "S3.580,000000nm"}));
}

TEST(LiveSender, APictureArrivesAsItWas) {
    const auto listener = listener_with();
    for (const auto& bands : {std::vector<Band>{named_band("mono")}, bands_at({440.0, 580.0})}) {
        const StokesImage picture = picture_of(bands, 300, 130);  // more than one tile, and cut ones
        LiveSender sender(listener->address(), source_of(picture, "sent"));
        const auto sent = sender.finish(10.0);
        ASSERT_TRUE(sent) << to_string(sent.error());
        LiveViewer viewer;
        EXPECT_TRUE(soon([&] {
            viewer.take(*listener);
            return viewer.named("sent") != nullptr && viewer.named("sent")->updates == 6;
        }));
        ASSERT_NE(viewer.named("sent"), nullptr);
        EXPECT_EQ(viewer.named("sent")->image.bands, picture.bands);
        EXPECT_EQ(viewer.named("sent")->image.stokes, picture.stokes);
        EXPECT_TRUE(viewer.lines.empty());
    }
}

TEST(LiveSender, NobodyThereIsToldOnceAndEndsNothing) {
    auto listener = listener_with();
    const LiveAddress address = listener->address();
    listener.reset();
    const StokesImage picture = picture_of({named_band("mono")}, 4, 4);
    std::atomic<int> told{0};
    LiveSender sender(address, source_of(picture, "sent"), [&](const Error&) { ++told; });
    ASSERT_TRUE(soon([&] { return told > 0; }));
    const auto sent = sender.finish(0.1);
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().kind, ErrorKind::output);
    EXPECT_EQ(told, 1);
}

TEST(LiveSender, AReceiverThatComesBackGetsTheWholePictureAgain) {
    auto listener = listener_with();
    const LiveAddress address = listener->address();
    const StokesImage picture = picture_of({named_band("mono")}, 200, 4);
    LiveSource source = source_of(picture, "sent");
    // A picture that changes for ever, so that the loss is noticed.
    source.tile_if_newer = [still = source.tile_if_newer](int tile, Version& seen) {
        seen = 0;
        return still(tile, seen);
    };
    std::atomic<int> told{0};
    LiveSender sender(address, source, [&](const Error&) { ++told; });
    LiveViewer before;
    ASSERT_TRUE(soon([&] {
        before.take(*listener);
        return before.named("sent") != nullptr && before.named("sent")->updates >= 4;
    }));
    listener.reset();
    ASSERT_TRUE(soon([&] { return told == 1; }));
    auto again = LiveListener::start(address, {}, {});
    ASSERT_TRUE(again) << to_string(again.error());
    LiveViewer after;
    EXPECT_TRUE(soon([&] {
        after.take(*again.value());
        return after.named("sent") != nullptr && after.named("sent")->updates >= 2;
    }));
    EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace pol
