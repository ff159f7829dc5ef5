// SPDX-License-Identifier: Apache-2.0
// Map values against closed forms. Tolerances: a handful of roundings of numbers of order 1, so 1e-14 (of order 90
// degrees: 1e-12), unless a comment says otherwise.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "core/units.h"
#include "maps/color_picture.h"
#include "maps/error_bars.h"
#include "maps/evaluate.h"
#include "maps/quantity.h"

namespace pol {
namespace {

/// One pixel at one wavelength.
StokesImage one_pixel(const Stokes<double>& s, double wavelength_nm = 580.0) {
    StokesImage image;
    image.width = 1;
    image.height = 1;
    image.bands = bands_at({wavelength_nm});
    image.stokes = {s};
    return image;
}

StokesImage with_residual(StokesImage image, double residual) {
    image.residual = {residual};
    image.brightest = {1.0};
    return image;
}

MapPixel pixel(const StokesImage& image, Quantity quantity) {
    return evaluate_pixel(image, quantity, 0, 0, 1.0);
}

/// Light of radiance 2 with degree of polarization `p`, azimuth `psi` and ellipticity angle `chi` (Poincare sphere).
Stokes<double> state(double p, double psi, double chi) {
    return {2.0, 2.0 * p * std::cos(2.0 * chi) * std::cos(2.0 * psi),
            2.0 * p * std::cos(2.0 * chi) * std::sin(2.0 * psi), 2.0 * p * std::sin(2.0 * chi)};
}

TEST(Quantity, IsFoundByItsOwnNameAndByTheNearestToATypo) {
    for (const QuantityInfo& about : quantities()) {
        EXPECT_EQ(quantity_named(about.name), about.quantity);
        EXPECT_EQ(&info(about.quantity), &about);
        EXPECT_FALSE(about.definition.empty());
    }
    EXPECT_FALSE(quantity_named("dopp"));
    EXPECT_EQ(nearest_quantity("azimut"), Quantity::azimuth);
    EXPECT_EQ(nearest_quantity("colour"), Quantity::color);
    EXPECT_EQ(nearest_quantity("elipticity"), Quantity::ellipticity);
}

TEST(Quantity, RowsAreUniqueWhereTheyMustBe) {
    std::set<std::string_view> names;
    std::set<std::string_view> titles;
    std::set<std::string_view> list_titles;
    std::set<std::pair<char, bool>> keys;
    for (const QuantityInfo& about : quantities()) {
        SCOPED_TRACE(about.name);
        EXPECT_TRUE(names.insert(about.name).second);
        EXPECT_TRUE(titles.insert(about.title).second);
        EXPECT_TRUE(list_titles.insert(about.title_in_list()).second);
        const MapKey key = about.key;
        EXPECT_TRUE(key == MapKey{} || keys.emplace(key.letter, key.shift).second) << "two maps have the key";
        const bool is_plain = (key.letter >= '0' && key.letter <= '9') || (key.letter >= 'A' && key.letter <= 'Z');
        EXPECT_TRUE(key == MapKey{} || is_plain);
        // The name is a part of an identifier in the shaders.
        EXPECT_EQ(about.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string_view::npos);
    }
}

TEST(Quantity, RowsSayWhatListsAndPagesNeed) {
    std::set<MapGroup> begun;
    std::optional<MapGroup> last;
    for (const QuantityInfo& about : quantities()) {
        SCOPED_TRACE(about.name);
        EXPECT_TRUE(about.group == last || begun.insert(about.group).second) << "its group is torn apart";
        last = about.group;
        EXPECT_EQ(about.row_name.empty(), about.group != MapGroup::polarization);
        EXPECT_EQ(about.low_word.empty(), about.high_word.empty());
        EXPECT_TRUE(std::isnan(about.high) || about.low < about.high);
        EXPECT_TRUE(about.kind != ScaleKind::diverging || about.low == -about.high);
        EXPECT_TRUE(about.row_name.empty() || about.from_source.empty() || !about.in_a_frame.empty())
            << "its page may be in any convention";
    }
}

/// Light with all properties, of which a little was left out.
PixelLight some_light() {
    PixelLight light;
    light.stokes = {1.0, -0.4, -0.3, -0.55};
    light.missing = 0.02;
    light.surplus = 0.005;
    light.residual = 0.015;
    light.samples = 16.0;
    light.scale = 1.0;
    return light;
}

TEST(Quantity, EveryRowHasItsFormulaAndABarExactlyIfItSaysSo) {
    const PixelLight light = some_light();
    std::set<double> values;
    for (const QuantityInfo& about : quantities()) {
        if (about.kind == ScaleKind::color) continue;
        SCOPED_TRACE(about.name);
        const MapPixel pixel = evaluate_light(light, about.quantity, 0.9);
        EXPECT_EQ(pixel.state, PixelState::defined);
        EXPECT_TRUE(values.insert(pixel.value).second) << "another map has the same value";
        EXPECT_GE(pixel.value, about.low);
        EXPECT_TRUE(about.kind == ScaleKind::gray || !(pixel.value > about.high)) << pixel.value;
        const auto bar = error_bar(light, about.quantity, 0.9);
        ASSERT_EQ(bar.has_value(), about.has_bar);
        if (!bar) continue;
        EXPECT_LT(bar->low, pixel.value);
        EXPECT_GT(bar->high, pixel.value);
    }
}

// The row says which part of the light has the property; the formulas are asked.
TEST(Quantity, IsUndefinedExactlyWhereItsCarrierIsMissing) {
    PixelLight unpolarized = some_light();
    unpolarized.stokes = {1.0, 0.0, 0.0, 0.0};
    PixelLight circular = some_light();
    circular.stokes = {1.0, 0.0, 0.0, 1.0};
    for (PixelLight* light : {&unpolarized, &circular}) light->missing = light->surplus = light->residual = 0.0;
    for (const QuantityInfo& about : quantities()) {
        if (about.kind == ScaleKind::color) continue;
        SCOPED_TRACE(about.name);
        const auto is_defined = [&](const PixelLight& light) {
            return evaluate_light(light, about.quantity, 1.0).state == PixelState::defined;
        };
        EXPECT_EQ(is_defined(unpolarized), about.carrier == Carrier::light);
        EXPECT_EQ(is_defined(circular), about.carrier != Carrier::linear_part);
    }
}

TEST(Evaluate, GivesBackTheStateThatThePointOnThePoincareSphereNames) {
    for (const double p : {0.1, 0.5, 1.0}) {
        for (const double psi : {-1.2, -0.3, 0.0, 0.7, 1.5}) {
            for (const double chi : {-0.7, -0.2, 0.0, 0.4}) {
                SCOPED_TRACE(testing::Message() << p << " " << psi << " " << chi);
                const StokesImage image = one_pixel(state(p, psi, chi));
                EXPECT_NEAR(pixel(image, Quantity::dop).value, p, 1e-14);
                EXPECT_NEAR(pixel(image, Quantity::dolp).value, p * std::cos(2.0 * chi), 1e-14);
                EXPECT_NEAR(pixel(image, Quantity::docp).value, p * std::abs(std::sin(2.0 * chi)), 1e-14);
                EXPECT_NEAR(pixel(image, Quantity::ellipticity).value, std::abs(std::tan(chi)), 1e-14);
                // The linear part is at least 0.1 cos(1.4) = 0.017 of S0, which magnifies a rounding 60 times.
                EXPECT_NEAR(pixel(image, Quantity::azimuth).value, degrees(psi), 1e-11);
                EXPECT_NEAR(pixel(image, Quantity::handedness).value, std::sin(2.0 * chi), 1e-14);
                EXPECT_NEAR(pixel(image, Quantity::s1).value, p * std::cos(2.0 * chi) * std::cos(2.0 * psi), 1e-14);
                EXPECT_NEAR(pixel(image, Quantity::s2).value, p * std::cos(2.0 * chi) * std::sin(2.0 * psi), 1e-14);
                EXPECT_NEAR(pixel(image, Quantity::s3).value, p * std::sin(2.0 * chi), 1e-14);
                EXPECT_EQ(pixel(image, Quantity::unphysical).value, 0.0);
            }
        }
    }
}

TEST(Evaluate, TellsNoLightFromUnpolarizedLightFromLightThatWasNotTraced) {
    const StokesImage dark = one_pixel({0.0, 0.0, 0.0, 0.0});
    const StokesImage unpolarized = one_pixel({1.0, 0.0, 0.0, 0.0});
    for (const Quantity quantity :
         {Quantity::dop, Quantity::azimuth, Quantity::ellipticity, Quantity::handedness, Quantity::s1}) {
        SCOPED_TRACE(info(quantity).name);
        EXPECT_EQ(pixel(dark, quantity).state, PixelState::no_light);
        EXPECT_EQ(pixel(with_residual(dark, 0.01), quantity).state, PixelState::undetermined);
    }
    EXPECT_EQ(pixel(unpolarized, Quantity::dop).state, PixelState::defined);
    EXPECT_EQ(pixel(unpolarized, Quantity::azimuth).state, PixelState::undefined);
    EXPECT_EQ(pixel(unpolarized, Quantity::ellipticity).state, PixelState::undefined);
    // A residual of 1 % cannot polarize it by more than 1 %: still unpolarized. One of a half can.
    EXPECT_EQ(pixel(with_residual(unpolarized, 0.01), Quantity::azimuth).state, PixelState::undefined);
    EXPECT_EQ(pixel(with_residual(unpolarized, 0.5), Quantity::azimuth).state, PixelState::undetermined);
}

/// Three pixels side by side at one wavelength; the first is the brightest one.
StokesImage three_pixels(const Stokes<double>& a, const Stokes<double>& b, const Stokes<double>& c) {
    StokesImage image = one_pixel(a);
    image.width = 3;
    image.stokes = {a, b, c};
    image.residual = {0.0, 0.0, 0.0};
    image.brightest = {1.0};
    return image;
}

std::vector<PixelState> states_of(const StokesImage& image, Quantity quantity) {
    std::vector<PixelState> states;
    const Map map = evaluate(image, quantity, 0).value();
    for (const MapPixel& pixel : map.pixels) states.push_back(pixel.state);
    return states;
}

// CUTTING.md 1.2: the truth has at most S0 + missing there, and the brightest pixel at least S0 - surplus.
TEST(Evaluate, CallsDarkWhatNoMissingLightCanMakeAThousandthOfTheBrightestPixel) {
    using enum PixelState;
    const Stokes<double> none{};
    for (const Quantity quantity : {Quantity::dop, Quantity::ellipticity, Quantity::azimuth, Quantity::s1}) {
        SCOPED_TRACE(info(quantity).name);
        StokesImage image = three_pixels({0.5, 0.25, 0.0, 0.1}, none, none);
        // Less than 5e-4 in all; as much; nothing at all. Whatever lies in between is not determined.
        image.stokes[1] = {1e-5, 1e-6, 0.0, 0.0};
        image.residual = {0.0, 4.8e-4, 0.0};
        EXPECT_EQ(states_of(image, quantity), (std::vector{defined, dark, no_light}));
        image.residual[1] = 4.9e-4;
        EXPECT_EQ(states_of(image, quantity)[1], undetermined);
        image.residual = {0.0, 0.0, 3.9e-4};
        image.stokes[1] = {0.4, 0.1, 0.0, 0.1};
        EXPECT_EQ(states_of(image, quantity), (std::vector{defined, defined, dark})) << "nothing was found of it";
        // What a random tail has told of the brightest pixel may not be there.
        image.tail = {0.2, 0.0, 0.0};
        EXPECT_EQ(states_of(image, quantity)[2], dark) << "another pixel has 0.4";
        image.stokes[1] = none;
        EXPECT_EQ(states_of(image, quantity)[2], undetermined) << "0.3 is sure";
    }
}

TEST(Evaluate, ShowsOfDarknessWhatIsKnown) {
    StokesImage image = three_pixels({1.0, 0.0, 0.0, 0.0}, {1e-5, 5e-6, 0.0, 5e-6}, {1e-5, 5e-6, 0.0, 5e-6});
    image.residual = {0.0, 1e-7, 1e-4};
    using enum PixelState;
    EXPECT_EQ(states_of(image, Quantity::dop), (std::vector{defined, defined, dark}));
    EXPECT_EQ(states_of(image, Quantity::azimuth), (std::vector{undefined, defined, dark}));
    EXPECT_EQ(states_of(image, Quantity::intensity), (std::vector{defined, defined, defined}));
    EXPECT_EQ(states_of(image, Quantity::dop_error), (std::vector{defined, defined, defined}));
}

TEST(Evaluate, HasNoAzimuthForCircularLightAndNoEllipticityInTheNoiseOfUnpolarizedLight) {
    EXPECT_EQ(pixel(one_pixel({1.0, 0.0, 0.0, 1.0}), Quantity::azimuth).state, PixelState::undefined);
    EXPECT_DOUBLE_EQ(pixel(one_pixel({1.0, 0.0, 0.0, 1.0}), Quantity::ellipticity).value, 1.0);
    EXPECT_EQ(pixel(one_pixel({1.0, 1e-16, 0.0, 3e-16}), Quantity::ellipticity).state, PixelState::undefined);
}

TEST(Evaluate, FadesLinearlyWithThePolarizedPartThatCarriesTheDirection) {
    const MapPixel faint = pixel(one_pixel({1.0, 0.01, 0.0, 0.0}), Quantity::azimuth);
    EXPECT_NEAR(faint.weight, 0.01 / full_weight_polarization, 1e-14);
    EXPECT_EQ(pixel(one_pixel({1.0, 0.5, 0.0, 0.0}), Quantity::azimuth).weight, 1.0);
    // Circular light: fully polarized, so its handedness has full weight although its azimuth has none.
    EXPECT_EQ(pixel(one_pixel({1.0, 0.0, 0.0, -1.0}), Quantity::handedness).weight, 1.0);
    EXPECT_EQ(pixel(one_pixel({1.0, 0.01, 0.0, 0.0}), Quantity::dop).weight, 1.0);
}

TEST(Evaluate, ReportsNumbersThatAreNoLightInsteadOfRepairingThem) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Stokes<double>& s : {Stokes<double>{nan, 0.0, 0.0, 0.0},
                                    {1.0, nan, 0.0, 0.0},
                                    {infinity, 0.0, 0.0, 0.0},
                                    {1.0, 0.0, 0.0, infinity}}) {
        EXPECT_EQ(pixel(one_pixel(s), Quantity::dop).state, PixelState::not_a_number);
        EXPECT_EQ(pixel(one_pixel(s), Quantity::azimuth).state, PixelState::not_a_number);
        EXPECT_EQ(pixel(one_pixel(s), Quantity::unphysical).state, PixelState::not_a_number);
    }
    EXPECT_EQ(pixel(one_pixel({nan, 0.0, 0.0, 0.0}), Quantity::intensity).state, PixelState::not_a_number);
    EXPECT_EQ(pixel(with_residual(one_pixel({1.0, 0.5, 0.0, 0.0}), nan), Quantity::dop).state,
              PixelState::not_a_number);
}

