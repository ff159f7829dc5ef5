// SPDX-License-Identifier: Apache-2.0
// The picture that the GPU draws against the one of maps::evaluate and maps::colorize, pixel by pixel.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

#include "io/pictures/exr_file.h"
#include "maps/colorize.h"
#include "maps/difference.h"
#include "support/egl_context.h"
#include "viewer/gl/gl.h"
#include "viewer/picture/picture_renderer.h"
#include "viewer/session/map_look.h"
#include "viewer/shown/shown_picture.h"

namespace pol {
namespace {

constexpr int film_width = 61;
constexpr int film_height = 37;

/// All kinds of light at three wavelengths: random states, weak polarization, darkness, defects, light left out.
StokesImage known_film() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    StokesImage film;
    film.width = film_width;
    film.height = film_height;
    film.bands = bands_at({460.0, 550.0, 620.0});
    film.brightest = {1.5, 2.0, 1.0};
    std::mt19937 generator(7);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(generator()) / 4294967296.0;
    };
    for (std::size_t i = 0; i < 3 * film.pixel_count(); ++i) {
        const double s0 = i % 17 == 0 ? 0.0 : uniform(0.0, 1.2);
        const double p = i % 5 == 0 ? std::pow(10.0, uniform(-14.0, -1.0)) : uniform(0.0, 1.0);
        const double chi = i % 7 == 0 ? 0.0 : uniform(-0.785, 0.785);
        const double psi = uniform(-1.57, 1.57);
        film.stokes.push_back({s0, s0 * p * std::cos(2.0 * chi) * std::cos(2.0 * psi),
                               s0 * p * std::cos(2.0 * chi) * std::sin(2.0 * psi), s0 * p * std::sin(2.0 * chi)});
        film.residual.push_back(i % 3 == 0 ? 0.0 : std::pow(10.0, uniform(-9.0, -0.2)));
        film.tail.push_back(i % 4 == 0 ? std::pow(10.0, uniform(-6.0, -1.0)) : 0.0);
    }
    for (std::size_t w = 0; w < 3; ++w) {
        film.stokes[w * film.pixel_count() + 3] = {nan, 0.0, 0.0, 0.0};
        film.stokes[w * film.pixel_count() + 4] = {-0.5, 0.1, 0.0, 0.0};
        film.stokes[w * film.pixel_count() + 5] = {0.5, 0.6, 0.0, 0.0};
        film.stokes[w * film.pixel_count() + 6] = {1e-14, 1e-14, 0.0, 0.0};
        film.residual[w * film.pixel_count() + 6] = 0.0;
        film.tail[w * film.pixel_count() + 6] = 0.0;
        film.residual[w * film.pixel_count() + 8] = -0.1;
    }
    return film;
}

class Picture : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_EQ(context_.problem(), "");
        file_ = std::filesystem::temp_directory_path() / ("polariscope-picture-" + std::to_string(::getpid()) + ".exr");
        open(known_film());
    }
    void TearDown() override {
        renderer_.reset();
        std::filesystem::remove(file_);
    }

    void open(const StokesImage& film) {
        ASSERT_TRUE(write_exr(film, file_));
        ASSERT_TRUE(session_.open(file_)) << session_.log().lines().back().text;
        auto renderer = PictureRenderer::create();
        ASSERT_TRUE(renderer) << to_string(renderer.error());
        renderer_ = std::move(renderer).value();
    }

    const StokesImage& film() { return session_.current()->picture(); }

    /// What the session shows in a viewport of that size, row 0 at the top.
    RgbPicture drawn(int width, int height, double pixel_ratio = 1.0) {
        session_.finish_shown_map();
        renderer_->upload(session_);
        glBindTexture(GL_TEXTURE_2D, renderer_->render(session_, width, height, pixel_ratio));
        std::vector<std::array<std::uint8_t, 4>> pixels(static_cast<std::size_t>(width * height));
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        RgbPicture picture{width, height, {}};
        for (int y = height - 1; y >= 0; --y) {
            for (int x = 0; x < width; ++x) {
                const auto& pixel = pixels[static_cast<std::size_t>(y * width + x)];
                picture.pixels.push_back({pixel[0], pixel[1], pixel[2]});
            }
        }
        return picture;
    }

    RgbPicture drawn_at_1_to_1() {
        session_.change_transform() = {};
        return drawn(film().width, film().height);
    }

    Session session_;
    std::unique_ptr<PictureRenderer> renderer_;

