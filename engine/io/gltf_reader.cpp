// SPDX-License-Identifier: Apache-2.0
// glTF 2.0 and GLB: the triangles of the default scene, node transforms applied. Materials and images are not read.
#include <tiny_gltf.h>

#include <cmath>
#include <exception>
#include <glm/matrix.hpp>
#include <string>

#include "io/polygon_soup.h"

namespace pol {
namespace {

Error bad(const std::string& what) {
    return mesh_error(what, 0, "check the file with a glTF validator");
}

// One accessor's elements inside its buffer: bounds are checked once, here.
struct View {
    std::string_view bytes;
    std::size_t start = 0, stride = 0, count = 0;
};

Result<View> view_of(const tinygltf::Model& model, int index, int type, std::size_t element_size) {
    if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size()) return bad("no such accessor");
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    const std::string name = "accessor " + std::to_string(index);
    if (accessor.type != type || accessor.sparse.isSparse) return bad(name + " has a form that is not supported");
    if (accessor.bufferView < 0 || static_cast<std::size_t>(accessor.bufferView) >= model.bufferViews.size()) {
        return bad(name + " has no data");
    }
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size()) {
        return bad(name + " names a buffer that is not there");
    }
    const std::vector<unsigned char>& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    const std::size_t stride = view.byteStride != 0 ? view.byteStride : element_size;
    // Each term is below the size of the data before they are added: nothing overflows.
    const std::size_t size = data.size();
    const bool fits = view.byteOffset <= size && view.byteLength <= size - view.byteOffset &&
                      accessor.byteOffset <= view.byteLength && stride >= element_size && stride <= 65536 &&
                      (accessor.count == 0 ||
                       (element_size <= view.byteLength - accessor.byteOffset &&
                        accessor.count - 1 <= (view.byteLength - accessor.byteOffset - element_size) / stride));
    if (!fits) return bad(name + " reaches beyond its buffer");
    return View{{reinterpret_cast<const char*>(data.data()), size},
                view.byteOffset + accessor.byteOffset,
                stride,
                accessor.count};
}

DMat4 matrix_of(const tinygltf::Node& node) {
    DMat4 m(1.0);
    if (node.matrix.size() == 16) {
        for (int c = 0; c < 4; ++c) {
            for (int r = 0; r < 4; ++r) m[c][r] = node.matrix[static_cast<std::size_t>(4 * c + r)];
        }
        return m;
    }
    if (node.rotation.size() == 4) {
        const double x = node.rotation[0];
        const double y = node.rotation[1];
        const double z = node.rotation[2];
        const double w = node.rotation[3];
        m[0] = {1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y), 0.0};
        m[1] = {2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x), 0.0};
        m[2] = {2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y), 0.0};
    }
    if (node.scale.size() == 3) {
        for (int c = 0; c < 3; ++c) m[c] *= node.scale[static_cast<std::size_t>(c)];
    }
    if (node.translation.size() == 3) m[3] = {node.translation[0], node.translation[1], node.translation[2], 1.0};
    return m;
}