// They are numbers, and are called by what is wrong with them.
TEST(Evaluate, CallsNumbersThatNoLightHasUnphysicalAndNotNoNumber) {
    for (const Stokes<double>& s : {Stokes<double>{-1.0, 0.0, 0.0, 0.0}, {-1e-9, 0.0, 0.0, 1e-9}, {0.0, 0.0, 0.5, 0.0}})
        for (const Quantity quantity : {Quantity::dop, Quantity::azimuth, Quantity::ellipticity, Quantity::handedness,
                                        Quantity::s1, Quantity::azimuth_error})
            EXPECT_EQ(pixel(with_residual(one_pixel(s), 0.0), quantity).state, PixelState::unphysical)
                << info(quantity).name;
    EXPECT_EQ(pixel(with_residual(one_pixel({1.0, 0.5, 0.0, 0.0}), -0.1), Quantity::dop).state, PixelState::unphysical);
    EXPECT_EQ(pixel(one_pixel({-1.0, 0.0, 0.0, 0.0}), Quantity::intensity).value, -1.0) << "the number itself is there";
}

// Widths of the bars of the next test but one over half of the range: P by 0.2/2.1 of 0.5, the azimuth by asin(0.1)/2
// to both sides of a quarter of pi.
TEST(Evaluate, IsTheLessCertainTheWiderTheBarUntilNothingIsDetermined) {
    StokesImage image = with_residual(one_pixel({2.0, 1.0, 0.0, 0.0}), 0.05);
    image.brightest = {2.0};
    EXPECT_NEAR(pixel(image, Quantity::dop).certainty, 1.0 - 2.0 * 0.2 / 2.1, 1e-14);
    EXPECT_NEAR(pixel(image, Quantity::azimuth).certainty, 1.0 - std::asin(0.1) / 2.0 / (pi / 4.0), 1e-14);
    EXPECT_NEAR(pixel(image, Quantity::s1).certainty, 1.0 - 0.2 / 2.0, 1e-14);
    EXPECT_EQ(pixel(one_pixel({2.0, 1.0, 0.0, 0.0}), Quantity::dop).certainty, 1.0);
    EXPECT_EQ(pixel(image, Quantity::residual).certainty, 1.0) << "a bound has no bar";
    // The bar of S1 / S0 covers half of -1..1 when 0.5 of 2 is missing to both sides of S1.
    image.residual = {0.4999};
    EXPECT_LT(pixel(image, Quantity::s1).certainty, 1e-3);
    image.residual = {0.5001};
    EXPECT_EQ(pixel(image, Quantity::s1).state, PixelState::undetermined);
}

