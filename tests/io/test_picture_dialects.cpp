// SPDX-License-Identifier: Apache-2.0
// EXR pictures as other programs wrote them: each is recognised as what it is, with the numbers that its program has.
// Samples: tests/data/pictures, from Mitsuba 3.9.1 and by wave_tracer's file layout.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "io/exr_files.h"
#include "io/pictures/picture_file.h"
#include "io/pictures/stokes_channels.h"

namespace pol {
namespace {

const fs::path data = fs::path(POL_TESTS_DIR) / "data/pictures";

/// `layout` as after --layout.
PictureSource source(const fs::path& path, const std::string& layout = {}) {
    PictureSource source;
    source.files = {path};
    source.layout = layout;
    return source;
}

StokesImage sample(const std::string& name) {
    Result<StokesImage> image = read_picture(source(data / name));
    EXPECT_TRUE(image) << to_string(image.error());
    return image ? std::move(image).value() : StokesImage{};
}

std::vector<std::string> labels(const StokesImage& image) {
    std::vector<std::string> labels;
    for (const Band& band : image.bands) labels.push_back(band.label());
    return labels;
}

bool says(const std::vector<std::string>& sentences, const std::string& words) {
    return std::any_of(sentences.begin(), sentences.end(),
                       [&](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
}

using Names = std::vector<std::string>;

TEST(PictureDialects, EachSampleIsRecognisedAsItselfAndAsNothingElse) {
    struct Expected {
        std::string layout;
        std::string option;  ///< of --layout
        Names bands;
    };
    const Names rgb{"R", "G", "B"};
    const std::map<std::string, Expected> samples{
        {"mitsuba_exr/mono_luminance_f16.exr", {"Mitsuba 3, mono", "mitsuba", {"mono"}}},
        {"mitsuba_exr/mono_luminance_f32.exr", {"Mitsuba 3, mono", "mitsuba", {"mono"}}},
        {"mitsuba_exr/scalar_spectral_rgba_f16.exr", {"Mitsuba 3, RGB", "mitsuba", rgb}},
        {"mitsuba_exr/scalar_spectral_specfilm_f32.exr",
         {"Mitsuba 3, specfilm", "mitsuba", {"R", "G", "B", "band0", "band1", "band2"}}},
        {"mitsuba_exr/spectral_luminance_f32.exr", {"Mitsuba 3, RGB", "mitsuba", rgb}},
        {"mitsuba_exr/spectral_rgb_f16.exr", {"Mitsuba 3, RGB", "mitsuba", rgb}},
        {"mitsuba_exr/spectral_rgb_f32.exr", {"Mitsuba 3, RGB", "mitsuba", rgb}},
        {"mitsuba_exr/tensor_unnamed_f32.exr", {"Mitsuba 3 array, RGB", "mitsuba-array", rgb}},
        {"stokes_dialects/wt_rgb_I.exr", {"wave_tracer, four files", "wave_tracer", rgb}},
        {"stokes_dialects/wt_mono_V.exr", {"wave_tracer, four files", "wave_tracer", {"mono"}}},
        {"cases/mitsuba16.exr", {"Mitsuba 3, RGB", "mitsuba", rgb}},
        {"cases/mitsuba13.exr", {"Mitsuba 3, RGB", "mitsuba", rgb}},
        {"cases/mono4.exr", {"Stokes components without a band", "bare", {"mono"}}},
        {"cases/crop.exr", {"spectral layout", "spectral", {"580 nm"}}},
        {"cases/parts-each.exr", {"spectral layout", "spectral", {"580 nm"}}},
        {"cases/parts-rgb-first.exr", {"spectral layout", "spectral", {"580 nm"}}},
        {"cases/s0only.exr", {"spectral layout", "spectral", {"580 nm"}}},
    };
    for (const auto& [name, expected] : samples) {
        SCOPED_TRACE(name);
        const StokesImage image = sample(name);
        EXPECT_EQ(labels(image), expected.bands);
        EXPECT_EQ(image.origin.layout, expected.layout);
        for (const Band& band : image.bands) EXPECT_EQ(band.wavelength_nm.has_value(), band.label() == "580 nm");
        for (const PictureLayout& layout : picture_layouts()) {
            const Result<StokesImage> forced = read_picture(source(data / name, std::string(layout.name)));
            // Any picture of R, G and B or one channel is one without polarization, too: that comes last. A file of
            // four is one of any four.
            const bool may_fit = layout.name == expected.option || layout.name == "plain" ||
                                 (layout.name == "four" && expected.option == "wave_tracer");
            if (layout.name == expected.option) {
                ASSERT_TRUE(forced) << to_string(forced.error());
                EXPECT_EQ(forced.value().origin, image.origin);
                EXPECT_EQ(forced.value().stokes, image.stokes);
            } else if (!may_fit) {
                EXPECT_FALSE(forced) << layout.name;
            }
        }
    }
}

TEST(PictureDialects, HeadersSayWithoutPixelsWhatThePictureIs) {
    for (const std::string name : {"mitsuba_exr/spectral_rgb_f16.exr", "stokes_dialects/wt_rgb_Q.exr",
                                   "stokes_dialects/wt_mono_U.exr", "cases/crop.exr", "cases/s0only.exr"}) {
        SCOPED_TRACE(name);
        const StokesImage image = sample(name);
        const Result<PictureHeader> header = read_picture_header(source(data / name));
        ASSERT_TRUE(header) << to_string(header.error());
        EXPECT_EQ(header.value().width, image.width);
        EXPECT_EQ(header.value().height, image.height);
        EXPECT_EQ(header.value().bands, image.bands);
        EXPECT_EQ(header.value().origin, image.origin);
        EXPECT_GE(header.value().bytes, image.stokes.size() * sizeof(Stokes<double>));
    }
}

nlohmann::json json_of(const std::string& name) {
    return nlohmann::json::parse(std::ifstream(data / name));
}

/// The Stokes vector of color `c` (R, G, B) from the channel values of mi.Bitmap. `shift`: how many places the labels
/// are off.
Stokes<double> mitsuba_stokes(const nlohmann::json& values, std::size_t c, std::size_t shift) {
    static const Names names{"S0.R", "S0.G", "S0.B", "S1.R", "S1.G", "S1.B",
                             "S2.R", "S2.G", "S2.B", "S3.R", "S3.G", "S3.B"};
    const auto at = [&](std::size_t s) {
        const std::size_t place = 3 * s + c + shift;
        if (place >= names.size()) return 0.0;
        if (values.contains(names[place])) return values.at(names[place]).get<double>();
        const std::string unnamed = "ch" + std::string(place + 3 < 10 ? "0" : "") + std::to_string(place + 3);
        return values.at(unnamed).get<double>();
    };
    return {at(0), at(1), at(2), at(3)};
}

TEST(PictureDialects, MitsubasNumbersAreReadAsTheyAre) {
    const nlohmann::json files = json_of("mitsuba_exr/values.json");
    int compared = 0;
    for (const auto& entry : fs::directory_iterator(data / "mitsuba_exr")) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".exr") continue;
        SCOPED_TRACE(name);
        const StokesImage image = sample("mitsuba_exr/" + name);
        const std::size_t shift = name.find("specfilm") == std::string::npos ? 0 : 1;
        EXPECT_EQ(image.stored.bits, name.find("f16") == std::string::npos ? 32 : 16);
        for (const auto& [place, values] : files.at(name).at("pixels").items()) {
            const std::size_t comma = place.find(',');
            const std::size_t pixel =
                image.pixel(std::stoi(place.substr(0, comma)), std::stoi(place.substr(comma + 1)));
            for (std::size_t band = 0; band < std::min<std::size_t>(image.bands.size(), 3); ++band) {
                const Stokes<double> expected = mitsuba_stokes(values, band, shift);
                const Stokes<double>& read = image.at(band, pixel);
                // The values are given to 7 digits.
                EXPECT_NEAR(read.s0, expected.s0, 1e-6);
                EXPECT_NEAR(read.s1, expected.s1, 1e-6);
                EXPECT_NEAR(read.s2, expected.s2, 1e-6);
                EXPECT_NEAR(read.s3, expected.s3, 1e-6);
                ++compared;
            }
        }
    }
    EXPECT_EQ(compared, 3 * (2 * 1 + 6 * 3));
}

TEST(PictureDialects, ASpecfilmsShiftedLabelsAreMendedAndSaid) {
    const StokesImage image = sample("mitsuba_exr/scalar_spectral_specfilm_f32.exr");
    EXPECT_TRUE(says(image.origin.remarks, "one place off"));
    EXPECT_EQ(image.bands[0].known, StokesComponents::all());
    EXPECT_EQ(image.bands[1].known, StokesComponents::all());
    EXPECT_EQ(image.bands[2].known, StokesComponents::linear());
    EXPECT_EQ(image.bands[3].known, StokesComponents::s0());
    const std::size_t pixel = image.pixel(48, 40);
    EXPECT_EQ(image.at(2, pixel).s3, 0.0);
    EXPECT_NEAR(image.at(3, pixel).s0, 88.53127, 1e-5);  // band0
    // The same scene by an hdrfilm, other samples: within the noise of 256 of them.
    const StokesImage rgba = sample("mitsuba_exr/scalar_spectral_rgba_f16.exr");
    for (std::size_t band = 0; band < 3; ++band) {
        double sum = 0.0;
        double sum_rgba = 0.0;
        for (std::size_t i = 0; i < image.pixel_count(); ++i) {
            sum += image.at(band, i).s1;
            sum_rgba += rgba.at(band, i).s1;
        }
        EXPECT_NEAR(sum / sum_rgba, image.at(band, pixel).s0 / rgba.at(band, pixel).s0, 0.05);
    }
}

TEST(PictureDialects, MitsubaSaysNothingThatHasToBeAssumedButArraysDo) {
    EXPECT_TRUE(sample("mitsuba_exr/spectral_rgb_f32.exr").origin.assumed.empty());
    EXPECT_TRUE(
        says(sample("mitsuba_exr/tensor_unnamed_f32.exr").origin.assumed, "ch03 to ch14 are taken by position"));
    // No generatedBy, but polarisationHandedness: right.
    EXPECT_EQ(sample("cases/mitsuba16.exr").origin.assumed,
              Names{"azimuth is taken from image right, counter-clockwise: the file does not say"});
}

TEST(PictureDialects, WaveTracersFourFilesAreOnePictureWhicheverIsNamed) {
    const nlohmann::json expected = json_of("stokes_dialects/expected.json");
    for (const std::string component : {"I", "Q", "U", "V"}) {
        for (const std::string kind : {"rgb", "mono"}) {
            SCOPED_TRACE(kind + component);
            std::string name = "stokes_dialects/wt_";
            name += kind;
            name += "_" + component + ".exr";
            const StokesImage image = sample(name);
            ASSERT_EQ(image.width, 3);
            ASSERT_EQ(image.height, 2);
            for (int y = 0; y < 2; ++y) {
                for (int x = 0; x < 3; ++x) {
                    const auto s =
                        expected.at("stokes").at(static_cast<std::size_t>(y)).at(static_cast<std::size_t>(x));
                    for (std::size_t band = 0; band < image.bands.size(); ++band) {
                        const double share = kind == "rgb" ? expected.at("rgb_share").at(band).get<double>() : 1.0;
                        const Stokes<double>& read = image.at(band, image.pixel(x, y));
                        // Stored as floats of numbers up to 2.
                        EXPECT_NEAR(read.s0, share * s.at(0).get<double>(), 1e-6);
                        EXPECT_NEAR(read.s1, share * s.at(1).get<double>(), 1e-6);
                        EXPECT_NEAR(read.s2, share * s.at(2).get<double>(), 1e-6);
                        EXPECT_NEAR(read.s3, share * s.at(3).get<double>(), 1e-6);
                    }
                }
            }
            EXPECT_TRUE(says(image.origin.assumed, "azimuth"));
            EXPECT_TRUE(says(image.origin.assumed, "right-handed"));
        }
    }
}

// Case 01: degree of polarization 0.8 in every pixel, S0 = 1 + 0.1 x + 0.01 y. Of the files with colors this is so in
// band R alone: S1 and S3 are exchanged there, and G and B hold the four numbers in other orders.
TEST(PictureDialects, ThePicturesOfCase01HaveTheirPolarization) {
    for (const std::string name : {"cases/mitsuba16.exr", "cases/mitsuba13.exr", "cases/mono4.exr"}) {
        SCOPED_TRACE(name);
        const StokesImage image = sample(name);
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const Stokes<double>& s = image.at(0, image.pixel(x, y));
                EXPECT_NEAR(s.s0, 1.0 + 0.1 * x + 0.01 * y, 1e-6);
                EXPECT_NEAR(std::hypot(s.s1, s.s2, s.s3), 0.8 * s.s0, 1e-6 * s.s0);
            }
        }
    }
    const StokesImage mono = sample("cases/mono4.exr");
    const Stokes<double>& s = mono.at(0, mono.pixel(7, 5));  // azimuth 0.3 x + 0.05 y
    EXPECT_NEAR(std::atan2(s.s2, s.s1), std::remainder(2.0 * (0.3 * 7 + 0.05 * 5), 2.0 * std::acos(-1.0)), 1e-6);
    EXPECT_NEAR(s.s3, 0.8 * s.s0 * std::sin(2.0 * 0.2), 1e-6);
}

