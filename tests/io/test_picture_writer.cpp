// SPDX-License-Identifier: Apache-2.0
// Pictures in the forms of other programs: what is written comes back to the bit, or a sentence says what does not.
#include "io/pictures/picture_writer.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "io/exr_files.h"
#include "io/pictures/picture_file.h"
#include "spectrum/color.h"

namespace pol {
namespace {

constexpr std::array<double Stokes<double>::*, 4> components{&Stokes<double>::s0, &Stokes<double>::s1,
                                                             &Stokes<double>::s2, &Stokes<double>::s3};

/// Different numbers everywhere, floats of all sizes and signs, partly polarized; 5 x 2, which no layout mistakes.
StokesImage picture(std::vector<Band> bands) {
    StokesImage image;
    image.width = 5;
    image.height = 2;
    image.bands = std::move(bands);
    for (std::size_t i = 0; i < image.pixel_count() * image.bands.size(); ++i) {
        const double size = std::ldexp(static_cast<float>(1.0 + 0.1 * static_cast<double>(i)), static_cast<int>(i) - 9);
        const Stokes<double> s{size, size / 2.0, i % 2 == 0 ? -size / 4.0 : 0.0, -size / 8.0};
        image.stokes.push_back(only(image.bands[i / image.pixel_count()].known, s));
    }
    return image;
}
std::vector<Band> colors(StokesComponents known = StokesComponents::all()) {
    return {named_band("R", known), named_band("G", known), named_band("B", known)};
}

const PictureFormInfo& info(PictureForm form) {
    return *std::find_if(picture_forms().begin(), picture_forms().end(),
                         [form](const PictureFormInfo& one) { return one.form == form; });
}

bool says(const std::vector<std::string>& sentences, const std::string& words) {
    return std::any_of(sentences.begin(), sentences.end(),
                       [&](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
}

class PictureWriter : public ExrFile {
protected:
    [[nodiscard]] fs::path file_of(PictureForm form) const { return path("picture" + std::string(info(form).ending)); }
    Result<std::vector<std::string>> write(const StokesImage& image, const FormOptions& options) const {
        return write_picture(image, file_of(options.form), options);
    }
    /// What write_picture says is lost.
    std::vector<std::string> lost(const StokesImage& image, const FormOptions& options) const {
        const auto written = write(image, options);
        EXPECT_TRUE(written) << to_string(written.error());
        return written ? written.value() : std::vector<std::string>{};
    }
    [[nodiscard]] StokesImage back(PictureForm form, const StokesImage& image, const std::string& layout = {}) const {
        PictureSource source;
        source.files = {files_of_form(image, file_of(form), form).front()};
        source.layout = layout;
        const auto read = read_picture(source);
        EXPECT_TRUE(read) << to_string(read.error());
        return read ? read.value() : StokesImage{};
    }
    void expect_refused(const StokesImage& image, const FormOptions& options, const std::string& words) const {
        const auto written = write(image, options);
        ASSERT_FALSE(written) << info(options.form).name;
        EXPECT_EQ(written.error().kind, ErrorKind::usage);
        EXPECT_NE(to_string(written.error()).find(words), std::string::npos) << to_string(written.error());
        EXPECT_NE(to_string(written.error()).find("hint: "), std::string::npos) << to_string(written.error());
        EXPECT_EQ(file_count(), 0U);
    }
};

void expect_same_numbers(const StokesImage& a, const StokesImage& b) {
    ASSERT_EQ(a.width, b.width);
    ASSERT_EQ(a.height, b.height);
    ASSERT_EQ(a.stokes.size(), b.stokes.size());
    for (std::size_t i = 0; i < a.stokes.size(); ++i)
        for (std::size_t s = 0; s < 4; ++s) EXPECT_EQ(a.stokes[i].*components[s], b.stokes[i].*components[s]) << i;
}

const std::vector<StokesConvention>& conventions() {
    static const std::vector<StokesConvention> all{
        {}, {true, false, 0.0}, {false, true, 0.0}, {false, false, 90.0}, {true, true, 90.0}};
    return all;
}

TEST_F(PictureWriter, NumbersBandsAndTheConventionComeBackWhereNothingIsSaidToBeLost) {
    struct Case {
        PictureForm form;
        std::vector<Band> bands;
    };
    const StokesComponents linear = StokesComponents::linear();
    std::vector<Case> cases;
    using BandLists = std::vector<std::vector<Band>>;
    for (const PictureForm form : {PictureForm::npz, PictureForm::fits, PictureForm::spectral})
        for (const auto& bands : BandLists{bands_at({450.0, 632.816}),
                                           colors(),
                                           {named_band("mono")},
                                           colors(linear),
                                           {named_band("mono", linear)},
                                           {named_band("a b", linear), named_band("c", linear)}})
            cases.push_back({form, bands});
    for (const PictureForm form : {PictureForm::fits, PictureForm::spectral})
        cases.push_back({form, {named_band("Y", StokesComponents::s0())}});
    for (const PictureForm form : {PictureForm::mitsuba, PictureForm::four})
        for (const auto& bands : BandLists{colors(), {named_band("mono")}}) cases.push_back({form, bands});
    for (const Case& one : cases)
        for (const StokesConvention& convention : conventions()) {
            if (one.form == PictureForm::spectral && convention != StokesConvention{}) continue;
            SCOPED_TRACE(std::string(info(one.form).name) + ", " + one.bands.front().label() + ", " +
                         convention.text());
            const StokesImage image = picture(one.bands);
            EXPECT_EQ(lost(image, {one.form, false, convention}), std::vector<std::string>{});
            const StokesImage read = back(one.form, image);
            expect_same_numbers(read, image);
            EXPECT_EQ(read.bands, image.bands);
            EXPECT_EQ(read.origin.convention, convention);
            EXPECT_EQ(read.origin.assumed, std::vector<std::string>{});
        }
}

TEST_F(PictureWriter, TheConventionIsThatOfTheNumbersInTheFile) {
    const StokesImage image = picture({named_band("mono")});
    ASSERT_TRUE(write(image, {PictureForm::npy, false, {true, false, 90.0}}));
    const StokesImage read = back(PictureForm::npy, image, "nhwc");
    for (std::size_t i = 0; i < image.stokes.size(); ++i) {
        EXPECT_EQ(read.stokes[i].s1, -image.stokes[i].s1);
        EXPECT_EQ(read.stokes[i].s2, -image.stokes[i].s2);
        EXPECT_EQ(read.stokes[i].s3, -image.stokes[i].s3);
    }
}

TEST_F(PictureWriter, OfFourFilesAllHaveOneConvention) {
    const StokesImage image = picture({named_band("mono")});
    ASSERT_TRUE(write(image, {PictureForm::four, false, {}}));
    fs::rename(path("picture_V.exr"), path("kept"));
    ASSERT_TRUE(write(image, {PictureForm::four, false, {true, false, 0.0}}));
    fs::rename(path("kept"), path("picture_V.exr"));
    PictureSource source;
    source.files = {path("picture_I.exr")};
    const auto read = read_picture(source);
    ASSERT_FALSE(read);
    EXPECT_NE(to_string(read.error()).find("another convention"), std::string::npos) << to_string(read.error());
    EXPECT_NE(to_string(read.error()).find("picture_V.exr"), std::string::npos);
}

TEST_F(PictureWriter, AConventionThatIsReadIsNotThatOfTheNextFile) {
    const StokesImage image = picture({named_band("mono")});
    ASSERT_TRUE(write(image, {PictureForm::mitsuba, false, {true, false, 0.0}}));
    const StokesImage once = back(PictureForm::mitsuba, image);
    ASSERT_TRUE(write(once, {PictureForm::spectral, false, {}}));
    expect_same_numbers(back(PictureForm::spectral, image), image);
}

TEST_F(PictureWriter, AnArrayKeepsAllNumbersAndSaysThatNamesAreLost) {
    const StokesImage image = picture(bands_at({450.0, 632.8}));
    EXPECT_TRUE(says(lost(image, {PictureForm::npy, false, {}}), "wavelengths"));
    expect_same_numbers(back(PictureForm::npy, image), image);
    const StokesImage linear = picture(colors(StokesComponents::linear()));
    EXPECT_TRUE(says(lost(linear, {PictureForm::npy, false, {}}), "--layout nhwc"));
    expect_same_numbers(back(PictureForm::npy, linear, "nhwc"), linear);
}

TEST_F(PictureWriter, TheErrorPlanesOfARenderComeBackFromAnArchive) {
    const StokesImage image = sample_image(5, 2, {450.0, 632.8});
    EXPECT_TRUE(says(lost(image, {PictureForm::npz, false, {}}), "number of samples"));
    const StokesImage read = back(PictureForm::npz, image);
    EXPECT_EQ(read.residual, image.residual);
    EXPECT_EQ(read.tail, image.tail);
    ASSERT_EQ(read.sampling_error.size(), image.sampling_error.size());
    for (std::size_t i = 0; i < image.sampling_error.size(); ++i)
        for (std::size_t s = 0; s < 4; ++s)
            EXPECT_EQ(read.sampling_error[i].*components[s], image.sampling_error[i].*components[s]);
    for (const PictureForm form : {PictureForm::npy, PictureForm::fits, PictureForm::mitsuba})
        EXPECT_TRUE(says(lost(image, {form, false, {}}), "residual, tail, sampling error")) << info(form).name;
}

TEST_F(PictureWriter, RoundingIsSaid) {
    StokesImage image = picture({named_band("mono")});
    image.stokes[3].s1 = 0.1;     // no float
    image.stokes[4].s0 = 1e39;    // above all floats
    image.stokes[5].s0 = 65536.;  // above all halves
    for (const PictureForm form : {PictureForm::mitsuba, PictureForm::four, PictureForm::spectral}) {
        const auto sentences = lost(image, {form, false, {}});
        EXPECT_TRUE(says(sentences, "rounded to 32-bit floats")) << info(form).name;
        EXPECT_TRUE(says(sentences, "infinite now")) << info(form).name;
    }
    EXPECT_TRUE(says(lost(image, {PictureForm::mitsuba, true, {}}), "rounded to 16-bit floats"));
    for (const PictureForm form : {PictureForm::npz, PictureForm::fits}) {
        EXPECT_EQ(lost(image, {form, false, {}}), std::vector<std::string>{});
        expect_same_numbers(back(form, image), image);
    }
}

/// Every channel of an EXR file as floats, by name.
std::map<std::string, std::vector<float>> channels_of(const fs::path& path, std::size_t pixels) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    const auto width = static_cast<std::size_t>(window.max.x - window.min.x + 1);
    std::map<std::string, std::vector<float>> planes;
    Imf::FrameBuffer buffer;
    const Imf::ChannelList& channels = file.header().channels();
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
        std::vector<float>& plane = planes[channel.name()];
        plane.resize(pixels);
        buffer.insert(channel.name(), Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(plane.data()), sizeof(float),
                                                 sizeof(float) * width));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return planes;
}

TEST_F(PictureWriter, MitsubasFormHasItsSixteenChannels) {
    const StokesImage image = picture(colors());
    EXPECT_EQ(lost(image, {PictureForm::mitsuba, false, {}}), std::vector<std::string>{});
    const auto planes = channels_of(path(), image.pixel_count());
    std::vector<std::string> names;
    for (const auto& [name, plane] : planes) names.push_back(name);
    EXPECT_EQ(names, (std::vector<std::string>{"A", "B", "G", "R", "S0.B", "S0.G", "S0.R", "S1.B", "S1.G", "S1.R",
                                               "S2.B", "S2.G", "S2.R", "S3.B", "S3.G", "S3.R"}));
    for (std::size_t p = 0; p < image.pixel_count(); ++p) {
        EXPECT_EQ(planes.at("A")[p], 1.0F);
        EXPECT_EQ(planes.at("G")[p], planes.at("S0.G")[p]);
        EXPECT_EQ(planes.at("S2.B")[p], image.at(2, p).s2);
    }
}

TEST_F(PictureWriter, MitsubasFormTakesTwoWavelengthsToLinearSrgbByTheObserver) {
    // Trapezoid rule over 450 and 550 nm: both weigh 50 nm. X, Y and Z are sums of observer (CIE 1931, 2 degrees, table
    // of 1 nm) times light, over the sums that D65 (CIE, 1 at 560 nm) gives, times the white point's X, Y and Z.
    constexpr std::array<double, 3> at450{0.3362, 0.038, 1.77211};
    constexpr std::array<double, 3> at550{0.4334499, 0.9949501, 0.008749999};
    constexpr double d65_450 = 1.17008;
    constexpr double d65_550 = 1.04046;
    StokesImage image = picture(bands_at({450.0, 550.0}));
    const auto expected = [&](std::size_t pixel, double Stokes<double>::*component) {
        std::array<double, 3> part{};
        for (std::size_t i = 0; i < 3; ++i)
            part[i] = (at450[i] * image.at(0, pixel).*component + at550[i] * image.at(1, pixel).*component) /
                      (at450[i] * d65_450 + at550[i] * d65_550);
        const Xyz white = to_xyz({1.0, 1.0, 1.0});
        return to_linear_srgb({part[0] * white[0], part[1] * white[1], part[2] * white[2]});
    };
    EXPECT_TRUE(says(lost(image, {PictureForm::mitsuba, false, {}}), "the spectrum cannot be had back"));
    const auto planes = channels_of(path(), image.pixel_count());
    for (std::size_t p = 0; p < image.pixel_count(); ++p)
        for (std::size_t s = 0; s < 4; ++s) {
            const Rgb color = expected(p, components[s]);
            constexpr std::array<const char*, 3> names{".R", ".G", ".B"};
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(planes.at("S" + std::to_string(s) + names[c])[p], color[c],
                            1e-5 * std::abs(image.at(1, p).s0))
                    << p << " S" << s << names[c];
        }
}

TEST_F(PictureWriter, PhotographsAreOffByHalfAStepAndNameTheirScale) {
    const StokesComponents linear = StokesComponents::linear();
    for (const auto& bands : std::vector<std::vector<Band>>{colors(linear), {named_band("mono", linear)}}) {
        const StokesImage image = picture(bands);
        const auto sentences = lost(image, {PictureForm::png4, false, {}});
        EXPECT_TRUE(says(sentences, "65535th of the brightest"));
        EXPECT_FALSE(says(sentences, "S3"));
        double brightest = 0.0;  // behind a polarizer at 0, 45, 90, 135 degrees: (S0 +- S1) / 2, (S0 +- S2) / 2
        for (const Stokes<double>& s : image.stokes)
            brightest = std::max(brightest, (s.s0 + std::max(std::abs(s.s1), std::abs(s.s2))) / 2.0);
        const StokesImage read = back(PictureForm::png4, image);
        ASSERT_EQ(read.bands, image.bands);
        for (std::size_t i = 0; i < image.stokes.size(); ++i)
            for (std::size_t s = 0; s < 3; ++s)
                EXPECT_NEAR(read.stokes[i].*components[s], image.stokes[i].*components[s], 1.0001 * brightest / 65535.0)
                    << i;
    }
    EXPECT_TRUE(says(lost(picture({named_band("mono")}), {PictureForm::png4, false, {}}), "S3 is not in photographs"));
    StokesImage negative = picture({named_band("mono")});
    negative.stokes[0] = {1.0, -2.0, 0.0, 0.0};
    EXPECT_TRUE(says(lost(negative, {PictureForm::png4, false, {}}), "negative"));
}

TEST_F(PictureWriter, WhatAFormCannotHoldIsRefusedWithAnother) {
    const StokesImage linear = picture({named_band("mono", StokesComponents::linear())});
    expect_refused(linear, {PictureForm::mitsuba, false, {}}, "S0 to S3");
    expect_refused(picture({named_band("x"), named_band("y")}), {PictureForm::mitsuba, false, {}}, "npz");
    const StokesImage light = picture({named_band("Y", StokesComponents::s0())});
    for (const PictureForm form : {PictureForm::npy, PictureForm::npz, PictureForm::png4})
        expect_refused(light, {form, false, {}}, "not measured");
    const StokesImage mixed = picture({named_band("x", StokesComponents::linear()), named_band("y")});
    for (const PictureForm form : {PictureForm::npy, PictureForm::npz, PictureForm::fits, PictureForm::mitsuba})
        expect_refused(mixed, {form, false, {}}, "hint: ");
    for (const PictureForm form : {PictureForm::four, PictureForm::png4})
        expect_refused(picture(bands_at({450.0, 550.0})), {form, false, {}}, "one band, or R, G and B");
    expect_refused(picture({named_band("mono")}), {PictureForm::spectral, false, {true, false, 0.0}}, "--handedness");
}

TEST_F(PictureWriter, ThreeOfFourFilesAreWrittenWithoutS3AndThatIsSaid) {
    const StokesImage image = picture({named_band("mono", StokesComponents::linear())});
    EXPECT_TRUE(says(lost(image, {PictureForm::four, false, {}}), "--stokes"));
    EXPECT_EQ(file_count(), 3U);
    PictureSource source;
    source.stokes_files = {path("picture_I.exr"), path("picture_Q.exr"), path("picture_U.exr"), {}};
    const auto read = read_picture(source);
    ASSERT_TRUE(read) << to_string(read.error());
    expect_same_numbers(read.value(), image);
    EXPECT_EQ(read.value().bands, image.bands);
}

TEST_F(PictureWriter, AFolderThatIsMissingIsAnErrorOfTheOutput) {
    for (const PictureFormInfo& form : picture_forms()) {
        const auto written = write_picture(picture({named_band("mono")}),
                                           path("none") / ("x" + std::string(form.ending)), {form.form, false, {}});
        ASSERT_FALSE(written) << form.name;
        EXPECT_EQ(written.error().kind, ErrorKind::output) << form.name;
    }
}

}  // namespace
}  // namespace pol
