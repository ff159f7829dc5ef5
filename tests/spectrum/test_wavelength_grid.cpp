// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "spectrum/wavelength_grid.h"

namespace pol {
namespace {

using List = std::vector<double>;

TEST(WavelengthGrid, OneNumberIsOneWavelength) {
    EXPECT_EQ(parse_wavelengths("580").value(), List{580.0});
}

TEST(WavelengthGrid, AListIsTakenAsItIs) {
    EXPECT_EQ(parse_wavelengths("450, 550,650.5").value(), (List{450.0, 550.0, 650.5}));
}

TEST(WavelengthGrid, TheColorModeOfThePaperHas21WavelengthsAmongThem580) {
    const List list = parse_wavelengths("380:780:20").value();
    ASSERT_EQ(list.size(), 21u);
    EXPECT_EQ(list.front(), 380.0);
    EXPECT_EQ(list[10], 580.0);
    EXPECT_EQ(list.back(), 780.0);
}

TEST(WavelengthGrid, ARangeEndsWhereItsStepsDo) {
    EXPECT_EQ(parse_wavelengths("400:450:20").value(), (List{400.0, 420.0, 440.0}));
    EXPECT_EQ(parse_wavelengths("500:500:10").value(), List{500.0});
    // 0.1 is not a binary fraction: the last step must not be lost to rounding.
    EXPECT_EQ(parse_wavelengths("500:501:0.1").value().size(), 11u);
}

TEST(WavelengthGrid, RefusesWhatIsNoListOfWavelengths) {
    for (const char* text : {"",
                             " ",
                             "red",
                             "580nm",
                             "nan",
                             "inf",
                             "0",
                             "-580",
                             "450,,650",
                             "450,",
                             "450;550",
                             "650,550",
                             "550,550",
                             "380:780",
                             "380:780:20:5",
                             "780:380:20",
                             "380:780:0",
                             "380:780:-20",
                             "380:780:nan",
                             "380:inf:20",
                             "0:780:20",
                             "1:100000:1",
                             "380:780:1e-300",
                             "1e999"}) {
        const Result<List> result = parse_wavelengths(text);
        ASSERT_FALSE(result) << text;
        EXPECT_EQ(result.error().kind, ErrorKind::usage) << text;
        EXPECT_FALSE(result.error().hint.empty()) << text;
    }
}

TEST(WavelengthGrid, TheNearestWavelengthIsTheFirstOfTwoThatAreEquallyNear) {
    EXPECT_EQ(nearest_wavelength(parse_wavelengths("380:780:20").value(), 580.0), 10u);
    EXPECT_EQ(nearest_wavelength({450.0, 570.0, 590.0, 650.0}, 580.0), 1u);
    EXPECT_EQ(nearest_wavelength({1064.0, 1550.0}, 580.0), 0u);
    EXPECT_EQ(nearest_wavelength({450.0, 550.0}, 1e9), 1u);
}

TEST(WavelengthGrid, ANumberBelowAllLightAsksWhetherMicrometresWereMeant) {
    for (const char* text : {"0.58", "1.55", "0.45,0.55,0.65", "0.38:0.78:0.02", "0.58,600"}) {
        const Result<List> result = parse_wavelengths(text);
        ASSERT_FALSE(result) << text;
        EXPECT_NE(result.error().what.find("were micrometres meant?"), std::string::npos) << result.error().what;
    }
    EXPECT_EQ(parse_wavelengths("0.58").error().hint, "wavelengths are in nm: 0.58 um is 580");
    EXPECT_FALSE(checked_wavelengths({0.58}));
    EXPECT_TRUE(checked_wavelengths({13.5}));  // extreme ultraviolet is light
}

TEST(WavelengthGrid, HoldsAtMost4096Wavelengths) {
    EXPECT_EQ(parse_wavelengths("101:4196:1").value().size(), 4096u);
    EXPECT_FALSE(parse_wavelengths("101:4197:1"));
    EXPECT_FALSE(checked_wavelengths(List(4097, 100.0)));
    EXPECT_FALSE(checked_wavelengths({}));
    EXPECT_FALSE(checked_wavelengths({500.0, std::numeric_limits<double>::quiet_NaN()}));
}

}  // namespace
}  // namespace pol