private:
    EglContext context_;
    std::filesystem::path file_;
};

/// Pixels that differ by more than `tolerance` in some channel, the first few of them in words.
void expect_same(const RgbPicture& actual, const RgbPicture& expected, int tolerance = 1) {
    ASSERT_EQ(actual.pixels.size(), expected.pixels.size());
    int complaints = 0;
    for (std::size_t i = 0; i < expected.pixels.size() && complaints < 5; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            if (std::abs(actual.pixels[i][c] - expected.pixels[i][c]) <= tolerance) continue;
            ++complaints;
            ADD_FAILURE() << "pixel " << i << " channel " << c << ": " << int{actual.pixels[i][c]} << " instead of "
                          << int{expected.pixels[i][c]};
        }
    }
}

RgbPicture expected_of(const StokesImage& film, const ViewSettings& view) {
    MapOptions options{view.style, view.range[static_cast<std::size_t>(view.quantity)], view.exposure};
    options.fade_by_bar = view.fade_by_bar;
    return draw_map(film, view.quantity, view.band, options).value().picture;
}

TEST_F(Picture, EqualsTheColoredMapForEveryQuantityStyleAndWavelength) {
    for (const MapStyle style : {MapStyle::scientific, MapStyle::paper, MapStyle::wilkie}) {
        for (const QuantityInfo& about : quantities()) {
            for (std::size_t wavelength = 0; wavelength < 3; ++wavelength) {
                SCOPED_TRACE(std::string(about.name) + ", style " + std::to_string(static_cast<int>(style)) +
                             ", wavelength " + std::to_string(wavelength));
                session_.change_view().style = style;
                session_.change_view().band = wavelength;
                session_.show(about.quantity);
                expect_same(drawn_at_1_to_1(), expected_of(film(), session_.view()));
            }
        }
    }
}

TEST_F(Picture, FadesByTheBarAsTheColoredMapDoes) {
    session_.change_view().fade_by_bar = true;
    for (const MapStyle style : {MapStyle::scientific, MapStyle::paper}) {
        for (const QuantityInfo& about : quantities()) {
            SCOPED_TRACE(std::string(about.name) + ", style " + std::to_string(static_cast<int>(style)));
            session_.change_view().style = style;
            session_.show(about.quantity);
            expect_same(drawn_at_1_to_1(), expected_of(film(), session_.view()));
        }
    }
}

// The textures are those of the light as it is labeled; a switch back and forth leaves nothing behind.
TEST_F(Picture, FollowsTheConvention) {
    for (const Convention& convention :
         {Convention{Viewpoint::source, PositiveS3::right, TimeSign::minus},
          Convention{Viewpoint::receiver, PositiveS3::left, TimeSign::minus},
          Convention{Viewpoint::source, PositiveS3::left, TimeSign::plus}, Convention{}}) {
        session_.change_view().convention = convention;
        StokesImage labeled = film();
        for (Stokes<double>& s : labeled.stokes) s = convention.stokes(s);
        for (const Quantity quantity : {Quantity::s2, Quantity::s3, Quantity::handedness, Quantity::azimuth,
                                        Quantity::ellipticity, Quantity::color}) {
            SCOPED_TRACE(convention.text() + ", " + std::string(info(quantity).name));
            session_.show(quantity);
            expect_same(drawn_at_1_to_1(), expected_of(labeled, session_.view()));
        }
    }
}

TEST_F(Picture, MinusAReferenceEqualsTheColoredDifferenceOfTheMaps) {
    session_.set_reference();
    StokesImage other = known_film();
    for (std::size_t i = 0; i < other.stokes.size(); ++i)
        if (i % 4 != 0) other.stokes[i] = {1.1 * other.stokes[i].s0, 0.5 * other.stokes[i].s2, other.stokes[i].s1, 0.0};
    open(other);
    for (const Quantity quantity : {Quantity::intensity, Quantity::dop, Quantity::azimuth, Quantity::ellipticity,
                                    Quantity::s1, Quantity::residual}) {
        SCOPED_TRACE(std::string(info(quantity).name));
        session_.show(quantity);
        session_.change_view().difference = true;
        ASSERT_TRUE(session_.comparison());
        session_.finish_shown_map();
        const auto a = evaluate(film(), quantity, session_.view().band);
        const auto b = evaluate(session_.reference()->picture(), quantity, session_.view().band);
        Map map = a.value();
        map.is_difference = true;
        for (std::size_t i = 0; i < map.pixels.size(); ++i)
            map.pixels[i] = difference(quantity, a.value().pixels[i], b.value().pixels[i]);
        expect_same(drawn_at_1_to_1(), colorize(map, {}).picture);
    }
}

