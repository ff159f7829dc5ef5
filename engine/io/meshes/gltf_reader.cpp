// SPDX-License-Identifier: Apache-2.0
// glTF 2.0 and GLB: the triangles of the default scene, node transforms applied. Materials and images are not read;
// what would give the surfaces another shape (skins, morph targets, compression) is refused by name.
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <glm/matrix.hpp>
#include <span>
#include <string>
#include <utility>

#include "core/result.h"
#include "io/meshes/polygon_soup.h"

namespace pol {
namespace {

Error bad(const std::string& what) {
    return mesh_error(what, 0, "check the file with a glTF validator");
}

Error unsupported(const std::string& what, std::string hint) {
    return mesh_error(what + ", which is not supported", 0, std::move(hint));
}

// Elements inside a buffer: bounds are checked once, here.
struct View {
    std::string_view bytes;
    std::size_t start = 0, stride = 0;
};

Result<View> view_of(const tinygltf::Model& model, int index, std::size_t offset, std::size_t count,
                     std::size_t element_size, const std::string& name) {
    if (index < 0 || static_cast<std::size_t>(index) >= model.bufferViews.size()) return bad(name + " has no data");
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(index)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size()) {
        return bad(name + " names a buffer that is not there");
    }
    const std::vector<unsigned char>& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    const std::size_t stride = view.byteStride != 0 ? view.byteStride : element_size;
    // Each term is below the size of the data before they are added: nothing overflows.
    const std::size_t size = data.size();
    const bool fits = view.byteOffset <= size && view.byteLength <= size - view.byteOffset &&
                      offset <= view.byteLength && stride >= element_size && stride <= 65536 &&
                      (count == 0 || (element_size <= view.byteLength - offset &&
                                      count - 1 <= (view.byteLength - offset - element_size) / stride));
    if (!fits) return bad(name + " reaches beyond its buffer");
    return View{{reinterpret_cast<const char*>(data.data()), size}, view.byteOffset + offset, stride};
}

struct Component {
    int type;
    std::size_t size;
    double scale;  // of normalized integers: c / scale, from -1 on (glTF 2.0, 3.11)
    double (*read)(std::string_view bytes, std::size_t at);
};

template <class T>
double read_as(std::string_view bytes, std::size_t at) {
    return static_cast<double>(number_at<T>(bytes, at, std::endian::little));
}

constexpr Component index_types[] = {{TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, 1, 1.0, read_as<std::uint8_t>},
                                     {TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, 2, 1.0, read_as<std::uint16_t>},
                                     {TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, 4, 1.0, read_as<std::uint32_t>}};
// The integers: KHR_mesh_quantization.
constexpr Component position_types[] = {{TINYGLTF_COMPONENT_TYPE_FLOAT, 4, 1.0, read_as<float>},
                                        {TINYGLTF_COMPONENT_TYPE_BYTE, 1, 127.0, read_as<std::int8_t>},
                                        {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, 1, 255.0, read_as<std::uint8_t>},
                                        {TINYGLTF_COMPONENT_TYPE_SHORT, 2, 32767.0, read_as<std::int16_t>},
                                        {TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, 2, 65535.0, read_as<std::uint16_t>}};

const Component* component_of(std::span<const Component> allowed, int type) {
    const auto found = std::find_if(allowed.begin(), allowed.end(), [&](const Component& c) { return c.type == type; });
    return found == allowed.end() ? nullptr : &*found;
}

// All numbers of an accessor of SCALAR (`parts` = 1) or VEC3 (3), element by element.
Result<std::vector<double>> read_accessor(const tinygltf::Model& model, int index, std::span<const Component> allowed,
                                          std::size_t parts) {
    if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size()) return bad("no such accessor");
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    const std::string name = "accessor " + std::to_string(index);
    const Component* component = component_of(allowed, accessor.componentType);
    if (accessor.type != (parts == 1 ? TINYGLTF_TYPE_SCALAR : TINYGLTF_TYPE_VEC3) || component == nullptr)
        return bad(name + " has a type that " + (parts == 1 ? "indices" : "positions") + " cannot have");
    if (accessor.count > 3 * most_triangles)
        return mesh_error("more than 10 million triangles", 0, "simplify the model");

