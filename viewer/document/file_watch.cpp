// SPDX-License-Identifier: Apache-2.0
#include "viewer/document/file_watch.h"

#include <sys/stat.h>

#include <algorithm>

namespace pol {

void FileWatch::watch(const std::vector<std::filesystem::path>& files) {
    std::vector<File> next;
    for (const std::filesystem::path& path : files) {
        const auto known = std::find_if(files_.begin(), files_.end(), [&](const File& f) { return f.path == path; });
        const Mark mark = known == files_.end() ? look(path) : Mark{};
        next.push_back(known == files_.end() ? File{path, mark, mark} : *known);
    }
    files_ = std::move(next);
}

FileWatch::Mark FileWatch::look(const std::filesystem::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    return {status.st_ino, status.st_size,
            std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + std::int64_t{status.st_mtim.tv_nsec}};
}

bool FileWatch::changed(double now_s) {
    if (now_s - last_look_s_ < rest_s) return false;
    last_look_s_ = now_s;
    bool at_rest = true;
    bool differs = false;
    for (File& file : files_) {
        const Mark mark = look(file.path);
        const bool vanished = mark == Mark{} && file.known != Mark{};
        if (mark != file.seen || vanished) at_rest = false;
        if (mark != file.known) differs = true;
        file.seen = mark;
    }
    if (!differs || !at_rest) return false;
    for (File& file : files_) file.known = file.seen;
    return true;
}

}  // namespace pol
