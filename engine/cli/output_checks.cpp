// SPDX-License-Identifier: Apache-2.0
#include "cli/output_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <system_error>
#include <utility>

namespace pol {

namespace {

namespace fs = std::filesystem;

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code failed;
    if (fs::equivalent(a, b, failed) && !failed) return true;
    const fs::path real_a = fs::weakly_canonical(a, failed);
    const fs::path real_b = fs::weakly_canonical(b, failed);
    return !failed && real_a == real_b;
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

}  // namespace

Result<Done> make_folder(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed || !std::filesystem::is_directory(folder))
        return Error{ErrorKind::output, "cannot be made a folder", Place{folder.string()}, {}, "choose another name"};
    return Done{};
}

std::optional<Error> output_problem(const fs::path& output, std::string_view ending,
                                    const std::vector<fs::path>& others) {
    const auto refuse = [&output](std::string what, std::string hint) {
        return Error{ErrorKind::usage, std::move(what), Place{output.string()}, {}, std::move(hint)};
    };
    if (!ending.empty() && lower(output.extension().string()) != ending) {
        const bool has_name = output.has_filename() && output.filename() != ending;
        const fs::path name = has_name ? output : output.parent_path() / "name";
        return refuse(fmt::format("the name of the output does not end in {}", ending),
                      fmt::format("for example {}", fs::path(name).replace_extension(ending).string()));
    }
    for (const fs::path& other : others) {
        if (!other.empty() && is_same_file(output, other))
            return refuse(fmt::format("would be written over {}", other.string()), "choose another name");
    }
    return std::nullopt;
}

}  // namespace pol