TEST(Evaluate, SamplesAreThoseOfThePixelWhereItsLightIsSome) {
    StokesImage image = one_pixel({1.0, 0.5, 0.0, 0.0});
    EXPECT_EQ(pixel(image, Quantity::samples).state, PixelState::not_measured) << "the picture does not tell";
    image.samples = {4096};
    EXPECT_EQ(pixel(image, Quantity::samples).value, 4096.0);
    image.stokes[0] = {};
    EXPECT_EQ(pixel(image, Quantity::samples).value, 4096.0) << "dark pixels cost samples, too";
    image.stokes[0] = {1.0, 1.5, 0.0, 0.0};
    EXPECT_EQ(pixel(image, Quantity::samples).state, PixelState::unphysical);
    image.stokes[0].s0 = std::nan("");
    EXPECT_EQ(pixel(image, Quantity::samples).state, PixelState::not_a_number);
}

TEST(Evaluate, ShowsHowFarAVectorIsFromBeingLight) {
    EXPECT_NEAR(pixel(one_pixel({1.0, 1.5, 0.0, 0.0}), Quantity::unphysical).value, 0.5 / 2.5, 1e-15);
    EXPECT_EQ(pixel(one_pixel({-1.0, 0.0, 0.0, 0.0}), Quantity::unphysical).value, 1.0);
    EXPECT_EQ(pixel(one_pixel({0.0, 0.0, 0.0, 1e-9}), Quantity::unphysical).value, 1.0);
    // Rounded to floats, fully polarized light may come out a trace above 1, which is not the renderer's doing.
    EXPECT_EQ(pixel(one_pixel({1.0, 1.0 + 0x1p-24, 0.0, 0.0}), Quantity::unphysical).value, 0.0);
    EXPECT_GT(pixel(one_pixel({1.0, 1.0 + 0x1p-22, 0.0, 0.0}), Quantity::unphysical).value, 0.0);
    StokesImage halves = one_pixel({1.0, 1.0 + 0x1p-11, 0.0, 0.0});
    EXPECT_GT(pixel(halves, Quantity::unphysical).value, 0.0);
    halves.stored.bits = 16;
    EXPECT_EQ(pixel(halves, Quantity::unphysical).value, 0.0);
    halves.stokes[0].s1 = 1.0 + 0x1p-9;
    EXPECT_GT(pixel(halves, Quantity::unphysical).value, 0.0);
    // Whole numbers are off by a half each: 1, 1, 1 may be light of 1.4, fully polarized.
    StokesImage counts = one_pixel({1.0, 1.0, 1.0, 0.0});
    EXPECT_GT(pixel(counts, Quantity::unphysical).value, 0.0);
    counts.stored.spacing = 1.0;
    EXPECT_EQ(pixel(counts, Quantity::unphysical).value, 0.0);
    counts.stokes[0].s1 = 4.0;
    EXPECT_GT(pixel(counts, Quantity::unphysical).value, 0.0);
}

