// SPDX-License-Identifier: Apache-2.0
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "io/exr_files.h"
#include "io/pictures/exr_channel.h"
#include "io/pictures/exr_file.h"

namespace pol {
namespace {

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST_F(ExrFile, GivesBackTheSameNumbersToTheLastBit) {
    // 35 lines: one band of 32 and a rest.
    const StokesImage image = sample_image(7, 35, {440.0, 580.125, 700.0});
    ASSERT_TRUE(write_exr(image, path()));
    const Result<StokesImage> read = read_exr(path());
    ASSERT_TRUE(read) << to_string(read.error());
    const StokesImage& back = read.value();
    EXPECT_EQ(back.width, 7);
    EXPECT_EQ(back.height, 35);
    EXPECT_EQ(back.bands, image.bands);
    EXPECT_EQ(back.stokes, image.stokes);
    EXPECT_EQ(back.residual, image.residual);
    EXPECT_EQ(back.tail, image.tail);
    EXPECT_EQ(back.sampling_error, image.sampling_error);
    EXPECT_EQ(back.samples, image.samples);
    EXPECT_EQ(back.failures, image.failures);
    EXPECT_EQ(back.brightest, image.brightest);
    EXPECT_EQ(back.attributes.at("scene_hash"), "0123456789abcdef");
}

TEST_F(ExrFile, KeepsNanInfinityDenormalsAndTheSignOfZero) {
    using limits = std::numeric_limits<float>;
    StokesImage image;
    image.width = 8;
    image.height = 1;
    image.bands = bands_at({580.0});
    for (const float value : {limits::quiet_NaN(), limits::infinity(), -limits::infinity(), limits::denorm_min(),
                              -limits::denorm_min(), -0.0F, limits::max(), limits::min()}) {
        image.stokes.push_back({double{value}, double{value}, 1.0, double{value}});
    }
    ASSERT_TRUE(write_exr(image, path()));
    const Result<StokesImage> read = read_exr(path());
    ASSERT_TRUE(read) << to_string(read.error());
    for (std::size_t i = 0; i < image.stokes.size(); ++i) {
        EXPECT_TRUE(same_bits(read.value().stokes[i].s0, image.stokes[i].s0)) << i;
        EXPECT_TRUE(same_bits(read.value().stokes[i].s1, image.stokes[i].s1)) << i;
        EXPECT_TRUE(same_bits(read.value().stokes[i].s3, image.stokes[i].s3)) << i;
    }
}

TEST_F(ExrFile, RoundsDoublesToTheNearestFloat) {
    StokesImage image = sample_image(1, 1, {580.0});
    image.stokes[0] = {1.0 / 3.0, 0.1, -0.1, 1e-300};
    ASSERT_TRUE(write_exr(image, path()));
    const Result<StokesImage> read = read_exr(path());
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value().stokes[0], (Stokes<double>{double{1.0F / 3.0F}, double{0.1F}, double{-0.1F}, 0.0}));
}

TEST_F(ExrFile, KeepsWavelengthsThatTheChannelNamesRound) {
    const double odd = 1e7 / 17241.0;
    ASSERT_TRUE(write_exr(sample_image(2, 2, {odd, 600.0}), path()));
    const Result<StokesImage> read = read_exr(path());
    ASSERT_TRUE(read);
    EXPECT_TRUE(same_bits(*read.value().bands[0].wavelength_nm, odd));
}

TEST_F(ExrFile, FollowsTheSpectralLayoutAsOpenExrSeesIt) {
    StokesImage image = sample_image(3, 2, {580.0});
    image.residual.resize(image.pixel_count());
    image.failures.assign(image.pixel_count(), 0);
    ASSERT_TRUE(write_exr(image, path()));
    Imf::InputFile file(path().c_str());
    const Imf::Header& header = file.header();
    std::vector<std::string> names;
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c) names.emplace_back(c.name());
    // OpenEXR sorts by name. No failures, so no such channel.
    EXPECT_EQ(names, (std::vector<std::string>{
                         "B", "G", "R", "S0.580,000000nm", "S1.580,000000nm", "S2.580,000000nm", "S3.580,000000nm",
                         "residual", "samples", "sampling_error.S0.580,000000nm", "sampling_error.S1.580,000000nm",
                         "sampling_error.S2.580,000000nm", "sampling_error.S3.580,000000nm", "tail"}));
    EXPECT_EQ(header.channels()["S0.580,000000nm"].type, Imf::FLOAT);
    EXPECT_EQ(header.channels()["samples"].type, Imf::UINT);
    EXPECT_EQ(header.compression(), Imf::PIZ_COMPRESSION);
    const auto text = [&header](const char* name) { return header.typedAttribute<Imf::StringAttribute>(name).value(); };
    EXPECT_EQ(text("spectralLayoutVersion"), "1.0");
    EXPECT_EQ(text("emissiveUnits"), "W.m^-2.sr^-1");
    EXPECT_EQ(text("polarisationHandedness"), "right");
    EXPECT_EQ(text("polariscope.wavelengths"), "580");
    EXPECT_EQ(text("polariscope.brightest"), "0.1");
    EXPECT_EQ(text("polariscope.timeSign"), "exp(-i omega t)");
    EXPECT_FALSE(text("polariscope.frame").empty());
    EXPECT_FALSE(text("polariscope.azimuthZero").empty());
    EXPECT_FALSE(text("polariscope.version").empty());
}

