// SPDX-License-Identifier: Apache-2.0
// Notices that files were saved by another program: in place, or by renaming a new file over the old one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace pol {

/// Asks the file system for a few numbers per file; works on network drives too, and costs microseconds.
class FileWatch {
public:
    FileWatch() = default;
    /// Watches these files for changes from now on; a missing one is waited for.
    explicit FileWatch(const std::vector<std::filesystem::path>& files) { watch(files); }

    /// Watches these files instead; those that it watched before for changes since then. Call it after reading them,
    /// and no change is lost that was made meanwhile.
    void watch(const std::vector<std::filesystem::path>& files);

    /// True once for every change, when the files have come to rest: two calls at least `rest_s` apart saw the same,
    /// and all files that were there are there again. `now_s`: seconds of any clock that does not run backward.
    bool changed(double now_s);

    static constexpr double rest_s = 0.1;

private:
    /// Everything that a save changes. All 0: there is no such file.
    struct Mark {
        std::uint64_t inode = 0;
        std::int64_t size = 0;
        std::int64_t modified_ns = 0;
        friend bool operator==(const Mark&, const Mark&) = default;
    };
    struct File {
        std::filesystem::path path;
        Mark known{};  // as last reported
        Mark seen{};   // at the last look
    };
    static Mark look(const std::filesystem::path& path);

    std::vector<File> files_;
    double last_look_s_ = -1e9;
};

}  // namespace pol
