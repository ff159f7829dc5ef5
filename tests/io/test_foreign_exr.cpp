// SPDX-License-Identifier: Apache-2.0
// EXR files of other programs: what is read of them, and what is named instead.
#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "io/exr_files.h"
#include "io/pictures/exr_file.h"

namespace pol {
namespace {

class ForeignExr : public ExrFile {};

/// A file by another program: `left` or `right` handed, numbers as halves, extra channels, data window off the origin.
void write_foreign(const fs::path& path, const std::vector<std::string>& channels, const char* handedness,
                   Imf::PixelType type) {
    const Imath::Box2i window({3, 5}, {6, 6});
    Imf::Header header(Imath::Box2i({0, 0}, {9, 9}), window);
    if (handedness != nullptr) header.insert("polarisationHandedness", Imf::StringAttribute(handedness));
    std::vector<std::vector<float>> numbers;
    std::vector<std::vector<half>> halves;
    numbers.reserve(channels.size());
    halves.reserve(channels.size());
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < channels.size(); ++c) {
        header.channels().insert(channels[c], Imf::Channel(type));
        std::vector<float>& plane = numbers.emplace_back();
        std::vector<half>& half_plane = halves.emplace_back();
        for (int i = 0; i < 8; ++i) {
            plane.push_back(static_cast<float>(10 * c) + static_cast<float>(i));
            half_plane.emplace_back(plane.back());
        }
        if (type == Imf::HALF)
            buffer.insert(channels[c], Imf::Slice::Make(type, half_plane.data(), window));
        else
            buffer.insert(channels[c], Imf::Slice::Make(type, plane.data(), window));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(2);
}

TEST_F(ForeignExr, TwoChannelsOfOneWavelengthAreNamed) {
    write_foreign(path(), {"S0.580nm", "S0.0,58um", "S1.580nm", "S2.580nm", "S3.580nm"}, nullptr, Imf::FLOAT);
    const Result<StokesImage> read = read_exr(path());
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().what.find("S0.0,58um and S0.580nm are of one wavelength"), std::string::npos)
        << read.error().what;
}

TEST_F(ForeignExr, IsReadFromOtherProgramsWithHalvesAnOffsetWindowAndLeftHandedStates) {
    const std::vector<std::string> channels{"R",         "S0.5,8e2nm", "S1.5,8e2nm", "S2.5,8e2nm", "S3.5,8e2nm",
                                            "S0.0,45um", "S1.0,45um",  "S2.0,45um",  "S3.0,45um",  "T.580,0nm"};
    for (const char* handedness : {"left", "right"}) {
        SCOPED_TRACE(handedness);
        write_foreign(path(), channels, handedness, Imf::HALF);
        const Result<StokesImage> read = read_exr(path());
        ASSERT_TRUE(read) << to_string(read.error());
        EXPECT_EQ(read.value().width, 4);
        EXPECT_EQ(read.value().height, 2);
        ASSERT_EQ(read.value().bands.size(), 2U);
        EXPECT_NEAR(*read.value().bands[0].wavelength_nm, 450.0, 1e-10);
        EXPECT_EQ(*read.value().bands[1].wavelength_nm, 580.0);
        const double sign = std::string(handedness) == "left" ? -1.0 : 1.0;
        EXPECT_EQ(read.value().at(1, 6), (Stokes<double>{16.0, 26.0, 36.0, sign * 46.0}));
        EXPECT_EQ(read.value().at(0, 0), (Stokes<double>{50.0, 60.0, 70.0, sign * 80.0}));
        EXPECT_TRUE(read.value().residual.empty());
        EXPECT_TRUE(read.value().attributes.empty());
    }
}

TEST_F(ForeignExr, IsRefusedIfItHasNoStokesChannelsAndSaysWhatItHas) {
    write_foreign(path(), {"S0.R", "S1.R", "depth.Z"}, nullptr, Imf::FLOAT);
    const Result<StokesImage> read = read_exr(path());
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().kind, ErrorKind::input);
    EXPECT_NE(read.error().what.find("S0.R, S1.R, depth.Z"), std::string::npos) << read.error().what;
}

