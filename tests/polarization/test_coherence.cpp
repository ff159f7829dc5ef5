// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.h"
#include "polarization/coherence_matrix.h"
#include "polarization/measures.h"
#include "polarization/mueller.h"

namespace pol {
namespace {

using Jones = JonesVector<double>;
using Matrix = JonesMatrix<double>;
using Coherence = CoherenceMatrix<double>;

// A product of 2x2 complex matrices sums at most 4 terms a few times over; entries here are of order 1, so 16 epsilon
// per step is generous and 1e-14 covers every chain below.
constexpr double sum_rounding = 1e-14;

void expect_same(const Stokes<double>& a, const Stokes<double>& b, double tolerance) {
    EXPECT_NEAR(a.s0, b.s0, tolerance);
    EXPECT_NEAR(a.s1, b.s1, tolerance);
    EXPECT_NEAR(a.s2, b.s2, tolerance);
    EXPECT_NEAR(a.s3, b.s3, tolerance);
}

/// tr(A^H A)/2: the share of unpolarized light that A passes.
double mean_transmittance(const Matrix& a) {
    return 0.5 * (norm2(a[0][0]) + norm2(a[0][1]) + norm2(a[1][0]) + norm2(a[1][1]));
}

class RandomLight {
public:
    double normal() { return normal_(engine_); }
    Complex<double> complex() { return {normal(), normal()}; }
    Jones field() { return {complex(), complex()}; }
    Matrix matrix() { return {{{complex(), complex()}, {complex(), complex()}}}; }

private:
    std::mt19937_64 engine_{12345};
    std::normal_distribution<double> normal_;
};

TEST(Coherence, TheSixStandardStatesHaveTheirStokesVectors) {
    const double h = std::sqrt(0.5);
    // Right circular light: E_y = -i E_x with exp(-i omega t) (PHYSICS.md 1).
    const struct {
        Jones field;
        Stokes<double> expected;
    } cases[] = {
        {{1.0, 0.0}, {1.0, 1.0, 0.0, 0.0}},     {{0.0, 1.0}, {1.0, -1.0, 0.0, 0.0}},
        {{h, h}, {1.0, 0.0, 1.0, 0.0}},         {{h, -h}, {1.0, 0.0, -1.0, 0.0}},
        {{h, {0.0, -h}}, {1.0, 0.0, 0.0, 1.0}}, {{h, {0.0, h}}, {1.0, 0.0, 0.0, -1.0}},
    };
    for (const auto& c : cases) expect_same(to_stokes(Coherence::outer(c.field)), c.expected, sum_rounding);
}

// The receiver looks against k and sees x to the right, y up. Clockwise there means that the field, as a real vector of
// time, turns from y towards x.
TEST(Coherence, PositiveS3IsAFieldThatTurnsClockwiseForTheReceiver) {
    const Jones right{1.0, {0.0, -1.0}};
    ASSERT_GT(to_stokes(Coherence::outer(right)).s3, 0.0);
    const auto field_at = [&](double omega_t) {
        const Complex<double> phase = unit_phase(-omega_t);
        return DVec2{(right.x * phase).re, (right.y * phase).re};
    };
    const DVec2 now = field_at(0.0);
    const DVec2 later = field_at(0.1);
    EXPECT_LT(now.x * later.y - now.y * later.x, 0.0);
}

TEST(Coherence, StokesAndCoherenceSayTheSame) {
    RandomLight random;
    for (int i = 0; i < 100; ++i) {
        const Coherence j = Coherence::outer(random.field()) + Coherence::outer(random.field());
        const Coherence back = to_coherence(to_stokes(j));
        const double tolerance = sum_rounding * trace(j);
        EXPECT_NEAR(back.xx, j.xx, tolerance);
        EXPECT_NEAR(back.yy, j.yy, tolerance);
        EXPECT_NEAR(back.xy.re, j.xy.re, tolerance);
        EXPECT_NEAR(back.xy.im, j.xy.im, tolerance);
    }
}

TEST(Coherence, AnElementActsOnTheBeamAsOnItsFields) {
    RandomLight random;
    for (int i = 0; i < 100; ++i) {
        const Matrix a = random.matrix();
        const Jones u = random.field();
        const Jones v = random.field();
        const Coherence expected = Coherence::outer(a * u) + Coherence::outer(a * v);
        const Coherence j = transform(a, Coherence::outer(u) + Coherence::outer(v));
        // |A|^2 and |v|^2 multiply the sum_rounding.
        const double tolerance =
            sum_rounding * 4.0 * mean_transmittance(a) * (norm2(u.x) + norm2(u.y) + norm2(v.x) + norm2(v.y));
        expect_same(to_stokes(j), to_stokes(expected), tolerance);
    }
}

TEST(Coherence, RotatingTheBasisOfStokesAndOfCoherenceAgree) {
    RandomLight random;
    for (int i = 0; i < 100; ++i) {
        const Coherence j = Coherence::outer(random.field());
        const double angle = random.normal();
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const Matrix turn{{{c, s}, {-s, c}}};
        expect_same(to_stokes(transform(turn, j)), rotate_basis(to_stokes(j), angle), sum_rounding * trace(j));
    }
}

TEST(Coherence, LightAlongXIsMinus45DegreesInAFrameTurnedBy45) {
    const Stokes<double> turned = rotate_basis(Stokes<double>{1.0, 1.0, 0.0, 0.0}, pi / 4.0);
    expect_same(turned, {1.0, 0.0, -1.0, 0.0}, sum_rounding);
}

TEST(Mueller, ActsOnStokesAsJonesActsOnCoherence) {
    RandomLight random;
    for (int i = 0; i < 100; ++i) {
        const Matrix a = random.matrix();
        const Coherence j = Coherence::outer(random.field()) + Coherence::outer(random.field());
        const double tolerance = sum_rounding * 8.0 * mean_transmittance(a) * trace(j);
        expect_same(to_mueller(a) * to_stokes(j), to_stokes(transform(a, j)), tolerance);
    }
}

// Hecht, Optics, table 8.6: horizontal linear polarizer.
TEST(Mueller, OfAHorizontalPolarizerIsTheTextbookMatrix) {
    const MuellerMatrix<double> m = to_mueller(Matrix{{{1.0, 0.0}, {0.0, 0.0}}});
    const MuellerMatrix<double> expected{
        {{{0.5, 0.5, 0.0, 0.0}, {0.5, 0.5, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}}}};
    EXPECT_EQ(m, expected);
}

// The reversed path in the same field vectors: Theta M^T Theta, Theta = diag(1, 1, 1, -1), of the transposed Jones
// matrix.
TEST(Mueller, OfTheReversedPathBelongsToTheTransposedJonesMatrix) {
    RandomLight random;
    for (int i = 0; i < 100; ++i) {
        const Matrix a = random.matrix();
        const MuellerMatrix<double> m = to_mueller(a);
        const MuellerMatrix<double> back = to_mueller(Matrix{{{a[0][0], a[1][0]}, {a[0][1], a[1][1]}}});
        for (std::size_t r = 0; r < 4; ++r) {
            for (std::size_t c = 0; c < 4; ++c) {
                const double expected = (r == 3) != (c == 3) ? -m.m[c][r] : m.m[c][r];
                EXPECT_NEAR(back.m[r][c], expected, sum_rounding * 4.0 * mean_transmittance(a));
            }
        }
    }
}

}  // namespace
}  // namespace pol
