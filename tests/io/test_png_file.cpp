// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "io/pictures/png_file.h"
#include "report/bar_ticks.h"
#include "report/map_picture.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

fs::path scratch_file() {
    return fs::temp_directory_path() / ("polariscope-png-" + std::to_string(::getpid()) + ".png");
}

/// Decoded by libpng's own reader; width 0 if it refuses.
RgbPicture decode_png(const fs::path& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&image, path.c_str()) == 0) return {};
    image.format = PNG_FORMAT_RGB;
    RgbPicture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
    picture.pixels.resize(std::size_t{image.width} * image.height);
    if (png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr) == 0) return {};
    return picture;
}

Rgb8 at(const RgbPicture& picture, int x, int y) {
    return picture
        .pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x)];
}

/// Fully linearly polarized along +45 degrees, but dark in the first column and NaN in the last row.
StokesImage sample_image(int width, int height) {
    StokesImage image;
    image.width = width;
    image.height = height;
    image.bands = bands_at({580.0});
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (x == 0)
                image.stokes.push_back({0.0, 0.0, 0.0, 0.0});
            else
                image.stokes.push_back({1.0, 0.0, y == height - 1 ? std::nan("") : 1.0, 0.0});
        }
    }
    return image;
}

ColoredMap sample_map(Quantity quantity, int width, int height, const MapOptions& options = {}) {
    return draw_map(sample_image(width, height), quantity, 0, options).value();
}

/// Top left corner and side of the area of one color that contains most of its pixels, as a bounding box.
struct Box {
    int left = std::numeric_limits<int>::max();
    int top = std::numeric_limits<int>::max();
    int right = -1;
    int bottom = -1;
};
template <class Accept>
Box bounding_box(const RgbPicture& picture, Accept accept) {
    Box box;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            if (!accept(at(picture, x, y))) continue;
            box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
        }
    }
    return box;
}

TEST(PngFile, DecodesToTheSamePixels) {
    RgbPicture picture{3, 2, {{0, 0, 0}, {255, 0, 128}, {1, 2, 3}, {255, 255, 255}, {0, 255, 0}, {9, 8, 7}}};
    ASSERT_TRUE(write_png(picture, scratch_file()));
    const RgbPicture back = decode_png(scratch_file());
    fs::remove(scratch_file());
    EXPECT_EQ(back.width, 3);
    EXPECT_EQ(back.height, 2);
    EXPECT_EQ(back.pixels, picture.pixels);
}

TEST(PngFile, CannotBeWrittenToAMissingFolderOrWithoutPixels) {
    const Result<Done> missing = write_png(RgbPicture{1, 1, {{0, 0, 0}}}, scratch_file() / "missing" / "map.png");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, ErrorKind::output);
    EXPECT_FALSE(write_png(RgbPicture{}, scratch_file()));
    EXPECT_FALSE(fs::exists(scratch_file()));
}

TEST(Colorize, CountsDarkAndBadPixelsAndShowsThemInColorsOfTheirOwn) {
    const ColoredMap map = sample_map(Quantity::azimuth, 8, 4);
    const auto count = [&map](PixelState state) { return map.state_count[static_cast<std::size_t>(state)]; };
    EXPECT_EQ(count(PixelState::no_light), 4U);
    EXPECT_EQ(count(PixelState::not_a_number), 7U);
    EXPECT_EQ(count(PixelState::defined), 21U);
    EXPECT_EQ(at(map.picture, 0, 0), (Rgb8{0, 0, 0}));
    EXPECT_EQ(at(map.picture, 7, 3), (Rgb8{255, 0, 255}));
    // 45 degrees of -90..90 is three quarters up the scale.
    EXPECT_EQ(at(map.picture, 4, 1), encode(scale_color(ColorScale::cyclic, 0.75)));
}

