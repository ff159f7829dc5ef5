// SPDX-License-Identifier: Apache-2.0
// What the window says about a pixel is what the maps and the command line say.
#include <gtest/gtest.h>

#include <cstdio>

#include "core/units.h"
#include "known_picture.h"
#include "maps/color_picture.h"
#include "viewer/pages/pixel_readout.h"
#include "viewer/pages/readout_text.h"

namespace pol {
namespace {

TEST(PixelReadout, HasTheNumbersOfEveryMap) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    const StokesImage& picture = session.current()->picture();
    for (const PixelAddress at : {PixelAddress{0, 0}, PixelAddress{7, 5}, PixelAddress{15, 11}}) {
        const PixelReadout readout = read_pixel(session, at);
        ASSERT_EQ(readout.bands.size(), 2u);
        EXPECT_EQ(readout.samples, 4u);
        const std::size_t pixel = picture.pixel(at.x, at.y);
        EXPECT_EQ(readout.color, color_picture(picture)[pixel]);
        for (std::size_t w = 0; w < 2; ++w) {
            EXPECT_EQ(readout.bands[w].light.stokes, picture.at(w, pixel));
            for (const QuantityInfo& about : quantities()) {
                if (about.quantity == Quantity::color) continue;
                const auto map = evaluate(picture, about.quantity, w);
                ASSERT_TRUE(map);
                const MapPixel value = readout.quantity(about.quantity, w).pixel;
                EXPECT_EQ(value.state, map.value().pixels[pixel].state) << about.name;
                EXPECT_EQ(value.value, map.value().pixels[pixel].value) << about.name;
            }
        }
    }
}

// The residual of 1 % of a brightest of 1 is light that may be missing: S0 0.5 to 0.51.
TEST(PixelReadout, GivesEveryValueItsBar) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    const PixelReadout readout = read_pixel(session, {3, 9});
    const PixelLight& light = readout.bands[0].light;
    const double missing = light.missing;
    EXPECT_NEAR(missing, 0.01, 1e-9);
    for (const Quantity quantity : {Quantity::s1, Quantity::s2, Quantity::s3, Quantity::dop, Quantity::dolp,
                                    Quantity::docp, Quantity::ellipticity, Quantity::azimuth, Quantity::handedness}) {
        const QuantityReadout value = readout.quantity(quantity, 0);
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
        EXPECT_LT(value.bar->low, value.bar->high);
        const std::string text = readout_text(quantity, value);
        EXPECT_TRUE(text.find("\u00b1") != std::string::npos || text.find('[') != std::string::npos) << text;
    }
}

TEST(PixelReadout, StandsBehindThePolarimeter) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    session.set_polarimeter({{{PolarimeterElementKind::polarizer, true, radians(30.0), 0.0}}});
    const PixelReadout readout = read_pixel(session, {5, 6});
    EXPECT_NEAR(readout.quantity(Quantity::dop, 0).pixel.value, 1.0, 1e-12);
    EXPECT_NEAR(readout.quantity(Quantity::azimuth, 0).pixel.value, 30.0, 1e-9);
}

// What crossed polarizers leave is rounding, in a file that does not say how bright its light may be as well.
TEST(PixelReadout, SeesNoLightBehindCrossedPolarizers) {
    for (const bool says_brightest : {true, false}) {
        StokesImage image = known_picture();
        image.residual.clear();
        if (!says_brightest) image.brightest.clear();
        Session session;
        ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
        session.set_polarimeter({{{PolarimeterElementKind::polarizer, true, radians(30.0), 0.0},
                                  {PolarimeterElementKind::polarizer, true, radians(120.0), 0.0}}});
        const QuantityReadout value = read_pixel(session, {5, 6}).quantity(Quantity::dop, 0);
        EXPECT_EQ(value.pixel.state, PixelState::no_light) << says_brightest;
        EXPECT_EQ(readout_text(Quantity::dop, value), "no light");
    }
}