// S0 in [2, 2.1]; the missing light can add 0.1 to the polarized part 1 or take 0.1 from it: P between 0.9/2.1 and
// 1.1/2.1 around 0.5 (CUTTING.md 1.2). Azimuth: asin(0.1) / 2. b/a: tan(asin(0.1) / 2).
TEST(ErrorBars, AreThoseOfTheLightThatWasNotTraced) {
    StokesImage image = with_residual(one_pixel({2.0, 1.0, 0.0, 0.0}), 0.05);
    image.brightest = {2.0};
    EXPECT_NEAR(pixel(image, Quantity::residual).value, 0.05, 0.0);
    EXPECT_NEAR(pixel(image, Quantity::dop_error).value, 0.5 - 0.9 / 2.1, 1e-14);
    EXPECT_NEAR(pixel(image, Quantity::azimuth_error).value, degrees(std::asin(0.1) / 2.0), 1e-12);
    EXPECT_NEAR(pixel(image, Quantity::ellipticity_error).value, std::tan(std::asin(0.1) / 2.0), 1e-14);
}

// The tail stands in for light that was left out: the truth may have that light as well, or not the estimate. Ball of
// radius (0.05 + 0.05 + 0.05) * 1 about 1, S0 up to 2.1 and down to 1.95: P in [0.85/2.05, 1.15/2.05].
TEST(ErrorBars, CountTheRandomTailOnBothSides) {
    StokesImage image = with_residual(one_pixel({2.0, 1.0, 0.0, 0.0}), 0.05);
    image.tail = {0.05};
    const auto bars = error_bars(image, 0, 0);
    ASSERT_TRUE(bars);
    EXPECT_NEAR(bars->s0.low, 1.95, 1e-15);
    EXPECT_NEAR(bars->s0.high, 2.1, 1e-15);
    EXPECT_NEAR(bars->dop.low, 0.85 / 2.05, 1e-14);
    EXPECT_NEAR(bars->dop.high, 1.15 / 2.05, 1e-14);
}