TEST(Colorize, DrawsThePaperStyleWhiteForPolarizedAndBlackForUnpolarizedOrDark) {
    MapOptions options;
    options.style = MapStyle::paper;
    EXPECT_EQ(at(sample_map(Quantity::dop, 8, 4, options).picture, 4, 1), (Rgb8{255, 255, 255}));
    EXPECT_EQ(at(sample_map(Quantity::ellipticity, 8, 4, options).picture, 4, 1), (Rgb8{0, 0, 0}));
    EXPECT_EQ(at(sample_map(Quantity::dop, 8, 4, options).picture, 0, 1), (Rgb8{0, 0, 0}));
}

/// From left to right: no light, unpolarized, not determined, horizontal, vertical and right circular light, negative
/// S0, dark.
StokesImage image_of_states() {
    StokesImage image;
    image.width = 8;
    image.height = 1;
    image.bands = bands_at({580.0});
    image.brightest = {1.0};
    image.stokes = {{0.0, 0.0, 0.0, 0.0},  {1.0, 0.0, 0.0, 0.0}, {1.0, 0.5, 0.0, 0.0},  {1.0, 1.0, 0.0, 0.0},
                    {1.0, -1.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 1.0}, {-1.0, 0.0, 0.0, 0.0}, {1e-5, 0.0, 0.0, 0.0}};
    image.residual = {0.0, 0.0, 0.9, 0.0, 0.0, 0.0, 0.0, 5e-4};
    return image;
}

ColoredMap map_of_states(Quantity quantity, MapStyle style) {
    MapOptions options;
    options.style = style;
    return draw_map(image_of_states(), quantity, 0, options).value();
}

// Black is 0 in the paper's figures: unpolarized light has no polarization and no ellipticity. What was not traced is
// not 0.
TEST(Colorize, DrawsWhatIsNotDeterminedNeverAsAValue) {
    for (const Quantity quantity : {Quantity::dop, Quantity::ellipticity}) {
        const RgbPicture drawn = map_of_states(quantity, MapStyle::paper).picture;
        EXPECT_EQ(at(drawn, 0, 0), (Rgb8{0, 0, 0}));
        EXPECT_EQ(at(drawn, 1, 0), (Rgb8{0, 0, 0}));
        EXPECT_EQ(at(drawn, 2, 0), state_color(PixelState::undetermined, 2, 0));
        EXPECT_NE(at(drawn, 2, 0), (Rgb8{0, 0, 0}));
        EXPECT_EQ(at(drawn, 6, 0), state_color(PixelState::unphysical, 0, 0));
        EXPECT_EQ(at(drawn, 7, 0), state_color(PixelState::dark, 7, 0));
        EXPECT_NE(at(drawn, 7, 0), state_color(PixelState::undetermined, 7, 0));
    }
    // Stripes: no value of a gray scale has them.
    for (const PixelState state : {PixelState::undetermined, PixelState::dark})
        EXPECT_NE(state_color(state, 0, 0), state_color(state, 4, 0));
    EXPECT_NE(state_color(PixelState::unphysical, 0, 0), state_color(PixelState::not_a_number, 0, 0));
}

// Where black is -1 or a direction, nothing else is black in the paper's style but darkness.
TEST(Colorize, DrawsSignedAndClosedMapsInThePapersStyleOnScalesOfTheirOwn) {
    for (const Quantity quantity :
         {Quantity::s1, Quantity::s2, Quantity::s3, Quantity::handedness, Quantity::azimuth}) {
        const ColoredMap paper = map_of_states(quantity, MapStyle::paper);
        EXPECT_EQ(paper.picture.pixels, map_of_states(quantity, MapStyle::scientific).picture.pixels);
        EXPECT_FALSE(paper.black_is_none);
        for (int x = 3; x < 6; ++x) EXPECT_NE(at(paper.picture, x, 0), at(paper.picture, 0, 0)) << x;
    }
}