TEST_F(ExrFile, HasAPreviewThatIsWhiteForD65) {
    // D65 at 580 nm relative to 560 nm, from the CIE table.
    StokesImage image = sample_image(1, 1, {580.0});
    image.stokes[0].s0 = 0.95788;
    ASSERT_TRUE(write_exr(image, path()));
    Imf::InputFile file(path().c_str());
    float red = 0.0F;
    Imf::FrameBuffer buffer;
    buffer.insert("R", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&red), 4, 4));
    file.setFrameBuffer(buffer);
    file.readPixels(0);
    EXPECT_NEAR(red, 1.0F, 0x1p-11F);  // half precision
}

TEST_F(ExrFile, IsRefusedIfItIsMissingAFolderEmptyOrSomethingElse) {
    std::ofstream(path("empty.exr")).close();
    std::ofstream(path("text.exr")) << "not a picture";
    for (const fs::path& bad :
         {path("missing.exr"), folder_, path("empty.exr"), path("text.exr"), fs::path("/dev/null")}) {
        const Result<StokesImage> read = read_exr(bad);
        ASSERT_FALSE(read) << bad;
        EXPECT_EQ(read.error().kind, ErrorKind::input);
        EXPECT_EQ(read.error().place.file, bad.string());
    }
}

TEST_F(ExrFile, IsRefusedWhereverItIsCutOffAndNeverCrashesOnDamage) {
    ASSERT_TRUE(write_exr(sample_image(16, 70, {440.0, 580.0}), path()));
    std::ifstream whole(path(), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(whole)), {});
    for (std::size_t size = 1; size < bytes.size(); size += 1 + bytes.size() / 97) {
        std::ofstream(path("cut.exr"), std::ios::binary) << bytes.substr(0, size);
        EXPECT_FALSE(read_exr(path("cut.exr"))) << size << " of " << bytes.size();
    }
    // A flipped bit may be read or refused, but nothing worse (the sanitizer runs watch).
    for (std::size_t at = 4; at < bytes.size(); at += 1 + bytes.size() / 499) {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x40);
        std::ofstream(path("damaged.exr"), std::ios::binary) << damaged;
        static_cast<void>(read_exr(path("damaged.exr")));
    }
}

/// `exr` with its data window and display window made `width` x `height` pixels, whatever it holds.
std::string resized(std::string exr, std::uint32_t width, std::uint32_t height) {
    for (const std::string name : {"dataWindow", "displayWindow"}) {
        // After the name: 0, "box2i", 0, size 4, then min.x, min.y, max.x, max.y.
        const std::size_t window = exr.find(name) + name.size() + 1 + 6 + 4;
        for (std::size_t i = 0; i < 4; ++i) {
            exr[window + 8 + i] = static_cast<char>((width - 1) >> (8 * i));
            exr[window + 12 + i] = static_cast<char>((height - 1) >> (8 * i));
        }
    }
    return exr;
}

