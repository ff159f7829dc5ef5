// SPDX-License-Identifier: Apache-2.0
#include "io/mesh_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/random.h"
#include "geometry/half_space_solid.h"
#include "geometry/mesh_check.h"
#include "geometry/shapes.h"

namespace pol {
namespace {

class MeshFile : public testing::Test {
protected:
    MeshFile() {
        folder_ = std::filesystem::temp_directory_path() /
                  ("pol_mesh_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::create_directories(folder_);
    }
    ~MeshFile() override { std::filesystem::remove_all(folder_); }

    Result<Mesh> load(const std::string& name, const std::string& bytes) {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return load_mesh(folder_ / name);
    }
    std::string complaint(const std::string& name, const std::string& bytes) {
        const auto mesh = load(name, bytes);
        return mesh ? "" : to_string(mesh.error());
    }

    std::filesystem::path folder_;
};

template <class T>
void append(std::string& bytes, T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes.append(raw, sizeof(T));
}

std::string reversed(std::string bytes) {
    return {bytes.rbegin(), bytes.rend()};
}

void expect_box(const Result<Mesh>& mesh) {
    ASSERT_TRUE(mesh) << to_string(mesh.error());
    EXPECT_TRUE(check_closed(mesh.value()));
    EXPECT_EQ(mesh.value().facets.size(), 6U);
    EXPECT_EQ(mesh.value().vertices.size(), 8U);
    // 1 x 2 x 3, coordinates exact in float.
    EXPECT_NEAR(signed_volume(mesh.value()), 6.0, 1e-14);
}

const char* const box_obj = R"(# a box
mtllib box.mtl
o box
v 0 0 0
v 1 0 0
v 1 2 0
v 0 2 0
v 0 0 3 1.0
v 1 0 +3
v 1 2 3e0
v 0 2 3
vn 0 0 1
f 4 3 2 1
f 5//1 6//1 7//1 8//1
f 1/1 2/1 6/1 5/1
f -7 -6 -2 -3
f 3 4 8 7
f 4 1 5 8
)";

std::string box_ply(const std::string& format) {
    const int order[6][4] = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    std::string bytes = "ply\nformat " + format +
                        " 1.0\ncomment made here\nelement vertex 8\nproperty uchar red\nproperty float x\n"
                        "property double y\nproperty float z\nelement face 6\nproperty list uchar int vertex_indices\n"
                        "property short flag\nend_header\n";
    const auto put = [&](auto value) {
        if (format == "ascii") {
            bytes += std::to_string(value) + " ";
            return;
        }
        std::string raw;
        append(raw, value);
        bytes += format == "binary_big_endian" ? reversed(raw) : raw;
    };
    for (int v = 0; v < 8; ++v) {
        put(std::uint8_t{200});
        put(v % 4 == 1 || v % 4 == 2 ? 1.0F : 0.0F);
        put(v % 4 >= 2 ? 2.0 : 0.0);
        put(v >= 4 ? 3.0F : 0.0F);
        if (format == "ascii") bytes += "\n";
    }
    for (const auto& face : order) {
        put(std::uint8_t{4});
        for (const int v : face) put(std::int32_t{v});
        put(std::int16_t{-1});
        if (format == "ascii") bytes += "\n";
    }
    return bytes;
}

std::string with_line_ends(const std::string& text, const char* end) {
    std::string result;
    for (const char c : text) result += c == '\n' ? end : std::string(1, c);
    return result;
}

std::vector<DVec3> box_corners() {
    std::vector<DVec3> corners;
    const Mesh mesh = make_mesh(BoxShape{{1.0, 2.0, 3.0}}).value();
    for (const auto& t : mesh.triangles) {
        for (const std::uint32_t v : t) corners.push_back(mesh.vertices[v]);
    }
    return corners;
}

std::string box_stl_binary() {
    std::string bytes(80, ' ');
    bytes.replace(0, 5, "solid");  // as some programs really write
    append(bytes, std::uint32_t{12});
    const auto corners = box_corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (i % 3 == 0) bytes += std::string(12, '\0');
        for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(corners[i][axis]));
        if (i % 3 == 2) append(bytes, std::uint16_t{0});
    }
    return bytes;
}

