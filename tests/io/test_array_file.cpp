// SPDX-License-Identifier: Apache-2.0
// Samples of other programs' arrays, photographs and FITS cubes. Expected: expected.json beside them, written with
// them.
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "io/array_files.h"

namespace pol {
namespace {

struct Sample {
    std::string name;
    std::string layout;      ///< asked for
    std::string recognised;  ///< begins or is within PictureOrigin::layout
    std::vector<std::string> bands;
    StokesComponents known = StokesComponents::all();
    double relative = 0.0;  ///< error of the storage: half a unit in the last place
    double absolute = 0.0;
    double unit = 1.0;  ///< what 1 of the reader is in expected.json
};

// A photograph's code is off by half a unit of 65535 (or of 4095), and a component is the sum of at most four halves.
constexpr double code16 = 2.0 * 2.0 * 0.5 / 65535.0;
constexpr double code12 = 2.0 * 2.0 * 0.5 / 4095.0;
// expected.json has six decimals.
constexpr double decimals = 0.5e-6;

const std::vector<Sample>& samples() {
    const StokesComponents linear = StokesComponents::linear();
    static const std::vector<Sample> all{
        {"hw4_f4.npy", "", "rows, columns, Stokes", {"mono"}, StokesComponents::all(), 0x1p-24},
        {"hw4_f8_fortran.npy", "", "rows, columns, Stokes", {"mono"}},
        {"hw4_be.npy", "", "rows, columns, Stokes", {"mono"}, StokesComponents::all(), 0x1p-24},
        {"hw4_f2.npy", "", "rows, columns, Stokes", {"mono"}, StokesComponents::all(), 0x1p-11, 0x1p-25},
        {"chw_f4.npy", "", "Stokes, rows, columns", {"mono"}, StokesComponents::all(), 0x1p-24},
        {"hw3_linear_f8.npy", "", "rows, columns, Stokes", {"mono"}, linear},
        {"hw_bgr_3_f8.npy", "", "blue green red", {"R", "G", "B"}, linear},
        {"mitsuba_tensor_f4.npy", "", "Mitsuba tensor", {"R", "G", "B"}, StokesComponents::all(), 0x1p-23},
        {"named.npz", "", "arrays s0, s1, s2, s3", {"mono"}},
        {"single.npz", "", "stokes, array", {"mono"}, StokesComponents::all(), 0x1p-24},
        {"iquv_iau.fits", "", "FITS", {"mono"}, StokesComponents::all(), 0x1p-24},
        {"four_000.png", "", "four photographs", {"mono"}, linear, 0.0, code16, 2.0},
        {"four_135.png", "", "four photographs", {"mono"}, linear, 0.0, code16, 2.0},
        {"mosaic_12bit.png", "mosaic", "mosaic of polarizers", {"mono"}, linear, 0.0, code12, 2.0 * 65535.0 / 65520.0},
    };
    return all;
}

class EverySample : public testing::TestWithParam<Sample> {};

TEST_P(EverySample, IsRecognisedAsItselfAndHasTheExpectedNumbers) {
    const Sample& about = GetParam();
    const PictureSource source = source_of(sample(about.name), about.layout);
    ASSERT_TRUE(is_array_file(source));
    const auto read = read_array_picture(source);
    ASSERT_TRUE(read) << to_string(read.error());
    const StokesImage& image = read.value();
    const auto expected = nlohmann::json::parse(bytes_of(sample("expected.json")));
    EXPECT_NE(image.origin.layout.find(about.recognised), std::string::npos) << image.origin.layout;
    EXPECT_FALSE(image.origin.assumed.empty());
    ASSERT_EQ(image.width, expected["width"].get<int>());
    ASSERT_EQ(image.height, expected["height"].get<int>());
    ASSERT_EQ(image.bands.size(), about.bands.size());
    ASSERT_EQ(image.stokes.size(), image.pixel_count() * image.bands.size());
    for (std::size_t b = 0; b < image.bands.size(); ++b) {
        EXPECT_EQ(image.bands[b].label(), about.bands[b]);
        EXPECT_FALSE(image.bands[b].wavelength_nm);
        EXPECT_EQ(image.bands[b].known, about.known);
        const double share = image.bands.size() == 3 ? expected["rgb_share"][b].get<double>() : 1.0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const Stokes<double>& s = image.at(b, image.pixel(x, y));
                const std::array<double, 4> found{s.s0, s.s1, s.s2, s.s3};
                for (unsigned i = 0; i < 4; ++i) {
                    const double truth =
                        about.known.has(i)
                            ? share * expected["stokes"][static_cast<std::size_t>(y)][static_cast<std::size_t>(x)][i]
                                          .get<double>()
                            : 0.0;
                    EXPECT_NEAR(about.unit * found[i], truth,
                                decimals + about.absolute + about.relative * std::abs(truth))
                        << about.name << " band " << b << " pixel " << x << "," << y << " S" << i;
                }
            }
    }
    const auto header = read_array_header(source);
    ASSERT_TRUE(header) << to_string(header.error());
    EXPECT_EQ(header.value().width, image.width);
    EXPECT_EQ(header.value().height, image.height);
    EXPECT_EQ(header.value().bands, image.bands);
    EXPECT_EQ(header.value().bytes, image.stokes.size() * sizeof(Stokes<double>));
}

INSTANTIATE_TEST_SUITE_P(Stokes, EverySample, testing::ValuesIn(samples()), [](const auto& about) {
    std::string name = about.param.name;
    for (char& c : name)
        if (c == '.' || c == '_') c = 'x';
    return name;
});

bool says(const std::vector<std::string>& sentences, const std::string& word) {
    for (const std::string& sentence : sentences)
        if (sentence.find(word) != std::string::npos) return true;
    return false;
}

TEST_F(ArrayFile, NoOtherFileIsTakenForAnArray) {
    EXPECT_FALSE(is_array_file(source_of(sample("expected.json"))));
    EXPECT_FALSE(is_array_file(source_of(path("missing.npy"))));
    EXPECT_FALSE(is_array_file(source_of(write("scene.npy", "spectrum: 580\n"))));
    EXPECT_FALSE(is_array_file(source_of(write("empty.png", ""))));
    EXPECT_FALSE(is_array_file(PictureSource{}));
}

TEST_F(ArrayFile, HalvesAreRememberedAsHalvesAndFloatsAsFloats) {
    EXPECT_EQ(read_array_picture(source_of(sample("hw4_f2.npy"))).value().stored.bits, 16);
    EXPECT_EQ(read_array_picture(source_of(sample("hw4_f4.npy"))).value().stored.bits, 32);
}

TEST_F(ArrayFile, EveryHalfIsReadExactly) {
    // One, the smallest normal and subnormal, the largest, and what is no number (IEEE 754 binary16).
    const std::vector<std::uint16_t> halves{0x3c00, 0x0400, 0x0001, 0x7bff, 0xc000, 0x7c00, 0xfc00, 0x7e00};
    const auto read =
        read_array_picture(source_of(write("h.npy", npy_of(dict_of("<f2", "(1, 2, 4)"), numbers_of(halves)))));
    ASSERT_TRUE(read) << to_string(read.error());
    const Stokes<double>& a = read.value().stokes[0];
    const Stokes<double>& b = read.value().stokes[1];
    EXPECT_EQ(a.s0, 1.0);
    EXPECT_EQ(a.s1, 0x1p-14);
    EXPECT_EQ(a.s2, 0x1p-24);
    EXPECT_EQ(a.s3, 65504.0);
    EXPECT_EQ(b.s0, -2.0);
    EXPECT_EQ(b.s1, HUGE_VAL);
    EXPECT_EQ(b.s2, -HUGE_VAL);
    EXPECT_TRUE(std::isnan(b.s3));
}

TEST_F(ArrayFile, HeadersOfAllThreeVersionsAndOrdersOfKeysAreRead) {
    const std::string data = numbers_of<float>({1.0F, 2.0F, 3.0F, 4.0F});
    const std::string other = "{\"shape\": (1, 1, 4), 'fortran_order': False , 'descr':'=f4'}";
    for (const unsigned version : {1U, 2U, 3U}) {
        const auto read = read_array_picture(source_of(write("v.npy", npy_of(other, data, version))));
        ASSERT_TRUE(read) << version << to_string(read.error());
        EXPECT_EQ(read.value().stokes[0].s3, 4.0);
    }
}

TEST_F(ArrayFile, CountsAreReadAndSaidToBeWhole) {
    const auto read = read_array_picture(
        source_of(write("c.npy", npy_of(dict_of(">u2", "(1, 1, 3)"), std::string("\x01\x00\x00\x02\xff\xff", 6)))));
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(read.value().stokes[0].s0, 256.0);
    EXPECT_EQ(read.value().stokes[0].s1, 2.0);
    EXPECT_EQ(read.value().stokes[0].s2, 65535.0);
    EXPECT_TRUE(says(read.value().origin.remarks, "whole"));
    EXPECT_EQ(read.value().stored.spacing, 1.0);
    EXPECT_EQ(read.value().stored.bits, 32);
}

TEST_F(ArrayFile, EveryLayoutPutsEachNumberWhereItSays) {
    // The number at each place tells its place: band 1000, row 100, column 10, component 1.
    struct Case {
        std::string layout;
        std::vector<std::string> axes;
        std::vector<std::size_t> sizes;
    };
    const std::vector<Case> cases{{"hwc", {"row", "column", "component"}, {2, 5, 4}},
                                  {"chw", {"component", "row", "column"}, {4, 2, 4}},
                                  {"chw", {"component", "row", "column"}, {3, 2, 5}},
                                  {"nhwc", {"band", "row", "column", "component"}, {2, 3, 5, 4}},
                                  {"hwnc", {"row", "column", "band", "component"}, {2, 3, 5, 4}}};
    const auto weight = [](const std::string& axis) {
        return axis == "band" ? 1000.0 : axis == "row" ? 100.0 : axis == "column" ? 10.0 : 1.0;
    };
    for (const Case& one : cases) {
        std::vector<double> numbers{0.0};
        std::string shape = "(";
        for (std::size_t axis = 0; axis < one.axes.size(); ++axis) {
            std::vector<double> more;
            for (const double number : numbers)
                for (std::size_t i = 0; i < one.sizes[axis]; ++i)
                    more.push_back(number + weight(one.axes[axis]) * static_cast<double>(i));
            numbers = more;
            shape += std::to_string(one.sizes[axis]) + ", ";
        }
        const auto read = read_array_picture(
            source_of(write("l.npy", npy_of(dict_of("<f8", shape + ")"), numbers_of(numbers))), one.layout));
        ASSERT_TRUE(read) << one.layout << to_string(read.error());
        const StokesImage& image = read.value();
        for (std::size_t b = 0; b < image.bands.size(); ++b)
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x) {
                    const double base = 1000.0 * static_cast<double>(b) + 100.0 * y + 10.0 * x;
                    const Stokes<double>& s = image.at(b, image.pixel(x, y));
                    EXPECT_EQ(s.s0, base) << one.layout;
                    EXPECT_EQ(s.s2, base + 2.0) << one.layout;
                    EXPECT_EQ(s.s3, image.bands[b].known.has(3) ? base + 3.0 : 0.0) << one.layout;
                }
    }
}

