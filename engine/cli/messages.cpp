// SPDX-License-Identifier: Apache-2.0
#include "cli/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>

namespace pol {

namespace {

/// Length of the UTF-8 character (RFC 3629) that `text` begins with; 0 if it begins with none.
std::size_t character_length(std::string_view text) {
    const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t length = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    const bool overlong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
    const bool surrogate = first == 0xed && byte(1) >= 0xa0;
    const bool beyond = first == 0xf4 && byte(1) >= 0x90;
    const bool control = first == 0xc2 && byte(1) < 0xa0;
    return overlong || surrogate || beyond || control ? 0 : length;
}

}  // namespace

Error usage_error(std::string option, std::string what, std::string hint) {
    return Error{ErrorKind::usage, std::move(what), {}, std::move(option), std::move(hint)};
}

std::string printable(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const auto first = static_cast<unsigned char>(text.front());
        const bool is_control = (first < 0x20 && first != '\n') || first == 0x7f;
        const std::size_t length = is_control ? 0 : character_length(text);
        out += length > 0 ? std::string(text.substr(0, length)) : fmt::format("\\x{:02x}", first);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return out;
}

void remark(const std::string& text) {
    static_cast<void>(std::fputs(text.c_str(), stderr));
}

int report(const Error& error) {
    remark("polariscope: " + printable(to_string(error)) + "\n");
    return static_cast<int>(error.kind);
}

}  // namespace pol
