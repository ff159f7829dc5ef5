// SPDX-License-Identifier: Apache-2.0
// Statistics of a region, its distance from the reference, the worst pixel, and pixels that are typed.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "known_picture.h"
#include "viewer/pages/region_page.h"
#include "viewer/shown/region_statistics.h"
#include "viewer/widgets/widget_map.h"
#include "window_without_gl.h"

namespace pol {
namespace {

/// 3 x 2 pixels of one band. Numbers that 32-bit floats have.
StokesImage six_pixels() {
    StokesImage image;
    image.width = 3;
    image.height = 2;
    image.bands = bands_at({580.0});
    image.stokes = {{1.0, 0.5, 0.0, 0.0}, {2.0, 1.0, 0.0, 1.0}, {8.0, 0.0, 0.0, 0.0},
                    {3.0, 1.5, 0.0, 1.0}, {6.0, 1.0, 0.0, 2.0}, {8.0, 0.0, 0.0, 0.0}};
    return image;
}

constexpr TileRect left_four{0, 0, 2, 2};

// S0 1 2 3 6: mean 3, squares 4 1 0 9, standard deviation sqrt(14 / 3). S1 0.5 1 1.5 1: mean 1, 0.25 0 0.25 0,
// sqrt(0.5 / 3). S3 0 1 1 2: mean 1, 1 0 0 1, sqrt(2 / 3).
TEST(Region, HasTheMeanAndTheStandardDeviationOfItsPixels) {
    const StokesImage image = six_pixels();
    const RegionStatistics found = region_statistics(ShownPicture(image, {}), 0, left_four);
    EXPECT_EQ(found.count, 4U);
    EXPECT_EQ(found.left_out, 0U);
    EXPECT_EQ(found.mean.stokes, (Stokes<double>{3.0, 1.0, 0.0, 1.0}));
    EXPECT_NEAR(found.deviation.s0, std::sqrt(14.0 / 3.0), 1e-15);
    EXPECT_NEAR(found.deviation.s1, std::sqrt(0.5 / 3.0), 1e-15);
    EXPECT_EQ(found.deviation.s2, 0.0);
    EXPECT_NEAR(found.deviation.s3, std::sqrt(2.0 / 3.0), 1e-15);
    const RegionStatistics one = region_statistics(ShownPicture(image, {}), 0, TileRect{1, 1, 2, 2});
    EXPECT_EQ(one.mean.stokes, image.stokes[4]);
    EXPECT_EQ(one.deviation, Stokes<double>{});
}

TEST(Region, LeavesOutWhatIsNoNumberOrHasNoSample) {
    StokesImage image = six_pixels();
    image.stokes[4].s2 = std::numeric_limits<double>::quiet_NaN();
    image.samples = {1, 1, 1, 0, 1, 1};
    const RegionStatistics found = region_statistics(ShownPicture(image, {}), 0, left_four);
    EXPECT_EQ(found.count, 2U);
    EXPECT_EQ(found.left_out, 2U);
    EXPECT_EQ(found.mean.stokes, (Stokes<double>{1.5, 0.75, 0.0, 0.5}));
}

TEST(Region, IsSeenBehindThePolarimeterAndInTheShownConvention) {
    const StokesImage image = six_pixels();
    Polarimeter polarizer;
    polarizer.elements.push_back({PolarimeterElementKind::polarizer, true, 0.0, 0.0});
    // A horizontal polarizer passes (S0 + S1) / 2 as light with S1 = S0 (Malus).
    const Stokes<double> behind = region_statistics(ShownPicture(image, polarizer), 0, left_four).mean.stokes;
    EXPECT_NEAR(behind.s0, 2.0, 1e-15);
    EXPECT_NEAR(behind.s1, 2.0, 1e-15);
    EXPECT_NEAR(behind.s3, 0.0, 1e-15);
    const Convention other{Viewpoint::receiver, PositiveS3::left, TimeSign::minus};
    EXPECT_EQ(region_statistics(ShownPicture(image, {}, other), 0, left_four).mean.stokes.s3, -1.0);
}

const PageRow& row(const PageGroup& group, const std::string& name) {
    for (const PageRow& each : group.rows)
        if (each.name == name) return each;
    ADD_FAILURE() << "no row " << name << " in " << group.title;
    static const PageRow none;
    return none;
}

TEST(Region, PageHasTheMapsOfTheMeanLight) {
    Session session;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, six_pixels()));
    session.select_region(left_four);
    const RegionPage page = make_region_page(session);
    EXPECT_EQ(page.title, "2 x 2 pixels from 0,0");
    EXPECT_EQ(row(page.light, "pixels").value, "4");
    EXPECT_EQ(std::stod(row(page.light, "S0").exact), 3.0);
    EXPECT_NEAR(std::stod(row(page.light, "DoP").exact), std::sqrt(2.0) / 3.0, 1e-15) << "not the mean of the DoPs";
    EXPECT_NEAR(std::stod(row(page.light, "azimuth").exact), 0.0, 1e-13);
    EXPECT_TRUE(page.metrics.rows.empty());
    EXPECT_NE(page.why_not.find("no reference"), std::string::npos);
}

