// SPDX-License-Identifier: Apache-2.0
// What the tests of arrays, photographs and FITS share.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "io/pictures/array_file.h"

namespace pol {

namespace fs = std::filesystem;

inline fs::path sample(const std::string& name) {
    return fs::path(POL_TESTS_DIR) / "data/pictures/stokes_dialects" / name;
}

inline std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline PictureSource source_of(const fs::path& path, const std::string& layout = {}) {
    PictureSource source;
    source.files = {path};
    source.layout = layout;
    return source;
}

inline void append_number(std::string& bytes, std::uint64_t number, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>(number >> 8 * i & 0xff);
}

/// An .npy of any header text, as the format lays it out.
inline std::string npy_of(const std::string& dict, const std::string& data, unsigned version = 1) {
    std::string bytes = "\x93NUMPY";
    append_number(bytes, version, 1);
    append_number(bytes, 0, 1);
    append_number(bytes, dict.size(), version == 1 ? 2 : 4);
    return bytes + dict + data;
}
inline std::string dict_of(const std::string& descr, const std::string& shape) {
    return "{'descr': '" + descr + "', 'fortran_order': False, 'shape': " + shape + ", }\n";
}
template <class Number>
std::string numbers_of(const std::vector<Number>& numbers) {
    std::string bytes(numbers.size() * sizeof(Number), '\0');
    if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

/// An empty folder of its own for each test.
class ArrayFile : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("polariscope-array-" + std::to_string(::getpid()));
        fs::remove_all(folder_);
        fs::create_directory(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] fs::path path(const std::string& name) const { return folder_ / name; }
    [[nodiscard]] fs::path write(const std::string& name, std::string_view bytes) const {
        std::ofstream(path(name), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return path(name);
    }
    /// The error of a file of these bytes, or "read".
    [[nodiscard]] std::string complaint(const std::string& name, std::string_view bytes,
                                        const std::string& layout = {}) const {
        const auto read = read_array_picture(source_of(write(name, bytes), layout));
        return read ? "read" : to_string(read.error());
    }

    fs::path folder_;
};

}  // namespace pol
