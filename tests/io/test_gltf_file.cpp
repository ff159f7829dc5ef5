// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "geometry/mesh_check.h"
#include "io/mesh_files.h"

namespace pol {
namespace {

using test::append;
using test::area_from_above;
using test::box_glb;
using test::glb;
using GltfFile = test::MeshFile;

// A GLB of the cube from 0 to 1, all of whose parts can be said otherwise: its corners as `T` with 1 as `one`, every 3
// numbers followed by `padding` others; the rest of the JSON objects of the accessor of positions, the node and the
// file. Two more views hold the numbers of all corners (bytes) and corners of twice the length in x.
template <class T>
struct CubeFile {
    T one{1};
    int component_type = 5126;
    std::size_t padding = 0;
    std::string accessor{}, node{}, file = R"("scene":0,"scenes":[{"nodes":[0]}])", nodes_after{}, primitive{};

    std::string bytes() const {
        std::string binary;
        for (int v = 0; v < 8; ++v) {
            for (int axis = 0; axis < 3; ++axis) append(binary, (v >> axis & 1) != 0 ? one : T{});
            for (std::size_t i = 0; i < padding; ++i) append(binary, T{});
        }
        const std::size_t stride = (3 + padding) * sizeof(T);
        const std::uint8_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        for (const auto& f : faces) binary += {char(f[0]), char(f[1]), char(f[2]), char(f[0]), char(f[2]), char(f[3])};
        for (char v = 0; v < 8; ++v) binary += v;
        for (int v = 0; v < 8; ++v) {
            for (int axis = 0; axis < 3; ++axis)
                append(binary, (v >> axis & 1) == 0 ? T{} : axis == 0 ? static_cast<T>(2) : one);
        }
        const auto text = [](std::size_t number) { return std::to_string(number); };
        return glb(R"({"asset":{"version":"2.0"},)" + file + R"(,"nodes":[{"mesh":0)" + node + "}" + nodes_after +
                       R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1)" + primitive +
                       R"(}]}],"buffers":[{"byteLength":)" + text(binary.size()) +
                       R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + text(8 * stride) + R"(,"byteStride":)" +
                       text(stride) + R"(},{"buffer":0,"byteOffset":)" + text(8 * stride) +
                       R"(,"byteLength":36},{"buffer":0,"byteOffset":)" + text(8 * stride + 36) +
                       R"(,"byteLength":8},{"buffer":0,"byteOffset":)" + text(8 * stride + 44) + R"(,"byteLength":)" +
                       text(24 * sizeof(T)) +
                       R"(}],"accessors":[{"bufferView":0,"count":8,"type":"VEC3","componentType":)" +
                       std::to_string(component_type) + accessor +
                       R"(},{"bufferView":1,"componentType":5121,"count":36,"type":"SCALAR"}]})",
                   binary);
    }
};

void expect_cube(const Result<Mesh>& mesh, double low, double high) {
    ASSERT_TRUE(mesh) << to_string(mesh.error());
    EXPECT_TRUE(check_closed(mesh.value()));
    EXPECT_EQ(mesh.value().vertices.size(), 8U);
    for (const DVec3& p : mesh.value().vertices) {
        for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(p[axis] == low || p[axis] == high) << p[axis];
    }
}

TEST_F(GltfFile, NodesMoveMirrorAndScale) {
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

// KHR_mesh_quantization: integers, which stand for themselves or, normalized, for c / (the largest) and no less than
// -1.
TEST_F(GltfFile, QuantizedPositionsAreTheNumbersThatTheyStandFor) {
    const std::string used = R"("extensionsRequired":["KHR_mesh_quantization"],"scene":0,"scenes":[{"nodes":[0]}])";
    const std::string normalized = R"(,"normalized":true)";
    expect_cube(load("a.glb", CubeFile<std::int16_t>{32767, 5122, 1, normalized, "", used}.bytes()), 0.0, 1.0);
    expect_cube(load("a.glb", CubeFile<std::uint16_t>{65535, 5123, 1, normalized, R"(,"scale":[2,2,2])", used}.bytes()),
                0.0, 2.0);
    expect_cube(
        load("a.glb", CubeFile<std::int8_t>{127, 5120, 1, normalized, R"(,"translation":[3,3,3])", used}.bytes()), 3.0,
        4.0);
    expect_cube(load("a.glb", CubeFile<std::uint8_t>{255, 5121, 1, normalized, "", used}.bytes()), 0.0, 1.0);
    expect_cube(load("a.glb", CubeFile<std::uint8_t>{200, 5121, 1, "", "", used}.bytes()), 0.0, 200.0);
    expect_cube(load("a.glb", CubeFile<std::int16_t>{300, 5122, 1, "", "", used}.bytes()), 0.0, 300.0);
    // Floats stand for themselves, whatever the flag says.
    const auto floats = load("a.glb", CubeFile<float>{-2.0F, 5126, 1, normalized}.bytes());
    ASSERT_TRUE(floats);
    for (const DVec3& p : floats.value().vertices) EXPECT_TRUE(p.x == 0.0 || p.x == -2.0) << p.x;
    const auto least = load("a.glb", CubeFile<std::int16_t>{-32768, 5122, 1, normalized, "", used}.bytes());
    ASSERT_TRUE(least);
    for (const DVec3& p : least.value().vertices) EXPECT_TRUE(p.x == 0.0 || p.x == -1.0) << p.x;
    EXPECT_NE(complaint("a.glb", CubeFile<std::int32_t>{1, 5124}.bytes()).find("accessor 0 has a type that positions"),
              std::string::npos);
}

TEST_F(GltfFile, PositionsMayBeInterleavedWithOtherNumbers) {
    expect_cube(load("a.glb", CubeFile<float>{1.0F, 5126, 5}.bytes()), 0.0, 1.0);
}

// Corners 4 to 7, or all, become twice as long in x: a frustum of volume 1 x (1 + 2) / 2, or a box of volume 2.
TEST_F(GltfFile, SparseAccessorsReplaceWhatTheyName) {
    const auto sparse = [](int count, int first, int type) {
        return R"(,"sparse":{"count":)" + std::to_string(count) + R"(,"indices":{"bufferView":2,"byteOffset":)" +
               std::to_string(first) + R"(,"componentType":)" + std::to_string(type) +
               R"(},"values":{"bufferView":3,"byteOffset":)" + std::to_string(12 * first) + "}}";
    };
    CubeFile<float> cube;
    cube.accessor = sparse(4, 4, 5121);
    const auto frustum = load("a.glb", cube.bytes());
    ASSERT_TRUE(frustum) << to_string(frustum.error());
    EXPECT_TRUE(check_closed(frustum.value()));
    EXPECT_NEAR(signed_volume(frustum.value()), 1.5, 1e-15);

    cube.accessor = sparse(8, 0, 5121);
    std::string from_nothing = cube.bytes();
    const std::string base = R"("bufferView":0,"count":8)";
    from_nothing.replace(from_nothing.find(base), base.size(), R"(               "count":8)");
    for (const auto& box : {load("a.glb", cube.bytes()), load("a.glb", from_nothing)}) {
        ASSERT_TRUE(box) << to_string(box.error());
        EXPECT_TRUE(check_closed(box.value()));
        EXPECT_NEAR(signed_volume(box.value()), 2.0, 1e-15);
    }

    const auto expect = [&](const std::string& accessor, const std::string& what) {
        cube.accessor = accessor;
        const std::string text = complaint("a.glb", cube.bytes());
        EXPECT_NE(text.find("accessor 0 " + what), std::string::npos) << text;
    };
    expect(sparse(8, 1, 5121), "reaches beyond its buffer");
    expect(sparse(1, 0, 5123), "has a sparse element beyond its end");  // 0 and 1 read as one number: 256
    // Newer versions of the library refuse these themselves.
    for (const std::string& negative : {sparse(-1, 0, 5121), sparse(1, -1, 5121)}) {
        cube.accessor = negative;
        EXPECT_NE(complaint("a.glb", cube.bytes()), "");
    }
    expect(sparse(1, 0, 5126), "has a broken sparse part");
    // The indices of the faces begin 0 2 3 0.
    expect(R"(,"sparse":{"count":4,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":3}})",
           "has sparse elements that do not ascend");
    std::string endless = from_nothing;
    endless.replace(endless.find(R"("count":8)"), 9, R"("count":9999)");
    EXPECT_NE(complaint("a.glb", endless), "");
}