// All S0 of the region larger by a tenth: dC = (dS0, 0, 0, 0), |dC|^2 = dS0^2 / 2, so that fro_c is
// 0.1 sqrt(sum S0^2) / sqrt(sum (S0^2 + |s|^2)), with sum S0^2 = 50 and sum |s|^2 = 0.25 + 2 + 3.25 + 5 = 10.5.
TEST(Region, PageHasTheMetricsOfTheRegionAgainstTheReference) {
    Session session;
    StokesImage image = six_pixels();
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    session.set_reference();
    for (const std::size_t i : {0U, 1U, 3U, 4U}) image.stokes[i].s0 *= 1.1;
    image.stokes[2].s0 = 100.0;  // outside the region
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    session.select_region(left_four);
    const RegionPage page = make_region_page(session);
    EXPECT_EQ(page.why_not, "");
    const double rounding = 1e-6;  // of 32-bit floats, ten times as much of a tenth
    EXPECT_NEAR(std::stod(row(page.metrics, "fro_c").exact), 0.1 * std::sqrt(50.0 / 60.5), rounding);
    EXPECT_NEAR(std::stod(row(page.metrics, "rel_rmse_s0").exact), 0.1, rounding);
    EXPECT_EQ(std::stod(row(page.metrics, "azimuth_w").exact), 0.0);
    EXPECT_NE(text_of(page).find("fro_c 0.09"), std::string::npos) << text_of(page);
}

TEST(Region, OfAPartIsComparedWithTheSamePlaceOfTheWhole) {
    Session session;
    StokesImage image = six_pixels();
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    session.set_reference();
    StokesImage part = cut_out(image, 0, TileRect{1, 0, 3, 2});
    ASSERT_NO_FATAL_FAILURE(open_picture(session, part));
    ASSERT_EQ(session.current()->picture().left, 1);
    session.select_region(TileRect{0, 0, 2, 2});
    const RegionPage page = make_region_page(session);
    EXPECT_EQ(page.title, "2 x 2 pixels from 1,0");
    EXPECT_EQ(row(page.metrics, "pixels").value, "4");
    EXPECT_EQ(std::stod(row(page.metrics, "fro_c").exact), 0.0);
    session.set_reference();
    session.step_document(1);
    session.select_region(TileRect{0, 0, 3, 2});
    EXPECT_EQ(row(make_region_page(session).metrics, "pixels").value, "4") << "of 6";
    session.select_region(TileRect{0, 0, 1, 2});
    EXPECT_EQ(make_region_page(session).why_not, "the reference has none of these pixels");
}

TEST(WorstPixel, IsWhereTheShownDifferenceIsLargest) {
    Session session;
    StokesImage image = six_pixels();
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    session.set_reference();
    image.stokes[1].s0 += 0.5;
    image.stokes[3].s0 -= 0.75;
    image.stokes[5].s1 += 4.0;
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    session.show(Quantity::intensity);
    session.change_view().difference = true;
    session.pin_worst();
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{0, 1})) << "-0.75 is farther than 0.5";
    session.show(Quantity::s1);
    session.pin_worst();
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{2, 1}));
    session.show(Quantity::s2);
    session.pin_worst();
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{2, 1})) << "S2 differs nowhere";
    EXPECT_NE(session.log().lines().back().text.find("do not differ"), std::string::npos);
}

