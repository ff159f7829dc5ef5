// SPDX-License-Identifier: Apache-2.0
// OBJ, STL and PLY as other programs and systems write them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <utility>

#include "io/mesh_files.h"

namespace pol {
namespace {

using test::box_obj;
using test::box_ply;
using test::box_stl_ascii;
using test::box_stl_binary;
using test::expect_box;
using test::with_line_ends;
using MeshText = test::MeshFile;

// A byte order mark says nothing, whatever line ends follow it.
TEST_F(MeshText, TextFilesOfAnySystemReadTheSame) {
    const std::pair<const char*, std::string> files[] = {
        {"a.obj", box_obj}, {"a.ply", box_ply("ascii")}, {"a.stl", box_stl_ascii()}};
    for (const auto& [name, text] : files) {
        for (const char* end : {"\n", "\r\n", "\r"}) {
            SCOPED_TRACE(name + std::to_string(static_cast<int>(end[0])));
            expect_box(load(name, with_line_ends(text, end)));
            expect_box(load(name, "\xef\xbb\xbf" + with_line_ends(text, end)));
        }
    }
}

TEST_F(MeshText, TextOfSixteenBitCharactersIsNamed) {
    const std::pair<const char*, std::string> files[] = {
        {"a.obj", box_obj}, {"a.ply", box_ply("ascii")}, {"a.stl", box_stl_ascii()}};
    for (const auto& [name, text] : files) {
        std::string wide = "\xff\xfe";
        for (const char c : text) wide += {c, '\0'};
        EXPECT_NE(complaint(name, wide).find(":1: the file is UTF-16 text"), std::string::npos);
    }
    expect_box(load("a.stl", box_stl_binary().replace(0, 5, "\xff\xfe...")));  // a header may hold any bytes
}

TEST_F(MeshText, LinesAreCountedWhateverEndsThem) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
        EXPECT_NE(complaint("a.obj", with_line_ends("v 0 0 0\n\nv 1 0 zero\n", end)).find(":3: 'zero'"),
                  std::string::npos);
        EXPECT_NE(
            complaint("a.stl", with_line_ends("solid\n facet\n\n  loup\n endfacet\n outer lop", end)).find(":6: 'lop'"),
            std::string::npos);
    }
}

TEST_F(MeshText, ObjKnowsTheFormatsOwnWordsCommentsAndContinuedLines) {
    std::string text = box_obj;
    text.replace(text.find("f 4 3 2 1"), 9, "f 4 3\\\n  2 \\ # two\n\\\n1#one");
    text.replace(text.find("f 3 4 8 7"), 1, "fo");
    expect_box(load("a.obj",
                    "# made in C:\\models\\\n# tabs\nlod\t3\nbevel off\nc_interp off\nd_interp off\nmg 1 0.1\ns off\n"
                    "shadow_obj x.obj\ntrace_obj x.obj\ncstype bezier\ng a b\nvp 0 0\nvt 0 0\n" +
                        text + "l 1 2 3\np 1\nusemtl red#1\ncurv 0 1 1 2\nparm u 0 1\nend\n"));
}

TEST_F(MeshText, ObjRefusesByNameWhatHoldsOtherSurfaces) {
    for (const std::string word : {"surf", "bsp", "call", "cdp"}) {
        EXPECT_NE(complaint("a.obj", box_obj + word + " 1 2\n").find(":19: '" + word + "' is not read: only polygons"),
                  std::string::npos);
    }
}

TEST_F(MeshText, AVertexThatIsContinuedOnTheNextLineKeepsTheLineItBeginsOn) {
    EXPECT_NE(complaint("a.obj", "v 0 \\\n 0 \\\n x\n").find(":1: 'x' is not a finite number"), std::string::npos);
    EXPECT_NE(complaint("a.obj", "v 0 \\\n 0 0\nv 0 0 y\n").find(":3: 'y' is not a finite number"), std::string::npos);
    EXPECT_NE(complaint("a.obj", "v 0 0 \\").find(":1: '' is not a finite number"), std::string::npos);
}