TEST_F(GltfFile, WithoutADefaultSceneShowsItsFirstAndWithoutScenesItsRootNodes) {
    CubeFile<float> cube;
    cube.nodes_after = R"(,{"mesh":0,"translation":[5,5,5]})";
    cube.file = R"("scenes":[{"nodes":[1]},{"nodes":[0]}])";
    expect_cube(load("a.glb", cube.bytes()), 5.0, 6.0);
    cube.file = R"("extensionsUsed":[])";
    cube.nodes_after = R"(,{"children":[0],"translation":[5,5,5]})";
    expect_cube(load("a.glb", cube.bytes()), 5.0, 6.0);
    cube.file = R"("scene":1,"scenes":[{"nodes":[0]}])";
    EXPECT_NE(complaint("a.glb", cube.bytes()).find("the default scene is not in the file"), std::string::npos);
    cube.file = R"("scenes":[])";
    cube.nodes_after = "";
    cube.node = R"(,"children":[0])";
    EXPECT_NE(complaint("a.glb", cube.bytes()).find("the file has no nodes"), std::string::npos);
}

TEST_F(GltfFile, ThatWouldHaveAnotherShapeIsRefusedByName) {
    const auto expect = [&](const CubeFile<float>& cube, const std::string& what) {
        const std::string text = complaint("a.glb", cube.bytes());
        EXPECT_NE(text.find(what), std::string::npos) << text;
    };
    const std::string scene = R"(,"scene":0,"scenes":[{"nodes":[0]}])";
    CubeFile<float> cube;
    for (const std::string name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "X_unheard_of"}) {
        cube.file = R"("extensionsRequired":[")" + name + R"("])" + scene;
        expect(cube, "the file needs the extension " + name + ", which is not supported");
    }
    cube.file = R"("extensionsRequired":["KHR_materials_unlit","KHR_texture_transform"])" + scene;
    expect_cube(load("a.glb", cube.bytes()), 0.0, 1.0);
    // A buffer that only its extension can fill: the extension is named, not the buffer.
    EXPECT_NE(complaint("a.gltf", R"({"asset":{"version":"2.0"},"extensionsRequired":["EXT_meshopt_compression"],)"
                                  R"("buffers":[{"byteLength":10}]})")
                  .find("needs the extension EXT_meshopt_compression"),
              std::string::npos);
    EXPECT_NE(complaint("a.gltf", R"({"asset":{"version":"1.0"},"scene":"s","scenes":{"s":{"nodes":["n"]}}})")
                  .find("the file is glTF 1.0, which is not supported"),
              std::string::npos);

    expect({.node = R"(,"name":"arm","skin":0)"}, "node 'arm' has a skin");
    expect({.node = R"(,"name":"face","weights":[0,0.5])"}, "node 'face' is bent by morph targets");
    expect_cube(load("a.glb", CubeFile<float>{.node = R"(,"weights":[0,0])"}.bytes()), 0.0, 1.0);
    expect({.node = R"(,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{}}})"},
           "has the extension EXT_mesh_gpu_instancing");
    expect({.primitive = R"(,"mode":9)"}, "unknown mode 9");
}