TEST(WorstPixel, IsTheMostUnphysicalOneWithoutAComparison) {
    Session session;
    StokesImage image = six_pixels();
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    session.pin_worst();
    EXPECT_FALSE(session.selection().pinned());
    EXPECT_NE(session.log().lines().back().text.find("no pixel is unphysical"), std::string::npos);
    image.stokes[2] = {8.0, 9.0, 0.0, 0.0};
    image.stokes[4] = {6.0, 12.0, 0.0, 0.0};
    ASSERT_NO_FATAL_FAILURE(open_picture(session, image));
    session.pin_worst();
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{1, 1}));
    image.stokes[0].s2 = std::numeric_limits<double>::quiet_NaN();
    session.open_picture(image, "broken");
    session.pin_worst();
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{0, 0})) << "no number at all is worse";
}

TEST(GoTo, PinsAPixelOfTheWholePictureAndBringsItIntoView) {
    Session session;
    StokesImage part = cut_out(six_pixels(), 0, TileRect{1, 1, 3, 2});
    ASSERT_NO_FATAL_FAILURE(open_picture(session, part));
    session.set_view_size({100.0, 50.0});
    session.change_transform() = {40.0, {-1000.0, 0.0}};
    EXPECT_TRUE(session.go_to("2,1"));
    EXPECT_EQ(session.selection().pinned(), (PixelAddress{1, 0}));
    EXPECT_EQ(session.transform().view_from_picture({2.5, 1.5}), DVec2(50.0, 25.0)) << "in the middle";
    EXPECT_TRUE(session.go_to(" 1 , 1 "));
    EXPECT_TRUE(session.go_to("1 1"));
    EXPECT_EQ(session.transform().view_from_picture({2.5, 1.5}), DVec2(50.0, 25.0)) << "it was in view";
}

TEST(GoTo, SaysWhatIsNoPixel) {
    Session session;
    EXPECT_FALSE(session.go_to("0,0"));
    StokesImage part = cut_out(six_pixels(), 0, TileRect{1, 1, 3, 2});
    ASSERT_NO_FATAL_FAILURE(open_picture(session, part));
    for (const char* typed : {"", ",", "1", "1,", "1,x", "1,1,1", "1.5,1", "12", "99999999999,0", "a,b", "1;1"})
        EXPECT_NE(session.go_to(typed).error().what.find("is no pixel"), std::string::npos) << typed;
    for (const char* typed : {"0,1", "1,0", "3,1", "-1,1", "-2147483648,1", "2147483647,1"})
        EXPECT_NE(session.go_to(typed).error().what.find("columns are 1 to 2, its rows 1 to 1"), std::string::npos)
            << typed;
    EXPECT_FALSE(session.selection().pinned());
}

TEST(RegionPanel, SelectsTheWholePictureAndWishesNothingMore) {
    WindowWithoutGl window;
    WidgetMap map;
    map.text_log = "/dev/null";
    ASSERT_NO_FATAL_FAILURE(open_picture(window.session, known_picture()));
    ASSERT_NO_FATAL_FAILURE(open_picture(window.session, known_picture()));
    ImGui::GetIO().UserData = &map;
    window.draw(3);
    const auto click = [&](const std::string& name) {
        ASSERT_TRUE(map.rects.contains(name)) << name;
        window.click(map.rects.at(name).origin + 0.5 * map.rects.at(name).size);
        window.draw(2);
    };
    ASSERT_NO_FATAL_FAILURE(click("tab Compare"));
    ASSERT_NO_FATAL_FAILURE(click("whole picture"));
    ASSERT_TRUE(window.session.selection().region);
    EXPECT_EQ(window.session.selection().region->pixel_count(), 16U * 12U);
    ASSERT_NO_FATAL_FAILURE(click("copy region"));
}

}  // namespace
}  // namespace pol