    const std::size_t element_size = parts * component->size;
    const auto number = [&](const View& view, std::size_t element, std::size_t part) {
        const double c = component->read(view.bytes, view.start + element * view.stride + part * component->size);
        return accessor.normalized && component->scale != 1.0 ? std::max(c / component->scale, -1.0) : c;
    };
    std::vector<double> numbers;
    if (accessor.bufferView >= 0 || !accessor.sparse.isSparse) {
        const Result<View> view =
            view_of(model, accessor.bufferView, accessor.byteOffset, accessor.count, element_size, name);
        if (!view) return view.error();
        numbers.reserve(accessor.count * parts);
        for (std::size_t i = 0; i < accessor.count; ++i) {
            for (std::size_t part = 0; part < parts; ++part) numbers.push_back(number(view.value(), i, part));
        }
    } else {
        // Zeros but for the sparse ones. A file that uses them all names each in its bytes.
        std::size_t bytes = 0;
        for (const tinygltf::Buffer& buffer : model.buffers) bytes += buffer.data.size();
        if (accessor.count > bytes) return bad(name + " has more elements than the file has bytes");
        numbers.resize(accessor.count * parts);
    }
    if (!accessor.sparse.isSparse) return numbers;

    const auto& sparse = accessor.sparse;
    const Component* place = component_of(index_types, sparse.indices.componentType);
    const auto negative = [](auto n) { return static_cast<std::int64_t>(n) < 0; };  // int in old versions, then size_t
    if (place == nullptr || negative(sparse.count) || negative(sparse.indices.byteOffset) ||
        negative(sparse.values.byteOffset))
        return bad(name + " has a broken sparse part");
    const auto count = static_cast<std::size_t>(sparse.count);
    POL_TRY(const auto places, view_of(model, sparse.indices.bufferView,
                                       static_cast<std::size_t>(sparse.indices.byteOffset), count, place->size, name));
    POL_TRY(const auto values, view_of(model, sparse.values.bufferView,
                                       static_cast<std::size_t>(sparse.values.byteOffset), count, element_size, name));
    double before = -1.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double at = place->read(places.bytes, places.start + i * places.stride);
        if (!(at < static_cast<double>(accessor.count))) return bad(name + " has a sparse element beyond its end");
        if (!(at > before)) return bad(name + " has sparse elements that do not ascend");
        before = at;
        for (std::size_t part = 0; part < parts; ++part)
            numbers[static_cast<std::size_t>(at) * parts + part] = number(values, i, part);
    }
    return numbers;
}

Result<DMat4> matrix_of(const tinygltf::Node& node) {
    const auto has = [](const std::vector<double>& list, std::size_t size) {
        return list.empty() || list.size() == size;
    };
    if (!has(node.matrix, 16) || !has(node.rotation, 4) || !has(node.scale, 3) || !has(node.translation, 3))
        return bad("the transform of node '" + node.name + "' has the wrong number of numbers");
    DMat4 m(1.0);
    if (!node.matrix.empty()) {
        for (int c = 0; c < 4; ++c) {
            for (int r = 0; r < 4; ++r) m[c][r] = node.matrix[static_cast<std::size_t>(4 * c + r)];
        }
        if (m[0][3] != 0.0 || m[1][3] != 0.0 || m[2][3] != 0.0 || m[3][3] != 1.0)
            return bad("the matrix of node '" + node.name + "' is not by columns: the last row is not 0 0 0 1");
        return m;
    }
    if (!node.rotation.empty()) {
        const auto& q = node.rotation;
        const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        if (!(size > 0.0)) return bad("the rotation of node '" + node.name + "' is zero");
        const double x = q[0] / size;
        const double y = q[1] / size;
        const double z = q[2] / size;
        const double w = q[3] / size;
        m[0] = {1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y), 0.0};
        m[1] = {2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x), 0.0};
        m[2] = {2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y), 0.0};
    }
    if (!node.scale.empty()) {
        for (int c = 0; c < 3; ++c) m[c] *= node.scale[static_cast<std::size_t>(c)];
    }
    if (!node.translation.empty()) m[3] = {node.translation[0], node.translation[1], node.translation[2], 1.0};
    return m;
}

