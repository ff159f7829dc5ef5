// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pol {

/// How one number of an array lies in the bytes of a file.
struct NumberFormat {
    enum class Kind { float16, float32, float64, unsigned8, unsigned16, signed16, signed32 };
    Kind kind = Kind::float32;
    std::endian order = std::endian::little;

    [[nodiscard]] std::size_t bytes() const {
        constexpr std::array<std::size_t, 7> sizes{2, 4, 8, 1, 2, 2, 4};
        return sizes[static_cast<std::size_t>(kind)];
    }
    [[nodiscard]] bool is_whole() const { return kind >= Kind::unsigned8; }

    /// The number, exactly. Requires: bytes() bytes.
    [[nodiscard]] double at(const char* bytes_of_it) const {
        const std::size_t count = bytes();
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t from = order == std::endian::big ? i : count - 1 - i;
            bits = bits << 8U | static_cast<unsigned char>(bytes_of_it[from]);
        }
        switch (kind) {
            case Kind::float16:
                return half_number(static_cast<std::uint16_t>(bits));
            case Kind::float32:
                return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
            case Kind::float64:
                return std::bit_cast<double>(bits);
            case Kind::signed16:
                return static_cast<std::int16_t>(static_cast<std::uint16_t>(bits));
            case Kind::signed32:
                return static_cast<std::int32_t>(static_cast<std::uint32_t>(bits));
            case Kind::unsigned8:
            case Kind::unsigned16:
                break;
        }
        return static_cast<double>(bits);
    }

private:
    /// IEEE 754 binary16.
    static double half_number(std::uint16_t bits) {
        const int exponent = bits >> 10U & 0x1f;
        const int fraction = bits & 0x3ff;
        const double sign = (bits & 0x8000U) != 0 ? -1.0 : 1.0;
        if (exponent == 31) return fraction == 0 ? sign * HUGE_VAL : std::nan("");
        if (exponent == 0) return sign * std::ldexp(fraction, -24);
        return sign * std::ldexp(1024 + fraction, exponent - 25);
    }
};

}  // namespace pol
