// SPDX-License-Identifier: Apache-2.0
// Pictures of other programs in the window: what was not measured is not 0, and what is assumed can be changed.
#include <gtest/gtest.h>

#include <algorithm>

#include "io/pictures/exr_file.h"
#include "viewer/foreign_picture.h"
#include "viewer/pages/pixel_page.h"
#include "viewer/pages/readout_text.h"
#include "viewer/pages/sphere_view.h"
#include "viewer/session/exports.h"
#include "viewer/viewer_files.h"

namespace pol {
namespace {

class ForeignPicture : public testing::Test {
protected:
    ForeignPicture() { session.open_picture(foreign_picture(), "room"); }

    PixelPage page_of_band(std::size_t band) {
        session.choose_band(band);
        session.pin({4, 8});
        session.update();
        return make_pixel_page(session);
    }
    static const PageRow& row_of(const PixelPage& page, const std::string& name) {
        for (const PageGroup& group : page.groups)
            for (const PageRow& row : group.rows)
                if (row.name == name) return row;
        throw std::runtime_error("no row " + name);
    }
    static bool has_row(const PixelPage& page, const std::string& name) {
        return std::any_of(page.groups.begin(), page.groups.end(), [&](const PageGroup& group) {
            return std::any_of(group.rows.begin(), group.rows.end(),
                               [&](const PageRow& row) { return row.name == name; });
        });
    }
    MapPixel shown_pixel(Quantity quantity) {
        session.show(quantity);
        session.finish_shown_map();
        const std::size_t pixel = session.current()->picture().pixel(4, 8);
        return {session.shown_map().values()[pixel], 1.0, session.shown_map().states()[pixel]};
    }
    Session session;
};

TEST_F(ForeignPicture, ThePageSaysOfWhatWasNotMeasuredThatItWasNot) {
    const PixelPage page = page_of_band(1);
    for (const char* name : {"S3", "Im Jxy", "DoP", "DoCP", "ellipticity b/a", "ellipticity angle", "handedness",
                             "polarized", "unpolarized", "eigenvalue 1", "eigenvalue 2"}) {
        EXPECT_EQ(row_of(page, name).value, "not measured") << name;
        EXPECT_EQ(row_of(page, name).exact, "") << name;
        EXPECT_EQ(row_of(page, name).bar, "") << name;
    }
    for (const char* name : {"S0", "S1", "S2", "Jxx", "Jyy", "Re Jxy", "DoLP", "azimuth"})
        EXPECT_FALSE(row_of(page, name).exact.empty()) << name;
    EXPECT_EQ(page.matrix_texts.xy.substr(page.matrix_texts.xy.size() - 4), " ? i");
    EXPECT_EQ(page.matrix_texts.exact_xy.substr(page.matrix_texts.exact_xy.size() - 3), "? i");
    EXPECT_NE(page.matrix_texts.xx, "not measured");
    // The other band has all of it.
    const PixelPage full = page_of_band(0);
    for (const PageGroup& group : full.groups)
        for (const PageRow& row : group.rows) EXPECT_NE(row.value, "not measured") << row.name;
}

TEST_F(ForeignPicture, ATurnedFrameDoesNotMakeUpComponents) {
    StokesImage image = foreign_picture();
    image.bands[1].known = StokesComponents::s0().with(1);
    session.open_picture(std::move(image), "half");
    EXPECT_FALSE(row_of(page_of_band(1), "S1").exact.empty());
    session.set_page({FrameChoice::own_angle, 0.3});
    const PixelPage page = page_of_band(1);
    EXPECT_EQ(row_of(page, "S1").value, "not measured");
    EXPECT_EQ(row_of(page, "S2").value, "not measured");
    EXPECT_EQ(row_of(page, "Jxx").value, "not measured");
    EXPECT_EQ(page.matrix_texts.xy, "not measured");
    EXPECT_EQ(page.matrix_texts.exact_xy, "");
}

TEST_F(ForeignPicture, PixelsHaveTheNumbersOfTheWholePictureAndBandsTheirNames) {
    const PixelPage page = page_of_band(1);
    EXPECT_EQ(page.pixel, (PixelAddress{104, 28}));
    EXPECT_EQ(text_of(page).substr(0, 20), "pixel 104,28  G\nrece");
}

TEST_F(ForeignPicture, NothingIsSaidOfWhatTheFileDoesNotKnow) {
    const PixelPage page = page_of_band(0);
    for (const char* name : {"residual", "tail", "brightest", "failures"}) EXPECT_FALSE(has_row(page, name)) << name;
    EXPECT_EQ(row_of(page, "samples").value, "the file says nothing");
}

TEST_F(ForeignPicture, TheSphereHasNoPlaceForLightWithoutS3) {
    const TileRect all{0, 0, 16, 12};
    const SphereView view;
    const std::vector<DVec2> everything{{-2.0, -2.0}, {2.0, -2.0}, {2.0, 2.0}, {-2.0, 2.0}};
    EXPECT_TRUE(sphere_points(session.shown_picture(), 1, all, 1000).empty());
    EXPECT_EQ(sphere_points(session.shown_picture(), 0, all, 1000).size(), 192U);
    const auto marked = pixels_inside(session.shown_picture(), 1, all, view, everything, false);
    EXPECT_EQ(std::count(marked.begin(), marked.end(), true), 0);
}

TEST(MissingText, NamesWhatIsMissingAsASentenceWould) {
    EXPECT_EQ(missing_text(StokesComponents::all(), StokesComponents::all()), "");
    EXPECT_EQ(missing_text(StokesComponents::all(), StokesComponents::linear()), "S3 was not measured");
    EXPECT_EQ(missing_text(StokesComponents::linear(), StokesComponents::s0()), "S1 and S2 were not measured");
    EXPECT_EQ(missing_text(StokesComponents::all(), StokesComponents::s0()), "S1, S2 and S3 were not measured");
}

TEST_F(ForeignPicture, AnotherAssumptionTurnsTheMapsOfEveryView) {
    session.choose_band(0);
    const double azimuth = shown_pixel(Quantity::azimuth).value;
    const double s3 = shown_pixel(Quantity::s3).value;
    ASSERT_GT(std::abs(s3), 0.01);
    const std::uint64_t version = session.current()->picture_version();
    session.take_numbers_for(session.current(), StokesConvention{true, false, 90.0});
    EXPECT_GT(session.current()->picture_version(), version);
    EXPECT_NEAR(std::abs(shown_pixel(Quantity::azimuth).value - azimuth), 90.0, 1e-9);
    EXPECT_DOUBLE_EQ(shown_pixel(Quantity::s3).value, -s3);
    ASSERT_TRUE(session.current()->chosen_convention());
    EXPECT_NE(session.current()->picture().origin.remarks.back().find("S3 > 0 is left-handed"), std::string::npos);
    EXPECT_EQ(session.log().lines().back().text.substr(0, 30), "room: its numbers are taken fo");

    session.take_numbers_for(session.current(), std::nullopt);
    EXPECT_FALSE(session.current()->chosen_convention());
    EXPECT_TRUE(session.current()->picture().stokes == foreign_picture().stokes);
    EXPECT_EQ(session.current()->picture().origin, foreign_picture().origin);
}

TEST_F(ForeignPicture, ADocumentThatIsNotOnScreenKeepsItsAssumptions) {
    const Document* first = session.current();
    session.open_picture(foreign_picture(), "another");
    session.take_numbers_for(first, StokesConvention{true, false, 0.0});
    EXPECT_FALSE(first->chosen_convention());
    session.take_numbers_for(nullptr, StokesConvention{true, false, 0.0});
    EXPECT_FALSE(session.current()->chosen_convention());
}

TEST_F(ForeignPicture, WhoHasBorrowedThePictureKeepsTheOldAssumptions) {
    const auto lent = session.current()->lend_picture();
    session.take_numbers_for(session.current(), StokesConvention{true, false, 0.0});
    EXPECT_TRUE(lent->stokes == foreign_picture().stokes);
    EXPECT_FALSE(session.current()->picture().stokes == foreign_picture().stokes);
}

TEST_F(ForeignPicture, AnExportCarriesTheAssumptionsAlong) {
    const test::WorkingFolder folder;
    session.take_numbers_for(session.current(), StokesConvention{true, false, 90.0});
    const StokesImage shown = session.current()->picture();
    export_snapshot(session);
    while (!session.exports().idle()) session.update();
    session.update();
    const auto read = read_exr("room.exr");
    ASSERT_TRUE(read) << to_string(read.error());
    ASSERT_EQ(read.value().stokes.size(), shown.stokes.size());
    for (std::size_t i = 0; i < shown.stokes.size(); ++i) {
        EXPECT_FLOAT_EQ(static_cast<float>(read.value().stokes[i].s1), static_cast<float>(shown.stokes[i].s1));
        EXPECT_FLOAT_EQ(static_cast<float>(read.value().stokes[i].s3), static_cast<float>(shown.stokes[i].s3));
    }
    EXPECT_EQ(read.value().bands, shown.bands);
    EXPECT_EQ(read.value().left, 100);
    const auto& remarks = read.value().origin.remarks;
    EXPECT_TRUE(std::any_of(remarks.begin(), remarks.end(), [](const std::string& remark) {
        return remark.find("The user took the numbers for") != std::string::npos;
    }));
    EXPECT_EQ(read.value().origin.assumed, shown.origin.assumed);
}

TEST(PictureFile, WhatTheUserChoseHoldsWhenTheFileIsReadAgain) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(write_exr(known_picture(), folder / "a.exr"));
    auto opened = Document::open(folder / "a.exr", {});
    ASSERT_TRUE(opened);
    Document& document = *opened.value();
    const std::vector<Stokes<double>> before = document.picture().stokes;
    document.take_numbers_for(StokesConvention{true, false, 0.0});
    ASSERT_TRUE(document.reload());
    EXPECT_EQ(document.chosen_convention(), (StokesConvention{true, false, 0.0}));
    EXPECT_EQ(document.picture().stokes[40].s3, -before[40].s3);
}

}  // namespace
}  // namespace pol
