// SPDX-License-Identifier: Apache-2.0
// Random numbers without state: the same key gives the same number on every thread and machine.
#pragma once

#include <cstdint>

namespace pol {

/// Finalizer of SplitMix64 (Steele, Lea, Flood, OOPSLA 2014): a bijection that passes avalanche tests.
constexpr std::uint64_t mix_bits(std::uint64_t x) {
    x ^= x >> 30U;
    x *= 0xbf58476d1ce4e5b9ULL;
    x ^= x >> 27U;
    x *= 0x94d049bb133111ebULL;
    x ^= x >> 31U;
    return x;
}

/// What a random number belongs to.
struct RandomKey {
    std::uint64_t seed = 0;
    std::uint32_t pixel = 0;
    std::uint32_t sample = 0;
    std::uint32_t wavelength = 0;  ///< WavelengthGroup::key or ::places
};

constexpr std::uint64_t random_bits(const RandomKey& key, std::uint32_t dimension) {
    std::uint64_t h = mix_bits(key.seed + 0x9e3779b97f4a7c15ULL);
    h = mix_bits(h ^ ((std::uint64_t{key.pixel} << 32U) | key.sample));
    return mix_bits(h + ((std::uint64_t{key.wavelength} << 32U) | dimension) * 0x9e3779b97f4a7c15ULL);
}

/// Uniform in [0, 1), 53 bits.
constexpr double random_unit(const RandomKey& key, std::uint32_t dimension) {
    return static_cast<double>(random_bits(key, dimension) >> 11U) * 0x1.0p-53;
}

}  // namespace pol
