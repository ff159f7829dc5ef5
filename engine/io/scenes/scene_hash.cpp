// SPDX-License-Identifier: Apache-2.0
#include "io/scenes/scene_hash.h"

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "core/overloaded.h"
#include "core/random.h"
#include "io/scenes/scene_file.h"
#include "scene/medium_fields.h"

namespace pol {
namespace {

/// Two independently keyed 64-bit streams over 8-byte words; mix_bits is a bijection, so every word changes both.
class Digest {
public:
    void add(std::uint64_t word) {
        low_ = mix_bits(low_ ^ word) + 0x9e3779b97f4a7c15ULL;
        high_ = mix_bits(high_ + word) ^ 0xd1b54a32d192ed03ULL;
        high_ = std::rotl(high_, 23) + low_;
    }
    void add(std::string_view bytes) {
        add(bytes.size());
        std::uint64_t word = 0;
        unsigned filled = 0;
        for (const char c : bytes) {
            word |= std::uint64_t{static_cast<unsigned char>(c)} << (8U * filled);
            if (++filled < 8) continue;
            add(word);
            word = 0;
            filled = 0;
        }
        add(word);
    }
    [[nodiscard]] std::string hex() const {
        constexpr std::string_view digits = "0123456789abcdef";
        std::string text;
        for (const std::uint64_t half : {mix_bits(high_), mix_bits(low_ ^ high_)}) {
            for (unsigned shift = 64; shift > 0; shift -= 4) text += digits[(half >> (shift - 4)) & 15U];
        }
        return text;
    }

private:
    std::uint64_t low_ = 0x243f6a8885a308d3ULL;
    std::uint64_t high_ = 0x13198a2e03707344ULL;
};

std::string digest_of(const RgbImage& image) {
    Digest digest;
    digest.add(static_cast<std::uint64_t>(image.width));
    digest.add(static_cast<std::uint64_t>(image.height));
    for (const float value : image.rgb) digest.add(std::uint64_t{std::bit_cast<std::uint32_t>(value)});
    return digest.hex();
}

std::string digest_of(const Mesh& mesh) {
    Digest digest;
    digest.add(mesh.vertices.size());
    for (const DVec3& vertex : mesh.vertices) {
        for (int i = 0; i < 3; ++i) digest.add(std::bit_cast<std::uint64_t>(vertex[i]));
    }
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) digest.add(std::uint64_t{corner});
    }
    return digest.hex();
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
    Digest digest;
    digest.add(save_scene(content));
    return digest.hex();
}

}  // namespace pol
