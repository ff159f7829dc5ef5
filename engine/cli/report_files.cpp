// SPDX-License-Identifier: Apache-2.0
#include "cli/report_files.h"

#include <system_error>

#include "io/output_file.h"

namespace pol {

Result<Done> write_text(const std::filesystem::path& path, const std::string& text) {
    auto file = OutputFile::create(path);
    if (!file) return file.error();
    file.value()->write(text.data(), text.size());
    return file.value()->commit();
}

Result<Done> make_folder(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed || !std::filesystem::is_directory(folder))
        return Error{ErrorKind::output, "cannot be made a folder", Place{folder.string()}, {}, "choose another name"};
    return Done{};
}

}  // namespace pol