std::optional<Error> add_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                   const DMat4& to_world, PolygonSoup& soup) {
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != -1) {
        return bad("only plain triangles are supported, not strips, fans, lines or points");
    }
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) return bad("a primitive has no POSITION");
    const Result<View> points = view_of(model, position->second, TINYGLTF_TYPE_VEC3, 12);
    if (!points) return points.error();
    const View& p = points.value();
    if (model.accessors[static_cast<std::size_t>(position->second)].componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
        return bad("positions must be floats");
    }
    if (p.count > 3 * most_triangles || soup.vertices.size() > 3 * most_triangles) {
        return mesh_error("more than 30 million vertices", 0, "simplify the model");
    }
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (std::size_t i = 0; i < p.count; ++i) {
        DVec3 point(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            point[axis] = static_cast<double>(number_at<float>(
                p.bytes, p.start + i * p.stride + 4 * static_cast<std::size_t>(axis), std::endian::little));
        }
        soup.vertices.push_back(DMat3(to_world) * point + DVec3(to_world[3]));
    }

    std::vector<std::uint32_t> corners;
    if (primitive.indices < 0) {
        for (std::size_t i = 0; i < p.count; ++i) corners.push_back(static_cast<std::uint32_t>(i));
    } else {
        if (static_cast<std::size_t>(primitive.indices) >= model.accessors.size()) return bad("no such accessor");
        const int type = model.accessors[static_cast<std::size_t>(primitive.indices)].componentType;
        const std::size_t size = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? 1
                                 : type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 2
                                 : type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT   ? 4
                                                                                  : 0;
        if (size == 0) return bad("indices must be unsigned bytes, shorts or ints");
        const Result<View> indices = view_of(model, primitive.indices, TINYGLTF_TYPE_SCALAR, size);
        if (!indices) return indices.error();
        const View& v = indices.value();
        for (std::size_t i = 0; i < v.count; ++i) {
            const std::size_t at = v.start + i * v.stride;
            std::uint32_t index = 0;
            if (size == 1) index = number_at<std::uint8_t>(v.bytes, at, std::endian::little);
            if (size == 2) index = number_at<std::uint16_t>(v.bytes, at, std::endian::little);
            if (size == 4) index = number_at<std::uint32_t>(v.bytes, at, std::endian::little);
            if (index >= p.count) {
                return bad("index " + std::to_string(i) + " names vertex " + std::to_string(index) + " of " +
                           std::to_string(p.count));
            }
            corners.push_back(index);
        }
    }
    if (corners.size() % 3 != 0) return bad("the number of indices is not a multiple of 3");
    if (soup.corners.size() + corners.size() > 3 * most_triangles) {
        return mesh_error("more than 10 million triangles", 0, "simplify the model");
    }
    // glTF 2.0, 3.7.4: a mirroring transform turns the sense of rotation round.
    const bool mirrored = glm::determinant(DMat3(to_world)) < 0.0;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        soup.corners.push_back(first + corners[i]);
        soup.corners.push_back(first + corners[mirrored ? i + 2 : i + 1]);
        soup.corners.push_back(first + corners[mirrored ? i + 1 : i + 2]);
        soup.last.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    }
    return std::nullopt;
}

std::optional<Error> add_node(const tinygltf::Model& model, int index, const DMat4& parent, std::size_t depth,
                              std::size_t& visited, PolygonSoup& soup) {
    if (index < 0 || static_cast<std::size_t>(index) >= model.nodes.size()) return bad("no such node");
    // Nodes form trees: more visits than nodes means a loop or a shared child.
    if (++visited > model.nodes.size() || depth > 1000) return bad("the nodes do not form a tree");
    const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(index)];
    const DMat4 to_world = parent * matrix_of(node);
    if (node.mesh >= 0) {
        if (static_cast<std::size_t>(node.mesh) >= model.meshes.size()) return bad("no such mesh");
        for (const tinygltf::Primitive& primitive : model.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
            if (auto problem = add_primitive(model, primitive, to_world, soup)) return problem;
        }
    }
    for (const int child : node.children) {
        if (auto problem = add_node(model, child, to_world, depth + 1, visited, soup)) return problem;
    }
    return std::nullopt;
}

bool ignore_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
    return true;
}

}  // namespace

Result<PolygonSoup> read_gltf(std::string_view bytes, const std::filesystem::path& folder) {
    try {
        if (bytes.size() > 0xffffffffU) return mesh_error("the file is larger than 4 GiB", 0, "simplify the model");
        tinygltf::TinyGLTF loader;
        loader.SetImageLoader(ignore_image, nullptr);
        tinygltf::Model model;
        std::string error;
        std::string warning;
        const auto size = static_cast<unsigned>(bytes.size());
        const bool loaded =
            bytes.substr(0, 4) == "glTF"
                ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                              reinterpret_cast<const unsigned char*>(bytes.data()), size,
                                              folder.string())
                : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, folder.string());
        if (!loaded) return bad("not a valid glTF file: " + error.substr(0, error.find('\n')));
        PolygonSoup soup;
        std::size_t visited = 0;
        const int scene = model.defaultScene >= 0 ? model.defaultScene : 0;
        if (static_cast<std::size_t>(scene) >= model.scenes.size()) return bad("the file has no scene");
        for (const int node : model.scenes[static_cast<std::size_t>(scene)].nodes) {
            if (auto problem = add_node(model, node, DMat4(1.0), 0, visited, soup)) return *problem;
        }
        return soup;
    } catch (const std::exception& problem) {
        return bad(std::string("not a valid glTF file: ") + problem.what());
    }
}

}  // namespace pol
