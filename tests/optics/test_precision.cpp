// SPDX-License-Identifier: Apache-2.0
// The formulas run over wider numbers, and are then better by as many digits: what limits them is rounding alone.
#include <gtest/gtest.h>

#include "core/quad.h"
#include "optics/boundary_helpers.h"
#include "optics/evanescent_modes.h"

namespace pol::test {
namespace {

template <class Real>
Vec3<Real> widened(const DVec3& v) {
    return {Real(v.x), Real(v.y), Real(v.z)};
}

template <class Real>
Dielectric<Real> widened(const Dielectric<double>& m) {
    if (m.kind == MediumKind::isotropic) return make_isotropic(Real(m.n));
    if (m.kind == MediumKind::conductor) return make_conductor(Real(m.n), Real(m.kappa));
    return make_uniaxial(Real(m.n), Real(m.n_e), widened<Real>(m.axis));
}

/// Largest |R + T + A - 1| over random interfaces of all kinds, evanescent waves included.
template <class Real>
double largest_energy_defect() {
    Dice dice(128);
    double worst = 0.0;
    std::size_t evanescent = 0;
    for (int i = 0; i < 300; ++i) {
        const auto from = widened<Real>(dice.any());
        const auto to = widened<Real>(i % 5 == 0 ? make_conductor(0.3, 2.8) : dice.any());
        const auto normal = unit(widened<Real>(dice.direction()));
        const auto waves = waves_of_wave_normal(from, unit(widened<Real>(dice.direction())));
        for (int w = 0; w < waves.count; ++w) {
            const auto r = respond(from, to, normal, waves.wave[w]);
            if (!r.incident) continue;
            evanescent += evanescent_modes(from, to, normal, waves.wave[w]).size();
            for (std::size_t j = 0; j < static_cast<std::size_t>(r.incident_modes); ++j) {
                worst = std::max(worst, std::abs(static_cast<double>(total_power(r, j) - Real(1))));
            }
        }
    }
    EXPECT_GT(evanescent, 50U);
    return worst;
}

// Random waves come within 1e-3 of grazing or critical, which costs at most three digits (derivative of sqrt q).
TEST(Precision, EnergyIsConservedToTheDigitsOfTheNumberType) {
    EXPECT_LT(largest_energy_defect<double>(), 1e-12);
    EXPECT_LT(largest_energy_defect<long double>(), 1e-12 / 1024.0);
    EXPECT_LT(largest_energy_defect<Quad>(), 1e-30);
}

TEST(Precision, AQuadrupleResultIsTheLimitOfTheDoubleOne) {
    const auto narrow = arrive(air, calcite({1.0, 2.0, 3.0}), up, DVec3(0.6, 0.0, 0.8));
    const auto from = widened<Quad>(air);
    const auto to = make_uniaxial(Quad(1.6584), Quad(1.4864), widened<Quad>(DVec3(1.0, 2.0, 3.0)));
    const auto wide = respond(from, to, widened<Quad>(up),
                              waves_of_wave_normal(from, unit(widened<Quad>(DVec3(0.6, 0.0, 0.8)))).wave[0]);
    ASSERT_EQ(narrow.outgoing_count, wide.outgoing_count);
    for (const WaveKind kind : {WaveKind::ordinary, WaveKind::extraordinary}) {
        for (std::size_t j = 0; j < 2; ++j) {
            EXPECT_NEAR(static_cast<double>(power(wide, Side::transmitted, kind, j)),
                        power(narrow, Side::transmitted, kind, j), 8.0 * eps);
        }
    }
}

TEST(Precision, FresnelOfLongDoublesKeepsTheirDigits) {
    const long double n2 = 1.5L + 1e-15L;
    const auto f = fresnel(1.5L, n2, 1.5L * 0.8L);
    const long double expected = -(n2 - 1.5L) / (2.0L * 1.5L * 0.64L);
    EXPECT_NEAR(static_cast<double>(f.r_s.re / expected), 1.0, 1e-14);
}

}  // namespace
}  // namespace pol::test
