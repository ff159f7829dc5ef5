// SPDX-License-Identifier: Apache-2.0
// One box, 1 x 2 x 3, in every format of mesh files, and the fixture that reads them.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "geometry/mesh_check.h"
#include "geometry/shapes.h"
#include "io/meshes/mesh_file.h"

namespace pol::test {

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

inline std::string reversed(std::string bytes) {
    return {bytes.rbegin(), bytes.rend()};
}

inline void expect_box(const Result<Mesh>& mesh) {
    ASSERT_TRUE(mesh) << to_string(mesh.error());
    EXPECT_TRUE(check_closed(mesh.value()));
    EXPECT_EQ(mesh.value().facets.size(), 6U);
    EXPECT_EQ(mesh.value().vertices.size(), 8U);
    // 1 x 2 x 3, coordinates exact in float.
    EXPECT_NEAR(signed_volume(mesh.value()), 6.0, 1e-14);
}

inline const char* const box_obj = R"(# a box
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

inline std::string box_ply(const std::string& format) {
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

inline std::string with_line_ends(const std::string& text, const char* end) {
    std::string result;
    for (const char c : text) result += c == '\n' ? end : std::string(1, c);
    return result;
}

inline std::vector<DVec3> box_corners() {
    std::vector<DVec3> corners;
    const Mesh mesh = make_mesh(BoxShape{{1.0, 2.0, 3.0}}).value();
    for (const auto& t : mesh.triangles) {
        for (const std::uint32_t v : t) corners.push_back(mesh.vertices[v]);
    }
    return corners;
}

inline std::string box_stl_binary() {
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

inline std::string box_stl_ascii() {
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

inline std::string glb(std::string json, std::string binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4);
    std::string glb = "glTF";
    append(glb, std::uint32_t{2});
    append(glb, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size()));
    append(glb, static_cast<std::uint32_t>(json.size()));
    glb += "JSON" + json;
    append(glb, static_cast<std::uint32_t>(binary.size()));
    glb += std::string("BIN\0", 4) + binary;
    return glb;
}

// A GLB of one box, under a parent that mirrors and a child that moves and scales.
inline std::string box_glb(const std::string& indices_extra = "") {
    std::string binary;
    const auto corners = box_corners();
    for (const DVec3& p : corners) {
        for (int axis = 0; axis < 3; ++axis) append(binary, static_cast<float>(p[axis] / 2.0));
    }
    for (std::uint16_t i = 0; i < 36; ++i) append(binary, i);
    return glb(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)"
               R"({"children":[1],"scale":[-1,1,1]},{"mesh":0,"scale":[2,2,2],"translation":[5,0,0]}],)"
               R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
               R"("buffers":[{"byteLength":504}],"bufferViews":[{"buffer":0,"byteLength":432},)"
               R"({"buffer":0,"byteOffset":432,"byteLength":72}],)"
               R"("accessors":[{"bufferView":0,"componentType":5126,"count":36,"type":"VEC3"},)"
               R"({"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR")" +
                   indices_extra + "}]}",
               binary);
}

// Unsigned areas of the triangles that look up: twice as much where triangles fold over each other's outline.
inline double area_from_above(const Mesh& mesh) {
    double area = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const DVec3 n = cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
        if (n.z > 0.0) area += 0.5 * n.z;
    }
    return area;
}

}  // namespace pol::test
