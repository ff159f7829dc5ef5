// SPDX-License-Identifier: Apache-2.0
// What libFuzzer hands over, as text or as a file with an ending.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace pol::test {

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// The bytes as a file of this process, rewritten at every call; the same name for the same `ending`.
inline std::filesystem::path as_file(std::string_view bytes, const std::string& ending) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("polariscope-fuzz-" + std::to_string(getpid()) + ending);
    std::ofstream(path, std::ios::binary | std::ios::trunc)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return path;
}

}  // namespace pol::test
