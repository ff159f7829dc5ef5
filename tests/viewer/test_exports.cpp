// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "core/units.h"
#include "io/files/input_file.h"
#include "io/pictures/exr_file.h"
#include "io/scenes/scene_hash.h"
#include "support/render_scene.h"
#include "viewer/session/exports.h"
#include "viewer/viewer_files.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

/// The program runs in a folder of its own.
class Exports : public testing::Test {
protected:
    /// Updates the session as frames do until the exports have ended.
    static void wait_for_exports(Session& session) {
        while (!session.exports().idle()) {
            session.update();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    /// Reads as many numbers as fit.
    static std::array<double, 9>& fields_of(std::istringstream& line, std::array<double, 9>& numbers) {
        for (double& number : numbers) line >> number;
        return numbers;
    }
    static RgbPicture decode_png(const fs::path& path) {
        png_image image{};
        image.version = PNG_IMAGE_VERSION;
        if (png_image_begin_read_from_file(&image, path.c_str()) == 0) return {};
        image.format = PNG_FORMAT_RGB;
        RgbPicture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
        picture.pixels.resize(static_cast<std::size_t>(image.width) * image.height);
        png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr);
        return picture;
    }
    static std::string text_of(const fs::path& path) { return read_input_file(path, 1U << 30U).value(); }

    test::WorkingFolder folder;
};

TEST_F(Exports, ASnapshotInMidRenderIsThePictureOnScreen) {
    test::write_text("plate.yaml", test::plate_scene(256, 256));
    Session session;
    ASSERT_TRUE(session.open("plate.yaml"));
    Document& document = *session.current();
    // A slow machine takes over a preview for many frames before the first sample.
    const auto is_begun = [&] {
        const auto& samples = document.picture().samples;
        return std::any_of(samples.begin(), samples.end(), [](std::uint32_t count) { return count > 0; });
    };
    while (!is_begun()) session.update();
    document.set_paused(true);
    export_snapshot(session);
    const StokesImage before = document.picture();
    ASSERT_GT(document.progress().done, 0.0);
    ASSERT_LT(document.progress().done, 1.0) << "the render was too fast for this test";
    wait_for_exports(session);

    const auto read = read_exr("plate.exr");
    ASSERT_TRUE(read);
    const StokesImage& file = read.value();
    EXPECT_EQ(file.samples, before.samples);
    EXPECT_EQ(file.bands, before.bands);
    EXPECT_EQ(file.attributes.at("scene_hash"), scene_hash(document.scene()));
    EXPECT_EQ(file.attributes.at("scene"), "plate.yaml");
    ASSERT_EQ(file.stokes.size(), before.stokes.size());
    std::size_t traced = 0;
    for (std::size_t i = 0; i < file.stokes.size(); ++i) {
        const bool has_samples = before.samples[i % before.pixel_count()] > 0;
        traced += has_samples ? 1 : 0;
        const Stokes<double> expected = has_samples ? before.stokes[i] : Stokes<double>{};
        ASSERT_EQ(file.stokes[i].s0, static_cast<double>(static_cast<float>(expected.s0)));
        ASSERT_EQ(file.stokes[i].s1, static_cast<double>(static_cast<float>(expected.s1)));
    }
    EXPECT_GT(traced, 0U);
    EXPECT_LT(traced, file.stokes.size());
    // The render was not stopped by it.
    document.set_paused(false);
    test::finish(document);
    EXPECT_EQ(document.picture().samples.back(), 1U);
}

// A window under load shows a part of the film for a while; a file is of all of it.
TEST_F(Exports, TakeEverythingThatTheFilmHas) {
    test::write_text("plate.yaml", test::plate_scene(64, 48));
    Session session;
    ASSERT_TRUE(session.open("plate.yaml"));
    Document& document = *session.current();
    while (document.tracing()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const auto screen = document.lend_picture();  // as another export that is still at work
    ASSERT_EQ(screen->samples[0], 0U);
    export_snapshot(session);
    export_pixels(session);
    session.show(Quantity::dop);
    export_map(session);
    EXPECT_EQ(screen->samples[0], 0U);
    wait_for_exports(session);
    const auto file = read_exr("plate.exr");
    ASSERT_TRUE(file);
    const StokesImage whole = test::render(document.scene());
    EXPECT_EQ(file.value().samples, whole.samples);
    for (std::size_t i = 0; i < whole.stokes.size(); ++i)
        ASSERT_EQ(file.value().stokes[i].s0, static_cast<double>(static_cast<float>(whole.stokes[i].s0)));
    // The last line of the table is that of the last pixel, with its sample.
    const std::string table = text_of("plate.csv");
    EXPECT_NE(table.find("\n63,47,600,"), std::string::npos);
    EXPECT_TRUE(table.ends_with(",1,\"receiver's view, S3 > 0 right\"\n"));
    // The map is that of the whole picture, to the byte.
    fs::rename("plate-dop.png", "first.png");
    ASSERT_TRUE(document.progress().finished);
    export_map(session);
    wait_for_exports(session);
    EXPECT_EQ(text_of("first.png"), text_of("plate-dop.png"));
}

TEST_F(Exports, ARegionIsWrittenAsThatRegion) {
    test::write_text("plate.yaml", test::plate_scene(8, 4));
    Session session;
    ASSERT_TRUE(session.open("plate.yaml"));
    test::finish(*session.current());
    session.select_region(TileRect{2, 1, 5, 3});
    export_pixels(session);
    std::vector<bool> marked(32, false);
    marked[31] = true;
    session.mark(marked);
    export_pixels(session);
    wait_for_exports(session);
    std::istringstream lines(text_of("plate.csv"));
    std::string line;
    std::getline(lines, line);
    for (const char* pixel : {"2,1,", "3,1,", "4,1,", "2,2,", "3,2,", "4,2,"}) {
        for (const char* nm : {"500,", "600,"}) {
            ASSERT_TRUE(std::getline(lines, line));
            EXPECT_TRUE(line.starts_with(std::string(pixel) + nm)) << line;
        }
    }
    EXPECT_FALSE(std::getline(lines, line));
    // What is marked is chosen among all: it goes before the region.
    EXPECT_NE(text_of("plate-2.csv").find("\n7,3,500,"), std::string::npos);
}

TEST_F(Exports, APixelWithoutASampleHasNoNumbers) {
    StokesImage picture;
    picture.width = 2;
    picture.height = 1;
    picture.bands = bands_at({580.0});
    picture.stokes = {{1.0, 1.0, 0.0, 0.0}, {0.5, 0.0, 0.0, 0.0}};
    picture.residual = {0.0, 0.25};
    picture.samples = {4, 0};
    ASSERT_TRUE(write_exr(picture, "half.exr"));
    Session session;
    ASSERT_TRUE(session.open("half.exr"));
    export_pixels(session);
    wait_for_exports(session);
    const std::string table = text_of("half.csv");
    EXPECT_NE(table.find("\n0,0,580,1,1,0,0,1,0,0,0,0,4,"), std::string::npos) << table;
    EXPECT_NE(table.find("\n1,0,580,,,,,,,,1,0,0,"), std::string::npos) << table;
}

TEST_F(Exports, NamesAreNeverUsedTwice) {
    test::write_text("plate.yaml", test::plate_scene(8, 8));
    Session session;
    ASSERT_TRUE(session.open("plate.yaml"));
    export_snapshot(session);
    export_snapshot(session);
    wait_for_exports(session);
    export_snapshot(session);
    wait_for_exports(session);
    for (const char* name : {"plate.exr", "plate-2.exr", "plate-3.exr"}) EXPECT_TRUE(fs::exists(name)) << name;
    fs::create_directory("out");
    EXPECT_EQ(free_export_path(session, "plate", ".exr"), fs::path("out/plate.exr"));
    ASSERT_EQ(session.log().lines().size(), 3U);
    EXPECT_NE(session.log().lines()[0].text.find("plate.exr"), std::string::npos);
}

TEST_F(Exports, AFolderThatCannotBeWrittenIsReported) {
    test::write_text("plate.yaml", test::plate_scene(8, 8));
    Session session;
    ASSERT_TRUE(session.open("plate.yaml"));
    session.start_export("EXR snapshot", "no/such/folder.exr",
                         [](ExportProgress&) -> Result<Done> { return write_exr({}, "no/such/folder.exr"); });
    wait_for_exports(session);
    ASSERT_FALSE(session.log().lines().empty());
    EXPECT_EQ(session.log().lines().back().severity, Severity::error);
}

// Behind a polarizer at 0 degrees everything is linear along x.
TEST_F(Exports, TheMarkedPixelsAreListedAtAllWavelengthsBehindThePolarimeter) {
    test::write_text("plate.yaml", test::plate_scene(8, 4));
    Session session;
    ASSERT_TRUE(session.open("plate.yaml"));
    test::finish(*session.current());
    session.set_polarimeter({{{PolarimeterElementKind::polarizer, true, 0.0, 0.0}}});
    std::vector<bool> marked(32, false);
    marked[11] = marked[20] = true;
    session.mark(marked);
    export_pixels(session);
    wait_for_exports(session);
    std::istringstream lines(text_of("plate.csv"));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line.rfind("x,y,wavelength_nm,S0,S1,S2,S3,dop", 0), 0U);
    const StokesImage& picture = session.current()->picture();
    for (const std::size_t pixel : {11U, 20U}) {
        for (std::size_t w = 0; w < 2; ++w) {
            ASSERT_TRUE(std::getline(lines, line));
            std::replace(line.begin(), line.end(), ',', ' ');
            std::istringstream fields(line);
            double x{};
            double y{};
            double nm{};
            double s0{};
            double s1{};
            double s2{};
            double s3{};
            double dop{};
            fields >> x >> y >> nm >> s0 >> s1 >> s2 >> s3 >> dop;
            EXPECT_EQ(picture.pixel(static_cast<int>(x), static_cast<int>(y)), pixel);
            EXPECT_EQ(nm, *picture.bands[w].wavelength_nm);
            const Stokes<double>& s = picture.at(w, pixel);
            EXPECT_NEAR(s0, 0.5 * (s.s0 + s.s1), 1e-15);
            EXPECT_NEAR(s1, s0, 1e-15);
            EXPECT_NEAR(dop, 1.0, 1e-12);
        }
    }
    EXPECT_FALSE(std::getline(lines, line));
}

// The last column says how the others are labeled.
TEST_F(Exports, PixelsAreListedInTheShownConventionWhichTheTableNames) {
    test::write_text("plate.yaml", test::plate_scene(4, 2));
    Session session;
    ASSERT_TRUE(session.open("plate.yaml"));
    test::finish(*session.current());
    session.set_polarimeter(
        {{{PolarimeterElementKind::polarizer, true, 0.3, 0.0}, {PolarimeterElementKind::retarder, true, 0.0, 1.0}}});
    session.change_view().convention = {Viewpoint::source, PositiveS3::right, TimeSign::minus};
    const ShownPicture engine(session.current()->picture(), session.polarimeter());
    export_pixels(session);
    wait_for_exports(session);
    std::istringstream lines(text_of("plate.csv"));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line.substr(line.rfind(',') + 1), "convention");
    std::getline(lines, line);
    EXPECT_NE(line.find(",\"source's view, S3 > 0 right\""), std::string::npos) << line;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    std::array<double, 9> number{};
    for (double& field : fields_of(fields, number)) EXPECT_TRUE(std::isfinite(field));
    const Stokes<double> s = engine.stokes(0, 0);
    EXPECT_NE(s.s3, 0.0);
    EXPECT_NEAR(number[5], -s.s2, 1e-15) << "as the source sees it";
    EXPECT_NEAR(number[6], -s.s3, 1e-15);
    EXPECT_NEAR(number[8], -degrees(measure(s).azimuth), 1e-12);
}

