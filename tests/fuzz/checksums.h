// SPDX-License-Identifier: Apache-2.0
// Checksums made right, without which hardly a changed byte gets past them into a reader.
#pragma once

#include <zlib.h>

#include <cstddef>
#include <string>

namespace pol::test {

inline std::size_t big_endian(const std::string& bytes, std::size_t at) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

inline std::size_t little_endian(const std::string& bytes, std::size_t at, std::size_t count) {
    std::size_t value = 0;
    for (std::size_t i = count; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

inline uLong crc_of(const std::string& bytes, std::size_t at, std::size_t count) {
    return crc32(0, reinterpret_cast<const Bytef*>(bytes.data() + at), static_cast<uInt>(count));
}

/// PNG: 8 bytes of signature, then chunks of length, type, data and the CRC of type and data.
inline void mend_png(std::string& png) {
    std::size_t at = 8;
    while (at + 12 <= png.size()) {
        const std::size_t length = big_endian(png, at);
        if (length > png.size() - at - 12) return;
        const uLong crc = crc_of(png, at + 4, length + 4);
        for (std::size_t i = 0; i < 4; ++i) png[at + 8 + length + i] = static_cast<char>(crc >> (24U - 8U * i));
        at += length + 12;
    }
}

/// ZIP: the CRC of an entry that is not compressed stands in its header and in the directory.
inline void mend_zip(std::string& zip) {
    constexpr std::size_t directory_size = 46;
    constexpr std::size_t header_size = 30;
    for (std::size_t at = zip.find("PK\x01\x02"); at != std::string::npos; at = zip.find("PK\x01\x02", at + 4)) {
        if (at + directory_size > zip.size()) return;
        const std::size_t header = little_endian(zip, at + 42, 4);
        const std::size_t size = little_endian(zip, at + 20, 4);
        if (header > zip.size() || zip.size() - header < header_size) continue;
        const std::size_t data =
            header + header_size + little_endian(zip, header + 26, 2) + little_endian(zip, header + 28, 2);
        if (data > zip.size() || size > zip.size() - data) continue;
        const uLong crc = crc_of(zip, data, size);
        for (std::size_t i = 0; i < 4; ++i)
            zip[header + 14 + i] = zip[at + 16 + i] = static_cast<char>(crc >> (8U * i));
    }
}

}  // namespace pol::test