TEST_F(ForeignExr, IsRefusedIfAComponentLacksAWavelength) {
    write_foreign(path(),
                  {"S0.580,0nm", "S1.580,0nm", "S2.580,0nm", "S3.580,0nm", "S0.600,0nm", "S1.600,0nm", "S2.600,0nm"},
                  "right", Imf::FLOAT);
    const Result<StokesImage> read = read_exr(path());
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().what.find("S3 has no channel for S0.600,0nm"), std::string::npos) << read.error().what;
}

TEST_F(ForeignExr, IsRefusedIfItsHandednessIsUnknown) {
    write_foreign(path(), {"S0.580,0nm", "S1.580,0nm", "S2.580,0nm", "S3.580,0nm"}, "upwards", Imf::FLOAT);
    EXPECT_FALSE(read_exr(path()));
}

const std::vector<std::string> stokes_580{"S0.580,0nm", "S1.580,0nm", "S2.580,0nm", "S3.580,0nm"};

/// Channels of one part: channel c has the value 10 c + i in pixel i.
struct TestPart {
    std::vector<std::string> channels;
    Imath::Box2i window{{0, 0}, {3, 1}};
    const char* handedness = nullptr;
};

void write_parts(const fs::path& path, const std::vector<TestPart>& parts) {
    std::vector<Imf::Header> headers;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        Imf::Header& header = headers.emplace_back(Imath::Box2i({0, 0}, {9, 9}), parts[p].window);
        header.setName("part " + std::to_string(p));
        header.setType(Imf::SCANLINEIMAGE);
        if (parts[p].handedness != nullptr)
            header.insert("polarisationHandedness", Imf::StringAttribute(parts[p].handedness));
        for (const std::string& channel : parts[p].channels)
            header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    }
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), static_cast<int>(headers.size()));
    for (std::size_t p = 0; p < parts.size(); ++p) {
        std::vector<std::vector<float>> planes;
        planes.reserve(parts[p].channels.size());
        Imf::FrameBuffer buffer;
        for (const std::string& channel : parts[p].channels) {
            const auto component = static_cast<float>(channel[1] - '0');  // S0 to S3
            for (int i = 0; i < 8; ++i) {
                if (i == 0) planes.emplace_back();
                planes.back().push_back(10.0F * component + static_cast<float>(i));
            }
            buffer.insert(channel, Imf::Slice::Make(Imf::FLOAT, planes.back().data(), parts[p].window));
        }
        Imf::OutputPart part(file, static_cast<int>(p));
        part.setFrameBuffer(buffer);
        part.writePixels(2);
    }
}

std::string refusal(const fs::path& path) {
    const Result<StokesImage> read = read_exr(path);
    return read ? "read" : read.error().what;
}

TEST_F(ForeignExr, KeepsThePlaceOfItsPixelsInThePicture) {
    write_foreign(path(), stokes_580, "right", Imf::FLOAT);  // data window (3, 5), display window (0, 0)
    Result<StokesImage> read = read_exr(path());
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(std::pair(read.value().left, read.value().top), std::pair(3, 5));
    StokesImage image = sample_image(3, 35, {580.0});
    for (const auto& [left, top] : {std::pair{0, 0}, {60, 40}, {-5, -40}}) {
        image.left = left;
        image.top = top;
        ASSERT_TRUE(write_exr(image, path()));
        read = read_exr(path());
        ASSERT_TRUE(read);
        EXPECT_EQ(std::pair(read.value().left, read.value().top), std::pair(left, top));
        EXPECT_EQ(read.value().stokes, image.stokes);
        EXPECT_EQ(read.value().samples, image.samples);
    }
}

