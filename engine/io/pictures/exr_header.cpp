// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/exr_header.h"

#include <ImfCompression.h>
#include <fmt/format.h>
#include <openexr.h>

#include <cstdint>
#include <fstream>
#include <string>
#include <utility>

namespace pol {
namespace {

/// What OpenEXR's C library finds wrong: it checks sizes against the file.
std::string library_complaint(const std::filesystem::path& path) {
    std::string complaint;
    exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
    settings.user_data = &complaint;
    settings.error_handler_fn = [](exr_const_context_t context, exr_result_t, const char* message) {
        void* target = nullptr;
        exr_get_user_data(context, &target);
        auto& first = *static_cast<std::string*>(target);
        if (first.empty()) first = message;
    };
    exr_context_t context = nullptr;
    if (exr_start_read(&context, path.c_str(), &settings) == EXR_ERR_SUCCESS) exr_finish(&context);
    return complaint;
}

std::uint32_t little_endian(std::istream& stream) {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(stream.get() & 0xff) << (8 * i);
    return value;
}

Error damage(const std::string& complaint) {
    return {ErrorKind::input, "is damaged or truncated: " + complaint, {}, {}, "copy or render it again"};
}

Error unknown_to_us(const std::string& what) {
    return {ErrorKind::input,
            what + ", which this program does not know",
            {},
            {},
            "write it as EXR version 2 with ZIP or PIZ compression"};
}

/// The C library takes a channel list and a deep image state for as long as their size says, the C++ library for as
/// long as their contents are. If these differ, the latter goes on in the middle of an attribute and takes what it
/// finds there for a size.
std::optional<Error> attribute_problem(std::istream& stream, bool has_parts) {
    constexpr std::streamoff channel_bytes = 16;  // after its name: type, linearity, sampling
    const auto read_word = [&stream](std::string& word) { return std::getline(stream, word, '\0') && !word.empty(); };
    int attributes = 0;
    do {
        attributes = 0;
        for (std::string name, type, channel; read_word(name); ++attributes) {
            read_word(type);
            const std::streamoff size = little_endian(stream);
            const std::streamoff end = stream.tellg() + size;
            if (type == "compression" && size == 1) {
                if (const int kind = stream.get(); kind >= Imf::NUM_COMPRESSION_METHODS)
                    return unknown_to_us(fmt::format("is stored with compression {}", kind));
            } else if (type == "chlist") {
                while (stream.tellg() <= end && read_word(channel)) stream.seekg(channel_bytes, std::ios::cur);
            } else {
                stream.seekg(type == "deepImageState" ? 1 : size, std::ios::cur);
            }
            if (stream.tellg() != end)
                return damage(fmt::format("Attribute '{}', type '{}': Invalid size {}", name, type, size));
        }
    } while (has_parts && attributes > 0);  // a header without attributes is behind the last
    return std::nullopt;
}

}  // namespace

std::optional<Error> exr_header_problem(const std::filesystem::path& path) {
    constexpr std::uint32_t known_flags = 0x1e00;  // tiled, long names, deep, parts
    constexpr std::uint32_t part_flag = 0x1000;
    std::ifstream stream(path, std::ios::binary);
    stream.seekg(4);
    const std::uint32_t version = little_endian(stream);
    if ((version & 0xffU) != 2 || (version & ~(known_flags | 0xffU)) != 0)
        return unknown_to_us(
            fmt::format("is an EXR file of version {} with flags {:#x}", version & 0xffU, version >> 8U));
    if (auto problem = attribute_problem(stream, (version & part_flag) != 0)) return problem;
    const std::string complaint = library_complaint(path);
    if (!complaint.empty()) return damage(complaint);
    return std::nullopt;
}

}  // namespace pol
