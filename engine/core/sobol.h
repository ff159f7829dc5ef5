// SPDX-License-Identifier: Apache-2.0
// The first two dimensions of Sobol's sequence, and Owen's scrambling of them, as 32-bit fractions.
#pragma once

#include <cstdint>

namespace pol {

/// The first bit becomes the last. Of an index: van der Corput's sequence in base 2, the first dimension.
constexpr std::uint32_t reversed_bits(std::uint32_t x) {
    x = (x >> 16U) | (x << 16U);
    x = ((x & 0x00ff00ffU) << 8U) | ((x & 0xff00ff00U) >> 8U);
    x = ((x & 0x0f0f0f0fU) << 4U) | ((x & 0xf0f0f0f0U) >> 4U);
    x = ((x & 0x33333333U) << 2U) | ((x & 0xccccccccU) >> 2U);
    return ((x & 0x55555555U) << 1U) | ((x & 0xaaaaaaaaU) >> 1U);
}

/// The second dimension: primitive polynomial x + 1, direction numbers v_(k+1) = v_k xor v_k / 2 (Sobol 1967; Joe &
/// Kuo, SIAM J. Sci. Comput. 30, 2008).
constexpr std::uint32_t sobol_second(std::uint32_t index) {
    std::uint32_t sum = 0;
    for (std::uint32_t direction = 0x80000000U; index != 0; index >>= 1U, direction ^= direction >> 1U)
        if ((index & 1U) != 0) sum ^= direction;
    return sum;
}

/// Owen's nested uniform scrambling (Owen 1995) of a 32-bit fraction by the hash of Laine & Karras (EGSR 2011) with the
/// constants of Burley (JCGT 9(4), 2020): bit k is flipped by a function of the bits before it. The hash takes the
/// lower half of `scramble`; the upper half flips bits outright, so that every number is exactly uniform over all
/// scrambles.
constexpr std::uint32_t owen_scrambled(std::uint32_t fraction, std::uint64_t scramble) {
    std::uint32_t x = reversed_bits(fraction);
    x += static_cast<std::uint32_t>(scramble);
    x ^= x * 0x6c50b47cU;
    x ^= x * 0xb82f1e52U;
    x ^= x * 0xc7afe638U;
    x ^= x * 0x8d22f6e6U;
    return reversed_bits(x) ^ static_cast<std::uint32_t>(scramble >> 32U);
}

}  // namespace pol