// The same light labeled the other way round has the colors of the opposite light; end words and legend differ below
// and beside the picture only.
TEST_F(Exports, AMapIsWrittenInTheShownConvention) {
    test::write_text("plate.yaml", test::plate_scene(4, 4));
    Session session;
    ASSERT_TRUE(session.open("plate.yaml"));
    test::finish(*session.current());
    session.show(Quantity::s3);
    const auto corner_of_map = [&](double axis, PositiveS3 positive) {
        session.set_polarimeter({{{PolarimeterElementKind::polarizer, true, axis, 0.0},
                                  {PolarimeterElementKind::retarder, true, 0.0, 1.0}}});
        session.change_view().convention.positive_s3 = positive;
        session.finish_shown_map();
        const fs::path path = free_export_path(session, "plate-s3", ".png");
        export_map(session);
        wait_for_exports(session);
        const RgbPicture picture = decode_png(path);
        return picture.pixels[static_cast<std::size_t>(70 * picture.width + 30)];
    };
    const Rgb8 right = corner_of_map(0.3, PositiveS3::right);
    const Rgb8 left = corner_of_map(-0.3, PositiveS3::right);
    EXPECT_NE(right, left);
    EXPECT_EQ(corner_of_map(0.3, PositiveS3::left), left);
    EXPECT_EQ(corner_of_map(-0.3, PositiveS3::left), right);
}