// Corners of all triangles, three by three (glTF 2.0, 3.7.2.1).
Result<std::vector<std::uint32_t>> triangle_corners(const tinygltf::Primitive& primitive,
                                                    const std::vector<std::uint32_t>& indices) {
    const std::size_t count = indices.size();
    std::vector<std::uint32_t> corners;
    switch (primitive.mode) {
        case TINYGLTF_MODE_TRIANGLES:
            if (count % 3 != 0) return bad("the number of indices is not a multiple of 3");
            return indices;
        case TINYGLTF_MODE_TRIANGLE_STRIP:
            for (std::size_t i = 0; i + 2 < count; ++i) {
                const std::array<std::uint32_t, 3> t{indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]};
                // Strips are tied together by triangles with the same corner twice.
                if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) corners.insert(corners.end(), t.begin(), t.end());
            }
            return corners;
        case TINYGLTF_MODE_TRIANGLE_FAN:
            for (std::size_t i = 0; i + 2 < count; ++i)
                corners.insert(corners.end(), {indices[i + 1], indices[i + 2], indices[0]});
            return corners;
        default:
            return bad("a primitive has the unknown mode " + std::to_string(primitive.mode));
    }
}

std::optional<Error> add_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                   const DMat4& to_world, PolygonSoup& soup) {
    for (const int no_surface :
         {TINYGLTF_MODE_POINTS, TINYGLTF_MODE_LINE, TINYGLTF_MODE_LINE_LOOP, TINYGLTF_MODE_LINE_STRIP}) {
        if (primitive.mode == no_surface) return std::nullopt;
    }
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) return bad("a primitive has no POSITION");
    POL_TRY(const auto points, read_accessor(model, position->second, position_types, 3));
    const std::size_t count = points.size() / 3;

    std::vector<std::uint32_t> indices;
    if (primitive.indices < 0) {
        for (std::size_t i = 0; i < count; ++i) indices.push_back(static_cast<std::uint32_t>(i));
    } else {
        POL_TRY(const auto given, read_accessor(model, primitive.indices, index_types, 1));
        for (const double index : given) {
            if (!(index < static_cast<double>(count))) {
                return bad("index " + std::to_string(indices.size()) + " names vertex " +
                           std::to_string(static_cast<std::uint32_t>(index)) + " of " + std::to_string(count));
            }
            indices.push_back(static_cast<std::uint32_t>(index));
        }
    }
    POL_TRY(const auto corners, triangle_corners(primitive, indices));
    if (soup.corners.size() + corners.size() > 3 * most_triangles) {
        return mesh_error("more than 10 million triangles", 0, "simplify the model");
    }
    if (soup.vertices.size() + count > 3 * most_triangles) {
        return mesh_error("more than 30 million vertices", 0, "simplify the model");
    }
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (std::size_t i = 0; i < count; ++i) {
        const double* p = &points[3 * i];
        soup.vertices.push_back(DMat3(to_world) * DVec3(p[0], p[1], p[2]) + DVec3(to_world[3]));
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

// What would place or bend the meshes otherwise than their nodes do.
std::optional<Error> check_plain(const tinygltf::Node& node, const tinygltf::Mesh* mesh) {
    for (const char* name : {"EXT_mesh_gpu_instancing", "KHR_node_visibility"}) {
        if (node.extensions.count(name) > 0)
            return unsupported("node '" + node.name + "' has the extension " + name, "export the file without it");
    }
    if (mesh == nullptr) return std::nullopt;
    if (node.skin >= 0)
        return unsupported("node '" + node.name + "' has a skin", "apply the armature in a modeling program");
    for (const auto* weights : {&node.weights, &mesh->weights}) {
        if (std::any_of(weights->begin(), weights->end(), [](double w) { return w != 0.0; }))
            return unsupported("node '" + node.name + "' is bent by morph targets",
                               "apply the shape keys in a modeling program");
    }
    return std::nullopt;
}

std::optional<Error> add_node(const tinygltf::Model& model, int index, const DMat4& parent, std::size_t depth,
                              std::size_t& visited, PolygonSoup& soup) {
    if (index < 0 || static_cast<std::size_t>(index) >= model.nodes.size()) return bad("no such node");
    // Nodes form trees: more visits than nodes means a loop or a shared child.
    if (++visited > model.nodes.size() || depth > 1000) return bad("the nodes do not form a tree");
    const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(index)];
    POL_TRY(const auto own, matrix_of(node));
    const DMat4 to_world = parent * own;
    if (node.mesh >= static_cast<int>(model.meshes.size())) return bad("no such mesh");
    const tinygltf::Mesh* mesh = node.mesh < 0 ? nullptr : &model.meshes[static_cast<std::size_t>(node.mesh)];
    if (auto problem = check_plain(node, mesh)) return problem;
    if (mesh != nullptr) {
        for (const tinygltf::Primitive& primitive : mesh->primitives) {
            if (auto problem = add_primitive(model, primitive, to_world, soup)) return problem;
        }
    }
    for (const int child : node.children) {
        if (auto problem = add_node(model, child, to_world, depth + 1, visited, soup)) return problem;
    }
    return std::nullopt;
}