std::string box_stl_ascii() {
    std::string text = "solid box\n";
    const auto corners = box_corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (i % 3 == 0) text += " facet normal 0 0 0\n  outer loop\n";
        text += "   vertex " + std::to_string(corners[i].x) + " " + std::to_string(corners[i].y) + " " +
                std::to_string(corners[i].z) + "\n";
        if (i % 3 == 2) text += "  endloop\n endfacet\n";
    }
    return text + "endsolid box\n";
}

// A GLB of one box, under a parent that mirrors and a child that moves and scales.
std::string box_glb(const std::string& indices_extra = "") {
    std::string binary;
    const auto corners = box_corners();
    for (const DVec3& p : corners) {
        for (int axis = 0; axis < 3; ++axis) append(binary, static_cast<float>(p[axis] / 2.0));
    }
    for (std::uint16_t i = 0; i < 36; ++i) append(binary, i);
    std::string json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)"
                       R"({"children":[1],"scale":[-1,1,1]},{"mesh":0,"scale":[2,2,2],"translation":[5,0,0]}],)"
                       R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
                       R"("buffers":[{"byteLength":504}],"bufferViews":[{"buffer":0,"byteLength":432},)"
                       R"({"buffer":0,"byteOffset":432,"byteLength":72}],)"
                       R"("accessors":[{"bufferView":0,"componentType":5126,"count":36,"type":"VEC3"},)"
                       R"({"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR")" +
                       indices_extra + "}]}";
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string glb = "glTF";
    append(glb, std::uint32_t{2});
    append(glb, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size()));
    append(glb, static_cast<std::uint32_t>(json.size()));
    glb += "JSON" + json;
    append(glb, static_cast<std::uint32_t>(binary.size()));
    glb += std::string("BIN\0", 4) + binary;
    return glb;
}

TEST_F(MeshFile, OneBoxReadsTheSameFromEveryFormat) {
    expect_box(load("box.obj", box_obj));
    expect_box(load("ascii.ply", box_ply("ascii")));
    expect_box(load("little.ply", box_ply("binary_little_endian")));
    expect_box(load("BIG.PLY", box_ply("binary_big_endian")));
    expect_box(load("binary.stl", box_stl_binary()));
    expect_box(load("ascii.stl", box_stl_ascii()));
    expect_box(load("box.glb", box_glb()));
}

// A byte order mark says nothing, whatever line ends follow it.
TEST_F(MeshFile, TextFilesOfAnySystemReadTheSame) {
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

TEST_F(MeshFile, LinesAreCountedWhateverEndsThem) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
        EXPECT_NE(complaint("a.obj", with_line_ends("v 0 0 0\n\nv 1 0 zero\n", end)).find(":3: 'zero'"),
                  std::string::npos);
        EXPECT_NE(
            complaint("a.stl", with_line_ends("solid\n facet\n\n  loup\n endfacet\n outer lop", end)).find(":6: 'lop'"),
            std::string::npos);
    }
}

TEST_F(MeshFile, ObjKnowsTheFormatsOwnWordsCommentsAndContinuedLines) {
    std::string text = box_obj;
    text.replace(text.find("f 4 3 2 1"), 9, "f 4 3\\\n  2 \\ # two\n\\\n1#one");
    text.replace(text.find("f 3 4 8 7"), 1, "fo");
    expect_box(load("a.obj",
                    "# made in C:\\models\\\n# tabs\nlod\t3\nbevel off\nc_interp off\nd_interp off\nmg 1 0.1\ns off\n"
                    "shadow_obj x.obj\ntrace_obj x.obj\ncstype bezier\ng a b\nvp 0 0\nvt 0 0\n" +
                        text + "l 1 2 3\np 1\nusemtl red#1\ncurv 0 1 1 2\nparm u 0 1\nend\n"));
}

TEST_F(MeshFile, ObjRefusesByNameWhatHoldsOtherSurfaces) {
    for (const std::string word : {"surf", "bsp", "call", "cdp"}) {
        EXPECT_NE(complaint("a.obj", box_obj + word + " 1 2\n").find(":19: '" + word + "' is not read: only polygons"),
                  std::string::npos);
    }
}