// A single wrong pixel among a million equal ones can be seen in the whole picture.
TEST_F(Picture, MinusAReferenceShowsASinglePixelThatDiffersHoweverSmallItIsDrawn) {
    StokesImage plain;
    plain.width = plain.height = 64;
    plain.bands = bands_at({580.0});
    plain.stokes.assign(plain.pixel_count(), {1.0, 0.25, 0.0, 0.0});
    open(plain);
    session_.set_reference();
    plain.stokes[plain.pixel(37, 22)].s1 = -0.25;
    open(plain);
    session_.show(Quantity::s1);
    session_.change_view().difference = true;
    session_.change_transform() = {0.25, {0.0, 0.0}};
    const RgbPicture picture = drawn(16, 16);
    const Rgb8 zero = encode(scale_color(ColorScale::diverging, 0.5));
    const Rgb8 least = encode(scale_color(ColorScale::diverging, 0.0));
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            const Rgb8& seen = picture.pixels[static_cast<std::size_t>(16 * y + x)];
            const Rgb8& expected = x == 37 / 4 && y == 22 / 4 ? least : zero;
            for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], expected[c], 1) << x << " " << y;
        }
    }
}

TEST_F(Picture, EqualsTheColoredMapOfTheLightBehindThePolarimeter) {
    session_.set_polarimeter(
        {{{PolarimeterElementKind::retarder, true, 0.4, 1.3}, {PolarimeterElementKind::polarizer, true, 1.1, 0.0}}});
    StokesImage behind_polarimeter = film();
    const ShownPicture shown(film(), session_.polarimeter());
    for (std::size_t w = 0; w < 3; ++w) {
        for (std::size_t i = 0; i < film().pixel_count(); ++i)
            behind_polarimeter.stokes[w * film().pixel_count() + i] = shown.stokes(w, i);
    }
    for (const QuantityInfo& about : quantities()) {
        SCOPED_TRACE(about.name);
        session_.show(about.quantity);
        expect_same(drawn_at_1_to_1(), expected_of(behind_polarimeter, session_.view()));
    }
}

// Linear light stopped by a crossed analyzer is darkness, not the azimuth of a rounding error.
TEST_F(Picture, ShowsNoLightBehindACrossedAnalyzer) {
    StokesImage linear = known_film();
    for (Stokes<double>& s : linear.stokes) s = {0.75, 0.75 * std::cos(0.6), 0.75 * std::sin(0.6), 0.0};
    linear.residual.assign(linear.residual.size(), 0.0);
    linear.tail.assign(linear.tail.size(), 0.0);
    open(linear);
    session_.set_polarimeter({{{PolarimeterElementKind::polarizer, true, 0.0, 0.0},
                               {PolarimeterElementKind::polarizer, true, std::acos(0.0), 0.0}}});
    session_.show(Quantity::dop);
    const RgbPicture picture = drawn_at_1_to_1();
    EXPECT_EQ(picture.pixels[100], (Rgb8{0, 0, 0}));
}

TEST_F(Picture, FollowsRangeExposureAndScale) {
    session_.show(Quantity::dop);
    session_.change_view().range[static_cast<std::size_t>(Quantity::dop)] = MapRange{0.25, 0.5};
    expect_same(drawn_at_1_to_1(), expected_of(film(), session_.view()));
    for (const Quantity quantity : {Quantity::color, Quantity::intensity}) {
        session_.show(quantity);
        for (const double exposure : {-2.5, 1.0}) {
            session_.change_view().exposure = exposure;
            expect_same(drawn_at_1_to_1(), expected_of(film(), session_.view()));
        }
    }
    session_.show(Quantity::residual);
    session_.change_view().scale = ColorScale::gray;
    session_.change_view().range[static_cast<std::size_t>(Quantity::residual)] = MapRange{0.0, 1.0};
    const RgbPicture picture = drawn_at_1_to_1();
    const double residual = film().residual[10];
    EXPECT_NEAR(picture.pixels[10][0], 255.0 * srgb_encode(residual), 1.0);
}