// Nodes of the default scene, else of the first; of a file without scenes, all that are nobody's child.
Result<std::vector<int>> root_nodes(const tinygltf::Model& model) {
    const std::size_t scene = model.defaultScene < 0 ? 0 : static_cast<std::size_t>(model.defaultScene);
    if (scene < model.scenes.size()) return model.scenes[scene].nodes;
    if (model.defaultScene >= 0) return bad("the default scene is not in the file");
    std::vector<bool> is_child(model.nodes.size());
    for (const tinygltf::Node& node : model.nodes) {
        for (const int child : node.children) {
            if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
                is_child[static_cast<std::size_t>(child)] = true;
        }
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    }
    if (roots.empty()) return bad("the file has no nodes, which place its meshes");
    return roots;
}

// An extension that must be known to read the shape. What paints, lights or moves a model need not.
std::optional<Error> check_extensions(const tinygltf::Model& model) {
    for (const std::string& name : model.extensionsRequired) {
        bool known = name == "KHR_mesh_quantization";
        for (const char* harmless : {"KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_lights_",
                                     "EXT_lights_", "KHR_animation_", "KHR_xmp"})
            known = known || name.starts_with(harmless);
        if (!known)
            return unsupported("the file needs the extension " + name.substr(0, 60),
                               "export it without compression or extensions");
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
        // First: without its extensions, a file can look broken.
        if (auto problem = check_extensions(model)) return *problem;
        if (!model.asset.version.empty() && !model.asset.version.starts_with("2."))
            return unsupported("the file is glTF " + model.asset.version.substr(0, 20), "convert it to glTF 2.0");
        if (!loaded) return bad("not a valid glTF file: " + error.substr(0, error.find('\n')));
        PolygonSoup soup;
        std::size_t visited = 0;
        POL_TRY(const auto roots, root_nodes(model));
        for (const int node : roots) {
            if (auto problem = add_node(model, node, DMat4(1.0), 0, visited, soup)) return *problem;
        }
        return soup;
    } catch (const std::exception& problem) {
        return bad(std::string("not a valid glTF file: ") + problem.what());
    }
}

}  // namespace pol