TEST_F(MeshFile, AVertexThatIsContinuedOnTheNextLineKeepsTheLineItBeginsOn) {
    EXPECT_NE(complaint("a.obj", "v 0 \\\n 0 \\\n x\n").find(":1: 'x' is not a finite number"), std::string::npos);
    EXPECT_NE(complaint("a.obj", "v 0 \\\n 0 0\nv 0 0 y\n").find(":3: 'y' is not a finite number"), std::string::npos);
    EXPECT_NE(complaint("a.obj", "v 0 0 \\").find(":1: '' is not a finite number"), std::string::npos);
}

TEST_F(MeshFile, TextStlIsReadInCapitalsAfterBlanksAndInAnyLines) {
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

TEST_F(MeshFile, TextThatIsNoStlIsExplainedAsTextAndACutBinaryFileAsBinary) {
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

TEST_F(MeshFile, PropertiesThatNobodyUsesNeedNotBeNumbers) {
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

TEST_F(MeshFile, AHeaderWithCarriageReturnsLeavesALineFeedToTheData) {
    // The first byte of the body is the color 10, a line feed.
    for (const char* end : {"\n", "\r\n", "\r"}) {
        std::string ply = box_ply("binary_little_endian");
        const std::size_t body = ply.find("end_header\n") + 11;
        ply[body] = '\n';
        expect_box(load("a.ply", with_line_ends(ply.substr(0, body), end) + ply.substr(body)));
    }
}

TEST_F(MeshFile, PlyStripsAreRefusedByName) {
    std::string ply = box_ply("ascii");
    ply.replace(ply.find("end_header"), 0, "element tristrips 1\nproperty list int int vertex_indices\n");
    EXPECT_NE(complaint("a.ply", ply + "3 0 1 2\n").find("triangle strips (tristrips) are not read"),
              std::string::npos);
}

TEST_F(MeshFile, GltfNodesMoveMirrorAndScale) {
    const auto mesh = load("box.glb", box_glb());
    ASSERT_TRUE(mesh);
    double low = 1e9;
    double high = -1e9;
    for (const DVec3& p : mesh.value().vertices) {
        low = std::min(low, p.x);
        high = std::max(high, p.x);
    }
    EXPECT_EQ(low, -5.5);
    EXPECT_EQ(high, -4.5);
}

TEST(GemFile, HasIts73PlanesAndEncirclesAConvexSolid) {
    const auto mesh = load_mesh(std::filesystem::path(POL_ASSETS) / "scenes/bench/gem.ply");
    ASSERT_TRUE(mesh) << to_string(mesh.error());
    EXPECT_EQ(mesh.value().triangles.size(), 174U);
    EXPECT_EQ(mesh.value().facets.size(), 73U);
    const auto solid = HalfSpaceSolid::from_mesh(mesh.value());
    ASSERT_TRUE(solid) << to_string(solid.error());
    EXPECT_EQ(solid.value().facet_count(), 73);
}

TEST_F(MeshFile, ComplaintsNameFileLineAndCause) {
    const auto expect = [&](const std::string& name, const std::string& bytes, const std::string& what) {
        const std::string text = complaint(name, bytes);
        EXPECT_NE(text.find(what), std::string::npos) << text;
        EXPECT_NE(text.find(name), std::string::npos) << text;
        EXPECT_NE(text.find("hint"), std::string::npos) << text;
    };
    expect("a.obj", "v 0 0 0\nv 1 0 zero\n", ":2: 'zero' is not a finite number");
    expect("a.obj", "v 0 0 0\nv 1 0 nan\n", ":2: 'nan' is not a finite number");
    expect("a.obj", "v 0 0 0\nv 1 0 1e999\n", ":2: '1e999' is not a finite number");
    expect("a.obj", "v 0 0 0\nf 1 2 3\n", ":2: face 0 uses vertex 1 of 1");
    expect("a.obj", "v 0 0 0\nf 1 1 0\n", ":2: '0' names no vertex");
    expect("a.obj", "v 0 0 0\nf 1 -2 1\n", ":2: '-2' names no vertex");
    expect("a.obj", "v 0 0 0\nf 1 1\n", ":2: a face with fewer than 3 corners");
    expect("a.obj", "hello\n", ":1: 'hello' is not an OBJ keyword");
    expect("a.obj", "v 0 0 0\n", "no triangles");
    expect("a.obj", "", "the file is empty");
    expect("a.xyz", "v 0 0 0\n", "unknown kind of mesh file '.xyz'");
    expect("a.ply", "plx\n", ":1: this is not a PLY file");
    expect("a.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\n", ":3: element vertex has a count");
    expect("a.ply", "ply\nformat ascii 1.0\nelement vertex -1\n", ":3: element vertex has a count");
    expect("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
           "vertices have no property z");
    expect("a.ply", box_ply("ascii").substr(0, 300), "ends here");
    expect("a.ply", box_ply("binary_little_endian").substr(0, 320), "at byte");
    expect("a.stl", box_stl_binary().substr(0, 500), "at byte 80");
    expect("a.stl", box_stl_ascii().substr(0, 200), "ends inside a solid");
    expect("a.stl", "solid x\nfacet\nouter loop\nvertex 0 0 0\nendloop\n", ":5: a facet needs three vertices");
    expect("a.glb", box_glb().substr(0, 900), "not a valid glTF file");
    expect("a.gltf", "{]", "not a valid glTF file");
    expect("a.glb", box_glb(R"(,"byteOffset":2)"), "reaches beyond its buffer");
    expect("a.glb", box_glb(R"(,"byteOffset":18446744073709551614)"), "");
}

TEST_F(MeshFile, MissingFilesAndFoldersAreErrors) {
    EXPECT_FALSE(load_mesh(folder_ / "not-there.ply"));
    EXPECT_FALSE(load_mesh(folder_));
    std::filesystem::create_directories(folder_ / "folder.ply");
    EXPECT_FALSE(load_mesh(folder_ / "folder.ply"));
}

TEST_F(MeshFile, NotANumberInBinaryFilesIsFoundWithItsPlace) {
    std::string stl = box_stl_binary();
    const float nan = std::nanf("");
    std::memcpy(stl.data() + 84 + 50 * 7 + 12 + 16, &nan, 4);
    EXPECT_NE(complaint("a.stl", stl).find("at byte 462: triangle 7, corner 1 is not finite"), std::string::npos);
    std::string ply = box_ply("binary_little_endian");
    const std::size_t body = ply.find("end_header\n") + 11;
    std::memcpy(ply.data() + body + 17 * 3 + 1, &nan, 4);
    EXPECT_NE(complaint("a.ply", ply).find("vertex 3 is not finite"), std::string::npos);
}

// Unsigned areas of the triangles that look up: twice as much where triangles fold over each other's outline.
double area_from_above(const Mesh& mesh) {
    double area = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const DVec3 n = cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
        if (n.z > 0.0) area += 0.5 * n.z;
    }
    return area;
}

// Prisms from z = 0 to 1 over a U (4.985, by the shoelace formula) and a plus sign of five unit squares.
TEST_F(MeshFile, FacesThatAreNotConvexAreFilledToTheirOutline) {
    const std::vector<DVec2> letter_u{{0, 0}, {3, 0}, {3, 2.1}, {2, 2}, {2.1, 1}, {0.9, 1.1}, {1, 2.2}, {0.1, 2}};
    const std::vector<DVec2> plus{{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2},
                                  {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
    for (const auto& [outline, area] : {std::pair{letter_u, 4.985}, std::pair{plus, 5.0}}) {
        const std::size_t n = outline.size();
        std::string vertices;
        for (const char* z : {"0", "1"}) {
            for (const DVec2& p : outline)
                vertices += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + z + "\n";
        }
        std::vector<std::vector<std::size_t>> faces(2);
        for (std::size_t i = 0; i < n; ++i) {
            faces[0].push_back(n - 1 - i);
            faces[1].push_back(n + i);
            faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
        }
        std::string obj = vertices;
        std::string ply = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(2 * n) +
                          "\nproperty uchar v\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                          std::to_string(faces.size()) + "\nproperty list int int vertex_index\nend_header\n" +
                          vertices;
        for (const auto& face : faces) {
            obj += "f";
            ply += std::to_string(face.size());
            for (const std::size_t v : face) {
                obj += " " + std::to_string(v + 1);
                ply += " " + std::to_string(v);
            }
            obj += "\n";
            ply += "\n";
        }
        for (const auto& mesh : {load("a.obj", obj), load("a.ply", ply)}) {
            ASSERT_TRUE(mesh) << to_string(mesh.error());
            EXPECT_TRUE(check_closed(mesh.value()));
            EXPECT_EQ(mesh.value().facets.size(), n + 2);
            // A dozen sums of numbers below 10.
            EXPECT_NEAR(area_from_above(mesh.value()), area, 1e-13);
            EXPECT_NEAR(signed_volume(mesh.value()), area, 1e-13);
        }
    }
}

TEST_F(MeshFile, FacesThatHaveNoSingleInsideAreRefusedWithTheirLine) {
    const std::string corners =
        "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\nv 3 3 1\nf 1 2 3\n";
    const auto expect = [&](const std::string& face, const std::string& what) {
        const std::string text = complaint("a.obj", corners + face);
        EXPECT_NE(text.find(":11: face 1 " + what), std::string::npos) << text;
        EXPECT_NE(text.find("hint: cut it into simple faces or triangles"), std::string::npos) << text;
    };
    expect("f 1 3 2 4\n", "crosses itself near");
    expect("f 1 2 3 4 1 5 6 7 8 5\n", "touches itself near (0, 0, 0), as the outline of a face with a hole does");
    expect("f 1 2 9 4\n", "is not flat: its corners lie up to ");
    expect("f 1 2 1 2\n", "has all its corners in one line");
}

TEST_F(MeshFile, PolygonsWithACornerInTheMiddleOfASideBecomeSoundTriangles) {
    // Unit square with a fifth corner on its lower side, between corners 0 and 1.
    const auto mesh = load("a.obj", "v 0 0 0\nv 0.5 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4 5\n");
    ASSERT_TRUE(mesh) << to_string(mesh.error());
    EXPECT_EQ(mesh.value().triangles.size(), 3U);
    EXPECT_EQ(mesh.value().facets.size(), 1U);
}

// Damaged files: any answer will do but a crash, a hang or bad_alloc. Sanitizers look on in the asan preset.
TEST_F(MeshFile, DamagedFilesNeverCrash) {
    const std::vector<std::pair<std::string, std::string>> seeds{
        {"f.obj", box_obj},         {"f.ply", box_ply("ascii")}, {"g.ply", box_ply("binary_little_endian")},
        {"f.stl", box_stl_ascii()}, {"g.stl", box_stl_binary()}, {"h.ply", box_ply("binary_big_endian")},
        {"f.glb", box_glb()}};
    std::uint32_t dimension = 0;
    const auto random = [&](std::size_t n) {
        return static_cast<std::size_t>(random_unit({11, 0, 0, 0}, dimension++) * static_cast<double>(n));
    };
    for (const auto& [name, sound] : seeds) {
        int accepted = 0;
        for (int trial = 0; trial < 150; ++trial) {
            std::string damaged = sound;
            for (std::size_t hits = 1 + random(4); hits > 0; --hits) {
                const std::size_t at = random(damaged.size());
                switch (random(4)) {
                    case 0:
                        damaged[at] = static_cast<char>(random(256));
                        break;
                    case 1:
                        damaged.resize(at + 1);
                        break;
                    case 2:
                        damaged.erase(at, 1 + random(8));
                        break;
                    default:
                        damaged.insert(at, damaged.substr(random(damaged.size()), 1 + random(16)));
                }
            }
            accepted += static_cast<bool>(load(name, damaged));
        }
        EXPECT_LT(accepted, 150) << name << ": damage is never noticed";
    }
}

}  // namespace
}  // namespace pol