TEST_F(ArrayFile, ThreeEqualColorsOfATensorAreOneBand) {
    std::vector<float> numbers;
    for (int component = 0; component < 4; ++component)
        for (int color = 0; color < 3; ++color) numbers.push_back(static_cast<float>(component) + 0.5F);
    const auto read =
        read_array_picture(source_of(write("m.npy", npy_of(dict_of("<f4", "(1, 1, 12)"), numbers_of(numbers)))));
    ASSERT_TRUE(read) << to_string(read.error());
    ASSERT_EQ(read.value().bands.size(), 1U);
    EXPECT_EQ(read.value().bands[0].name, "mono");
    EXPECT_EQ(read.value().stokes.at(0).s3, 3.5);
}

TEST_F(ArrayFile, OneFileForEachComponentMakesAPicture) {
    PictureSource source;
    for (unsigned i = 0; i < 3; ++i)
        source.stokes_files[i] = write("s" + std::to_string(i) + ".npy",
                                       npy_of(dict_of("<f8", "(1, 2)"), numbers_of<double>({1.0 + i, 10.0 + i})));
    ASSERT_TRUE(is_array_file(source));
    const auto read = read_array_picture(source);
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(read.value().bands[0].known, StokesComponents::linear());
    EXPECT_EQ(read.value().stokes[1].s0, 10.0);
    EXPECT_EQ(read.value().stokes[1].s2, 12.0);
    source.stokes_files[0].clear();
    EXPECT_EQ(read_array_picture(source).error().kind, ErrorKind::usage);
    source.stokes_files[0] = write("other.npy", npy_of(dict_of("<f8", "(2, 1)"), numbers_of<double>({1.0, 2.0})));
    EXPECT_NE(to_string(read_array_picture(source).error()).find("another shape"), std::string::npos);
}

