// SPDX-License-Identifier: Apache-2.0
// A picture minus a reference: which pictures can be compared, and what is then on screen.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "io/scenes/scene_file.h"
#include "known_picture.h"
#include "maps/difference.h"
#include "spectrum/illuminant.h"
#include "support/two_mirrors.h"
#include "viewer/session/map_look.h"

namespace pol {
namespace {

/// Two pictures of other light, the second one on screen, the first one the reference.
void open_two(Session& session) {
    StokesImage image = known_picture();
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    session.set_reference();
    for (Stokes<double>& s : image.stokes) s = {1.25 * s.s0, 0.5 * s.s1, s.s3, 0.5 * s.s2};
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
}

TEST(Comparison, ShowsTheDifferenceOfTheTwoMapsPixelByPixel) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_two(session));
    const auto& reference = *session.documents()[0];
    for (const QuantityInfo& about : quantities()) {
        if (about.quantity == Quantity::color) continue;
        session.show(about.quantity);
        session.change_view().difference = true;
        ASSERT_TRUE(session.comparison()) << about.name;
        session.finish_shown_map();
        const auto a = evaluate(session.current()->picture(), about.quantity, 0);
        const auto b = evaluate(reference.picture(), about.quantity, 0);
        for (std::size_t i = 0; i < a.value().pixels.size(); ++i) {
            const MapPixel expected = difference(about.quantity, a.value().pixels[i], b.value().pixels[i]);
            EXPECT_EQ(session.shown_map().states()[i], expected.state);
            EXPECT_EQ(session.shown_map().values()[i], expected.value);
        }
        const bool is_closed = about.quantity == Quantity::azimuth;
        EXPECT_EQ(map_look(session).scale, is_closed ? ColorScale::cyclic : ColorScale::diverging) << about.name;
        EXPECT_EQ(map_look(session).range.low, -map_look(session).range.high);
    }
}

// Both truths may lie anywhere in their bars.
TEST(Comparison, ADifferenceHasABarAsWideAsBothTogether) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_two(session));
    session.change_view().difference = true;
    for (const Quantity quantity : {Quantity::dop, Quantity::azimuth, Quantity::s3}) {
        session.show(quantity);
        const ShownQuantity both = session.shown_quantity();
        const std::size_t pixel = session.current()->picture().pixel(9, 9);
        const QuantityReadout a = both.own(pixel);
        const QuantityReadout b = both.of_reference(pixel);
        const QuantityReadout by = both.readout(pixel);
        ASSERT_EQ(by.pixel.state, PixelState::defined);
        ASSERT_TRUE(by.bar);
        EXPECT_EQ(by.pixel.value, both.at(pixel).value);
        // Sums of four numbers of up to 90.
        EXPECT_NEAR(by.bar->width(), a.bar->width() + b.bar->width(), 1e-12);
        EXPECT_NEAR(by.bar->high - by.pixel.value, (a.bar->high - a.pixel.value) + (b.pixel.value - b.bar->low), 1e-12);
    }
}

TEST(Comparison, OfColorIsThatOfTheIntensity) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_two(session));
    session.show(Quantity::color);
    session.toggle_difference();
    EXPECT_EQ(session.view().quantity, Quantity::intensity);
    EXPECT_TRUE(session.comparison());
    session.show(Quantity::color);
    EXPECT_FALSE(session.comparison());
}

TEST(Comparison, SaysWhyItIsNotPossible) {
    Session session;
    EXPECT_NE(session.compare().error().what.find("no reference"), std::string::npos);
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    session.set_reference();
    EXPECT_NE(session.compare().error().what.find("the reference itself"), std::string::npos);
    session.toggle_difference();
    EXPECT_FALSE(session.comparison());
    EXPECT_EQ(session.log().lines().back().severity, Severity::warning);

    StokesImage other = known_picture();
    for (Band& band : other.bands) *band.wavelength_nm += 1.0;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, other));
    EXPECT_NE(session.compare().error().what.find("no light of"), std::string::npos);

    StokesImage elsewhere = known_picture();
    elsewhere.left = 8;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, elsewhere));
    EXPECT_NE(session.compare().error().what.find("begins at pixel 8,0 of its picture"), std::string::npos);

    StokesImage small;
    small.width = small.height = 1;
    small.bands = bands_at({580.0});
    small.stokes = {{1.0, 0.0, 0.0, 0.0}};
    ASSERT_NO_FATAL_FAILURE(open_picture(session, small));
    EXPECT_NE(session.compare().error().what.find("1 x 1"), std::string::npos);
}

TEST(Comparison, EndsWhenTheReferenceIsClosed) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_two(session));
    session.show(Quantity::dop);
    session.toggle_difference();
    ASSERT_TRUE(session.comparison());
    session.step_document(1);
    EXPECT_FALSE(session.comparison());
    session.close_document();
    EXPECT_EQ(session.reference(), nullptr);
    EXPECT_FALSE(session.comparison());
    session.update();
}

/// Until both pictures of the comparison and the map of their difference are whole.
void wait(Session& session) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    for (;;) {
        session.update();
        bool is_done = session.shown_map().complete();
        for (const auto& document : session.documents())
            is_done = is_done && document->progress().finished &&
                      document->picture().samples == std::vector<std::uint32_t>(document->picture().pixel_count(), 1);
        if (is_done) return;
        ASSERT_LT(std::chrono::steady_clock::now(), end);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

// R_s^2 / 2 of the lamp with polarization, (R_s / 2)^2 without (PHYSICS.md 2.1).
TEST(Comparison, OfTheUnpolarizedTwinIsWhatPolarizationDoesToTheIntensity) {
    auto scene = parse_scene(test::two_mirrors, "mirrors.yaml", POL_TESTS_DIR);
    ASSERT_TRUE(scene);
    Session session;
    ASSERT_TRUE(session.open_scene(scene.value(), "mirrors.yaml"));
    ASSERT_TRUE(session.open_unpolarized_twin());
    EXPECT_EQ(session.current()->name(), "mirrors-unpolarized.yaml");
    EXPECT_TRUE(session.current()->scene().render.unpolarized);
    ASSERT_TRUE(session.comparison());
    ASSERT_EQ(session.view().quantity, Quantity::intensity);
    ASSERT_NO_FATAL_FAILURE(wait(session));
    const double r_s = test::brewster_s_reflectance;
    const double d65 = d65_at(580.0).value();  // the map is S0 / D65
    for (const double value : session.shown_map().values())
        EXPECT_NEAR(d65 * value, r_s * r_s / 4.0 - r_s * r_s / 2.0, 1e-14);
}

}  // namespace
}  // namespace pol
