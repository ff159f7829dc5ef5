// SPDX-License-Identifier: Apache-2.0
#include "io/files/output_file.h"
#include "core/result.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>

namespace pol {
namespace {

namespace fs = std::filesystem;

Error output_error(const fs::path& path, std::string what, std::string hint = {}) {
    return Error{ErrorKind::output, std::move(what), Place{path.string()}, {}, std::move(hint)};
}

std::string reason(int error_number) {
    return std::generic_category().message(error_number);
}

Error unwritable(const fs::path& path, int error_number) {
    const bool no_space = error_number == ENOSPC || error_number == EDQUOT || error_number == EFBIG;
    return output_error(path, fmt::format("cannot be written: {}", reason(error_number)),
                        no_space ? "free some space; an older file of this name is as it was"
                                 : "check the permissions of its folder, or choose another");
}

/// Process id in ".NAME.PID-N.tmp"; 0 if `file_name` has another form.
pid_t writer_of(std::string_view file_name, std::string_view prefix) {
    constexpr std::string_view suffix = ".tmp";
    if (!file_name.starts_with(prefix) || !file_name.ends_with(suffix)) return 0;
    file_name.remove_prefix(prefix.size());
    pid_t pid = 0;
    const auto [end, status] = std::from_chars(file_name.data(), file_name.data() + file_name.size(), pid);
    const bool is_ours = status == std::errc{} && end != file_name.data() + file_name.size() && *end == '-';
    return is_ours && pid > 0 ? pid : 0;
}

void remove_leftovers(const fs::path& folder, const std::string& prefix) {
    std::error_code ignored;
    for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored)) {
        const pid_t pid = writer_of(entry->path().filename().string(), prefix);
        if (pid != 0 && ::kill(pid, 0) != 0 && errno == ESRCH) ::unlink(entry->path().c_str());
        if (ignored) return;
    }
}

void sync_folder(const fs::path& folder) {
    // Some file systems cannot sync a folder; the rename has happened all the same, so this is best effort.
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
}

}  // namespace

struct OutputFile::Stream {
    std::FILE* file = nullptr;
    fs::path temporary;
    fs::path target;
    fs::path folder;
    int first_error = 0;

    bool note(bool succeeded) {
        if (!succeeded && first_error == 0) first_error = errno != 0 ? errno : EIO;
        return succeeded;
    }
};

OutputFile::OutputFile(std::unique_ptr<Stream> stream) : stream_(std::move(stream)) {}

OutputFile::~OutputFile() {
    if (stream_->file != nullptr) std::fclose(stream_->file);
    if (!stream_->temporary.empty()) ::unlink(stream_->temporary.c_str());
}

Result<std::unique_ptr<OutputFile>> OutputFile::create(const fs::path& path) {
    std::error_code status;
    auto stream = std::make_unique<Stream>();
    stream->target = fs::is_symlink(path, status) ? fs::weakly_canonical(path, status) : path;
    const std::string name = stream->target.filename().string();
    if (name.empty() || fs::is_directory(stream->target, status))
        return output_error(path, "is a folder, not a file name", "name a file in it");
    if (fs::exists(stream->target, status) && !fs::is_regular_file(stream->target, status)) {
        return output_error(path, "is not a regular file", "name a file that may be replaced");
    }
    stream->folder = stream->target.has_parent_path() ? stream->target.parent_path() : fs::path(".");
    if (!fs::is_directory(stream->folder, status)) {
        return output_error(path, "the folder does not exist", fmt::format("make {} first", stream->folder.string()));
    }

    const std::string prefix = fmt::format(".{}.", name);
    remove_leftovers(stream->folder, prefix);
    // Two writers of one program take different numbers.
    fs::path temporary;
    int descriptor = -1;
    for (int serial = 0; descriptor < 0 && (serial == 0 || errno == EEXIST); ++serial) {
        temporary = stream->folder / fmt::format("{}{}-{}.tmp", prefix, ::getpid(), serial);
        descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    }
    if (descriptor < 0) return unwritable(path, errno);
    stream->temporary = temporary;
    stream->file = ::fdopen(descriptor, "wb");
    if (stream->file == nullptr) {
        const int error_number = errno;
        ::close(descriptor);
        ::unlink(temporary.c_str());
        return unwritable(path, error_number);
    }
    return std::unique_ptr<OutputFile>(new OutputFile(std::move(stream)));
}

bool OutputFile::write(const void* bytes, std::size_t count) {
    errno = 0;
    if (!stream_->note(std::fwrite(bytes, 1, count, stream_->file) == count)) return false;
    position_ += count;
    return true;
}

bool OutputFile::seek(std::uint64_t position) {
    errno = 0;
    if (!stream_->note(::fseeko(stream_->file, static_cast<off_t>(position), SEEK_SET) == 0)) return false;
    position_ = position;
    return true;
}

bool OutputFile::good() const {
    return stream_->first_error == 0;
}

Result<Done> OutputFile::commit() {
    errno = 0;
    stream_->note(std::fflush(stream_->file) == 0);
    if (stream_->first_error == 0) stream_->note(::fsync(::fileno(stream_->file)) == 0);
    const int closed = std::fclose(stream_->file);
    stream_->file = nullptr;
    stream_->note(closed == 0);
    if (stream_->first_error != 0) {
        return unwritable(stream_->target, stream_->first_error);
    }
    if (::rename(stream_->temporary.c_str(), stream_->target.c_str()) != 0) {
        return unwritable(stream_->target, errno);
    }
    stream_->temporary.clear();
    sync_folder(stream_->folder);
    return Done{};
}

Result<Done> write_file(const std::filesystem::path& path, std::string_view text) {
    POL_TRY(auto file, OutputFile::create(path));
    file->write(text.data(), text.size());
    return file->commit();
}

}  // namespace pol
