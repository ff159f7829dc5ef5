// SPDX-License-Identifier: Apache-2.0
#include "io/files/input_file.h"

#include <fstream>
#include <system_error>

namespace pol {

Result<std::string> read_input_file(const std::filesystem::path& path, std::uintmax_t max_bytes) {
    namespace fs = std::filesystem;
    const auto error = [&](std::string what, std::string hint) {
        return Error{ErrorKind::input, std::move(what), {path.string(), 0, 0}, {}, std::move(hint)};
    };
    std::error_code failed;
    const fs::file_status status = fs::status(path, failed);
    if (status.type() == fs::file_type::not_found)
        return error("there is no such file", "check the path and its spelling");
    if (status.type() == fs::file_type::directory) return error("is a folder", "name a file in it");
    if (status.type() != fs::file_type::regular)
        return error("is not a regular file", "check the path and its permissions");

    const std::uintmax_t size = fs::file_size(path, failed);
    if (failed) return error("cannot be read: " + failed.message(), "check its permissions");
    if (size > max_bytes) {
        return error("is " + std::to_string(size) + " bytes long, more than the limit of " + std::to_string(max_bytes),
                     "is it the right file?");
    }
    std::string bytes(static_cast<std::size_t>(size), '\0');
    std::ifstream stream(path, std::ios::binary);
    stream.read(bytes.data(), static_cast<std::streamsize>(size));
    if (!stream) return error("cannot be read", "check its permissions");
    return bytes;
}

}  // namespace pol