TEST(Colorize, TheAzimuthHasAClosedScaleInEveryStyle) {
    for (const MapStyle style : {MapStyle::scientific, MapStyle::paper, MapStyle::wilkie}) {
        MapOptions options;
        options.style = style;
        const MapScale scale = map_scale(Quantity::azimuth, false, options, 0.0, 0.0);
        EXPECT_EQ(scale.kind, ScaleKind::cyclic);
        const Rgb8 low = encode(scale_color(scale.scale, 0.0));
        EXPECT_EQ(low, encode(scale_color(scale.scale, 1.0)));
        EXPECT_NE(low, encode(scale_color(scale.scale, 0.5)));
        // A part of the cycle has two ends: 20 degrees are not -20 degrees.
        options.range = MapRange{-20.0, 20.0};
        const MapScale part = map_scale(Quantity::azimuth, false, options, 0.0, 0.0);
        EXPECT_EQ(part.kind, ScaleKind::sequential);
        EXPECT_NE(encode(scale_color(part.scale, 0.0)), encode(scale_color(part.scale, 1.0)));
    }
}

// A tenth of S0 missing: P in [0.4, 0.6]/1.1, whose width of half the range is 2 * 0.2/1.1.
TEST(Colorize, FadesByTheWidthOfTheBarOnRequestButNotIntoAGrayThatIsAValue) {
    StokesImage image = sample_image(2, 1);
    image.stokes = {{1.0, 0.5, 0.0, 0.0}, {1.0, 0.5, 0.0, 0.0}};
    image.brightest = {1.0};
    image.residual = {0.0, 0.1};
    MapOptions options;
    options.fade_by_bar = true;
    const ColoredMap map = draw_map(image, Quantity::dop, 0, options).value();
    const Rgb color = scale_color(ColorScale::sequential, 0.5);
    EXPECT_TRUE(map.fades_by_bar);
    EXPECT_EQ(at(map.picture, 0, 0), encode(color));
    EXPECT_EQ(at(map.picture, 1, 0), faded(color, 1.0 - 2.0 * 0.2 / 1.1));
    options.style = MapStyle::paper;
    const ColoredMap paper = draw_map(image, Quantity::dop, 0, options).value();
    EXPECT_FALSE(paper.fades_by_bar);
    EXPECT_EQ(at(paper.picture, 1, 0), at(paper.picture, 0, 0));
}

TEST(Colorize, LetsExposureBrightenIntensityAndRangeStretchTheScale) {
    StokesImage image = sample_image(2, 1);
    image.stokes = {{0.95788 / 4.0, 0.0, 0.0, 0.0}, {1.0, 0.25, 0.0, 0.0}};
    MapOptions brighter;
    brighter.exposure = 2.0;
    // A quarter of D65 and two stops more is white. 12-digit rounding of the table value is far below 1/255.
    EXPECT_EQ(at(draw_map(image, Quantity::intensity, 0, brighter).value().picture, 0, 0), (Rgb8{255, 255, 255}));
    EXPECT_EQ(at(draw_map(image, Quantity::color, 0, brighter).value().picture, 0, 0), (Rgb8{255, 255, 255}));
    MapOptions stretched;
    stretched.range = MapRange{0.0, 0.2};
    const ColoredMap map = draw_map(image, Quantity::dop, 0, stretched).value();
    EXPECT_EQ(at(map.picture, 1, 0), encode(scale_color(ColorScale::sequential, 1.0)));
    EXPECT_EQ(map.above, 1U);
    EXPECT_EQ(map.below, 0U);
}

TEST(MapPicture, EnlargesSmallMapsByAWholeFactorAndNeverBlendsTheirPixels) {
    const ColoredMap map = sample_map(Quantity::azimuth, 64, 64);
    const RgbPicture drawn = map_picture(map, "scene.yaml").value();
    // Magenta also fills the legend's box, so look at the row of NaN: 63 pixels wide, 6 high.
    const Box magenta = bounding_box(drawn, [](const Rgb8& c) { return c == Rgb8{255, 0, 255}; });
    EXPECT_GE(magenta.right - magenta.left + 1, 63 * 6);
    const Rgb8 expected = at(map.picture, 40, 40);
    for (int dy = 0; dy < 6; ++dy) {
        for (int dx = 0; dx < 6; ++dx) {
            const int left = magenta.right + 1 - 64 * 6;
            EXPECT_EQ(at(drawn, left + 40 * 6 + dx, magenta.top - 63 * 6 + 40 * 6 + dy), expected);
        }
    }
}