TEST_F(ExrFile, IsRefusedIfItClaimsAnAbsurdSize) {
    ASSERT_TRUE(write_exr(sample_image(4, 4, {580.0}), path()));
    std::ifstream file(path(), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    std::ofstream(path("huge.exr"), std::ios::binary) << resized(bytes, 1000000, 1000000);
    const Result<StokesImage> read = read_exr(path("huge.exr"));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().kind, ErrorKind::input);

    std::ofstream(path("wide.exr"), std::ios::binary) << resized(bytes, 200000, 4);
    const Result<StokesImage> wide = read_exr(path("wide.exr"));
    ASSERT_FALSE(wide);
    EXPECT_EQ(wide.error().what, "promises 200000 x 4 pixels, more than the file can hold");
}

TEST_F(ExrFile, IsRefusedIfAnAttributeClaimsMoreThanTheFileHas) {
    ASSERT_TRUE(write_exr(sample_image(4, 4, {580.0}), path()));
    std::ifstream file(path(), std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(file)), {});
    const std::string start("emissiveUnits\0string\0", 21);
    const std::size_t size = bytes.find(start) + start.size();
    bytes[size + 3] = 0x6f;  // 1.7 GiB
    std::ofstream(path("long.exr"), std::ios::binary) << bytes;
    const Result<StokesImage> read = read_exr(path("long.exr"));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().what,
              "is damaged or truncated: Attribute 'emissiveUnits', type 'string': Invalid size 1862270988");
}

/// A header attribute as it stands in a file; `size` is claimed.
std::string attribute(const std::string& name, const std::string& type, std::size_t size, const std::string& value) {
    std::string bytes = name + '\0' + type + '\0';
    for (std::size_t i = 0; i < 4; ++i) bytes += static_cast<char>(size >> (8 * i));
    return bytes + value;
}

/// Reads `file` in a process of its own: the message and the most memory in KiB.
std::pair<std::string, long> refusal_and_memory(const fs::path& file, const fs::path& message) {
    const pid_t child = ::fork();
    if (child == 0) {
        const Result<StokesImage> read = read_exr(file);
        if (!read) std::ofstream(message) << read.error().what;
        ::_exit(0);
    }
    rusage usage{};
    ::wait4(child, nullptr, 0, &usage);
    std::string what;
    std::getline(std::ifstream(message), what);
    return {what, usage.ru_maxrss};
}

