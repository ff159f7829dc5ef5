// SPDX-License-Identifier: Apache-2.0
#include "io/exr_header.h"

#include <fmt/format.h>
#include <openexr.h>

#include <cstdint>
#include <fstream>

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

/// The C library takes a channel list and a deep image state for as long as their size says, the C++ library for as
/// long as their contents are. If these differ, the latter goes on in the middle of an attribute and takes what it
/// finds there for a size.
std::string attribute_complaint(const std::filesystem::path& path) {
    constexpr std::streamoff channel_bytes = 16;  // after its name: type, linearity, sampling
    constexpr std::uint32_t has_parts = 0x1000;
    std::ifstream stream(path, std::ios::binary);
    stream.seekg(4);
    const bool parts = (little_endian(stream) & has_parts) != 0;
    const auto read_word = [&stream](std::string& word) { return std::getline(stream, word, '\0') && !word.empty(); };
    int attributes = 0;
    do {
        attributes = 0;
        for (std::string name, type, channel; read_word(name); ++attributes) {
            read_word(type);
            const std::streamoff size = little_endian(stream);
            const std::streamoff end = stream.tellg() + size;
            if (type == "chlist")
                while (stream.tellg() <= end && read_word(channel)) stream.seekg(channel_bytes, std::ios::cur);
            else
                stream.seekg(type == "deepImageState" ? 1 : size, std::ios::cur);
            if (stream.tellg() != end)
                return fmt::format("Attribute '{}', type '{}': Invalid size {}", name, type, size);
        }
    } while (parts && attributes > 0);  // a header without attributes is behind the last
    return {};
}

}  // namespace

std::string exr_header_complaint(const std::filesystem::path& path) {
    const std::string complaint = library_complaint(path);
    return complaint.empty() ? attribute_complaint(path) : complaint;
}

}  // namespace pol