// Seen from behind, angles run the other way: the wheel is upside down about its axis from left to right, and nothing
// else of the drawing changes.
TEST(MapPicture, HasAWheelThatTurnsTheWayInWhichAnglesAreCounted) {
    ColoredMap map = map_of_states(Quantity::azimuth, MapStyle::scientific);
    const RgbPicture usual = map_picture(map, "scene.yaml").value();
    map.words.clockwise = true;
    const RgbPicture other = map_picture(map, "scene.yaml").value();
    ASSERT_EQ(usual.pixels.size(), other.pixels.size());
    Box wheel;
    for (int y = 0; y < usual.height; ++y) {
        for (int x = 0; x < usual.width; ++x) {
            if (at(usual, x, y) == at(other, x, y)) continue;
            wheel = {std::min(wheel.left, x), std::min(wheel.top, y), std::max(wheel.right, x),
                     std::max(wheel.bottom, y)};
        }
    }
    ASSERT_GT(wheel.right - wheel.left, 60) << "34 points around its center";
    for (int y = wheel.top; y <= wheel.bottom; ++y)
        for (int x = wheel.left; x <= wheel.right; ++x)
            ASSERT_EQ(at(other, x, y), at(usual, x, wheel.top + wheel.bottom - y)) << x << " " << y;
}

// Its boxes lie below the picture, in the colors that the picture has.
TEST(MapPicture, HasALegendInTheColorsOfThePictureInEveryStyle) {
    for (const MapStyle style : {MapStyle::scientific, MapStyle::paper, MapStyle::wilkie}) {
        for (const Quantity quantity : {Quantity::dop, Quantity::ellipticity, Quantity::azimuth}) {
            const ColoredMap map = map_of_states(quantity, style);
            const RgbPicture drawn = map_picture(map, "scene.yaml").value();
            const int factor = (384 + map.picture.width - 1) / map.picture.width;
            // Below the picture, left of all texts: the boxes begin at the margin and are 14 points wide.
            std::vector<Rgb8> boxes;
            for (int y = 58 + factor; y < drawn.height; ++y)
                for (int x = 15; x < 29; ++x) boxes.push_back(at(drawn, x, y));
            for (int x = 0; x < map.picture.width; ++x) {
                const PixelState state = map.states[static_cast<std::size_t>(x)];
                if (state == PixelState::defined) continue;
                EXPECT_NE(std::count(boxes.begin(), boxes.end(), at(map.picture, x, 0)), 0)
                    << info(quantity).name << " style " << static_cast<int>(style) << " state "
                    << static_cast<int>(state);
            }
        }
    }
}

TEST(MapPicture, HasAColorBarFromTheLowEndBelowToTheHighEndAbove) {
    for (const int size : {1, 64, 700, 2048}) {
        SCOPED_TRACE(size);
        const ColoredMap map = sample_map(Quantity::dop, size, size);
        const RgbPicture drawn = map_picture(map, "scene.yaml").value();
        const int longest = std::max(drawn.width, drawn.height);
        EXPECT_LT(longest, std::max(384 + 200, size + size / 3));
        // The map itself has only the colors 0 (none) and 1 of the scale; halfway up is in the bar alone.
        const Rgb8 low = encode(scale_color(ColorScale::sequential, 0.1));
        const Rgb8 high = encode(scale_color(ColorScale::sequential, 0.9));
        const auto close_to = [](const Rgb8& wanted) {
            return [wanted](const Rgb8& c) {
                return std::abs(c[0] - wanted[0]) + std::abs(c[1] - wanted[1]) + std::abs(c[2] - wanted[2]) <= 6;
            };
        };
        const Box low_box = bounding_box(drawn, close_to(low));
        const Box high_box = bounding_box(drawn, close_to(high));
        ASSERT_GE(low_box.right, 0);
        ASSERT_GE(high_box.right, 0);
        EXPECT_GT(low_box.top, high_box.bottom);
        EXPECT_GE(high_box.right - high_box.left, 18);
    }
}

