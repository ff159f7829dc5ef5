// SPDX-License-Identifier: Apache-2.0
#include "io/live/utf8.h"

#include <cstddef>
#include <cstdint>

namespace pol::tev {
namespace {

std::uint8_t byte_at(std::string_view bytes, std::size_t i) {
    return static_cast<std::uint8_t>(bytes[i]);
}

bool is_continuation(std::uint8_t byte) {
    return (byte & 0xC0U) == 0x80U;
}

/// Bytes of the character that begins there; 0 if none does.
std::size_t character_length(std::string_view bytes) {
    const std::uint8_t first = byte_at(bytes, 0);
    if (first < 0x80U) return 1;
    const std::size_t length = first >= 0xC2U && first < 0xE0U ? 2 : first >= 0xE0U && first < 0xF0U ? 3 : 4;
    if (first < 0xC2U || first > 0xF4U || bytes.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if (!is_continuation(byte_at(bytes, i))) return 0;
    const std::uint8_t second = byte_at(bytes, 1);
    const bool overlong = (first == 0xE0U && second < 0xA0U) || (first == 0xF0U && second < 0x90U);
    const bool surrogate = first == 0xEDU && second >= 0xA0U;
    const bool too_high = first == 0xF4U && second >= 0x90U;
    return overlong || surrogate || too_high ? 0 : length;
}

}  // namespace

bool is_utf8(std::string_view bytes) {
    while (!bytes.empty()) {
        const std::size_t length = character_length(bytes);
        if (length == 0) return false;
        bytes.remove_prefix(length);
    }
    return true;
}

std::string quoted_name(std::string_view name) {
    constexpr std::size_t longest = 80;
    std::string text = "'";
    for (std::size_t i = 0; i < name.size(); ++i) {
        const std::uint8_t byte = byte_at(name, i);
        if (i >= longest && !is_continuation(byte)) return text + "...'";
        // C1 control characters are C2 80 to C2 9F.
        const bool control =
            byte < 0x20U || byte == 0x7FU || (byte == 0xC2U && i + 1 < name.size() && byte_at(name, i + 1) < 0xA0U);
        text += control ? '?' : name[i];
        if (byte == 0xC2U && control) ++i;
    }
    return text + "'";
}

}  // namespace pol::tev