TEST_F(Picture, OffsetIsAddedAndGammaIsAPowerOfTheLight) {
    session_.show(Quantity::intensity);
    session_.change_view().band = 1;
    session_.change_view().offset = 0.1;
    session_.change_view().gamma = 2.0;
    const RgbPicture picture = drawn_at_1_to_1();
    const Map map = evaluate(film(), Quantity::intensity, 1).value();
    for (std::size_t i = 10; i < 100; ++i) {
        const double light = std::sqrt(map.pixels[i].value + 0.1);
        EXPECT_NEAR(picture.pixels[i][1], 255.0 * srgb_encode(std::min(1.0, light)), 1.0) << i;
    }
}

TEST_F(Picture, OverTheIntensityAMapIsDarkWhereThePictureIs) {
    session_.show(Quantity::azimuth);
    const RgbPicture map = drawn_at_1_to_1();
    session_.show(Quantity::color);
    const RgbPicture color = drawn_at_1_to_1();
    session_.show(Quantity::azimuth);
    session_.change_view().over_intensity = true;
    const RgbPicture both = drawn_at_1_to_1();
    for (std::size_t i = 10; i < 200; ++i) {
        const auto linear = [&](std::size_t c) { return srgb_decode(color.pixels[i][c] / 255.0); };
        if (std::max({color.pixels[i][0], color.pixels[i][1], color.pixels[i][2]}) == 255 ||
            std::min({color.pixels[i][0], color.pixels[i][1], color.pixels[i][2]}) == 0)
            continue;  // cut at the gamut
        const double lightness = srgb_encode(0.2126 * linear(0) + 0.7152 * linear(1) + 0.0722 * linear(2));
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(both.pixels[i][c], map.pixels[i][c] * lightness, 2.0) << i;
    }
}

TEST_F(Picture, IsNotSmoothedWhenEnlarged) {
    session_.show(Quantity::ellipticity);
    const RgbPicture small = drawn_at_1_to_1();
    session_.change_transform() = {3.0, {2.0, -6.0}};
    const RgbPicture large = drawn(100, 80);
    const Map map = evaluate(film(), Quantity::ellipticity, session_.view().band).value();
    for (int y = 0; y < 80; ++y) {
        for (int x = 2; x < 100; ++x) {
            const auto from = static_cast<std::size_t>((y + 6) / 3 * film_width + (x - 2) / 3);
            const auto to = static_cast<std::size_t>(y * 100 + x);
            if (is_hatched(map.pixels[from].state)) continue;  // by points, not pixels
            ASSERT_EQ(large.pixels[to], small.pixels[from]) << x << " " << y;
        }
    }
    EXPECT_EQ(large.pixels[0], (Rgb8{26, 26, 26})) << "left of the picture is background";
}

// Half horizontal, half vertical light is unpolarized where the eye cannot tell the pixels apart: light adds, maps do
// not.
TEST_F(Picture, AddsLightNotMapsWhenReduced) {
    StokesImage stripes;
    stripes.width = 64;
    stripes.height = 32;
    stripes.bands = bands_at({550.0});
    for (int i = 0; i < 64 * 32; ++i) stripes.stokes.push_back({1.0, i % 2 == 0 ? 1.0 : -1.0, 0.0, 0.0});
    open(stripes);
    session_.show(Quantity::dop);
    session_.change_view().scale = ColorScale::gray;
    for (const double ratio : {1.0, 2.0}) {
        session_.change_transform() = {0.5 / ratio, {0.0, 0.0}};
        const RgbPicture half = drawn(32, 16, ratio);
        for (const Rgb8& pixel : half.pixels) ASSERT_EQ(pixel, (Rgb8{0, 0, 0}));
    }
    session_.change_transform() = {1.0, {0.0, 0.0}};
    EXPECT_EQ(drawn(64, 32).pixels[0], (Rgb8{255, 255, 255}));
}

TEST_F(Picture, ADefectStaysVisibleWhenReduced) {
    StokesImage gray;
    gray.width = 64;
    gray.height = 64;
    gray.bands = bands_at({550.0});
    gray.stokes.assign(64 * 64, {1.0, 0.0, 0.0, 0.0});
    gray.stokes[20 * 64 + 33].s0 = std::numeric_limits<double>::quiet_NaN();
    gray.stokes[45 * 64 + 13].s1 = 2.0;
    open(gray);
    session_.show(Quantity::unphysical);
    session_.change_transform() = {0.125, {0.0, 0.0}};
    const RgbPicture reduced = drawn(8, 8);
    EXPECT_EQ(reduced.pixels[2 * 8 + 4], state_color(PixelState::not_a_number, 0, 0));
    EXPECT_EQ(reduced.pixels[5 * 8 + 1], encode(scale_color(ColorScale::sequential, 1.0)));
}