TEST_F(Exports, EveryMapIsWrittenAsPng) {
    test::write_text("plate.yaml", test::plate_scene(16, 8));
    Session session;
    ASSERT_TRUE(session.open("plate.yaml"));
    test::finish(*session.current());
    session.change_view().over_intensity = true;
    for (const QuantityInfo& quantity : quantities()) {
        session.show(quantity.quantity);
        session.update();
        export_map(session);
    }
    wait_for_exports(session);
    for (const QuantityInfo& quantity : quantities()) {
        const fs::path path = "plate-" + std::string(quantity.name) + ".png";
        EXPECT_TRUE(fs::exists(path)) << path;
    }
    for (const LogLine& line : session.log().lines()) EXPECT_EQ(line.severity, Severity::note) << line.text;
}

TEST_F(Exports, ADifferenceIsWrittenUnderANameOfItsOwn) {
    test::write_text("plate.yaml", test::plate_scene(16, 8));
    Session session;
    ASSERT_TRUE(session.open("plate.yaml"));
    ASSERT_TRUE(session.open_unpolarized_twin());
    for (std::size_t i = 0; i < session.documents().size(); ++i) {
        session.step_document(1);
        session.current()->set_resting(false);
        test::finish(*session.current());
    }
    session.show(Quantity::azimuth);
    ASSERT_TRUE(session.comparison());
    export_map(session);
    wait_for_exports(session);
    EXPECT_TRUE(fs::exists("plate-unpolarized-azimuth-difference.png"));
    for (const LogLine& line : session.log().lines()) EXPECT_EQ(line.severity, Severity::note) << line.text;
}

}  // namespace
}  // namespace pol