TEST(ErrorBars, ArePerWavelengthIfTheResidualIs) {
    StokesImage image;
    image.width = 1;
    image.height = 1;
    image.bands = bands_at({500.0, 600.0});
    image.stokes = {{1.0, 0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};
    image.brightest = {1.0, 2.0};
    image.residual = {0.1};
    EXPECT_DOUBLE_EQ(error_bars(image, 0, 0)->s0.high, 1.1);
    EXPECT_DOUBLE_EQ(error_bars(image, 1, 0)->s0.high, 1.2);
    image.residual = {0.1, 0.3};
    EXPECT_DOUBLE_EQ(error_bars(image, 1, 0)->s0.high, 1.6);
}

TEST(ErrorBars, AreNotKnownOfAPictureThatDoesNotTellWhatWasLeftOut) {
    const StokesImage image = one_pixel({2.0, 1.0, 0.5, 0.25});
    for (const Quantity quantity :
         {Quantity::residual, Quantity::dop_error, Quantity::ellipticity_error, Quantity::azimuth_error})
        EXPECT_EQ(pixel(image, quantity).state, PixelState::not_measured) << info(quantity).name;
    EXPECT_EQ(pixel(image, Quantity::unphysical).state, PixelState::defined);
}

TEST(ErrorBars, AreEmptyWithoutMissingLight) {
    const StokesImage image = with_residual(one_pixel({2.0, 1.0, 0.5, 0.25}), 0.0);
    EXPECT_EQ(pixel(image, Quantity::dop_error).value, 0.0);
    EXPECT_EQ(pixel(image, Quantity::azimuth_error).value, 0.0);
    EXPECT_NEAR(pixel(image, Quantity::ellipticity_error).value, 0.0, 1e-15);
}

// CIE D65 at 580 nm is 95.788 where it is 100 at 560 nm; the paper's gray is the radiance divided by that.
TEST(Intensity, IsRelativeToD65AtTheWavelength) {
    const Result<Map> map = evaluate(one_pixel({0.95788, 0.0, 0.0, 0.0}), Quantity::intensity, 0);
    ASSERT_TRUE(map);
    EXPECT_NEAR(map.value().pixels[0].value, 1.0, 1e-12);
    EXPECT_FALSE(evaluate(one_pixel({1.0, 0.0, 0.0, 0.0}, 1500.0), Quantity::intensity, 0));
}

TEST(ColorPicture, IsGrayForOneWavelengthAndTheSameAsTheIntensity) {
    const std::vector<Rgb> color = color_picture(one_pixel({0.95788 / 2.0, 0.0, 0.0, 0.0}));
    for (const double channel : color[0]) EXPECT_NEAR(channel, 0.5, 1e-12);
}

TEST(ColorPicture, OfLongWavesIsReddishAndOfShortWavesBluish) {
    StokesImage image;
    image.width = 2;
    image.height = 1;
    image.bands = bands_at({450.0, 550.0, 630.0});
    image.stokes = {{0.0}, {1.0}, {0.1}, {0.1}, {1.0}, {0.0}};
    const std::vector<Rgb> color = color_picture(image);
    EXPECT_GT(color[0][0], 2.0 * std::max(color[0][1], color[0][2]));
    EXPECT_GT(color[1][2], 2.0 * std::max(color[1][0], color[1][1]));
}

}  // namespace
}  // namespace pol