// Case 02.
TEST(PictureDialects, ACropLiesWhereItLayInThePicture) {
    const StokesImage whole = sample("cases/plain.exr");
    const StokesImage crop = sample("cases/crop.exr");
    EXPECT_EQ(std::pair(crop.left, crop.top), std::pair(4, 3));
    EXPECT_EQ(std::pair(crop.whole_width, crop.whole_height), std::pair(16, 12));
    EXPECT_EQ(std::pair(crop.width, crop.height), std::pair(8, 6));
    for (int y = 0; y < crop.height; ++y)
        for (int x = 0; x < crop.width; ++x)
            EXPECT_EQ(crop.at(0, crop.pixel(x, y)), whole.at(0, whole.pixel(x + 4, y + 3)));
    const StokesImage bad = sample("cases/crop-bad.exr");
    EXPECT_EQ(std::pair(bad.whole_width, bad.whole_height), std::pair(100, 80));
    EXPECT_EQ(std::pair(bad.left, bad.top), std::pair(60, 40));
    const Stokes<double>& worst = bad.at(0, bad.pixel(3, 2));
    EXPECT_TRUE(std::isnan(worst.s0 + worst.s1 + worst.s2 + worst.s3));
}

// Case 03.
TEST(PictureDialects, TheChannelsOfAllPartsAreGathered) {
    for (const std::string name : {"cases/parts-each.exr", "cases/parts-rgb-first.exr"}) {
        const StokesImage image = sample(name);
        for (const Stokes<double>& s : image.stokes) EXPECT_NEAR(std::hypot(s.s1, s.s2, s.s3) / s.s0, 0.8, 1e-6);
    }
}