TEST_F(Picture, PixelsWithoutASampleAreBackground) {
    StokesImage begun = known_film();
    begun.samples.assign(begun.pixel_count(), 1);
    begun.samples[10] = 0;
    begun.residual.resize(begun.pixel_count() *
                          (begun.residual.empty() ? 1 : begun.residual.size() / begun.pixel_count()));
    for (std::size_t plane = 0; plane < begun.residual.size(); plane += begun.pixel_count())
        begun.residual[plane + 10] = 1.0;  // with less it would be a preview
    open(begun);
    session_.show(Quantity::dop);
    EXPECT_EQ(drawn_at_1_to_1().pixels[10], (Rgb8{26, 26, 26}));
}

TEST_F(Picture, OfTheReferenceIsThatOfItsOwnFilmInTheSameMap) {
    session_.set_reference();
    StokesImage other = known_film();
    for (Stokes<double>& s : other.stokes) s = {1.25 * s.s0, 0.5 * s.s1, s.s3, 0.5 * s.s2};
    open(other);
    auto reference = PictureRenderer::create(PictureSide::reference);
    ASSERT_TRUE(reference) << to_string(reference.error());
    renderer_ = std::move(reference).value();
    session_.show(Quantity::dop);
    session_.change_view().band = 0;
    const Rgb8 ground = drawn_at_1_to_1().pixels.front();
    for (const Rgb8& pixel : drawn_at_1_to_1().pixels)
        ASSERT_EQ(pixel, ground) << "nothing is shown beside the picture";
    session_.toggle_layout(CompareLayout::wipe);
    ASSERT_EQ(session_.layout(), CompareLayout::wipe);
    expect_same(drawn_at_1_to_1(), expected_of(session_.reference()->picture(), session_.view()));
}

// Sample of cases/02: crop.exr is columns 4 to 11, rows 3 to 8 of a picture of 16 x 12.
TEST_F(Picture, OfAPartLiesWhereItIsInTheWhole) {
    ASSERT_TRUE(session_.open(std::string(POL_TESTS_DIR) + "/data/pictures/cases/crop.exr"));
    session_.show(Quantity::intensity);
    session_.change_view().band = 0;
    session_.change_transform() = {};
    const RgbPicture whole = drawn(16, 12);
    const RgbPicture part = expected_of(film(), session_.view());
    ASSERT_EQ(part.width, 8);
    RgbPicture found{8, 6, {}};
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 16; ++x) {
            const Rgb8& pixel = whole.pixels[static_cast<std::size_t>(16 * y + x)];
            const bool is_in_it = x >= 4 && x < 12 && y >= 3 && y < 9;
            if (is_in_it)
                found.pixels.push_back(pixel);
            else
                EXPECT_EQ(pixel, whole.pixels.front()) << x << "," << y;
        }
    }
    expect_same(found, part);
}

// A strip holds 2^18 numbers, 436 rows of 600: one band of 600 x 600 pixels is two strips of light and two of color.
TEST_F(Picture, ComesInStripsAndIsTheSameInTheEnd) {
    StokesImage large;
    large.width = 600;
    large.height = 600;
    large.bands = bands_at({550.0});
    for (int i = 0; i < 600 * 600; ++i) large.stokes.push_back({1.0, i % 601 / 600.0, 0.0, 0.0});
    open(large);
    session_.show(Quantity::dop);
    session_.change_transform() = {1.0, {0.0, 0.0}};
    for (int strips = 1; strips < 4; ++strips) EXPECT_TRUE(renderer_->upload(session_, 0.0)) << strips;
    EXPECT_FALSE(renderer_->upload(session_, 0.0));
    EXPECT_FALSE(renderer_->upload(session_, 0.0)) << "nothing changed";
    const RgbPicture in_strips = drawn(600, 600);
    auto at_once = PictureRenderer::create();
    ASSERT_TRUE(at_once);
    renderer_ = std::move(at_once).value();
    EXPECT_EQ(in_strips.pixels, drawn(600, 600).pixels);
    EXPECT_NE(in_strips.pixels.front(), in_strips.pixels[599 * 600]);
}

}  // namespace
}  // namespace pol
