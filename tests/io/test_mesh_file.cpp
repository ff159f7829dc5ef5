// SPDX-License-Identifier: Apache-2.0
#include "io/meshes/mesh_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/random.h"
#include "geometry/half_space_solid.h"
#include "geometry/mesh_check.h"
#include "io/mesh_files.h"

namespace pol {
namespace {

using test::area_from_above;
using test::box_glb;
using test::box_obj;
using test::box_ply;
using test::box_stl_ascii;
using test::box_stl_binary;
using test::expect_box;
using test::glb;
using test::MeshFile;

TEST_F(MeshFile, OneBoxReadsTheSameFromEveryFormat) {
    expect_box(load("box.obj", box_obj));
    expect_box(load("ascii.ply", box_ply("ascii")));
    expect_box(load("little.ply", box_ply("binary_little_endian")));
    expect_box(load("BIG.PLY", box_ply("binary_big_endian")));
    expect_box(load("binary.stl", box_stl_binary()));
    expect_box(load("ascii.stl", box_stl_ascii()));
    expect_box(load("box.glb", box_glb()));
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
        {"f.obj", box_obj},
        {"f.ply", box_ply("ascii")},
        {"g.ply", box_ply("binary_little_endian")},
        {"f.stl", box_stl_ascii()},
        {"g.stl", box_stl_binary()},
        {"h.ply", box_ply("binary_big_endian")},
        {"f.glb", box_glb()},
        {"u.obj", "v 0 0 0\nv 3 0 0\nv 3 2.1 0\nv 2 2 0\nv 2.1 1 0\nv 0.9 1.1 0\nv 1 2.2 0\nf 1 2 3 4 5 \\\n 6 7\n"}};
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
