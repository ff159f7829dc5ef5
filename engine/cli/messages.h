// SPDX-License-Identifier: Apache-2.0
// What the commands say besides their results.
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"

namespace pol {

/// Prints to stderr. What cannot be said there stays unsaid: a lost remark is no reason to lose a picture.
void remark(const std::string& text);

/// Prints the error to stderr and returns its exit code.
int report(const Error& error);

/// What is wrong with an option, or with what goes without one.
Error usage_error(std::string option, std::string what, std::string hint = {});

/// Of a check that found a fault, or of pictures that differ.
constexpr int self_check_failed = 5;

/// `text` with every byte that is neither UTF-8 nor meant for a terminal (control characters but the line feed) written
/// as \xNN. Messages quote files, and files may hold anything.
std::string printable(std::string_view text);

}  // namespace pol
