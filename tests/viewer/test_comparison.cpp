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
    EXPECT_NE(session.compare().error().what.find("has no band 501 nm"), std::string::npos);

    StokesImage elsewhere = known_picture();
    elsewhere.left = 8;
    elsewhere.whole_width = 24;
    elsewhere.whole_height = 12;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, elsewhere));
    EXPECT_NE(session.compare().error().what.find("has 24 x 12 pixels"), std::string::npos) << "of another whole";

    StokesImage small;
    small.width = small.height = 1;
    small.bands = bands_at({580.0});
    small.stokes = {{1.0, 0.0, 0.0, 0.0}};
    ASSERT_NO_FATAL_FAILURE(open_picture(session, small));
    EXPECT_NE(session.compare().error().what.find("1 x 1"), std::string::npos);
}

// Sample of cases/02: crop.exr is columns 4 to 11, rows 3 to 8 of plain.exr.
TEST(Comparison, OfAPartWithTheWholeIsThatOfThePixelsBothHave) {
    const std::string samples = std::string(POL_TESTS_DIR) + "/data/pictures/cases/";
    Session session;
    ASSERT_TRUE(session.open(samples + "plain.exr"));
    session.set_reference();
    ASSERT_TRUE(session.open(samples + "crop.exr"));
    session.change_view().difference = true;
    for (const Quantity quantity : {Quantity::intensity, Quantity::s1, Quantity::azimuth, Quantity::poincare}) {
        session.show(quantity);
        ASSERT_TRUE(session.comparison());
        session.finish_shown_map();
        const MapSummary& found = session.shown_map().summary();
        EXPECT_EQ(found.pixels, 8U * 6U);
        EXPECT_GT(found.state[static_cast<std::size_t>(PixelState::defined)], 0U);
        EXPECT_EQ(found.low, 0.0) << info(quantity).name;
        EXPECT_EQ(found.high, 0.0) << info(quantity).name;
    }
    session.set_reference();
    session.step_document(1);
    session.show(Quantity::intensity);
    ASSERT_TRUE(session.comparison());
    session.finish_shown_map();
    const StokesImage& whole = session.current()->picture();
    ASSERT_EQ(whole.width, 16);
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 16; ++x) {
            const bool is_shared = x >= 4 && x <= 11 && y >= 3 && y <= 8;
            EXPECT_EQ(session.shown_map().states()[whole.pixel(x, y)],
                      is_shared ? PixelState::defined : PixelState::undefined)
                << x << "," << y;
        }
    }
}

TEST(Comparison, OfPartsThatShareNoPixelIsNotPossible) {
    Session session;
    StokesImage part = known_picture();
    part.whole_width = 40;
    part.whole_height = 12;
    session.open_picture(part, "left");
    session.set_reference();
    part.left = 16;
    session.open_picture(part, "right");
    EXPECT_NE(session.compare().error().what.find("share no pixel"), std::string::npos);
    part.left = 15;
    session.open_picture(part, "overlapping");
    EXPECT_TRUE(session.compare());
}

/// One pixel of each light, against one of another.
double poincare_of(const Stokes<double>& a, const Stokes<double>& b) {
    PixelLight light_a;
    PixelLight light_b;
    light_a.stokes = a;
    light_b.stokes = b;
    const MapPixel found = poincare_distance(light_a, light_b);
    return found.state == PixelState::defined ? found.value : -1.0;
}

// Half the angle on the sphere: that of the lines for linear states, 45 degrees from linear to circular, 90 to the
// opposite state, whatever intensity and degree of polarization are.
TEST(Poincare, DistanceIsHalfTheAngleOnTheSphere) {
    const auto linear = [](double degrees) {
        return polarized_light(2.0, 0.5, degrees * 3.141592653589793 / 180.0, 0.0);
    };
    EXPECT_NEAR(poincare_of(linear(10.0), linear(40.0)), 30.0, 1e-12);
    EXPECT_NEAR(poincare_of(linear(85.0), linear(-85.0)), 10.0, 1e-12) << "90 and -90 degrees are one line";
    EXPECT_NEAR(poincare_of(linear(0.0), linear(90.0)), 90.0, 1e-12);
    EXPECT_NEAR(poincare_of(linear(20.0), {1.0, 0.0, 0.0, 1.0}), 45.0, 1e-12);
    EXPECT_NEAR(poincare_of({1.0, 0.0, 0.0, 1.0}, {3.0, 0.0, 0.0, -2.0}), 90.0, 1e-12);
    EXPECT_EQ(poincare_of({1.0, 0.3, 0.4, 0.5}, {2.0, 0.6, 0.8, 1.0}), 0.0) << "the same state";
    EXPECT_EQ(poincare_of({1.0, 0.0, 0.0, 0.0}, linear(0.0)), -1.0) << "no state, no distance";
}

