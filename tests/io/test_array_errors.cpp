// SPDX-License-Identifier: Apache-2.0
// What is refused, and by which name: a rule, a test.
#include <algorithm>

#include "io/array_files.h"

namespace pol {
namespace {

#define EXPECT_SAYS(text, words)                                               \
    do {                                                                       \
        const std::string said = (text);                                       \
        EXPECT_NE(said.find(words), std::string::npos) << "says: " << said;    \
        EXPECT_NE(said.find("hint: "), std::string::npos) << "says: " << said; \
    } while (false)

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, from.size(), to);
}

TEST_F(ArrayFile, PicklesRecordsAndOtherNumbersAreRefusedByName) {
    const std::string data(256, '\0');
    EXPECT_SAYS(complaint("a.npy", npy_of(dict_of("|O", "(1, 1, 4)"), data)), "pickle");
    EXPECT_SAYS(complaint("a.npy", npy_of("{'descr': [('s0', '<f4')], 'fortran_order': False, 'shape': (1,), }", data)),
                "records");
    EXPECT_SAYS(complaint("a.npy", npy_of(dict_of("|V16", "(1, 1, 4)"), data)), "records");
    EXPECT_SAYS(complaint("a.npy", npy_of(dict_of("<c8", "(1, 1, 4)"), data)), "complex");
    EXPECT_SAYS(complaint("a.npy", npy_of(dict_of("<U4", "(1, 1, 4)"), data)), "text");
    EXPECT_SAYS(complaint("a.npy", npy_of(dict_of("<i8", "(1, 1, 4)"), data)), "'<i8'");
}

TEST_F(ArrayFile, ATruncatedArrayIsRefusedWhereverItEnds) {
    const std::string whole = bytes_of(sample("hw4_f4.npy"));
    for (std::size_t size = 6; size < whole.size(); ++size)
        EXPECT_SAYS(complaint("t.npy", whole.substr(0, size)), path("t.npy").string());
}

TEST_F(ArrayFile, APromisedSizeIsHeldAgainstTheBytesThatAreThere) {
    EXPECT_SAYS(complaint("p.npy", npy_of(dict_of("<f4", "(1000000, 1000000, 4)"), "1234")), "promises");
    EXPECT_SAYS(complaint("p.npy", npy_of(dict_of("<f4", "(18446744073709551615, 4, 4)"), "1234")), "promises");
    EXPECT_SAYS(complaint("p.npy", npy_of(dict_of("<f4", "(99999999999999999999, 4, 4)"), "1234")), "header");
    EXPECT_SAYS(complaint("p.npy", npy_of(dict_of("<f4", "(0, 4, 4)"), "")), "");
    EXPECT_SAYS(complaint("p.npy", npy_of(dict_of("<f4", "(0, 5, 4)"), "")), "no pixel");
}

TEST_F(ArrayFile, ADamagedHeaderIsRefused) {
    const std::string data(64, '\0');
    for (const std::string dict :
         {"", "{", "{}", "[]", "{'descr': '<f4'}", "{'descr': '<f4', 'fortran_order': Maybe, 'shape': (1, 1, 4)}",
          "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 1, 4), 'more': 1}",
          "{'descr': '<f4', 'descr': '<f4', 'fortran_order': False, 'shape': (1, 1, 4)}",
          "{'descr': '<f4', 'fortran_order': False, 'shape': (1 1 4)}",
          "{'descr': '<f4', 'fortran_order': False, 'shape': (-1, 1, 4)}",
          "{'descr': '<f4' 'fortran_order': False, 'shape': (1, 1, 4)}",
          "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 1, 4)} rest"})
        EXPECT_SAYS(complaint("d.npy", npy_of(dict, data)), "damaged header");
    EXPECT_SAYS(complaint("d.npy", npy_of(dict_of("<f4", "(1, 1, 4)"), data, 4)), "format 4");
}

TEST_F(ArrayFile, ShapesThatCanBeTwoThingsAreRefusedWithBothNames) {
    const std::string data(4096, '\0');
    const std::string both = complaint("s.npy", npy_of(dict_of("<f4", "(4, 5, 4)"), data));
    EXPECT_SAYS(both, "hwc");
    EXPECT_SAYS(both, "chw");
    EXPECT_SAYS(both, "--layout");
    EXPECT_SAYS(complaint("s.npy", npy_of(dict_of("<f4", "(5, 4, 4)"), data)), "Mueller");
    const std::string matrices = complaint("s.npy", npy_of(dict_of("<f4", "(5, 6, 4, 4)"), std::string(1920, '\0')));
    EXPECT_SAYS(matrices, "nhwc (bands, rows, columns, Stokes) or Mueller matrices");
    EXPECT_SAYS(matrices, "--layout nhwc");
    EXPECT_SAYS(complaint("s.npy", npy_of(dict_of("<f4", "(4, 5, 13)"), data)), "tensor");
    EXPECT_EQ(complaint("s.npy", npy_of(dict_of("<f4", "(4, 5, 4)"), data), "chw"), "read");
    EXPECT_EQ(complaint("s.npy", npy_of(dict_of("<f4", "(5, 4, 4)"), data), "hwc"), "read");
}