TEST_F(MeshText, TextStlIsReadInCapitalsAfterBlanksAndInAnyLines) {
    std::string capitals = box_stl_ascii();
    for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    expect_box(load("a.stl", capitals));
    expect_box(load("a.stl", " \t\n\r\n" + box_stl_ascii()));
    expect_box(load("a.stl", "\xef\xbb\xbf \n" + capitals));
    std::string one_line = box_stl_ascii();
    const std::size_t name_end = one_line.find('\n');
    std::replace(one_line.begin() + static_cast<std::ptrdiff_t>(name_end) + 1, one_line.end(), '\n', ' ');
    expect_box(load("a.stl", one_line));
    std::string no_normals = box_stl_ascii();
    no_normals.replace(no_normals.find("0 0 0"), 5, "-nan(ind) 1.#QNAN vertices");
    expect_box(load("a.stl", no_normals));
}

TEST_F(MeshText, TextThatIsNoStlIsExplainedAsTextAndACutBinaryFileAsBinary) {
    const auto expect = [&](const std::string& bytes, const std::string& what) {
        const std::string text = complaint("a.stl", bytes);
        EXPECT_NE(text.find(what), std::string::npos) << text;
    };
    expect("v 0 0 0\n" + std::string(200, 'x'), ":1: 'v' stands outside a solid");
    expect("SOLID x\nFACIT\n", ":2: 'FACIT' is not an STL keyword");
    expect("solid x\nendsolid\nfacet", ":3: 'facet' stands outside a solid");
    expect(box_stl_ascii() + "solid second\n", "ends inside a solid");
    expect(box_stl_binary().substr(0, 500), "at byte 80: the number of triangles does not fit");
    expect(box_stl_binary().replace(0, 5, "SOLID").substr(0, 500), "at byte 80");
}

TEST_F(MeshText, PropertiesThatNobodyUsesNeedNotBeNumbers) {
    for (const std::string word : {"nan", "-nan", "NaN", "inf", "-inf", "-nan(ind)", "1.#QNAN", "-1.#IND", "1e999"}) {
        SCOPED_TRACE(word);
        std::string text = box_ply("ascii");
        for (std::size_t at = text.find("200 "); at != std::string::npos; at = text.find("200 "))
            text.replace(at, 3, word);
        text.replace(text.find("end_header"), 0, "property list uchar float m\n");
        for (std::size_t at = text.find(" -1 \n"); at != std::string::npos; at = text.find(" -1 \n"))
            text.replace(at, 4, " " + word + " 2 1 " + word);
        expect_box(load("a.ply", text));
    }
    std::string cut = box_ply("ascii");
    cut.resize(cut.rfind("-1"));
    EXPECT_NE(complaint("a.ply", cut).find("face 5, flag: the file ends here"), std::string::npos);
    EXPECT_NE(complaint("a.ply", std::string(box_ply("ascii")).replace(box_ply("ascii").find("200 0.0"), 7, "200 nan"))
                  .find("vertex 0, x: not a finite number"),
              std::string::npos);
}

TEST_F(MeshText, AHeaderWithCarriageReturnsLeavesALineFeedToTheData) {
    // The first byte of the body is the color 10, a line feed.
    for (const char* end : {"\n", "\r\n", "\r"}) {
        std::string ply = box_ply("binary_little_endian");
        const std::size_t body = ply.find("end_header\n") + 11;
        ply[body] = '\n';
        expect_box(load("a.ply", with_line_ends(ply.substr(0, body), end) + ply.substr(body)));
    }
}

// A header that counts too few leaves rows behind.
TEST_F(MeshText, DataAfterTheLastElementOfAPlyFileAreNamed) {
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        std::string fewer = box_ply(format);
        const std::size_t count = fewer.find("element face ") + 13;
        fewer[count] = static_cast<char>(fewer[count] - 1);
        EXPECT_NE(complaint("a.ply", fewer).find("data after the last element"), std::string::npos) << format;
    }
}

TEST_F(MeshText, PlyStripsAreRefusedByName) {
    std::string ply = box_ply("ascii");
    ply.replace(ply.find("end_header"), 0, "element tristrips 1\nproperty list int int vertex_indices\n");
    EXPECT_NE(complaint("a.ply", ply + "3 0 1 2\n").find("triangle strips (tristrips) are not read"),
              std::string::npos);
}

}  // namespace
}  // namespace pol