TEST_F(ArrayFile, ProgressMayStopTheReading) {
    const auto read = read_array_picture(source_of(sample("hw4_f4.npy")), [](double) { return false; });
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().what.find("stopped"), std::string::npos);
    double last = 0.0;
    ASSERT_TRUE(read_array_picture(source_of(sample("named.npz")), [&](double share) {
        EXPECT_GE(share, last);
        last = share;
        return true;
    }));
    EXPECT_EQ(last, 1.0);
}

TEST(FitsConventions, AreThoseOfIauAndCosmoOrOurs) {
    const auto iau = read_array_header(source_of(sample("iquv_iau.fits")));
    ASSERT_TRUE(iau);
    const Stokes<double> sky{1.0, 0.25, 0.5, 0.125};
    const Stokes<double> ours = iau.value().origin.convention.to_ours(sky);
    EXPECT_EQ(ours.s1, -sky.s1);
    EXPECT_EQ(ours.s2, -sky.s2);
    EXPECT_EQ(ours.s3, -sky.s3);
}

TEST(PolarizerAngles, OfAnySpreadGiveTheLightBack) {
    // Malus behind an ideal polarizer, Stokes (2, 0.5, -0.75): written as 16 bits would be, here as arrays are not
    // read.
    for (const auto& name : {"four_000.png", "four_045.png"}) {
        PictureSource source;
        for (const char* angle : {"000", "045", "090", "135"})
            source.files.push_back(sample(std::string("four_") + angle + ".png"));
        source.angles_deg = {180.0, -135.0, 270.0, 315.0};  // the same directions
        const auto by_angle = read_array_picture(source);
        const auto by_name = read_array_picture(source_of(sample(name)));
        ASSERT_TRUE(by_angle) << to_string(by_angle.error());
        ASSERT_TRUE(by_name);
        for (std::size_t i = 0; i < by_name.value().stokes.size(); ++i) {
            EXPECT_EQ(by_angle.value().stokes[i].s0, by_name.value().stokes[i].s0);
            EXPECT_EQ(by_angle.value().stokes[i].s1, by_name.value().stokes[i].s1);
            EXPECT_EQ(by_angle.value().stokes[i].s2, by_name.value().stokes[i].s2);
        }
        // Three of them are enough: without noise, the fourth follows.
        source.files.pop_back();
        source.angles_deg = {0.0, 45.0, 90.0};
        const auto by_three = read_array_picture(source);
        ASSERT_TRUE(by_three) << to_string(by_three.error());
        for (std::size_t i = 0; i < by_name.value().stokes.size(); ++i)
            EXPECT_NEAR(by_three.value().stokes[i].s2, by_name.value().stokes[i].s2, 4.0 * 0.5 / 65535.0);
    }
}

