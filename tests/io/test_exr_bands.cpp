// SPDX-License-Identifier: Apache-2.0
// Our EXR files of bands without wavelengths, of measured components alone, and of pictures that came from elsewhere.
#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "io/exr_files.h"
#include "io/pictures/picture_file.h"

namespace pol {
namespace {

class ExrBands : public ExrFile {};

/// Different numbers in all measured components, 0 in the others.
StokesImage image_of(std::vector<Band> bands) {
    StokesImage image = sample_image(3, 2, std::vector<double>(bands.size(), 0.0));
    image.bands = std::move(bands);
    for (std::size_t b = 0; b < image.bands.size(); ++b) {
        for (std::size_t i = b * image.pixel_count(); i < (b + 1) * image.pixel_count(); ++i) {
            image.stokes[i] = only(image.bands[b].known, image.stokes[i]);
            image.sampling_error[i] = only(image.bands[b].known, image.sampling_error[i]);
        }
    }
    image.origin.layout = "Mitsuba 3, RGB";
    image.origin.convention = {true, true, 90.0};
    image.origin.assumed = {"one sentence", "another,\nof two lines \\ and a backslash"};
    image.origin.remarks = {"S3 of B is lost", ""};
    return image;
}

TEST_F(ExrBands, ComeBackAsTheyWere) {
    for (const std::vector<Band>& bands :
         {std::vector<Band>{named_band("R"), named_band("G"), named_band("B", StokesComponents::linear())},
          {named_band("mono", StokesComponents::s0())},
          {{580.0, {}, StokesComponents::linear()}},
          {{440.0, {}, StokesComponents::all()}, {1e7 / 17241.0, {}, StokesComponents::s0()}, named_band("Y")},
          // Names that are no channel names, or are twice there, or look like a wavelength.
          {named_band(""), named_band("a.b"), named_band("a\nb\\"), named_band("580nm"), named_band("x"),
           named_band("x"), named_band("band.0"), named_band(std::string(300, 'n'))}}) {
        SCOPED_TRACE(bands.front().label());
        const StokesImage image = image_of(bands);
        const Result<Done> written = write_exr(image, path());
        ASSERT_TRUE(written) << to_string(written.error());
        PictureSource source;
        source.files = {path()};
        const Result<StokesImage> read = read_picture(source);
        ASSERT_TRUE(read) << to_string(read.error());
        const StokesImage& back = read.value();
        EXPECT_EQ(back.bands, image.bands);
        EXPECT_EQ(back.stokes, image.stokes);
        EXPECT_EQ(back.sampling_error, image.sampling_error);
        EXPECT_EQ(back.residual, image.residual);
        EXPECT_EQ(back.tail, image.tail);
        EXPECT_EQ(back.samples, image.samples);
        EXPECT_EQ(back.brightest, image.brightest);
        EXPECT_EQ(back.origin, image.origin);
        // And once more.
        ASSERT_TRUE(write_exr(back, path("again.exr")));
        const Result<StokesImage> again = read_exr(path("again.exr"));
        ASSERT_TRUE(again);
        EXPECT_EQ(again.value().origin, image.origin);
        EXPECT_EQ(again.value().attributes, back.attributes);
    }
}

TEST_F(ExrBands, WhatWasNotMeasuredIsNotWritten) {
    ASSERT_TRUE(write_exr(
        image_of({named_band("B", StokesComponents::linear()), named_band("Y", StokesComponents::s0())}), path()));
    const Imf::InputFile file(path().c_str());
    const Imf::ChannelList& channels = file.header().channels();
    for (const char* there : {"S0.B", "S1.B", "S2.B", "S0.Y", "sampling_error.S2.B", "residual.B", "R", "G", "B"})
        EXPECT_NE(channels.findChannel(there), nullptr) << there;
    for (const char* missing : {"S3.B", "S1.Y", "sampling_error.S3.B"})
        EXPECT_EQ(channels.findChannel(missing), nullptr) << missing;
}

TEST_F(ExrBands, ThePictureAndThePlaceInItComeBack) {
    StokesImage image = image_of({named_band("mono")});
    image.left = 10;
    image.top = 5;
    image.whole_width = 100;
    image.whole_height = 80;
    image.stored = {16, "B44", 0.25};
    ASSERT_TRUE(write_exr(image, path()));
    const Result<StokesImage> back = read_exr(path());
    ASSERT_TRUE(back);
    EXPECT_EQ(std::pair(back.value().left, back.value().top), std::pair(10, 5));
    EXPECT_EQ(std::pair(back.value().whole_width, back.value().whole_height), std::pair(100, 80));
    // 32 bits do not give back what 16 lost.
    EXPECT_EQ(back.value().stored.bits, 16);
    EXPECT_EQ(back.value().stored.lossy, "B44");
    EXPECT_EQ(back.value().stored.spacing, 0.25);
}

TEST_F(ExrBands, OfWhichNothingWasMeasuredAreRefused) {
    const Result<Done> written = write_exr(image_of({named_band("R", StokesComponents::s0().without(0))}), path());
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, ErrorKind::usage);
    EXPECT_EQ(written.error().what, "band R has no component that was measured");
}

TEST_F(ExrBands, ThatAnotherProgramChangedAreRefused) {
    ASSERT_TRUE(write_exr(image_of({named_band("R"), named_band("G")}), path()));
    const auto refusal = [&](const char* attribute, const std::string& text) {
        const Imf::InputFile file(path().c_str());
        Imf::Header header(file.header());
        header.insert(attribute, Imf::StringAttribute(text));
        {
            Imf::OutputFile changed(path("changed.exr").c_str(), header);
            Imf::InputFile pixels(path().c_str());
            changed.copyPixels(pixels);
        }
        const Result<StokesImage> read = read_exr(path("changed.exr"));
        return read ? "read" : read.error().what;
    };
    EXPECT_EQ(refusal("polariscope.bands", "0123 R n R\n0123 G n G\n"), "read");
    EXPECT_EQ(refusal("polariscope.bands", "0123 X n X\n"), "channel S0.X is missing");
    for (const char* bad : {"0123", "0123 R", "4 R n R", "01 R x R", " R n R", "0123 R w five", "0123 R w -5",
                            "0123 R w inf", "0123 R w 1 2"})
        EXPECT_EQ(refusal("polariscope.bands", bad), "polariscope.bands is not understood: '" + std::string(bad) + "'");
    EXPECT_EQ(refusal("polariscope.bands", "0123 R w 600\n0123 G w 500\n"),
              "polariscope.bands is not understood: '0123 G w 500'");
    EXPECT_EQ(refusal("polariscope.bands", "0123 R n R\n0123 R n Q\n"),
              "polariscope.bands is not understood: '0123 R n Q'");
    EXPECT_EQ(refusal("polariscope.origin.convention", "left_handed"),
              "polariscope.origin.convention is not understood: 'left_handed'");
    EXPECT_EQ(refusal("polariscope.origin.convention", "right_handed y_down nan"),
              "polariscope.origin.convention is not understood: 'right_handed y_down nan'");
}

}  // namespace
}  // namespace pol