TEST_F(GltfFile, TransformsThatAreNoneAreRefused) {
    const auto expect = [&](const std::string& node, const std::string& what) {
        const std::string text = complaint("a.glb", CubeFile<float>{.node = R"(,"name":"n",)" + node}.bytes());
        EXPECT_NE(text.find(what), std::string::npos) << text;
    };
    expect(R"("matrix":[1,0,0,5, 0,1,0,5, 0,0,1,5, 0,0,0,1])", "the matrix of node 'n' is not by columns");
    expect(R"("matrix":[1,0,0, 0,1,0, 0,0,1])", "the transform of node 'n' has the wrong number of numbers");
    expect(R"("scale":[2])", "the transform of node 'n' has the wrong number of numbers");
    expect(R"("rotation":[0,0,0,0])", "the rotation of node 'n' is zero");
    // A quarter turn about z, not of unit length: nothing is scaled. cos of 90 degrees is within 3e-16 of 0.
    const auto turned = load("a.glb", CubeFile<float>{.node = R"(,"rotation":[0,0,2,2])"}.bytes());
    ASSERT_TRUE(turned);
    EXPECT_NEAR(signed_volume(turned.value()), 1.0, 1e-15);
    EXPECT_NEAR(turned.value().vertices[1].y, 1.0, 1e-15);
}