TEST_F(ArrayFile, OtherShapesAndLayoutsAreRefused) {
    const std::string data(4096, '\0');
    for (const char* shape : {"()", "(4,)", "(5, 5)", "(5, 5, 5)", "(5, 5, 17)", "(2, 5, 5, 5)", "(1, 1, 1, 1, 4)"})
        EXPECT_SAYS(complaint("s.npy", npy_of(dict_of("<f4", shape), data)), shape);
    EXPECT_SAYS(complaint("s.npy", npy_of(dict_of("<f4", "(5, 5, 4)"), data), "nhwc"), "not nhwc");
    EXPECT_SAYS(complaint("s.npy", npy_of(dict_of("<f4", "(5, 5, 4)"), data), "mosaic"), "'mosaic'");
    EXPECT_SAYS(complaint("s.npy", npy_of(dict_of("<f4", "(5, 5, 4)"), data), "gibberish"), "'gibberish'");
}

TEST_F(ArrayFile, ADamagedArchiveIsRefusedWhereverItIsDamaged) {
    for (const char* name : {"named.npz", "single.npz"}) {
        const std::string whole = bytes_of(sample(name));
        for (std::size_t size = 4; size < whole.size(); ++size)
            EXPECT_SAYS(complaint("t.npz", whole.substr(0, size)), path("t.npz").string());
        // A changed byte is found by the checksum, or is in what is not read: a picture is never wrong.
        const auto good = read_array_picture(source_of(sample(name)));
        for (std::size_t at = 4; at < whole.size(); ++at) {
            std::string changed = whole;
            changed[at] = static_cast<char>(changed[at] ^ 0x10);
            const auto read = read_array_picture(source_of(write("c.npz", changed)));
            if (!read) continue;
            for (std::size_t i = 0; i < good.value().stokes.size(); ++i)
                EXPECT_EQ(read.value().stokes[i].s1, good.value().stokes[i].s1) << name << " byte " << at;
        }
    }
}

TEST_F(ArrayFile, AnArchiveSaysWhichArrayIsWrongOrMissing) {
    const std::string named = bytes_of(sample("named.npz"));
    // The names stand in the headers and in the directory.
    const auto renamed = [&](const std::string& from, const std::string& to) {
        return replaced(replaced(named, from, "@@@@@@"), from, to).replace(named.find(from), to.size(), to);
    };
    EXPECT_SAYS(complaint("n.npz", renamed("s1.npy", "x1.npy")), "not both of s1 and s2");
    EXPECT_SAYS(complaint("n.npz", renamed("s0.npy", "x0.npy")), "x0");
    EXPECT_EQ(complaint("n.npz", renamed("s3.npy", "x3.npy")), "read");
    EXPECT_SAYS(complaint("n.npz", renamed("s1.npy", "s0.npy")), "two entries");
    EXPECT_SAYS(complaint("n.npz", named, "hwc"), "--layout");
}

TEST_F(ArrayFile, AnArchivesPromiseIsHeldAgainstItsBytes) {
    std::string bytes = bytes_of(sample("single.npz"));
    // Sizes in the directory: 20 and 24 bytes behind its signature.
    const std::size_t directory = bytes.find("PK\x01\x02");
    ASSERT_NE(directory, std::string::npos);
    std::string more = bytes;
    for (std::size_t i = 0; i < 3; ++i) more[directory + 24 + i] = '\xff';
    EXPECT_SAYS(complaint("p.npz", more), "promises");
    std::string encrypted = bytes;
    encrypted[directory + 8] = 1;
    EXPECT_SAYS(complaint("p.npz", encrypted), "encrypted");
    std::string other = bytes;
    other[directory + 10] = 12;
    EXPECT_SAYS(complaint("p.npz", other), "method 12");
}

TEST_F(ArrayFile, OfASetOfPhotographsNoneMayBeMissingOrOfAnotherSize) {
    for (const char* angle : {"000", "045", "090"})
        fs::copy_file(sample(std::string("four_") + angle + ".png"), path(std::string("a_") + angle + ".png"));
    const auto missing = read_array_picture(source_of(path("a_000.png")));
    ASSERT_FALSE(missing);
    EXPECT_SAYS(to_string(missing.error()), "a_135.png");
    fs::copy_file(sample("mosaic_12bit.png"), path("a_135.png"));
    const auto other = read_array_picture(source_of(path("a_000.png")));
    ASSERT_FALSE(other);
    EXPECT_SAYS(to_string(other.error()), "another size");
    EXPECT_SAYS(to_string(other.error()), "a_135.png");
    // Alone it is a photograph, whatever its name.
    fs::copy_file(sample("four_000.png"), path("alone_0.png"));
    EXPECT_TRUE(read_array_picture(source_of(path("alone_0.png"))));
    EXPECT_SAYS(to_string(read_array_picture(source_of(path("alone_0.png"), "four-angles")).error()), "missing");
}

