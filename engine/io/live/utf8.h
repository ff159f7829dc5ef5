// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace pol::tev {

/// Whether `bytes` is UTF-8: no stray, missing or overlong bytes, no surrogates, nothing above U+10FFFF (RFC 3629, 4).
bool is_utf8(std::string_view bytes);

/// A stranger's name for one line of a log: in quotes, control characters as '?', cut after about 80 bytes.
/// Requires: UTF-8.
std::string quoted_name(std::string_view name);

}  // namespace pol::tev
