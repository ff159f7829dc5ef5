// SPDX-License-Identifier: Apache-2.0
// A file that appears whole or not at all: written under a temporary name in the same folder, synced, renamed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include "core/result.h"

namespace pol {

/// A file on its way to `path`. Until commit() the old file, if any, is untouched; a kill at any moment leaves the old
/// file or the new one, never a mixture. The temporary `.NAME.PID-N.tmp` of a killed program is removed by the next
/// program that writes to the same path.
class OutputFile {
public:
    /// Error (kind output): the folder is missing or not writable, or `path` is a folder, a device or a pipe. A
    /// symbolic link is followed.
    static Result<std::unique_ptr<OutputFile>> create(const std::filesystem::path& path);

    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    /// Removes the temporary file unless it was committed.
    ~OutputFile();

    /// False after a failed write; commit() then says why. Nothing has to be checked before commit().
    bool write(const void* bytes, std::size_t count);
    bool seek(std::uint64_t position);
    [[nodiscard]] std::uint64_t position() const { return position_; }
    /// False once a write has failed.
    [[nodiscard]] bool good() const;

    /// Flushes, syncs and moves the file to its place. Error (kind output) if any write failed (disk full).
    Result<Done> commit();

private:
    struct Stream;
    explicit OutputFile(std::unique_ptr<Stream> stream);

    std::unique_ptr<Stream> stream_;
    std::uint64_t position_ = 0;
};

/// Writes the whole file, or leaves the old one. Error as OutputFile.
Result<Done> write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace pol
