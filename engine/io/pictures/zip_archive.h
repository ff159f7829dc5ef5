// SPDX-License-Identifier: Apache-2.0
// ZIP archives as numpy writes them: entries stored or deflated, also with 64-bit sizes (APPNOTE.TXT 6.3.10).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"
#include "io/files/output_file.h"
#include "io/pictures/byte_source.h"

namespace pol {

struct ZipEntry {
    std::string name;
    std::uint16_t method = 0;       ///< 0 stored, 8 deflated
    std::uint32_t checksum = 0;     ///< CRC-32
    std::uint64_t packed = 0;       ///< bytes in the archive
    std::uint64_t unpacked = 0;     ///< bytes that they stand for
    std::uint64_t data_begins = 0;  ///< in the file
};

/// The entries in the order of the directory. Error (kind input, no place): no archive, damaged, encrypted, packed in
/// another way, in several volumes, an entry that promises more than its bytes can hold, or a name twice.
Result<std::vector<ZipEntry>> read_zip_directory(const std::filesystem::path& path);

/// What is in an entry; the last byte is not read if the checksum is wrong.
std::unique_ptr<ByteSource> open_zip_entry(const std::filesystem::path& path, const ZipEntry& entry);

/// Writes an archive of stored entries, one after the other.
class ZipWriter {
public:
    explicit ZipWriter(OutputFile& file) : file_(file) {}

    void begin_entry(const std::string& name);
    void write(const void* bytes, std::size_t count);
    void end_entry();
    /// Writes the directory; then the file may be committed.
    void finish();

private:
    OutputFile& file_;
    std::vector<ZipEntry> entries_;
    std::vector<std::uint64_t> headers_;  ///< where they begin
};

}  // namespace pol