TEST_F(ArrayFile, APhotographAt135DegreesBelongsToTheSetThatIsBesideIt) {
    const auto copy = [&](const char* from, const char* to) { fs::copy_file(sample(from), path(to)); };
    copy("four_000.png", "p_0.png");
    copy("four_045.png", "p_45.png");
    copy("four_090.png", "p_90.png");
    copy("four_135.png", "p_135.png");
    const auto by_first = read_array_picture(source_of(path("p_0.png")));
    const auto by_last = read_array_picture(source_of(path("p_135.png")));
    ASSERT_TRUE(by_first) << to_string(by_first.error());
    ASSERT_TRUE(by_last) << to_string(by_last.error());
    EXPECT_EQ(by_last.value().origin, by_first.value().origin);
    EXPECT_EQ(by_last.value().stokes, by_first.value().stokes);
}

TEST(Photographs, SayTheResidualAndTheBitsThatAreUsed) {
    const auto four = read_array_picture(source_of(sample("four_090.png")));
    EXPECT_TRUE(says(four.value().origin.remarks, "I0 + I90 - I45 - I135"));
    EXPECT_TRUE(says(four.value().origin.remarks, "no S3"));
    const auto mosaic = read_array_picture(source_of(sample("mosaic_12bit.png"), "mosaic"));
    EXPECT_TRUE(says(mosaic.value().origin.remarks, "multiples of 16"));
    // S0 is half the sum of four numbers, each of which is a multiple of 16.
    EXPECT_DOUBLE_EQ(four.value().stored.spacing, 2.0 / 65535.0);
    EXPECT_DOUBLE_EQ(mosaic.value().stored.spacing, 2.0 * 16.0 / 65535.0);
}

