// SPDX-License-Identifier: Apache-2.0
// The bars against random positive semidefinite light: truth = common + missing part, estimate = common + surplus part.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/units.h"
#include "core/vec.h"
#include "polarization/bounds.h"

namespace pol {
namespace {

double azimuth_distance(double a, double b) {
    return std::abs(std::remainder(a - b, pi));
}

class RandomStates {
public:
    double uniform() { return uniform_(engine_); }
    /// Light of trace `s0`: |(s1, s2, s3)| = dop * s0 in a random direction.
    Stokes<double> light(double s0, double dop) {
        const double x = normal_(engine_);
        const double y = normal_(engine_);
        const double z = normal_(engine_);
        const double f = dop * s0 / std::sqrt(x * x + y * y + z * z);
        return {s0, f * x, f * y, f * z};
    }
    /// Mostly the extremes: fully polarized, unpolarized, or anything.
    double dop() {
        const double u = uniform();
        return u < 0.5 ? 1.0 : (u < 0.6 ? 0.0 : uniform());
    }
    /// Between 1e-6 and 10, on a logarithmic scale.
    double amount() { return std::pow(10.0, 7.0 * uniform() - 6.0); }

private:
    std::mt19937_64 engine_{2024};
    std::uniform_real_distribution<double> uniform_;
    std::normal_distribution<double> normal_;
};

void expect_inside(const Interval<double>& bar, double truth, double slack, const char* name) {
    EXPECT_GE(truth, bar.low - slack) << name;
    EXPECT_LE(truth, bar.high + slack) << name;
}

struct Trial {
    Stokes<double> estimate;
    Stokes<double> truth;
    double missing;
    double surplus;
};

void expect_covered(const Trial& t) {
    const MeasureBounds<double> bars = measure_bounds(t.estimate, t.missing, t.surplus);
    const Measures<double> m = measure(t.truth);
    // Sums of three numbers, one square root, one quotient: 16 epsilon of the numbers involved. Where the truth is
    // faint, the rounding of the sums weighs more in the quotients; asin has a square root branch point at 1: half the
    // digits there.
    const double scale = t.estimate.s0 + t.truth.s0;
    const double epsilon = 16.0 * std::numeric_limits<double>::epsilon();
    const double slack = epsilon * scale;
    const double share_slack = epsilon * scale / t.truth.s0;
    const double angle_slack = std::sqrt(epsilon);
    expect_inside(bars.s0, t.truth.s0, slack, "s0");
    expect_inside(bars.s1, t.truth.s1, slack, "s1");
    expect_inside(bars.s2, t.truth.s2, slack, "s2");
    expect_inside(bars.s3, t.truth.s3, slack, "s3");
    expect_inside(bars.dop, m.dop, share_slack, "dop");
    expect_inside(bars.dolp, m.dolp, share_slack, "dolp");
    expect_inside(bars.docp, m.docp, share_slack, "docp");
    if (m.has_polarization) {
        expect_inside(bars.ellipticity, m.ellipticity, angle_slack, "ellipticity");
        expect_inside(bars.ellipticity_angle, m.ellipticity_angle, angle_slack, "ellipticity angle");
    }
    if (m.has_azimuth) {
        EXPECT_LE(azimuth_distance(m.azimuth, measure(t.estimate).azimuth), bars.azimuth + angle_slack);
    }
}

TEST(Bounds, AreNeverViolatedByMissingLight) {
    RandomStates random;
    for (int i = 0; i < 100000 && !::testing::Test::HasFailure(); ++i) {
        const double missing = random.amount();
        const Stokes<double> estimate = random.light(random.amount(), random.dop());
        const Stokes<double> extra = random.light(missing * std::sqrt(random.uniform()), random.dop());
        expect_covered({estimate, estimate + extra, missing, 0.0});
    }
}

TEST(Bounds, AreNeverViolatedByMissingLightAndARandomTail) {
    RandomStates random;
    for (int i = 0; i < 200000 && !::testing::Test::HasFailure(); ++i) {
        const double missing = random.amount();
        const double surplus = random.amount();
        const Stokes<double> common = random.light(random.amount(), random.dop());
        const Stokes<double> extra = random.light(missing * std::sqrt(random.uniform()), random.dop());
        const Stokes<double> tail = random.light(surplus * std::sqrt(random.uniform()), random.dop());
        expect_covered({common + tail, common + extra, missing, surplus});
    }
}

TEST(Bounds, OfDeterminedLightAreNarrow) {
    RandomStates random;
    int determined = 0;
    for (int i = 0; i < 100000; ++i) {
        const Stokes<double> light = random.light(1.0, random.dop());
        const double missing = std::pow(10.0, -7.0 * random.uniform());
        if (!is_determined(light, missing)) continue;
        ++determined;
        constexpr double most = determined_width * (1.0 + 1e-12);
        const auto bars = measure_bounds(light, missing);
        EXPECT_LE(bars.dop.width(), most);
        EXPECT_TRUE(bars.ellipticity.width() <= most || bars.dop.high <= weak_polarization) << missing;
    }
    EXPECT_GT(determined, 50000);
    EXPECT_FALSE(is_determined({}, 1e-300)) << "nothing was found, but something may be there";
    EXPECT_TRUE(is_determined({}, 0.0));
}

// The light that reaches each bar, built by hand from the proof: the missing part fully polarized along or against the
// estimate, the tail the other way round. The estimate is strong and half polarized, so that every part stays physical.
TEST(Bounds, AreReachedByTheWorstLight) {
    const double missing = 0.03;
    const double surplus = 0.02;
    const double polarized = 0.5;
    const Stokes<double> estimate{1.0, polarized, 0.0, 0.0};
    const MeasureBounds<double> bars = measure_bounds(estimate, missing, surplus);
    const double s0 = 1.0 + missing - surplus;
    EXPECT_DOUBLE_EQ(bars.s0.high, 1.0 + missing);
    EXPECT_DOUBLE_EQ(bars.s0.low, 1.0 - surplus);

    const Stokes<double> up =
        estimate + Stokes<double>{missing, missing, 0, 0} - Stokes<double>{surplus, -surplus, 0, 0};
    const Stokes<double> down =
        estimate + Stokes<double>{missing, -missing, 0, 0} - Stokes<double>{surplus, surplus, 0, 0};
    EXPECT_DOUBLE_EQ(bars.dop.high, measure(up).dop);
    EXPECT_DOUBLE_EQ(bars.dop.low, measure(down).dop);
    EXPECT_DOUBLE_EQ(bars.dolp.high, measure(up).dolp);
    EXPECT_DOUBLE_EQ(bars.dolp.low, measure(down).dolp);
    EXPECT_DOUBLE_EQ(bars.s1.high, up.s1);
    EXPECT_DOUBLE_EQ(bars.s1.low, down.s1);

    // Tangent from the origin to the disc of radius r about (polarized, 0): azimuth; and the same upright: ellipticity.
    const double r = missing + surplus;
    const double sine = r / polarized;
    const double cosine = std::sqrt(1.0 - sine * sine);
    const DVec2 offset{-sine, cosine};
    const auto moved = [&](double x, double y, double z) {
        return Stokes<double>{s0, polarized + r * x, r * y, r * z};
    };
    EXPECT_NEAR(measure(moved(offset.x, offset.y, 0.0)).azimuth, bars.azimuth, 1e-15);
    EXPECT_NEAR(measure(moved(offset.x, 0.0, offset.y)).ellipticity_angle, bars.ellipticity_angle.high, 1e-15);
    EXPECT_NEAR(measure(moved(offset.x, 0.0, -offset.y)).ellipticity_angle, bars.ellipticity_angle.low, 1e-15);
    EXPECT_NEAR(measure(moved(offset.x, 0.0, offset.y)).ellipticity, bars.ellipticity.high, 1e-15);
    EXPECT_EQ(bars.ellipticity.low, 0.0);

    const Stokes<double> round{1.0, 0.0, 0.0, polarized};
    EXPECT_DOUBLE_EQ(measure_bounds(round, missing, surplus).docp.high, (polarized + r) / s0);
    EXPECT_DOUBLE_EQ(measure_bounds(round, missing, surplus).docp.low, (polarized - r) / s0);
}

// CUTTING.md 1.2, without a tail: -(1+p) e/(S0+e) <= dp <= (1-p) e/(S0+e).
TEST(Bounds, WithoutATailAreTheOneSidedBarsOfTheNotes) {
    for (const double p : {0.3, 0.6, 0.9}) {
        for (const double e : {1e-4, 1e-2, 0.1}) {
            const MeasureBounds<double> bars = measure_bounds(Stokes<double>{2.0, 2.0 * p, 0.0, 0.0}, e);
            // Differences of numbers of order 1: a few epsilon.
            EXPECT_NEAR(bars.dop.high - p, (1.0 - p) * e / (2.0 + e), 1e-15);
            EXPECT_NEAR(p - bars.dop.low, (1.0 + p) * e / (2.0 + e), 1e-15);
        }
    }
}

TEST(Bounds, OfACompletePictureHaveNoWidth) {
    const Stokes<double> s{2.0, 0.6, -0.8, 0.5};
    const MeasureBounds<double> bars = measure_bounds(s, 0.0);
    const Measures<double> m = measure(s);
    EXPECT_EQ(bars.dop, (Interval<double>{m.dop, m.dop}));
    EXPECT_EQ(bars.ellipticity_angle, (Interval<double>{m.ellipticity_angle, m.ellipticity_angle}));
    EXPECT_NEAR(bars.ellipticity.low, m.ellipticity, 1e-15);  // tan of the angle against the closed form: 3 ulp
    EXPECT_EQ(bars.azimuth, 0.0);
}

TEST(Bounds, OfNothingKnownCoverEverything) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const MeasureBounds<double>& bars :
         {measure_bounds(Stokes<double>{}, 1.0), measure_bounds(Stokes<double>{1.0, 0.1, 0.0, 0.0}, 0.0, 1.0),
          measure_bounds(Stokes<double>{1.0, 1.0, 0.0, 0.0}, nan),
          measure_bounds(Stokes<double>{1.0, 1.0, 0.0, 0.0}, -1.0)}) {
        EXPECT_EQ(bars.dop.low, 0.0);
        EXPECT_EQ(bars.dop.high, 1.0);
        EXPECT_EQ(bars.ellipticity, (Interval<double>{0.0, bars.ellipticity.high}));
        EXPECT_NEAR(bars.ellipticity.high, 1.0, 1e-15);
        EXPECT_DOUBLE_EQ(bars.azimuth, pi / 2.0);
    }
}

}  // namespace
}  // namespace pol
