// SPDX-License-Identifier: Apache-2.0
// The solver against a 110-digit solution of the same boundary problems (oracle.py).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "optics/boundary_helpers.h"
#include "optics/evanescent_modes.h"
#include "optics/oracle_vectors.h"

namespace pol::test {
namespace {

WaveKind kind_of(const OracleMode& mode) {
    if (mode.in_pair()) return WaveKind::pair;
    return mode.label == "o" ? WaveKind::ordinary : WaveKind::extraordinary;
}

/// One incident wave of a case: one of the oracle's modes, or both modes of a pair.
struct Arrival {
    const OracleCase& facts;
    std::vector<const OracleIncident*> modes;
    Wave<double> wave;
    BoundaryResponse<double> response;
};

const std::vector<OracleCase>& cases() {
    static const std::vector<OracleCase> all = load_oracle_cases();
    return all;
}

template <class Check>
void for_each_arrival(const Check& check) {
    for (const OracleCase& facts : cases()) {
        const WavesOfNormal<double> waves = waves_of_wave_normal(facts.medium1, facts.wave_normal);
        for (int i = 0; i < waves.count; ++i) {
            const Wave<double>& wave = waves.wave[i];
            Arrival arrival{facts, {}, wave, respond(facts.medium1, facts.medium2, facts.normal, wave)};
            for (const OracleIncident& in : facts.incident) {
                if (kind_of(in.mode) == wave.kind) arrival.modes.push_back(&in);
            }
            SCOPED_TRACE(facts.category + " case " + std::to_string(facts.number) + " wave " + std::to_string(i));
            ASSERT_EQ(arrival.modes.size(), wave.kind == WaveKind::pair ? 2U : 1U);
            check(arrival);
        }
    }
}

double largest_index(const OracleCase& facts) {
    return std::max({facts.medium1.n, facts.medium1.n_e, facts.medium2.n, facts.medium2.n_e});
}

/// A power is the square of a quotient of sums of a few dozen rounded products of O(1): 16 eps where nothing cancels,
/// and where something does, as much as if every input were off by some ulps: the oracle measured what one ulp does. If
/// both waves of a crystal are evanescent and nearly one (they coincide in isolated directions, axis in the face), the
/// system that they span is ill-conditioned like 1/|1 - k_e/k_o|.
double power_tolerance(const OracleCase& facts) {
    double closeness = 0.0;
    for (const OracleIncident& in : facts.incident) {
        for (std::size_t i = 0; i + 1 < in.out.size(); ++i) {
            const OracleMode& a = in.out[i];
            const OracleMode& b = in.out[i + 1];
            if (!a.evanescent || !b.evanescent || a.side != b.side || a.in_pair()) continue;
            closeness = std::max(closeness, std::sqrt(length2(a.k_im) / length2(a.k_im - b.k_im)));
        }
    }
    return 16.0 * eps + 8.0 * facts.sensitivity + std::min(closeness, 1e4) * eps;
}

TEST(Oracle, HasTwoThousandCasesAndEveryCategory) {
    std::map<std::string, int> count;
    for (const OracleCase& facts : cases()) ++count[facts.category];
    EXPECT_EQ(count.size(), 21U);
    for (const auto& [category, number] : count) EXPECT_GE(number, 96) << category;
    EXPECT_GE(cases().size(), 2000U);
}

TEST(Oracle, AgreesWhichWavesBringEnergy) {
    for_each_arrival([](const Arrival& a) {
        for (const OracleIncident* in : a.modes) EXPECT_EQ(a.response.incident, in->incident);
    });
}

TEST(Oracle, AgreesOnEveryPower) {
    for_each_arrival([](const Arrival& a) {
        if (!a.response.incident) return;
        std::map<std::pair<Side, WaveKind>, double> expected;
        for (const OracleIncident* in : a.modes) {
            for (const OracleMode& out : in->out) expected[{out.side, kind_of(out)}] += out.power;
        }
        for (const auto& [wave, sum] : expected) {
            double got = 0.0;
            for (std::size_t j = 0; j < a.modes.size(); ++j) got += power(a.response, wave.first, wave.second, j);
            EXPECT_NEAR(got, sum, power_tolerance(a.facts));
        }
        for (std::size_t j = 0; j < a.modes.size(); ++j)
            EXPECT_NEAR(total_power(a.response, j), 1.0, power_tolerance(a.facts));
    });
}

/// |k| is read from the index; along the boundary k moves with its inputs, and q with the slope of the slowness
/// surface, which is 1/|ray.n|. 8 ulps for the handful of roundings from the input to q.
TEST(Oracle, AgreesOnWaveVectorsAndRays) {
    for_each_arrival([](const Arrival& a) {
        if (!a.response.incident) return;
        for (std::size_t i = 0; i < static_cast<std::size_t>(a.response.outgoing_count); ++i) {
            const OutgoingWave<double>& got = a.response.outgoing[i];
            const auto& list = a.modes[0]->out;
            const auto expected = std::find_if(list.begin(), list.end(), [&](const OracleMode& o) {
                return o.side == got.side && kind_of(o) == got.wave.kind;
            });
            ASSERT_NE(expected, list.end());
            ASSERT_FALSE(expected->evanescent);
            const double slope = 1.0 / std::abs(dot(expected->ray, a.facts.normal));
            const double n = largest_index(a.facts);
            EXPECT_LE(std::sqrt(length2(got.wave.k - expected->k)), 8.0 * eps * n * slope);
            // The ray is unit(eps k): its error is that of k times the anisotropy at most.
            const Dielectric<double>& medium = got.side == Side::reflected ? a.facts.medium1 : a.facts.medium2;
            const double ratio = std::max(medium.n, medium.n_e) / std::min(medium.n, medium.n_e);
            EXPECT_LE(std::sqrt(length2(got.wave.ray - expected->ray)),
                      8.0 * eps * ratio * ratio * slope * n / medium.n);
        }
    });
}

/// q^2 of an evanescent wave is off by some ulps of n^2 (times the anisotropy), so q by that over 2 |q|.
TEST(Oracle, AgreesOnEvanescentWaves) {
    int seen = 0;
    for_each_arrival([&](const Arrival& a) {
        if (!a.response.incident || a.facts.category == "same-medium") return;
        const auto modes = evanescent_modes(a.facts.medium1, a.facts.medium2, a.facts.normal, a.wave);
        std::size_t next = 0;
        for (const OracleMode& out : a.modes[0]->out) {
            if (!out.evanescent) continue;
            ASSERT_LT(next, modes.size());
            const EvanescentMode<double>& got = modes[next++];
            EXPECT_EQ(got.side, out.side);
            EXPECT_EQ(got.kind, kind_of(out));
            const double n = largest_index(a.facts);
            const double tolerance = 8.0 * eps * n * (1.0 + n / std::sqrt(length2(out.k_im)));
            EXPECT_LE(std::sqrt(length2(got.k_re - out.k)), tolerance);
            EXPECT_LE(std::sqrt(length2(got.k_im - out.k_im)), tolerance);
            ++seen;
        }
        EXPECT_EQ(next, modes.size());
    });
    EXPECT_GT(seen, 100);
}

/// Largest slope of the slowness surfaces at a boundary, 1/|ray.n|, or n/|k_im| for evanescent waves: an ulp of k_t
/// moves q by that.
double steepest(const Arrival& a) {
    double slope = 1.0 / std::abs(dot(a.wave.ray, a.facts.normal));
    for (const OracleMode& out : a.modes[0]->out) {
        slope = std::max(slope, out.evanescent ? largest_index(a.facts) / std::sqrt(length2(out.k_im))
                                               : 1.0 / std::abs(dot(out.ray, a.facts.normal)));
    }
    return slope;
}

/// sum_ij amplitude_ij E_i E_j^T does not depend on the signs of the fields, nor on the basis of a pair: it shows
/// phases and fields both. Flux-normalised amplitudes go with sqrt(q) of nearly grazing waves, so an ulp of k_t moves
/// them by slope^(3/2) ulps. The fields of o and e turn by an ulp over the angle from the axis.
TEST(Oracle, AgreesOnAmplitudesAndFields) {
    int seen = 0;
    for_each_arrival([&](const Arrival& a) {
        if (!a.response.incident || !a.modes[0]->mode.field) return;
        for (std::size_t i = 0; i < static_cast<std::size_t>(a.response.outgoing_count); ++i) {
            const OutgoingWave<double>& got = a.response.outgoing[i];
            double error2 = 0.0;
            for (int row = 0; row < 3; ++row) {
                for (int column = 0; column < 3; ++column) {
                    Complex<double> t;
                    for (const OracleIncident* in : a.modes) {
                        for (const OracleMode& out : in->out) {
                            if (out.side != got.side || kind_of(out) != got.wave.kind) continue;
                            t += out.amplitude * ((*out.field)[row] * (*in->mode.field)[column]);
                        }
                    }
                    for (std::size_t m = 0; m < static_cast<std::size_t>(got.wave.mode_count()); ++m) {
                        for (std::size_t j = 0; j < a.modes.size(); ++j) {
                            t -= got.amplitude[m][j] * (got.wave.field[m][row] * a.response.incident_field[j][column]);
                        }
                    }
                    error2 += norm2(t);
                }
            }
            const bool crystal = a.facts.medium1.kind == MediumKind::uniaxial && a.wave.kind != WaveKind::pair;
            const double sine = std::sqrt(length2(cross(a.facts.wave_normal, a.facts.medium1.axis)));
            EXPECT_LE(std::sqrt(error2), 16.0 * eps * (std::pow(steepest(a), 1.5) + (crystal ? 1.0 / sine : 0.0)));
            ++seen;
        }
    });
    EXPECT_GT(seen, 300);
}

}  // namespace
}  // namespace pol::test
