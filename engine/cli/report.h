// SPDX-License-Identifier: Apache-2.0
// What the commands say besides their results: errors, and numbers as people write them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace pol {

/// Prints to stderr. What cannot be said there stays unsaid: a lost remark is no reason to lose a picture.
void remark(const std::string& text);

/// Prints the error to stderr and returns its exit code.
int report(const Error& error);

/// `text` with every byte that is neither UTF-8 nor meant for a terminal (control characters but the line feed) written
/// as \xNN. Messages quote files, and files may hold anything.
std::string printable(std::string_view text);

/// "430 ms", "5.3 s", "2 min 10 s", "3 h 5 min".
std::string duration_text(double seconds);

/// "870", "1.47 million", "2.30 billion".
std::string count_text(std::uint64_t count);

/// What speaks against writing a result to `output`: its name does not end in `ending` (in any case; "" allows every
/// name), or it is one of `others`, by this or another name.
std::optional<Error> output_problem(const std::filesystem::path& output, std::string_view ending,
                                    const std::vector<std::filesystem::path>& others);

}  // namespace pol