// What a convention does to a state is in CONVENTIONS.md: seen from the source S2, S3 and the azimuth change their
// signs, and with left positive S3 does.
TEST(PixelReadout, IsLabeledInTheShownConvention) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, known_picture()));
    const PixelReadout engine = read_pixel(session, {5, 9});
    for (const Viewpoint viewpoint : {Viewpoint::receiver, Viewpoint::source}) {
        for (const PositiveS3 positive : {PositiveS3::right, PositiveS3::left}) {
            session.change_view().convention = {viewpoint, positive, TimeSign::plus};
            const PixelReadout shown = read_pixel(session, {5, 9});
            const double mirror = viewpoint == Viewpoint::source ? -1.0 : 1.0;
            const double turn = positive == PositiveS3::left ? -mirror : mirror;
            const auto expect_times = [&](Quantity quantity, double sign) {
                const QuantityReadout a = engine.quantity(quantity, 0);
                const QuantityReadout b = shown.quantity(quantity, 0);
                // Half widths of degrees, and of numbers of order 1, with a few roundings.
                EXPECT_NEAR(b.pixel.value, sign * a.pixel.value, 1e-13) << info(quantity).name;
                EXPECT_NEAR(b.bar->width(), a.bar->width(), 1e-13) << info(quantity).name;
            };
            expect_times(Quantity::dop, 1.0);
            expect_times(Quantity::ellipticity, 1.0);
            expect_times(Quantity::s1, 1.0);
            expect_times(Quantity::s2, mirror);
            expect_times(Quantity::s3, turn);
            expect_times(Quantity::azimuth, mirror);
            expect_times(Quantity::handedness, turn);
        }
    }
}

// Negative S0 is a number, and so is what it is called by.
TEST(PixelReadout, CallsNegativeLightUnphysical) {
    StokesImage image = known_picture();
    image.stokes[image.pixel(3, 4)].s0 = -0.5;
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    const PixelReadout readout = read_pixel(session, {3, 4});
    EXPECT_EQ(readout_text(Quantity::dop, readout.quantity(Quantity::dop, 0)), "unphysical");
    EXPECT_NE(state_definition(PixelState::unphysical).find("S0"), std::string_view::npos);
    EXPECT_EQ(state_definition(PixelState::not_a_number).find("S0"), std::string_view::npos);
}

TEST(PixelReadout, SaysWhereTheIntensityHasNoUnit) {
    StokesImage image = known_picture();
    image.bands = bands_at({250.0, 600.0});
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    EXPECT_EQ(read_pixel(session, {1, 1}).quantity(Quantity::intensity, 0).pixel.state, PixelState::undefined);
    EXPECT_EQ(read_pixel(session, {1, 1}).quantity(Quantity::intensity, 1).pixel.state, PixelState::defined);
}

QuantityReadout readout_of(double value, double low, double high) {
    return {{value, 1.0, PixelState::defined}, Interval<double>{low, high}, 1e-12};
}

// 0.9975 - 0.4665 = 0.531: 1.464 is no degree of polarization.
TEST(ReadoutText, WritesAOneSidedBarAsTheIntervalThatItIs) {
    EXPECT_EQ(readout_text(Quantity::dop, readout_of(0.9975, 0.531, 0.9975)), "0.998 [0.531, 0.998]");
    EXPECT_EQ(readout_text(Quantity::dop, readout_of(0.5, 0.45, 0.56)), "0.5 [0.45, 0.56]");
    EXPECT_EQ(readout_text(Quantity::azimuth, readout_of(10.0, 9.0, 12.5)), "10\u00b0 [9\u00b0, 12.5\u00b0]");
    EXPECT_EQ(readout_text(Quantity::intensity, readout_of(0.5, 0.5, 0.51)), "0.5 \u00d7 D65 [0.5, 0.51] \u00d7 D65");
    EXPECT_EQ(readout_text(Quantity::dop, {{0.0, 0.0, PixelState::undetermined}, Interval<double>{0.2, 1.0}}),
              "not determined [0.2, 1]");
    EXPECT_EQ(readout_text(Quantity::dop, {{0.0, 0.0, PixelState::dark}, Interval<double>{0.2, 1.0}}), "dark [0.2, 1]");
}

