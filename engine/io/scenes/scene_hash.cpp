// SPDX-License-Identifier: Apache-2.0
#include "io/scenes/scene_hash.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <bit>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/overloaded.h"
#include "io/scenes/scene_file.h"
#include "scene/medium_fields.h"

namespace pol {
namespace {

/// To be changed whenever a scene that did not change gets another hash: by another function, or as save_scene() writes
/// it otherwise. A test holds a hash against this. Before it there were 32 digits without a mark.
constexpr std::string_view version_mark = "v4:";

// Numbers are hashed as they lie in memory.
static_assert(std::endian::native == std::endian::little, "hashes are to be equal on all machines");

std::string hex_digest(const void* bytes, std::size_t count) {
    XXH128_canonical_t canonical{};
    XXH128_canonicalFromHash(&canonical, XXH3_128bits(bytes, count));
    std::string text;
    for (const unsigned char byte : canonical.digest) text += fmt::format("{:02x}", byte);
    return text;
}

template <class Item>
std::string digest_of(const std::vector<Item>& items) {
    static_assert(std::is_trivially_copyable_v<Item>);
    return std::to_string(items.size()) + ":" + hex_digest(items.data(), items.size() * sizeof(Item));
}

std::string digest_of(const RgbImage& image) {
    return fmt::format("{}x{}:{}", image.width, image.height, digest_of(image.rgb));
}

std::string digest_of(const Mesh& mesh) {
    return digest_of(mesh.vertices) + ":" + digest_of(mesh.triangles);
}

void forget_record_name(RefractiveIndex& index) {
    std::visit(Overloaded{[](ConstantIndex&) {}, [](DispersiveIndex& dispersive) { dispersive.name.clear(); }}, index);
}

void forget_record_names(Matter& matter) {
    for_each_field(matter, Overloaded{[](const auto&, RefractiveIndex& index) { forget_record_name(index); },
                                      [](const auto&, const Absorption&) {}, [](const auto&, const DVec3&) {},
                                      [](const auto&, AxisSpace) {}});
}

}  // namespace

std::string scene_hash(const Scene& scene) {
    // The canonical dump is the saved scene with contents in place of the names of files.
    Scene content = scene;
    content.title.clear();
    for (Medium& medium : content.media) forget_record_names(medium.matter);
    for (Object& object : content.objects) {
        if (auto* shape = std::get_if<MeshShape>(&object.shape))
            shape->path = shape->mesh ? digest_of(*shape->mesh) : "";
        if (auto* emission = std::get_if<Emission>(&object.role)) {
            auto* textured = std::get_if<TexturedRadiance>(&emission->radiance);
            if (textured != nullptr) textured->path = textured->image ? digest_of(*textured->image) : "";
        }
    }
    const std::string dump = save_scene(content);
    return std::string(version_mark) + hex_digest(dump.data(), dump.size());
}

bool is_comparable_hash(const std::string& hash) {
    return hash.starts_with(version_mark);
}

}  // namespace pol
