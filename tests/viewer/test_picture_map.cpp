// SPDX-License-Identifier: Apache-2.0
// The shown map is maps::evaluate, whatever slices it is made in.
#include <gtest/gtest.h>

#include <limits>

#include "known_picture.h"
#include "maps/evaluate.h"
#include "viewer/session/map_look.h"
#include "viewer/shown/shown_map.h"

namespace pol {
namespace {

TEST(ShownMap, HasTheValuesOfEvaluate) {
    Session session;
    StokesImage image = known_picture();
    image.stokes[5].s0 = std::numeric_limits<double>::quiet_NaN();
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    const Document& document = *session.current();
    for (const QuantityInfo& about : quantities()) {
        if (about.quantity == Quantity::color) continue;
        session.show(about.quantity);
        session.finish_shown_map();
        ASSERT_TRUE(session.shown_map().complete());
        const auto map = evaluate(document.picture(), about.quantity, 0);
        ASSERT_TRUE(map);
        std::array<std::size_t, pixel_state_count> states{};
        for (std::size_t pixel = 0; pixel < map.value().pixels.size(); ++pixel) {
            const MapPixel& expected = map.value().pixels[pixel];
            EXPECT_EQ(session.shown_map().states()[pixel], expected.state);
            if (expected.state == PixelState::defined) {
                EXPECT_EQ(session.shown_map().values()[pixel], expected.value);
            }
            ++states[static_cast<std::size_t>(expected.state)];
        }
        EXPECT_EQ(session.shown_map().summary().state, states) << about.name;
    }
}

TEST(ShownMap, IsMadeInSlicesAndFollowsMapAndPolarimeter) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    session.show(Quantity::dop);
    const Document& document = *session.current();
    ShownMap map;
    int slices = 0;
    while (!map.complete() || slices == 0) {
        map.update(document, session.view(), session.polarimeter(), 0.0, false);
        ASSERT_LE(++slices, 12);
    }
    EXPECT_EQ(slices, 12) << "a row per slice";
    EXPECT_NEAR(map.summary().high, 1.0, 1e-6);
    const std::uint64_t version = map.version();
    EXPECT_FALSE(map.update(document, session.view(), session.polarimeter(), 1.0, false));
    EXPECT_EQ(map.version(), version) << "nothing changed";

    session.set_polarimeter({{{}}});
    map.update(document, session.view(), session.polarimeter(), 0.0, false);
    EXPECT_FALSE(map.complete());
    map.finish(document, session.view(), session.polarimeter());
    EXPECT_NEAR(map.summary().low, 1.0, 1e-12) << "behind a polarizer all light is polarized";
}

// S3 is positive for left-handed light there, seen from the source for right-handed light again.
TEST(ShownMap, FollowsTheConvention) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    session.show(Quantity::s3);
    session.finish_shown_map();
    const std::vector<double> engine = session.shown_map().values();
    session.change_view().convention.positive_s3 = PositiveS3::left;
    session.finish_shown_map();
    for (std::size_t i = 0; i < engine.size(); ++i) EXPECT_EQ(session.shown_map().values()[i], -engine[i]) << i;
    session.change_view().convention.viewpoint = Viewpoint::source;
    session.finish_shown_map();
    EXPECT_EQ(session.shown_map().values(), engine);
}

TEST(MapLook, AzimuthDifferencesAreClosedUntilAPartOfTheCycleIsAskedFor) {
    Session session;
    StokesImage image = known_picture();
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    session.set_reference();
    for (Stokes<double>& s : image.stokes) s = rotate_basis(s, 0.02);
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    session.show(Quantity::azimuth);
    session.change_view().difference = true;
    session.finish_shown_map();
    EXPECT_EQ(map_look(session).kind, ScaleKind::cyclic);
    EXPECT_EQ(map_look(session).scale, ColorScale::cyclic);
    EXPECT_EQ(map_look(session).range.high, 90.0);
    fit_bar_range(session);  // the frame was turned by 0.02 radians: all azimuths are that much less
    EXPECT_EQ(map_look(session).kind, ScaleKind::diverging);
    EXPECT_NEAR(map_look(session).range.high, 0.02 * 180.0 / 3.14159265358979, 1e-3);
    reset_bar_range(session);
    EXPECT_EQ(map_look(session).kind, ScaleKind::cyclic);
    session.change_view().difference = false;
    fit_bar_range(session);
    EXPECT_EQ(map_look(session).range.low, -90.0) << "azimuths themselves keep their cycle";
}

TEST(MapLook, TakesItsRangeFromTheUserElseFromTheQuantityElseFromTheData) {
    Session session;
    StokesImage image = known_picture();
    image.residual[7] = 0.25;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    session.show(Quantity::residual);
    session.finish_shown_map();
    EXPECT_EQ(map_look(session).range.high, 0.25);
    session.change_view().range[static_cast<std::size_t>(Quantity::residual)] = MapRange{0.1, 0.2};
    EXPECT_EQ(map_look(session).range.low, 0.1);
    session.show(Quantity::azimuth);
    EXPECT_EQ(map_look(session).range.low, -90.0);
    EXPECT_EQ(map_look(session).scale, ColorScale::cyclic);
}

}  // namespace
}  // namespace pol