TEST_F(ExrFile, IsRefusedWithoutTakingMemoryIfAnAttributeDoesNotFillItsSize) {
    ASSERT_TRUE(write_exr(sample_image(4, 4, {580.0}), path()));
    std::ifstream file(path(), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    const std::string huge = attribute("x", "string", 0x6fffffff, "");

    // The channel list lacks its final zero: one that stands in the next attribute ends it, and more seems to follow.
    const std::string start("channels\0chlist\0", 16);
    const std::size_t list = bytes.find(start) + start.size() + 4;
    const auto size = static_cast<unsigned char>(bytes[list - 4]) + 256U * static_cast<unsigned char>(bytes[list - 3]);
    const std::string value = std::string(5, ' ') + '\0' + huge;
    std::ofstream(path("list.exr"), std::ios::binary)
        << bytes.substr(0, list - start.size() - 4)
        << attribute("channels", "chlist", size - 1, bytes.substr(list, size - 1))
        << attribute("a", "string", value.size(), value) << bytes.substr(list + size);
    auto [what, kib] = refusal_and_memory(path("list.exr"), path("message"));
    EXPECT_EQ(what,
              "is damaged or truncated: Attribute 'channels', type 'chlist': Invalid size " + std::to_string(size - 1));
    EXPECT_LT(kib, 1 << 20);

    // OpenEXR reads a single byte of this kind, whatever its size.
    std::ofstream(path("state.exr"), std::ios::binary)
        << bytes.substr(0, list + size) << attribute("a", "deepImageState", 1 + huge.size(), '\0' + huge)
        << bytes.substr(list + size);
    std::tie(what, kib) = refusal_and_memory(path("state.exr"), path("message"));
    EXPECT_EQ(what, "is damaged or truncated: Attribute 'a', type 'deepImageState': Invalid size 14");
    EXPECT_LT(kib, 1 << 20);
}

TEST_F(ExrFile, CannotBeWrittenToAMissingFolderAFolderOrADevice) {
    const StokesImage image = sample_image(2, 2, {580.0});
    for (const fs::path& bad : {path("missing/picture.exr"), folder_, fs::path("/dev/null"), path("picture.exr/")}) {
        const Result<Done> written = write_exr(image, bad);
        ASSERT_FALSE(written) << bad;
        EXPECT_EQ(written.error().kind, ErrorKind::output) << bad;
    }
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_EQ(file_count(), 0U);
}

TEST_F(ExrFile, CannotHoldAnEmptyPictureOrTwoWavelengthsOfOneName) {
    EXPECT_FALSE(write_exr(StokesImage{}, path()));
    EXPECT_FALSE(write_exr(sample_image(2, 2, {580.0, 580.0000001}), path()));
    EXPECT_EQ(file_count(), 0U);
}

TEST_F(ExrFile, LeavesTheOldFileAndNoLitterWhenTheDiskIsFull) {
    ASSERT_TRUE(write_exr(sample_image(2, 2, {580.0}), path()));
    const pid_t child = ::fork();
    if (child == 0) {
        // Files may not grow over 20 kB: a write beyond fails with EFBIG, as it would with ENOSPC.
        const rlimit limit{20000, 20000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        ::signal(SIGXFSZ, SIG_IGN);
        const Result<Done> written = write_exr(sample_image(128, 128, {580.0}), path());
        ::_exit(!written && written.error().kind == ErrorKind::output ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    const Result<StokesImage> old = read_exr(path());
    ASSERT_TRUE(old);
    EXPECT_EQ(old.value().width, 2);
    EXPECT_EQ(file_count(), 1U);
}

TEST_F(ExrFile, IsTheOldOneOrTheNewOneAfterAKillAtAnyMoment) {
    const StokesImage image = sample_image(256, 256, {440.0, 580.0});
    ASSERT_TRUE(write_exr(image, path()));
    int killed = 0;
    for (int run = 0; run < 25; ++run) {
        const pid_t child = ::fork();
        if (child == 0) {
            for (;;) static_cast<void>(write_exr(image, path()));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5 + 7 * run));
        ::kill(child, SIGKILL);
        int status = 0;
        ::waitpid(child, &status, 0);
        killed += WIFSIGNALED(status) ? 1 : 0;
        ASSERT_TRUE(read_exr(path())) << "run " << run;
    }
    EXPECT_EQ(killed, 25);
    // The next writer sweeps up what the killed ones left.
    ASSERT_TRUE(write_exr(image, path()));
    EXPECT_EQ(file_count(), 1U);
}

TEST_F(ExrFile, LeavesTemporaryFilesOfOthersAlone) {
    const std::string of_a_living = ".picture.exr." + std::to_string(::getppid()) + "-0.tmp";
    const std::string of_another = ".other.exr.999999999-0.tmp";
    for (const std::string& name : {of_a_living, of_another, std::string(".picture.exr.notes.tmp")})
        std::ofstream(path(name)) << "x";
    ASSERT_TRUE(write_exr(sample_image(2, 2, {580.0}), path()));
    EXPECT_EQ(file_count(), 4U);
}

TEST(ExrChannel, WritesSixDecimalsWithAComma) {
    EXPECT_EQ(wavelength_suffix(580.0), "580,000000nm");
}

TEST(ExrChannel, ReadsEveryUnitOfTheLayout) {
    EXPECT_EQ(parse_wavelength_suffix("580,000000nm"), 580.0);
    EXPECT_EQ(parse_wavelength_suffix("5,8e2nm"), 580.0);
    // A few roundings: relative 1e-15.
    EXPECT_NEAR(*parse_wavelength_suffix("0,58um"), 580.0, 1e-12);
    EXPECT_NEAR(*parse_wavelength_suffix("5,8e-7m"), 580.0, 1e-12);
    EXPECT_NEAR(*parse_wavelength_suffix("500THz"), 599.584916, 1e-12);
    EXPECT_NEAR(*parse_wavelength_suffix("5e14Hz"), 599.584916, 1e-12);
    for (const char* bad :
         {"", "nm", "580", "580.0nm", "580,0xm", "R", "0nm", "-5nm", "nannm", "infnm", "580nm.600nm", "1e999nm"}) {
        EXPECT_FALSE(parse_wavelength_suffix(bad)) << bad;
    }
}

}  // namespace
}  // namespace pol