TEST(Photographs, AreS0AloneUnlessAMosaicIsAskedFor) {
    const auto read = read_array_picture(source_of(sample("mosaic_12bit.png")));
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value().width, 6);
    EXPECT_EQ(read.value().bands[0].known, StokesComponents::s0());
    EXPECT_EQ(read.value().origin.layout, "photograph");
}

/// A PNG with one more chunk behind its header.
std::string with_chunk(const std::string& png, const std::string& type, const std::string& data) {
    const std::string content = type + data;
    std::uint32_t crc = ~0U;  // ISO 3309, a bit at a time
    for (const char c : content) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xedb88320U : crc >> 1U;
    }
    const auto big_endian = [](std::uint32_t number) {
        std::string bytes;
        for (unsigned i = 4; i-- > 0;) bytes += static_cast<char>(number >> 8U * i & 0xffU);
        return bytes;
    };
    constexpr std::size_t behind_header = 8 + 25;
    return png.substr(0, behind_header) + big_endian(static_cast<std::uint32_t>(data.size())) + content +
           big_endian(~crc) + png.substr(behind_header);
}
const std::string linear_gamma("\x00\x01\x86\xa0", 4);  // gAMA counts in 100000ths: 1.0
const std::string half_gamma("\x00\x00\xc3\x50", 4);    // 0.5

TEST_F(ArrayFile, APhotographBecomesLightAsItsFileSays) {
    const std::string png = bytes_of(sample("four_000.png"));
    const auto light = [&](const std::string& bytes) {
        const auto read = read_array_picture(source_of(write("one.png", bytes)));
        EXPECT_TRUE(read) << to_string(read.error());
        return read.value();
    };
    const StokesImage linear = light(with_chunk(png, "gAMA", linear_gamma));
    EXPECT_TRUE(linear.origin.assumed.empty());
    EXPECT_FALSE(says(linear.origin.remarks, "decoded"));
    const StokesImage squared = light(with_chunk(png, "gAMA", half_gamma));
    EXPECT_TRUE(says(squared.origin.remarks, "gAMA of 0.5"));
    const StokesImage srgb = light(with_chunk(png, "sRGB", std::string(1, '\0')));
    EXPECT_TRUE(says(srgb.origin.remarks, "by the sRGB curve, as the file says"));
    const StokesImage silent = light(png);
    EXPECT_TRUE(says(silent.origin.assumed, "by the sRGB curve: the file does not say"));
    for (std::size_t i = 0; i < linear.stokes.size(); ++i) {
        const double code = linear.stokes[i].s0;
        EXPECT_NEAR(code * 65535.0, std::round(code * 65535.0), 1e-9);
        EXPECT_NEAR(squared.stokes[i].s0, code * code, 1e-15);
        // IEC 61966-2-1
        const double decoded = code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
        EXPECT_NEAR(srgb.stokes[i].s0, decoded, 1e-15);
        EXPECT_EQ(silent.stokes[i].s0, srgb.stokes[i].s0);
    }
}

TEST_F(ArrayFile, OfGammaEncodedPhotographsBehindPolarizersTheStokesNumbersAreCalledMeaningless) {
    const auto set = [&](const std::string& type, const std::string& data) {
        for (const char* angle : {"000", "045", "090", "135"}) {
            const std::string png = bytes_of(sample(std::string("four_") + angle + ".png"));
            std::ignore = write(std::string("x_") + angle + ".png", type.empty() ? png : with_chunk(png, type, data));
        }
        return read_array_picture(source_of(path("x_000.png"))).value().origin;
    };
    EXPECT_TRUE(says(set("gAMA", half_gamma).remarks, "meaningless in gamma-encoded files"));
    EXPECT_TRUE(says(set("sRGB", std::string(1, '\0')).remarks, "meaningless in gamma-encoded files"));
    const PictureOrigin linear = set("gAMA", linear_gamma);
    EXPECT_FALSE(says(linear.remarks, "gamma"));
    EXPECT_FALSE(says(linear.assumed, "proportional"));
    EXPECT_TRUE(says(set("", "").assumed, "proportional to light"));
}

}  // namespace
}  // namespace pol
