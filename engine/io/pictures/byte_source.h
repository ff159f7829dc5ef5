// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>

namespace pol {

/// Bytes that are read once, from front to back: those of a file, or of an entry of an archive.
class ByteSource {
public:
    ByteSource() = default;
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;
    virtual ~ByteSource() = default;

    /// Fills all of `target`. False: they end before that, cannot be read, or are not what their checksum says.
    virtual bool read(char* target, std::size_t count) = 0;
    /// How many are left.
    [[nodiscard]] virtual std::uint64_t left() const = 0;
};

/// Those of a file from `offset` on.
class FileBytes : public ByteSource {
public:
    FileBytes(const std::filesystem::path& path, std::uint64_t offset, std::uint64_t count)
        : stream_(path, std::ios::binary), left_(count) {
        stream_.seekg(static_cast<std::streamoff>(offset));
    }

    bool read(char* target, std::size_t count) override {
        if (count > left_) return false;
        left_ -= count;
        return static_cast<bool>(stream_.read(target, static_cast<std::streamsize>(count)));
    }
    [[nodiscard]] std::uint64_t left() const override { return left_; }

private:
    std::ifstream stream_;
    std::uint64_t left_;
};

}  // namespace pol