TEST_F(ForeignExr, CountsPixelsFromTheCornerOfTheDisplayWindow) {
    const Imath::Box2i window({-4, 23}, {-1, 24});
    Imf::Header header(Imath::Box2i({-10, 20}, {9, 39}), window);
    Imf::FrameBuffer buffer;
    const std::vector<float> plane(8, 1.0F);
    for (const std::string& channel : stokes_580) {
        header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
        buffer.insert(channel, Imf::Slice::Make(Imf::FLOAT, plane.data(), window));
    }
    {
        Imf::OutputFile file(path().c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(2);
    }
    const Result<StokesImage> read = read_exr(path());
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(std::pair(read.value().left, read.value().top), std::pair(6, 3));
}

TEST_F(ForeignExr, GathersTheChannelsOfAllItsParts) {
    write_parts(path(),
                {{{stokes_580[0]}}, {{stokes_580[1]}}, {{stokes_580[2]}}, {{stokes_580[3]}, {{0, 0}, {3, 1}}, "left"}});
    write_parts(path("second.exr"), {{{"R0", "G0"}}, {stokes_580, {{0, 0}, {3, 1}}, "left"}});
    for (const fs::path& file : {path(), path("second.exr")}) {
        const Result<StokesImage> read = read_exr(file);
        ASSERT_TRUE(read) << to_string(read.error());
        EXPECT_EQ(read.value().at(0, 6), (Stokes<double>{6.0, 16.0, 26.0, -36.0}));
    }
    // A part that is not needed may lie elsewhere.
    write_parts(path(), {{{"R0"}, {{0, 0}, {1, 1}}}, {stokes_580}});
    EXPECT_TRUE(read_exr(path()));
}

TEST_F(ForeignExr, IsRefusedIfItsPartsDoNotFitTogether) {
    write_parts(path(), {{{stokes_580[0], stokes_580[1]}}, {{stokes_580[2], stokes_580[3]}, {{1, 0}, {4, 1}}}});
    EXPECT_EQ(refusal(path()), "part 0 holds the pixels (0, 0) to (3, 1), part 1 (1, 0) to (4, 1)");
    write_parts(path(), {{stokes_580}, {stokes_580}});
    EXPECT_EQ(refusal(path()), "parts 0 and 1 both have a channel S0.580,0nm");
    write_parts(path(), {{{stokes_580[0], stokes_580[1]}, {{0, 0}, {3, 1}}, "left"},
                         {{stokes_580[2], stokes_580[3]}, {{0, 0}, {3, 1}}, "right"}});
    EXPECT_EQ(refusal(path()), "polarisationHandedness is left in one part, right in another");
}

TEST_F(ForeignExr, OfCoarserSamplingIsSoundButNotRead) {
    Imf::Header header(4, 4);
    header.channels().insert(stokes_580[0], Imf::Channel(Imf::FLOAT));
    for (std::size_t s = 1; s < 4; ++s) header.channels().insert(stokes_580[s], Imf::Channel(Imf::FLOAT, 2, 2));
    const std::vector<float> plane(16, 1.0F);
    char* base = const_cast<char*>(reinterpret_cast<const char*>(plane.data()));
    Imf::FrameBuffer buffer;
    buffer.insert(stokes_580[0], Imf::Slice(Imf::FLOAT, base, 4, 16));
    for (std::size_t s = 1; s < 4; ++s) buffer.insert(stokes_580[s], Imf::Slice(Imf::FLOAT, base, 4, 8, 2, 2));
    {
        Imf::OutputFile file(path().c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(4);
    }
    EXPECT_EQ(refusal(path()), "channel S1.580,0nm has sampling 2 x 2; only full resolution is read");
}

TEST_F(ForeignExr, OfDeepPixelsIsSoundButNotRead) {
    Imf::Header header(1, 1);
    header.setType(Imf::DEEPSCANLINE);
    header.compression() = Imf::ZIPS_COMPRESSION;
    for (const std::string& channel : stokes_580) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    unsigned count = 1;
    float value = 1.0F;
    float* samples = &value;
    Imf::DeepFrameBuffer buffer;
    buffer.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(&count), 4, 4));
    for (const std::string& channel : stokes_580)
        buffer.insert(channel, Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(&samples), 8, 8, 4));
    {
        Imf::DeepScanLineOutputFile file(path().c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(1);
    }
    EXPECT_EQ(refusal(path()), "channel S0.580,0nm is deep: any number of samples a pixel");
}

TEST_F(ForeignExr, OfTilesIsReadAtItsFullSizeWhateverSmallerCopiesItHas) {
    Imf::Header header(4, 2);
    header.setTileDescription(Imf::TileDescription(2, 2, Imf::MIPMAP_LEVELS));
    for (const std::string& channel : stokes_580) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    {
        Imf::TiledOutputFile file(path().c_str(), header);
        for (int level = 0; level < file.numLevels(); ++level) {
            const std::vector<float> plane(8, static_cast<float>(1 + level));
            char* base = const_cast<char*>(reinterpret_cast<const char*>(plane.data()));
            Imf::FrameBuffer buffer;
            for (const std::string& channel : stokes_580) buffer.insert(channel, Imf::Slice(Imf::FLOAT, base, 4, 16));
            file.setFrameBuffer(buffer);
            file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
        }
    }
    const Result<StokesImage> read = read_exr(path());
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(read.value().stokes, std::vector<Stokes<double>>(8, {1.0, 1.0, 1.0, 1.0}));
}