TEST_F(ArrayFile, AnglesThatDoNotTellTheComponentsApartAreRefused) {
    PictureSource source;
    for (const char* angle : {"000", "045", "090"})
        source.files.push_back(sample(std::string("four_") + angle + ".png"));
    for (const std::vector<double>& angles :
         {std::vector<double>{0.0, 90.0, 180.0}, {0.0, 45.0, 225.0}, {10.0, 10.5, 11.0}}) {
        source.angles_deg = angles;
        const auto read = read_array_picture(source);
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().kind, ErrorKind::usage);
        EXPECT_SAYS(to_string(read.error()), "angles");
    }
    source.angles_deg = {0.0, 45.0};
    EXPECT_EQ(read_array_picture(source).error().kind, ErrorKind::usage);
    source.files.pop_back();
    EXPECT_SAYS(to_string(read_array_picture(source).error()), "2 polarizer angles");
}

TEST_F(ArrayFile, AMosaicIsGrayAndHasWholeCells) {
    EXPECT_SAYS(complaint("m.png", bytes_of(sample("mosaic_12bit.png")), "color-mosaic"), "whole cells of 4 x 4");
    EXPECT_SAYS(complaint("m.png", bytes_of(sample("four_000.png")), "mosaic"), "whole cells of 2 x 2");
    EXPECT_SAYS(complaint("m.png", bytes_of(sample("four_000.png")), "hwc"), "'hwc'");
}

TEST_F(ArrayFile, ATruncatedPhotographIsRefused) {
    const std::string whole = bytes_of(sample("mosaic_12bit.png"));
    for (std::size_t size = 8; size < whole.size(); ++size)
        EXPECT_SAYS(complaint("t.png", whole.substr(0, size)), "damaged PNG");
}

TEST_F(ArrayFile, CorrelationsOfTwoReceiversAreRefusedByName) {
    const std::string whole = bytes_of(sample("iquv_iau.fits"));
    const std::string card = "CRVAL3  =                  1.0";
    EXPECT_SAYS(complaint("f.fits", replaced(whole, card, "CRVAL3  =                 -4.0")), "correlations LR");
    EXPECT_SAYS(complaint("f.fits", replaced(whole, card, "CRVAL3  =                 -8.0")), "correlations YX");
    EXPECT_SAYS(complaint("f.fits", replaced(whole, card, "CRVAL3  =                  2.0")), "STOKES code 5");
    EXPECT_SAYS(complaint("f.fits", replaced(whole, card, "CRVAL3  =                  1.5")), "STOKES code 1.5");
    EXPECT_SAYS(complaint("f.fits", replaced(whole, card, "CRVAL3  =                  one")), "CRVAL3");
}

TEST_F(ArrayFile, ACubeOfFitsIsHeldAgainstItsHeader) {
    const std::string whole = bytes_of(sample("iquv_iau.fits"));
    EXPECT_SAYS(complaint("f.fits", whole.substr(0, 1000)), "ends within its header");
    EXPECT_SAYS(complaint("f.fits", whole.substr(0, 2890)), "promises");
    EXPECT_SAYS(
        complaint("f.fits", replaced(whole, "NAXIS1  =                    3", "NAXIS1  =             30000000")),
        "promises");
    EXPECT_SAYS(
        complaint("f.fits", replaced(whole, "NAXIS1  =                    3", "NAXIS1  =                   -3")),
        "NAXIS1");
    EXPECT_SAYS(
        complaint("f.fits", replaced(whole, "BITPIX  =                  -32", "BITPIX  =                   64")),
        "BITPIX 64");
    EXPECT_SAYS(complaint("f.fits", replaced(whole, "'STOKES  '", "'FREQ    '")), "no axis STOKES behind the two");
    EXPECT_SAYS(complaint("f.fits", whole, "hwc"), "'hwc'");
}

TEST_F(ArrayFile, CosmoTurnsUOnceMore) {
    const std::string whole = bytes_of(sample("iquv_iau.fits"));
    const auto iau = read_array_picture(source_of(sample("iquv_iau.fits")));
    const auto cosmo = read_array_picture(source_of(write("c.fits", replaced(whole, "'IAU     '", "'COSMO   '"))));
    ASSERT_TRUE(iau && cosmo);
    for (std::size_t i = 0; i < iau.value().stokes.size(); ++i) {
        EXPECT_EQ(cosmo.value().stokes[i].s1, iau.value().stokes[i].s1);
        EXPECT_EQ(cosmo.value().stokes[i].s2, -iau.value().stokes[i].s2);
        EXPECT_EQ(cosmo.value().stokes[i].s3, iau.value().stokes[i].s3);
    }
}

}  // namespace
}  // namespace pol
