// SPDX-License-Identifier: Apache-2.0
#include "cli/report_files.h"

#include <system_error>

namespace pol {

Result<Done> make_folder(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed || !std::filesystem::is_directory(folder))
        return Error{ErrorKind::output, "cannot be made a folder", Place{folder.string()}, {}, "choose another name"};
    return Done{};
}

}  // namespace pol