TEST_F(ForeignExr, OfAYoungerFormatIsNotCalledDamaged) {
    ASSERT_TRUE(write_exr(sample_image(4, 4, {580.0}), path()));
    std::ifstream file(path(), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    std::string compressed = bytes;
    const std::string start("compression\0compression\0\1\0\0\0", 28);
    compressed[bytes.find(start) + start.size()] = 10;
    std::ofstream(path("compressed.exr"), std::ios::binary) << compressed;
    EXPECT_EQ(refusal(path("compressed.exr")), "is stored with compression 10, which this program does not know");
    std::string version = bytes;
    version[4] = 3;
    std::ofstream(path("version.exr"), std::ios::binary) << version;
    EXPECT_EQ(refusal(path("version.exr")),
              "is an EXR file of version 3 with flags 0x0, which this program does not know");
}

/// How a picture is said to be stored whose numbers need all 24 bits of a float, and the worst that became of them.
struct Kept {
    StoredNumbers stored;
    double worst = 0.0;
};
Kept kept(const fs::path& path, Imf::PixelType type, Imf::Compression compression) {
    constexpr int side = 32;
    Imf::Header header(side, side);
    header.compression() = compression;
    std::vector<float> plane;
    std::vector<half> halves;
    for (int i = 0; i < side * side; ++i) {
        plane.push_back(static_cast<float>(std::exp(0.01 * i / 3.0)));
        halves.emplace_back(plane.back());
    }
    Imf::FrameBuffer buffer;
    for (const std::string& channel : stokes_580) {
        header.channels().insert(channel, Imf::Channel(type));
        if (type == Imf::HALF)
            buffer.insert(channel, Imf::Slice(type, reinterpret_cast<char*>(halves.data()), 2, 2 * side));
        else
            buffer.insert(channel, Imf::Slice(type, reinterpret_cast<char*>(plane.data()), 4, 4 * side));
    }
    {
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(side);
    }
    const Result<StokesImage> read = read_exr(path);
    EXPECT_TRUE(read) << to_string(read.error());
    Kept result{read.value().stored, 0.0};
    for (std::size_t i = 0; i < plane.size(); ++i) {
        const auto truth = static_cast<double>(plane[i]);
        result.worst = std::max(result.worst, std::abs(read.value().stokes[i].s1 - truth) / truth);
    }
    return result;
}

// The error of the numbers that OpenEXR gives back against what is said of them: within, and not by a factor of four.
TEST_F(ForeignExr, SaysHowCoarselyItsNumbersAreStored) {
    for (const Imf::Compression lossless : {Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION, Imf::B44_COMPRESSION,
                                            Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION}) {
        const Kept floats = kept(path(), Imf::FLOAT, lossless);
        EXPECT_EQ(floats.stored.bits, 32) << lossless;
        EXPECT_EQ(floats.stored.lossy, "") << lossless;
        EXPECT_EQ(floats.worst, 0.0) << lossless;
    }
    for (const auto& [type, compression, bits] : {std::tuple{Imf::FLOAT, Imf::PXR24_COMPRESSION, 24},
                                                  {Imf::HALF, Imf::PXR24_COMPRESSION, 16},
                                                  {Imf::HALF, Imf::ZIP_COMPRESSION, 16},
                                                  {Imf::HALF, Imf::DWAA_COMPRESSION, 16}}) {
        const Kept coarse = kept(path(), type, compression);
        EXPECT_EQ(coarse.stored.bits, bits) << compression;
        EXPECT_EQ(coarse.stored.lossy, "") << compression;
        EXPECT_LE(coarse.worst, coarse.stored.rounding()) << compression;
        EXPECT_GT(coarse.worst, 0.25 * coarse.stored.rounding()) << compression;
    }
    for (const auto& [compression, name] : {std::pair{Imf::B44_COMPRESSION, "B44"}, {Imf::B44A_COMPRESSION, "B44A"}}) {
        const Kept lossy = kept(path(), Imf::HALF, compression);
        EXPECT_EQ(lossy.stored.lossy, name);
        EXPECT_GT(lossy.worst, lossy.stored.rounding());
    }
}

}  // namespace
}  // namespace pol