TEST(MapPicture, IsWhiteAlongItsEdgesSoNothingIsCutOff) {
    const std::string long_caption(300, 'W');
    for (const QuantityInfo& about : quantities()) {
        for (const int width : {1, 64, 900}) {
            SCOPED_TRACE(testing::Message() << about.name << " " << width);
            const RgbPicture drawn = map_picture(sample_map(about.quantity, width, 20), long_caption).value();
            constexpr Rgb8 white{255, 255, 255};
            for (int x = 0; x < drawn.width; ++x) {
                ASSERT_EQ(at(drawn, x, 0), white);
                ASSERT_EQ(at(drawn, x, drawn.height - 1), white);
            }
            for (int y = 0; y < drawn.height; ++y) {
                ASSERT_EQ(at(drawn, 0, y), white);
                ASSERT_EQ(at(drawn, drawn.width - 1, y), white);
            }
        }
    }
}

TEST(MapPicture, IsRefusedIfItIsTooLargeForALegend) {
    ColoredMap map = sample_map(Quantity::dop, 2, 1);
    map.picture.width = 40000;
    map.picture.pixels.resize(40000);
    map.states.resize(40000);
    const Result<RgbPicture> drawn = map_picture(map, "");
    ASSERT_FALSE(drawn);
    EXPECT_EQ(drawn.error().kind, ErrorKind::output);
}

// A sign has a name only where its side of the scale is.
TEST(BarTicks, SayWhatTheSignsMeanAtTheEnds) {
    const ScaleWords words{"left", "right", {}};
    EXPECT_EQ(end_word(-1.0, {-1.0, 1.0}, words), " left");
    EXPECT_EQ(end_word(1.0, {-1.0, 1.0}, words), " right");
    EXPECT_EQ(end_word(0.5, {-1.0, 1.0}, words), "");
    EXPECT_EQ(end_word(0.25, {0.25, 1.0}, words), "");
    EXPECT_EQ(end_word(-1.0, {-1.0, 1.0}, {}), "");
}

TEST(BarTicks, AreRoundNumbersBetweenTheEnds) {
    const std::vector<double> unit = bar_ticks({0.0, 1.0}, ScaleKind::sequential);
    ASSERT_EQ(unit.size(), 6U);
    // Multiples of 0.2 summed up: a rounding each.
    for (std::size_t i = 0; i < unit.size(); ++i) EXPECT_NEAR(unit[i], 0.2 * static_cast<double>(i), 1e-15);
    EXPECT_EQ(bar_ticks({-90.0, 90.0}, ScaleKind::cyclic), (std::vector<double>{-90.0, -45.0, 0.0, 45.0, 90.0}));
    EXPECT_EQ(bar_ticks({-1.0, 1.0}, ScaleKind::diverging), (std::vector<double>{-1.0, -0.5, 0.0, 0.5, 1.0}));
    for (const double high : {1e-300, 3.7e-9, 0.00123, 42.0, 1e300}) {
        const std::vector<double> ticks = bar_ticks({0.0, high}, ScaleKind::sequential);
        EXPECT_TRUE(std::is_sorted(ticks.begin(), ticks.end()));
        EXPECT_GE(ticks.size(), 4U) << high;
        EXPECT_LE(ticks.size(), 9U) << high;
        EXPECT_EQ(ticks.back(), high);
    }
    // Ends so close that a round step would not move a number on.
    EXPECT_LE(bar_ticks({1.0, std::nextafter(1.0, 2.0)}, ScaleKind::sequential).size(), 9U);
}

}  // namespace
}  // namespace pol