// Case 04.
TEST(PictureDialects, SubsampledChannelsAreRefusedByName) {
    const Result<StokesImage> read = read_picture(source(data / "cases/subsampled.exr"));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().what, "channel S1.580,000000nm has sampling 2 x 2; only full resolution is read");
    EXPECT_EQ(read.error().hint, "write all channels at full resolution");
}

// Case 06.
TEST(PictureDialects, S0AloneIsAPictureOfUnknownPolarization) {
    const StokesImage image = sample("cases/s0only.exr");
    ASSERT_EQ(image.bands.size(), 1U);
    EXPECT_EQ(image.bands[0].known, StokesComponents::s0());
    EXPECT_EQ(image.bands[0].wavelength_nm, 580.0);
    EXPECT_TRUE(image.origin.assumed.empty());
}

// Case 09.
TEST(PictureDialects, LossyCompressionIsNamed) {
    const StoredNumbers pxr24 = sample("cases/pxr24.exr").stored;
    EXPECT_EQ(pxr24.bits, 24);
    EXPECT_EQ(pxr24.lossy, "");
    const StoredNumbers b44 = sample("cases/b44.exr").stored;
    EXPECT_EQ(b44.bits, 16);
    EXPECT_EQ(b44.lossy, "B44");
}

// Over the wire a channel may have no name; "" stands for a component that is not there.
TEST(StokesChannels, AChannelWithoutANameIsNoPicture) {
    EXPECT_FALSE(find_stokes_channels({""}, "", ""));
    const auto found = find_stokes_channels({"", "S0", "S1", "S2"}, "", "");
    ASSERT_TRUE(found);
    EXPECT_EQ(found.value().bands[0].band.known, StokesComponents::linear());
}

}  // namespace
}  // namespace pol