// Faces abc, bdc, cda, dba of a corner of the unit cube.
TEST_F(GltfFile, StripsAndFansMakeTheTrianglesOfTheSpecification) {
    std::string binary;
    for (const int x : {0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1}) append(binary, static_cast<float>(x));
    const auto tetrahedron = [&](const std::string& primitives, const std::string& indices) {
        std::string views;
        std::string accessors;
        std::string all = binary;
        for (std::size_t begin = 0; begin < indices.size();) {
            const std::size_t end = std::min(indices.find(' ', begin), indices.size());
            views += R"(,{"buffer":0,"byteOffset":)" + std::to_string(all.size()) + R"(,"byteLength":)" +
                     std::to_string(end - begin) + "}";
            accessors += R"(,{"bufferView":)" +
                         std::to_string(1 + std::count(accessors.begin(), accessors.end(), '{')) +
                         R"(,"componentType":5121,"type":"SCALAR","count":)" + std::to_string(end - begin) + "}";
            for (; begin < end; ++begin) all += static_cast<char>(indices[begin] - 'a');
            begin = end + 1;
        }
        return load("a.glb", glb(R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[)" +
                                     primitives + R"(]}],"buffers":[{"byteLength":)" + std::to_string(all.size()) +
                                     R"(}],"bufferViews":[{"buffer":0,"byteLength":48})" + views +
                                     R"(],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})" +
                                     accessors + "]}",
                                 all));
    };
    const auto primitive = [](int mode, int indices) {
        return R"({"attributes":{"POSITION":0},"mode":)" + std::to_string(mode) + R"(,"indices":)" +
               std::to_string(indices) + "}";
    };
    for (const auto& mesh :
         {tetrahedron(primitive(5, 1), "abcdab"),
          tetrahedron(primitive(5, 1), "abcdabbb"),  // ended by triangles without area, as strips are tied together
          tetrahedron(primitive(6, 1) + "," + primitive(4, 2), "dcbac abc"),
          tetrahedron(primitive(4, 1) + "," + primitive(1, 2) + "," + primitive(0, 2), "abcbdccdadba abcd")}) {
        ASSERT_TRUE(mesh) << to_string(mesh.error());
        EXPECT_EQ(mesh.value().triangles.size(), 4U);
        EXPECT_TRUE(check_closed(mesh.value()));
        EXPECT_NEAR(signed_volume(mesh.value()), 1.0 / 6.0, 1e-16);
    }
}

// A buffer as base64 in a text file, after a byte order mark; and in a file whose name has a blank.
TEST_F(GltfFile, BuffersMayLieInTheTextAndInFilesOfAnyName) {
    const std::string before = R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
                               R"({"attributes":{"POSITION":0}}]}],"buffers":[{"byteLength":36,"uri":")";
    const std::string after = R"("}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
                              R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}]})";
    std::string binary;
    for (const int x : {0, 0, 0, 1, 0, 0, 0, 1, 0}) append(binary, static_cast<float>(x));
    std::ofstream(folder_ / "one triangle.bin", std::ios::binary) << binary;
    const std::string base64 = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    for (const std::string& text : {before + "data:application/octet-stream;base64," + base64 + after,
                                    "\xef\xbb\xbf" + before + "one%20triangle.bin" + after}) {
        const auto mesh = load("a.gltf", text);
        ASSERT_TRUE(mesh) << to_string(mesh.error());
        EXPECT_EQ(area_from_above(mesh.value()), 0.5);
    }
}

}  // namespace
}  // namespace pol
