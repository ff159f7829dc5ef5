// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/complex.h"
#include "core/hypot.h"
#include "core/quad.h"
#include "core/random.h"

namespace pol {
namespace {

using C = Complex<double>;

// One rounding of each of a handful of operations.
constexpr double eps = 4.0 * std::numeric_limits<double>::epsilon();

// exp(-i omega t): the root with a non-negative imaginary part decays along +.
TEST(Complex, SquareRootDecaysAndSquaresBackInEveryQuadrant) {
    for (const double magnitude : {1e-150, 1e-8, 1.0, 1e8, 1e150}) {
        for (const double angle : {0.0, 0.3, 1.5707, 2.0, 3.1415, -0.3, -1.5708, -3.0}) {
            SCOPED_TRACE(angle);
            const C z = unit_phase(angle) * magnitude;
            const C root = sqrt_decaying(z);
            EXPECT_GE(root.im, 0.0);
            EXPECT_LE(abs(root * root - z), eps * magnitude);
        }
    }
    EXPECT_EQ(sqrt_decaying(C(-4.0)), C(0.0, 2.0));
    EXPECT_EQ(sqrt_decaying(C(4.0)), C(2.0, 0.0));
}

// The textbook formula squares |b| and overflows; Smith's does not.
TEST(Complex, DivisionOfHugeNumbersDoesNotOverflow) {
    const C quotient = C(3e300, 4e300) / C(1e300, 2e300);  // (3 + 4i)/(1 + 2i) = (11 - 2i)/5
    EXPECT_NEAR(quotient.re, 2.2, 2.2 * eps);
    EXPECT_NEAR(quotient.im, -0.4, eps);
    const C small = C(1e-300, 0.0) / C(0.0, 1e-300);
    EXPECT_EQ(small, C(0.0, -1.0));
}

// Legs of a triangle of every size and shape, also beyond the normal numbers.
double leg(std::uint32_t number, std::uint32_t which) {
    const RandomKey key{0, number, which, 0};
    const auto exponent = static_cast<int>(random_bits({0, number, 0, 0}, 0) % 2040U) - 1050;
    const auto shorter = static_cast<int>(random_bits(key, 1) % 30U);
    return std::ldexp(random_unit(key, 2), exponent - shorter);
}

TEST(Hypot, IsTheHypotenuseToOneUnitInTheLastPlace) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < 100000; ++i) {
        const double a = leg(i, 1);
        const double b = leg(i, 2);
        const double found = hypot(a, b);
        const Quad off = abs(hypot(Quad(a), Quad(b)) - Quad(found));
        ASSERT_FALSE(off > Quad(std::nextafter(found, infinity) - found)) << a << " " << b;
        ASSERT_EQ(found, hypot(-b, a));
    }
}

TEST(Hypot, IsExactWhereItIsANumber) {
    for (const double size : {1e-300, 0x1p-1070, 1.0, 0x1p1020}) EXPECT_EQ(hypot(3.0 * size, -4.0 * size), 5.0 * size);
    EXPECT_EQ(hypot(0.0, -0.0), 0.0);
    EXPECT_EQ(hypot(-2.0, 0.0), 2.0);
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(hypot(nan, -infinity), infinity);
    EXPECT_EQ(hypot(std::numeric_limits<double>::max(), std::numeric_limits<double>::max()), infinity);
    EXPECT_TRUE(std::isnan(hypot(nan, 0.0)));
}

// Pictures are compared between machines; these are the bits of glibc 2.36 on x86-64.
TEST(Hypot, HasTheSameBitsOnEveryMachine) {
    std::uint64_t all = 0;
    for (std::uint32_t i = 0; i < 100000; ++i)
        all = mix_bits(all ^ std::bit_cast<std::uint64_t>(hypot(leg(i, 1), leg(i, 2))));
    EXPECT_EQ(all, 1294914109864342507ULL);
}

TEST(Random, DependsOnEveryPartOfItsKeyAndOnNothingElse) {
    const RandomKey key{7, 100, 3, 1};
    EXPECT_EQ(random_bits(key, 5), random_bits(key, 5));
    const std::uint64_t bits = random_bits(key, 5);
    EXPECT_NE(bits, random_bits({8, 100, 3, 1}, 5));
    EXPECT_NE(bits, random_bits({7, 101, 3, 1}, 5));
    EXPECT_NE(bits, random_bits({7, 100, 4, 1}, 5));
    EXPECT_NE(bits, random_bits({7, 100, 3, 2}, 5));
    EXPECT_NE(bits, random_bits(key, 6));
}

// Mean 1/2 and variance 1/12 of n uniform numbers, each within 5 sigma: sigma of the mean is 1/sqrt(12 n), of the
// variance 1/sqrt(180 n).
TEST(Random, IsUniformOverPixels) {
    constexpr int n = 100000;
    double sum = 0.0;
    double squares = 0.0;
    for (std::uint32_t pixel = 0; pixel < n; ++pixel) {
        const double u = random_unit({0, pixel, 0, 0}, 0);
        ASSERT_GE(u, 0.0);
        ASSERT_LT(u, 1.0);
        sum += u - 0.5;
        squares += (u - 0.5) * (u - 0.5);
    }
    EXPECT_NEAR(sum / n, 0.0, 5.0 / std::sqrt(12.0 * n));
    EXPECT_NEAR(squares / n, 1.0 / 12.0, 5.0 / std::sqrt(180.0 * n));
}

}  // namespace
}  // namespace pol
