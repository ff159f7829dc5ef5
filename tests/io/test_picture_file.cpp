// SPDX-License-Identifier: Apache-2.0
// The rules of read_picture, one by one, and our own form for bands without wavelengths.
#include "io/pictures/picture_file.h"

#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "io/exr_files.h"
#include "io/pictures/stokes_channels.h"

namespace pol {
namespace {

using Names = std::vector<std::string>;

/// How a test file is written; channel c has the value 10 (c + 1) + i in pixel i of 4 x 2.
struct Form {
    std::map<std::string, std::string> attributes;
    Imf::Compression compression = Imf::ZIP_COMPRESSION;
    Imf::LineOrder order = Imf::INCREASING_Y;
    int width = 4;
};

class PictureFile : public ExrFile {
protected:
    fs::path write(const std::string& name, const Names& channels, const Form& form = {}) const {
        Imf::Header header(form.width, 2);
        header.compression() = form.compression;
        header.lineOrder() = form.order;
        for (const auto& [attribute, text] : form.attributes) header.insert(attribute, Imf::StringAttribute(text));
        std::vector<std::vector<float>> planes;
        planes.reserve(channels.size());
        Imf::FrameBuffer buffer;
        for (const std::string& channel : channels) {
            header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
            std::vector<float>& plane = planes.emplace_back();
            for (int i = 0; i < 2 * form.width; ++i)
                plane.push_back(10.0F * static_cast<float>(planes.size()) + static_cast<float>(i));
            buffer.insert(channel, Imf::Slice::Make(Imf::FLOAT, plane.data(), header.dataWindow()));
        }
        Imf::OutputFile file(path(name).c_str(), header);
        file.setFrameBuffer(buffer);
        if (form.order == Imf::DECREASING_Y) {
            file.writePixels(1);
            file.writePixels(1);
        } else {
            file.writePixels(2);
        }
        return path(name);
    }
};

PictureSource named(const fs::path& path, const std::string& layout = {}) {
    PictureSource source;
    source.files = {path};
    source.layout = layout;
    return source;
}

Result<StokesImage> read(const fs::path& path, const std::string& layout = {}) {
    return read_picture(named(path, layout));
}

StokesImage image_of(const fs::path& path, const std::string& layout = {}) {
    Result<StokesImage> image = read(path, layout);
    EXPECT_TRUE(image) << to_string(image.error());
    return image ? std::move(image).value() : StokesImage{};
}

/// What is wrong; the same for the header alone.
std::string refusal_of(const fs::path& path, const std::string& layout = {}) {
    const Result<StokesImage> image = read(path, layout);
    const Result<PictureHeader> header = read_picture_header(named(path, layout));
    if (image || header) return "read";
    EXPECT_EQ(image.error().what, header.error().what);
    EXPECT_EQ(image.error().kind, ErrorKind::input);
    EXPECT_EQ(image.error().place.file, path.string());
    return image.error().what;
}

Names twelve() {
    Names names;
    for (const char* s : {"S0.", "S1.", "S2.", "S3."})
        for (const char* color : {"R", "G", "B"}) names.push_back(std::string(s) + color);
    return names;
}

Names with(Names names, const Names& more) {
    names.insert(names.end(), more.begin(), more.end());
    return names;
}

bool one_says(const Names& sentences, const std::string& words) {
    return std::any_of(sentences.begin(), sentences.end(),
                       [&](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
}

TEST_F(PictureFile, BareComponentsAreReadInAnyCaseAndBehindAnyLayer) {
    for (const Names& names : {Names{"S0", "S1", "S2", "S3"},
                               {"s0", "s1", "s2", "s3"},
                               {"I", "Q", "U", "V"},
                               {"stokes.S0", "stokes.S1", "stokes.S2", "stokes.S3"},
                               {"a.b.i", "a.b.q", "a.b.u", "a.b.v"}}) {
        const StokesImage image = image_of(write("bare.exr", with(names, {"R", "G", "B"})));
        ASSERT_EQ(image.bands, std::vector<Band>{named_band("mono")}) << names[0];
        EXPECT_EQ(image.at(0, 3), (Stokes<double>{13.0, 23.0, 33.0, 43.0}));
        EXPECT_EQ(image.origin.assumed.size(), 2U);  // everything
    }
    const StokesImage linear = image_of(write("linear.exr", {"I", "Q", "U"}));
    EXPECT_EQ(linear.bands[0].known, StokesComponents::linear());
    EXPECT_EQ(linear.origin.assumed, Names{std::string(assumed_axes)});
    EXPECT_EQ(refusal_of(write("twice.exr", {"a.S0", "a.S1", "a.S2", "b.S0", "b.S1", "b.S2"})),
              "has Stokes components twice, as a.S0 and as b.S0");
    EXPECT_EQ(refusal_of(write("case.exr", {"S0", "s0", "S1", "S2"})),
              "channels S0 and s0 are of one Stokes component");
}

TEST_F(PictureFile, SpectralPicturesMayLackS3OrAllPolarization) {
    const StokesImage linear = image_of(write("linear.exr", {"S0.580nm", "S1.580nm", "S2.580nm"}));
    EXPECT_EQ(linear.bands, (std::vector<Band>{{580.0, {}, StokesComponents::linear()}}));
    EXPECT_EQ(linear.at(0, 1), (Stokes<double>{11.0, 21.0, 31.0, 0.0}));
    const StokesImage s0 = image_of(write("s0.exr", {"S0.580nm", "S0.600nm"}));
    EXPECT_EQ(s0.bands[1], (Band{600.0, {}, StokesComponents::s0()}));
    EXPECT_EQ(refusal_of(write("gap.exr", {"S0.580nm", "S1.580nm"})), "S2 has no channel for S0.580nm");
    EXPECT_EQ(refusal_of(write("headless.exr", {"S1.580nm", "S2.580nm", "S3.580nm"})),
              "S0 has no channel for S1.580nm");
}

TEST_F(PictureFile, WhatTheFileSaysNeedNotBeAssumed) {
    const Names names{"S0.580nm", "S1.580nm", "S2.580nm", "S3.580nm"};
    const StokesImage silent = image_of(write("a.exr", names));
    EXPECT_EQ(silent.origin.assumed, (Names{std::string(assumed_axes), std::string(assumed_handedness)}));
    const StokesImage left = image_of(write("a.exr", names, {{{"polarisationHandedness", "left"}}}));
    EXPECT_EQ(left.origin.assumed, Names{std::string(assumed_axes)});
    EXPECT_TRUE(left.origin.convention.left_handed);
    EXPECT_EQ(left.at(0, 0).s3, -40.0);
    StokesImage back = left;
    read_in(back, {});
    EXPECT_EQ(back.stokes, silent.stokes);
}

TEST_F(PictureFile, MitsubasThreeEqualColorsAreOneBand) {
    const StokesImage rgb =
        image_of(write("rgb.exr", with(twelve(), {"Y"}), {{{"generatedBy", "Mitsuba version 3.9.1"}}}));
    EXPECT_EQ(rgb.origin.layout, "Mitsuba 3, RGB");
    EXPECT_EQ(rgb.at(1, 0), (Stokes<double>{20.0, 50.0, 80.0, 110.0}));
    StokesImage mono = rgb;
    std::copy_n(mono.stokes.begin(), 8, mono.stokes.begin() + 8);
    std::copy_n(mono.stokes.begin(), 8, mono.stokes.begin() + 16);
    StokesImage almost = mono;
    merge_equal_colors(mono);
    EXPECT_EQ(mono.bands, std::vector<Band>{named_band("mono")});
    EXPECT_EQ(mono.stokes.size(), 8U);
    EXPECT_EQ(mono.origin.layout, "Mitsuba 3, mono");
    EXPECT_TRUE(mono.origin.remarks.empty());
    almost.stokes.back().s3 = std::bit_cast<double>(std::bit_cast<std::uint64_t>(almost.stokes.back().s3) + 1);
    merge_equal_colors(almost);
    EXPECT_EQ(almost.bands.size(), 3U);
}

TEST_F(PictureFile, ASpecfilmIsReadIfItsLabelsCanBe) {
    const Form mitsuba{{{"generatedBy", "Mitsuba version 3.9.1"}}};
    const StokesImage four = image_of(write("4.exr", with(twelve(), {"a", "b", "c", "d"}), mitsuba));
    EXPECT_EQ(four.at(0, 0), (Stokes<double>{10.0, 40.0, 70.0, 100.0}));
    EXPECT_EQ(four.at(3, 0), (Stokes<double>{130.0, 0.0, 0.0, 0.0}));
    const StokesImage three = image_of(write("3.exr", with(twelve(), {"a", "b", "c"}), mitsuba));
    EXPECT_EQ(three.at(0, 0), (Stokes<double>{20.0, 50.0, 80.0, 110.0}));
    EXPECT_EQ(three.at(2, 0), (Stokes<double>{40.0, 70.0, 100.0, 0.0}));
    EXPECT_EQ(three.bands[2].known, StokesComponents::linear());
    EXPECT_EQ(
        refusal_of(write("2.exr", with(twelve(), {"a", "b"}), mitsuba)),
        "was made by Mitsuba with a specfilm of 2 bands: its labels S0.R to S3.B are 2 places off and numbers are "
        "lost");
    EXPECT_EQ(refusal_of(write("1.exr", with(twelve(), {"a"}), mitsuba)).substr(0, 54),
              "was made by Mitsuba with a specfilm of 1 band: its lab");
    // What other integrators add has dots.
    EXPECT_EQ(image_of(write("aov.exr", with(twelve(), {"nn.X", "R", "G", "B", "A"}), mitsuba)).bands.size(), 3U);
}

TEST_F(PictureFile, UnnamedChannelsAreReadByPosition) {
    for (const int count : {12, 13, 16}) {
        Names names;
        for (int i = 0; i < count; ++i) names.push_back((i < 10 ? "ch0" : "ch") + std::to_string(i));
        const StokesImage image = image_of(write("array.exr", names));
        const double first = 10.0 * (count - 11);  // S0.R
        EXPECT_EQ(image.at(0, 0), (Stokes<double>{first, first + 30.0, first + 60.0, first + 90.0})) << count;
        EXPECT_EQ(image.at(2, 0).s0, first + 20.0);
        EXPECT_TRUE(one_says(image.origin.assumed, "by position"));
    }
    EXPECT_NE(refusal_of(write("array.exr", {"ch00", "ch01", "ch02"})), "read");
}

TEST_F(PictureFile, OtherBandsKeepTheirNames) {
    const StokesImage image =
        image_of(write("a.exr", {"S0.red", "S1.red", "S2.red", "S3.red", "S0.nir", "S1.nir", "S2.nir"}));
    ASSERT_EQ(image.bands.size(), 2U);
    EXPECT_EQ(image.bands[0], named_band("nir", StokesComponents::linear()));
    EXPECT_EQ(image.bands[1], named_band("red"));
    EXPECT_EQ(image.at(0, 0), (Stokes<double>{50.0, 60.0, 70.0, 0.0}));
}

TEST_F(PictureFile, PicturesWithoutPolarizationHaveS0Alone) {
    const std::vector<Band> rgb{named_band("R", StokesComponents::s0()), named_band("G", StokesComponents::s0()),
                                named_band("B", StokesComponents::s0())};
    const StokesImage color = image_of(write("a.exr", {"R", "G", "B", "A", "depth.Z"}));
    EXPECT_EQ(color.bands, rgb);
    EXPECT_EQ(color.at(1, 0), (Stokes<double>{20.0, 0.0, 0.0, 0.0}));
    EXPECT_EQ(color.origin.remarks, Names{"channels not read: depth.Z"});
    EXPECT_EQ(image_of(write("a.exr", {"beauty.R", "beauty.G", "beauty.B"})).bands, rgb);
    EXPECT_EQ(image_of(write("a.exr", {"Y", "A"})).bands[0].label(), "Y");
    EXPECT_EQ(image_of(write("a.exr", {"luminance"})).bands[0].label(), "luminance");
    for (const Names& names : {Names{"S1"}, {"Q"}, {"S2.R"}, {"S1.R", "S1.G", "S1.B"}, {"R", "G"}})
        EXPECT_EQ(refusal_of(write("a.exr", names)).substr(0, 26), "no Stokes channels; found ") << names[0];
}

TEST_F(PictureFile, TwoLayoutsThatFitAreNamedAndOneMayBeChosen) {
    const Names both = with(twelve(), {"S0.580nm", "S1.580nm", "S2.580nm", "S3.580nm"});
    const fs::path file = write("both.exr", both);
    EXPECT_EQ(refusal_of(file), "has the channels of two layouts, spectral and mitsuba");
    EXPECT_EQ(read(file).error().hint, "say which: --layout spectral or --layout mitsuba");
    EXPECT_EQ(image_of(file, "spectral").bands.size(), 1U);
    EXPECT_EQ(image_of(file, "mitsuba").bands.size(), 3U);
    // The file says who wrote it.
    EXPECT_EQ(image_of(write("a.exr", both, {{{"generatedBy", "Mitsuba version 3.9.1"}}})).bands.size(), 3U);
    EXPECT_EQ(refusal_of(file, "bare").substr(0, 41), "does not have the channels of layout bare");
    const Result<StokesImage> unknown = read(file, "fancy");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().kind, ErrorKind::usage);
    EXPECT_EQ(unknown.error().what, "there is no layout 'fancy'");
}

TEST_F(PictureFile, FourFilesAreFoundByAnyOfTheirEndings) {
    for (const Names& names : {Names{"a_S0", "a_S1", "a_S2", "a_S3"},
                               {"b.s0", "b.s1", "b.s2", "b.s3"},
                               {"c_I", "c_Q", "c_U", "c_V"},
                               {"d_i", "d_q", "d_u", "d_v"}}) {
        for (const std::string& name : names) write(name + ".exr", {"R", "G", "B"});
        for (const std::string& name : names) {
            const StokesImage image = image_of(path(name + ".exr"));
            EXPECT_EQ(image.origin.layout, "four files");
            EXPECT_EQ(image.at(2, 1), (Stokes<double>{31.0, 31.0, 31.0, 31.0}));
            EXPECT_EQ(image.bands[0], named_band("R"));
        }
    }
    // A file that says so is left-handed.
    write("a_S3.exr", {"R", "G", "B"}, {{{"polarisationHandedness", "left"}}});
    const StokesImage left = image_of(path("a_S1.exr"));
    EXPECT_EQ(left.at(2, 1), (Stokes<double>{31.0, 31.0, 31.0, -31.0}));
    EXPECT_TRUE(left.origin.convention.left_handed);
    EXPECT_EQ(left.origin.assumed, Names{std::string(assumed_axes)});
    // One channel each, whatever its name.
    for (const std::string name : {"S0", "S1", "S2", "S3"}) write("e_" + name + ".exr", {name});
    EXPECT_EQ(image_of(path("e_S2.exr")).bands, std::vector<Band>{named_band("mono")});
}

TEST_F(PictureFile, FourFilesThatDoNotFitTogetherAreRefused) {
    for (const char* name : {"a_I", "a_Q", "a_U"}) write(std::string(name) + ".exr", {"R", "G", "B"});
    EXPECT_EQ(refusal_of(path("a_Q.exr")), "is one of four files, of which a_V.exr is missing");
    Form narrow;
    narrow.width = 3;
    write("a_V.exr", {"R", "G", "B"}, narrow);
    EXPECT_EQ(read(path("a_I.exr")).error().what, "has 3 x 2 pixels, a_I.exr 4 x 2");
    EXPECT_EQ(read(path("a_I.exr")).error().place.file, path("a_V.exr").string());
    write("a_V.exr", {"Y"});
    EXPECT_EQ(read(path("a_I.exr")).error().what, "does not have the channels of a_I.exr");
    // A picture that happens to be called so.
    const StokesImage lone = image_of(write("photo_V.exr", {"R", "G", "B"}));
    EXPECT_EQ(lone.bands[0].known, StokesComponents::s0());
    EXPECT_EQ(lone.origin.assumed, Names{"this is a picture of S0: photo_I.exr is not beside it"});
    EXPECT_EQ(refusal_of(write("w_Q.exr", {"L"}, {{{"renderer", "wave_tracer 0.1"}}})),
              "is one of four files, of which w_I.exr is missing");
    // What is inside goes before what lies beside.
    EXPECT_EQ(image_of(write("s_I.exr", {"S0.580nm"})).bands[0].wavelength_nm, 580.0);
}

TEST_F(PictureFile, FilesOfComponentsMayBeNamedAndSomeLeftOut) {
    PictureSource named;
    named.stokes_files = {write("x.exr", {"Y"}), write("y.exr", {"Y"}), write("z.exr", {"grey"}), {}};
    const Result<StokesImage> image = read_picture(named);
    ASSERT_TRUE(image) << to_string(image.error());
    EXPECT_EQ(image.value().bands, std::vector<Band>{named_band("mono", StokesComponents::linear())});
    EXPECT_EQ(image.value().at(0, 2), (Stokes<double>{12.0, 12.0, 12.0, 0.0}));
    EXPECT_EQ(image.value().origin.assumed, Names{std::string(assumed_axes)});
    EXPECT_EQ(read_picture_header(named).value().origin, image.value().origin);
    named.stokes_files[0].clear();
    EXPECT_EQ(read_picture(named).error().kind, ErrorKind::usage);
    EXPECT_EQ(read_picture({}).error().kind, ErrorKind::usage);
    named.files = {path("x.exr")};
    EXPECT_EQ(read_picture(named).error().kind, ErrorKind::usage);
}

TEST_F(PictureFile, PartsOfAPictureAreRefusedAsWhatTheyAre) {
    const Names names{"sum.S0.580,000000nm.hi", "sum.S0.580,000000nm.lo", "R", "G", "B"};
    EXPECT_EQ(refusal_of(write("part.exr", names, {{{"polariscope.part", "3/16"}}})), "this is part 3 of 16");
}

TEST_F(PictureFile, WhatIsNoPictureIsRefused) {
    std::ofstream(path("text.exr")) << "not a picture";
    std::ofstream(path("empty.exr")).close();
    EXPECT_EQ(refusal_of(path("missing.exr")), "there is no such file");
    EXPECT_EQ(refusal_of(folder_), "is a folder, not a picture");
    EXPECT_EQ(refusal_of(path("empty.exr")), "is empty");
    EXPECT_EQ(refusal_of(path("text.exr")), "is no picture that is read");
    // Content decides, not the ending.
    fs::copy_file(write("a.exr", {"Y"}), path("a.png"));
    EXPECT_EQ(image_of(path("a.png")).bands[0].label(), "Y");
    EXPECT_TRUE(is_picture_name("a.EXR"));
    EXPECT_TRUE(is_picture_name("b.fits"));
    EXPECT_FALSE(is_picture_name("scene.yaml"));
}

TEST_F(PictureFile, ReadingTellsOfItsProgressAndCanBeStopped) {
    ASSERT_TRUE(write_exr(sample_image(4, 100, {580.0}), path()));
    std::vector<double> shares;
    const auto listen = [&](double share) {
        shares.push_back(share);
        return true;
    };
    ASSERT_TRUE(read_picture(named(path()), listen));
    EXPECT_EQ(shares.size(), 4U);  // bands of 32 lines
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.back(), 1.0);
    const auto stop = [&](double share) { return share < 0.5; };
    const Result<StokesImage> stopped = read_picture(named(path()), stop);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().what, "was stopped");
    // Four files are one picture.
    for (const char* name : {"a_I", "a_Q", "a_U", "a_V"}) write(std::string(name) + ".exr", {"Y"});
    shares.clear();
    ASSERT_TRUE(read_picture(named(path("a_I.exr")), listen));
    EXPECT_EQ(shares, (std::vector<double>{0.25, 0.5, 0.75, 1.0}));
}

TEST_F(PictureFile, LinesInAnyOrderAndRipLevelsAreOnePicture) {
    const Names names{"S0", "S1", "S2", "S3"};
    const StokesImage up = image_of(write("up.exr", names));
    EXPECT_EQ(up.at(0, up.pixel(1, 1)).s0, 15.0);
    Form down;
    down.order = Imf::DECREASING_Y;
    EXPECT_EQ(image_of(write("down.exr", names, down)).stokes, up.stokes);
    Imf::Header header(4, 2);
    header.setTileDescription(Imf::TileDescription(2, 2, Imf::RIPMAP_LEVELS));
    for (const std::string& name : names) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    {
        Imf::TiledOutputFile file(path("rip.exr").c_str(), header);
        for (int ly = 0; ly < file.numYLevels(); ++ly) {
            for (int lx = 0; lx < file.numXLevels(); ++lx) {
                const std::vector<float> plane(8, static_cast<float>(1 + lx + 10 * ly));
                char* base = const_cast<char*>(reinterpret_cast<const char*>(plane.data()));
                Imf::FrameBuffer buffer;
                for (const std::string& name : names) buffer.insert(name, Imf::Slice(Imf::FLOAT, base, 4, 16));
                file.setFrameBuffer(buffer);
                file.writeTiles(0, file.numXTiles(lx) - 1, 0, file.numYTiles(ly) - 1, lx, ly);
            }
        }
    }
    EXPECT_EQ(image_of(path("rip.exr")).stokes, std::vector<Stokes<double>>(8, {1.0, 1.0, 1.0, 1.0}));
}

TEST_F(PictureFile, DwaIsLossyForColorsAndKeepsWavelengths) {
    Form dwa;
    dwa.compression = Imf::DWAA_COMPRESSION;
    const StoredNumbers colors = image_of(write("a.exr", twelve(), dwa)).stored;
    EXPECT_EQ(colors.bits, 16);
    EXPECT_EQ(colors.lossy, "DWAA");
    const StoredNumbers bare = image_of(write("a.exr", {"S0", "S1", "S2", "S3"}, dwa)).stored;
    EXPECT_EQ(bare.bits, 32);
    EXPECT_EQ(bare.lossy, "");
}

}  // namespace
}  // namespace pol
