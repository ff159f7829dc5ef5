// SPDX-License-Identifier: Apache-2.0
// What the window says about a pixel is what the maps and the command line say.
#include <gtest/gtest.h>

#include "core/units.h"
#include "known_picture.h"
#include "maps/color_picture.h"
#include "viewer/pixel_reading.h"
#include "viewer/reading_text.h"

namespace pol {
namespace {

TEST(PixelReading, HasTheNumbersOfEveryMap) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    const StokesImage& picture = session.current()->picture();
    for (const PixelAddress at : {PixelAddress{0, 0}, PixelAddress{7, 5}, PixelAddress{15, 11}}) {
        const PixelReading reading = read_pixel(session, at);
        ASSERT_EQ(reading.wavelengths.size(), 2u);
        EXPECT_EQ(reading.samples, 4u);
        const std::size_t pixel = picture.pixel(at.x, at.y);
        EXPECT_EQ(reading.color, color_picture(picture)[pixel]);
        for (std::size_t w = 0; w < 2; ++w) {
            EXPECT_EQ(reading.wavelengths[w].light.stokes, picture.at(w, pixel));
            for (const QuantityInfo& about : quantities()) {
                if (about.quantity == Quantity::color) continue;
                const auto map = evaluate(picture, about.quantity, w);
                ASSERT_TRUE(map);
                const MapPixel value = reading.quantity(about.quantity, w).pixel;
                EXPECT_EQ(value.state, map.value().pixels[pixel].state) << about.name;
                EXPECT_EQ(value.value, map.value().pixels[pixel].value) << about.name;
            }
        }
    }
}

// The residual of 1 % of a brightest of 1 is light that may be missing: S0 0.5 to 0.51.
TEST(PixelReading, GivesEveryValueItsBar) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    const PixelReading reading = read_pixel(session, {3, 9});
    const PixelLight& light = reading.wavelengths[0].light;
    const double missing = light.missing;
    EXPECT_NEAR(missing, 0.01, 1e-9);
    for (const Quantity quantity : {Quantity::s1, Quantity::s2, Quantity::s3, Quantity::dop, Quantity::dolp,
                                    Quantity::docp, Quantity::ellipticity, Quantity::azimuth, Quantity::handedness}) {
        const QuantityReading value = reading.quantity(quantity, 0);
        ASSERT_TRUE(value.bar);
        // Any pure state with the missing light added stays inside.
        for (double psi = 0.0; psi < 3.1; psi += 0.3) {
            for (const double chi : {-pi / 4.0, -0.3, 0.0, 0.6}) {
                PixelLight truth = light;
                truth.stokes += polarized_light(missing, 1.0, psi, chi);
                double there = evaluate_light(truth, quantity, 1.0).value;
                if (quantity == Quantity::azimuth) there -= 180.0 * std::round((there - value.pixel.value) / 180.0);
                EXPECT_GE(there, value.bar->low - 1e-12) << info(quantity).name;
                EXPECT_LE(there, value.bar->high + 1e-12) << info(quantity).name;
            }
        }
        EXPECT_GT(*value.half_width(), 0.0);
        EXPECT_NE(reading_text(quantity, value).find("\u00b1"), std::string::npos);
    }
}

TEST(PixelReading, StandsBehindTheBench) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    session.bench.elements.push_back({BenchElementKind::polarizer, true, radians(30.0), 0.0});
    const PixelReading reading = read_pixel(session, {5, 6});
    EXPECT_NEAR(reading.quantity(Quantity::dop, 0).pixel.value, 1.0, 1e-12);
    EXPECT_NEAR(reading.quantity(Quantity::azimuth, 0).pixel.value, 30.0, 1e-9);
}

// What crossed polarizers leave is rounding, in a file that does not say how bright its light may be as well.
TEST(PixelReading, SeesNoLightBehindCrossedPolarizers) {
    for (const bool says_brightest : {true, false}) {
        StokesImage image = known_picture();
        image.residual.clear();
        if (!says_brightest) image.brightest.clear();
        Session session;
        ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
        session.bench.elements.push_back({BenchElementKind::polarizer, true, radians(30.0), 0.0});
        session.bench.elements.push_back({BenchElementKind::polarizer, true, radians(120.0), 0.0});
        const QuantityReading value = read_pixel(session, {5, 6}).quantity(Quantity::dop, 0);
        EXPECT_EQ(value.pixel.state, PixelState::no_light) << says_brightest;
        EXPECT_EQ(reading_text(Quantity::dop, value), "no light");
    }
}

TEST(PixelReading, SaysWhereTheIntensityHasNoUnit) {
    StokesImage image = known_picture();
    image.wavelengths_nm = {250.0, 600.0};
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    EXPECT_EQ(read_pixel(session, {1, 1}).quantity(Quantity::intensity, 0).pixel.state, PixelState::undefined);
    EXPECT_EQ(read_pixel(session, {1, 1}).quantity(Quantity::intensity, 1).pixel.state, PixelState::defined);
}

TEST(ReadingText, IsShortAndHonest) {
    EXPECT_EQ(short_number(-0.0, 4), "0");
    EXPECT_EQ(reading_text(Quantity::azimuth, {{12.5, 1.0, PixelState::defined}, Interval<double>{12.0, 13.0}}),
              "12.5\u00b0 \u00b1 0.5\u00b0");
    EXPECT_EQ(reading_text(Quantity::dop, {{0.25, 1.0, PixelState::defined}, Interval<double>{0.25, 0.25}}), "0.25");
    EXPECT_EQ(reading_text(Quantity::dop, {{0.25, 0.0, PixelState::undetermined}, std::nullopt}), "not determined");
}

}  // namespace
}  // namespace pol