TEST(Poincare, IsShownAsADifferenceAtOnceAndNeedsAReference) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    session.show(Quantity::poincare);
    EXPECT_FALSE(session.comparison());
    EXPECT_NE(session.log().lines().back().text.find("no reference"), std::string::npos);
    session.finish_shown_map();
    EXPECT_EQ(session.shown_map().summary().state[static_cast<std::size_t>(PixelState::defined)], 0U);
    session.set_reference();
    StokesImage turned = known_picture();
    for (Stokes<double>& s : turned.stokes) s = {s.s0, -s.s2, s.s1, s.s3};  // by 45 degrees
    ASSERT_NO_FATAL_FAILURE(open_picture(session, turned));
    ASSERT_TRUE(session.comparison());
    EXPECT_EQ(map_look(session).kind, ScaleKind::sequential);
    EXPECT_EQ(map_look(session).range.low, 0.0);
    EXPECT_EQ(map_look(session).range.high, 90.0);
    session.finish_shown_map();
    const StokesImage& picture = session.current()->picture();
    const Stokes<double>& s = picture.at(0, picture.pixel(9, 9));
    // Between (r cos u, r sin u, z) and the same turned by a quarter the cosine is z^2 / (r^2 + z^2).
    const double cosine = s.s3 * s.s3 / (s.s1 * s.s1 + s.s2 * s.s2 + s.s3 * s.s3);
    const double expected = 0.5 * std::acos(cosine) * 180.0 / 3.141592653589793;
    EXPECT_NEAR(session.shown_map().values()[picture.pixel(9, 9)], expected, 1e-5) << "32-bit floats";
    session.toggle_difference();
    EXPECT_FALSE(session.comparison());
    EXPECT_FALSE(info(session.view().quantity).of_two) << "of one picture there is none";
}

// 89 and -89 degrees are 2 degrees apart.
TEST(Comparison, OfAzimuthsKnowsTheWrap) {
    Session session;
    StokesImage image = known_picture();
    const double degree = 3.141592653589793 / 180.0;
    for (Stokes<double>& s : image.stokes) s = polarized_light(1.0, 1.0, -89.0 * degree, 0.0);
    image.residual.assign(image.pixel_count(), 0.0);
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    session.set_reference();
    for (Stokes<double>& s : image.stokes) s = polarized_light(1.0, 1.0, 89.0 * degree, 0.0);
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    session.show(Quantity::azimuth);
    session.toggle_difference();
    session.finish_shown_map();
    for (const double value : session.shown_map().values()) EXPECT_NEAR(value, -2.0, 1e-4) << "32-bit floats";
    EXPECT_EQ(map_look(session).kind, ScaleKind::cyclic);
    EXPECT_EQ(map_look(session).scale, ColorScale::cyclic);
}

TEST(Layout, ShowsBothPicturesAsTheyAre) {
    Session session;
    session.toggle_layout(CompareLayout::wipe);
    EXPECT_EQ(session.layout(), CompareLayout::single);
    EXPECT_NE(session.log().lines().back().text.find("no reference"), std::string::npos);
    ASSERT_NO_FATAL_FAILURE(open_two(session));
    session.show(Quantity::dop);
    session.toggle_difference();
    EXPECT_FALSE(session.side(PictureSide::reference));
    EXPECT_TRUE(session.side(PictureSide::current)->is_difference);
    session.toggle_layout(CompareLayout::wipe);
    EXPECT_FALSE(session.comparison());
    EXPECT_EQ(session.layout(), CompareLayout::wipe);
    ASSERT_TRUE(session.side(PictureSide::reference));
    EXPECT_EQ(session.side(PictureSide::reference)->document, session.reference());
    EXPECT_FALSE(session.side(PictureSide::current)->is_difference);
    session.toggle_layout(CompareLayout::side_by_side);
    EXPECT_EQ(session.layout(), CompareLayout::side_by_side);
    session.step_document(1);
    EXPECT_EQ(session.layout(), CompareLayout::single) << "the reference alone";
    session.step_document(1);
    EXPECT_EQ(session.layout(), CompareLayout::side_by_side);
    session.toggle_difference();
    EXPECT_EQ(session.layout(), CompareLayout::single);
    session.toggle_layout(CompareLayout::wipe);
    session.toggle_layout(CompareLayout::wipe);
    EXPECT_EQ(session.layout(), CompareLayout::single);
}

TEST(Layout, ShowsTheSameBandOfTheReference) {
    Session session;
    StokesImage image = known_picture();
    image.bands = bands_at({600.0, 700.0});
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    session.set_reference();
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    session.change_view().band = 1;  // 600 nm
    session.toggle_layout(CompareLayout::wipe);
    ASSERT_TRUE(session.side(PictureSide::reference));
    EXPECT_EQ(session.side(PictureSide::reference)->band, 0U);
    session.change_view().band = 0;
    EXPECT_EQ(session.layout(), CompareLayout::single) << "the reference has no 500 nm";
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
