// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/complex.h"
#include "core/exponential.h"
#include "core/hypot.h"
#include "core/lanes.h"
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

// From 2^-60 to 1, up to 40, and to where the exponential leaves the numbers, of both signs.
double exponent(std::uint32_t number) {
    const RandomKey key{0, number, 3, 0};
    const double to_one = 2.0 * random_unit(key, 1) - 1.0;
    switch (number % 4) {
        case 0:
            return std::ldexp(to_one, -static_cast<int>(random_bits(key, 2) % 60U));
        case 1:
            return 1.2 * to_one;
        case 2:
            return 40.0 * to_one;
        default:
            return 745.0 * to_one;
    }
}

/// Taylor's series where e^x - 1 cancels.
Quad exp_less_one(const Quad& x) {
    if (abs(x) > Quad(0.5)) return exp(x) - Quad(1);
    Quad sum = x;
    Quad term = x;
    for (int n = 2; n < 32; ++n) {
        term = term * x / Quad(n);
        sum += term;
    }
    return sum;
}

Quad unit_in_last_place(double a) {
    return Quad(std::nextafter(std::abs(a), std::numeric_limits<double>::infinity()) - std::abs(a));
}

void expect_within_one_unit(double found, const Quad& exact, double x) {
    if (std::isinf(found)) return;
    EXPECT_LE(abs(exact - Quad(found)), unit_in_last_place(found)) << x;
}

TEST(Exponential, IsOffByLessThanOneUnitInTheLastPlace) {
    for (std::uint32_t i = 0; i < 200000; ++i) {
        const double x = exponent(i);
        expect_within_one_unit(exponential(x), exp(Quad(x)), x);
        expect_within_one_unit(exponential_less_one(x), exp_less_one(Quad(x)), x);
    }
}

TEST(Exponential, EndsWhereTheNumbersEnd) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double smallest = std::numeric_limits<double>::denorm_min();
    for (const double x : {0.0, -0.0, smallest, -smallest}) {
        EXPECT_EQ(exponential(x), 1.0);
        EXPECT_EQ(exponential_less_one(x), x);
        EXPECT_EQ(std::signbit(exponential_less_one(x)), std::signbit(x));
    }
    // Beside ln(2^1024) = 709.7827 and ln(2^-1075) = -745.1332.
    EXPECT_TRUE(std::isfinite(exponential(709.782)) && std::isfinite(exponential_less_one(709.782)));
    EXPECT_EQ(exponential(-745.133), smallest);
    for (const double x : {709.783, 1e4, 1e300, infinity}) {
        EXPECT_EQ(exponential(x), infinity);
        EXPECT_EQ(exponential_less_one(x), infinity);
    }
    for (const double x : {-745.134, -1e4, -1e300, -infinity}) {
        EXPECT_EQ(exponential(x), 0.0);
        EXPECT_EQ(exponential_less_one(x), -1.0);
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(exponential(nan)) && std::isnan(exponential_less_one(nan)));
}

// What lanes are for: a formula over them has the bits that it has over doubles.
TEST(Lanes, TheFormulasOfThisRoomHaveTheBitsOfASingleNumber) {
    using Pair = Lanes<2>;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> numbers{0.0, -0.0, 1.0, -1.0, 709.783, -745.14, infinity, -infinity, nan, 1e-310, -3e300};
    for (std::uint32_t i = 0; i < 2000; ++i) {
        numbers.push_back(exponent(i));
        numbers.push_back(leg(i, 1));
    }
    const auto expect_same = [](const Pair& found, double first, double second, double x) {
        alignas(16) double each[2];
        found.store(each);
        for (const auto& [got, expected] : {std::pair(each[0], first), std::pair(each[1], second)})
            EXPECT_TRUE(std::bit_cast<std::uint64_t>(got) == std::bit_cast<std::uint64_t>(expected) ||
                        (std::isnan(got) && std::isnan(expected)))
                << x;
    };
    for (std::size_t i = 1; i < numbers.size(); ++i) {
        alignas(16) const double both[2]{numbers[i - 1], numbers[i]};
        const Pair x = Pair::load(both);
        expect_same(exponential(x), exponential(both[0]), exponential(both[1]), both[1]);
        expect_same(exponential_less_one(x), exponential_less_one(both[0]), exponential_less_one(both[1]), both[1]);
        expect_same(hypot(x, Pair(0.3)), hypot(both[0], 0.3), hypot(both[1], 0.3), both[1]);
        const Complex<Pair> root = sqrt_decaying(Complex<Pair>(x, Pair(both[0])));
        const C first = sqrt_decaying(C(both[0], both[0]));
        const C second = sqrt_decaying(C(both[1], both[0]));
        expect_same(root.re, first.re, second.re, both[1]);
        expect_same(root.im, first.im, second.im, both[1]);
    }
}

}  // namespace
}  // namespace pol