// The ends of what is written contain the truth, too.
TEST(ReadoutText, RoundsBarsOutwardsAndEndsDigitsWhereTheyBegin) {
    EXPECT_EQ(readout_text(Quantity::dop, readout_of(0.8312449, 0.8312449 - 0.00204, 0.8312449 + 0.00204)),
              "0.8312 \u00b1 0.0021");
    EXPECT_EQ(readout_text(Quantity::dop, readout_of(0.12345678, 0.1, 0.4)), "0.123 [0.1, 0.4]");
    EXPECT_EQ(readout_text(Quantity::s1, readout_of(-0.123456, -0.123456 - 0.3, -0.123456 + 0.3)), "-0.12 \u00b1 0.3");
    EXPECT_EQ(readout_text(Quantity::intensity, readout_of(1.23456e-7, 1.23456e-7 - 4e-9, 1.23456e-7 + 4e-9)),
              "1.235e-07 \u00d7 D65 \u00b1 4e-09 \u00d7 D65");
    EXPECT_EQ(value_text(Quantity::dop, readout_of(0.8312449, 0.7312449, 0.9312449), 6), "0.83");
    for (int i = 1; i < 200; ++i) {
        const double low = 0.37 * i / 200.0;
        const double high = 0.4 + 0.59 * i / 200.0;
        const std::string text = interval_text({low, high}, 0.0, "");
        double a = 0.0;
        double b = 0.0;
        ASSERT_EQ(std::sscanf(text.c_str(), "[%lf, %lf]", &a, &b), 2) << text;
        // A step of the last digit is up to 1e-3; numbers are parsed with one rounding.
        EXPECT_LE(a, low + 1e-15) << text;
        EXPECT_GE(a, low - 1e-3) << text;
        EXPECT_GE(b, high - 1e-15) << text;
        EXPECT_LE(b, high + 1e-3) << text;
    }
}

// 1e-17 beside 1 is what is left of a difference of equal numbers. 1e-9 is not.
TEST(ReadoutText, WritesWhatIsNothingButRoundingAsZero) {
    EXPECT_EQ(readout_text(Quantity::s2, readout_of(1.2e-17, 1.2e-17, 1.2e-17)), "0");
    EXPECT_EQ(readout_text(Quantity::s2, readout_of(-1.2e-9, -1.2e-9, -1.2e-9)), "-1.2e-09");
    EXPECT_EQ(readout_text(Quantity::ellipticity, readout_of(0.5, 0.5 - 1e-16, 0.5 + 1e-16)), "0.5");
    EXPECT_EQ(readout_text(Quantity::s2, readout_of(3e-17, -0.25, 0.25)), "0 \u00b1 0.25");
    EXPECT_EQ(short_number(6.1e-17, 6, 1.0), "0");
    EXPECT_EQ(short_number(6.1e-9, 6, 1.0), "6.1e-09");
    Session session;
    StokesImage image = known_picture();
    image.residual.clear();
    image.stokes.assign(image.stokes.size(), {0.5, 0.5, 3e-17, -6e-17});
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    const PixelReadout readout = read_pixel(session, {3, 4});
    EXPECT_EQ(readout_text(Quantity::azimuth, readout.quantity(Quantity::azimuth, 0)), "0\u00b0");
    EXPECT_EQ(readout_text(Quantity::ellipticity, readout.quantity(Quantity::ellipticity, 0)), "0");
}

TEST(ReadoutText, IsShortAndHonest) {
    EXPECT_EQ(short_number(-0.0, 4), "0");
    EXPECT_EQ(readout_text(Quantity::azimuth, {{12.5, 1.0, PixelState::defined}, Interval<double>{12.0, 13.0}}),
              "12.5\u00b0 \u00b1 0.5\u00b0");
    EXPECT_EQ(readout_text(Quantity::dop, {{0.25, 1.0, PixelState::defined}, Interval<double>{0.25, 0.25}}), "0.25");
    EXPECT_EQ(readout_text(Quantity::dop, {{0.25, 0.0, PixelState::undetermined}, std::nullopt}), "not determined");
}

}  // namespace
}  // namespace pol
