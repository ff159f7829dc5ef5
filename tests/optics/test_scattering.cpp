// SPDX-License-Identifier: Apache-2.0
// The scattering matrix as a whole: unitary and reciprocal (PHYSICS.md 2.7, 2.8), amplitudes with their phases.
#include <gtest/gtest.h>

#include <vector>

#include "optics/boundary_helpers.h"

namespace pol::test {
namespace {

/// A channel is one mode: its wave vector and field, and the medium it lives in.
struct Channel {
    int medium = 0;
    WaveKind kind = WaveKind::pair;
    Vec3<double> k{}, field{};
};

struct Column {
    Channel in;
    std::vector<Channel> out;
    std::vector<Complex<double>> amplitude;
};

struct Interface {
    Dielectric<double> medium[2];
    DVec3 normal{};  // from medium[0] to medium[1]
};

std::vector<Column> scatter(const Interface& face, int side, const Wave<double>& wave) {
    const auto r = respond(face.medium[side], face.medium[1 - side], side == 0 ? face.normal : -face.normal, wave);
    std::vector<Column> columns;
    if (!r.incident) return columns;
    for (std::size_t j = 0; j < static_cast<std::size_t>(r.incident_modes); ++j) {
        Column column{{side, wave.kind, wave.k, r.incident_field[j]}, {}, {}};
        for (std::size_t i = 0; i < static_cast<std::size_t>(r.outgoing_count); ++i) {
            const auto& out = r.outgoing[i];
            for (std::size_t m = 0; m < static_cast<std::size_t>(out.wave.mode_count()); ++m) {
                column.out.push_back(
                    {out.side == Side::reflected ? side : 1 - side, out.wave.kind, out.wave.k, out.wave.field[m]});
                column.amplitude.push_back(out.amplitude[m][j]);
            }
        }
        columns.push_back(std::move(column));
    }
    return columns;
}

Wave<double> reversed(const Wave<double>& wave) {
    Wave<double> back = wave;
    back.k = -wave.k;
    back.ray = -wave.ray;
    return back;
}

/// All waves that come in with the tangential wave vector of `first`: those it leaves by, sent back from both sides,
/// turned by half a turn about the normal. Half-turns change media, so they are not symmetric; the columns are found
/// instead by sending back the outgoing waves, whose outgoing waves sent back have k_t of `first` again.
std::vector<Wave<double>> waves_out(const Interface& face, int side, const Wave<double>& wave,
                                    std::vector<int>& sides) {
    std::vector<Wave<double>> waves;
    const auto r = respond(face.medium[side], face.medium[1 - side], side == 0 ? face.normal : -face.normal, wave);
    for (std::size_t i = 0; i < static_cast<std::size_t>(r.outgoing_count); ++i) {
        waves.push_back(r.outgoing[i].wave);
        sides.push_back(r.outgoing[i].side == Side::reflected ? side : 1 - side);
    }
    return waves;
}

/// Amplitude from channel a to the reverse of channel b, with E taken as it is.
Complex<double> amplitude_between(const std::vector<Column>& columns, const Channel& from, const Channel& to) {
    Complex<double> sum;
    for (const Column& column : columns) {
        const double in = from.kind == WaveKind::pair ? dot(column.in.field, from.field)
                                                      : (dot(column.in.field, from.field) > 0.0 ? 1.0 : -1.0);
        for (std::size_t i = 0; i < column.out.size(); ++i) {
            const Channel& out = column.out[i];
            if (out.medium != to.medium || out.kind != to.kind) continue;
            const double f =
                to.kind == WaveKind::pair ? dot(out.field, to.field) : (dot(out.field, to.field) > 0.0 ? 1.0 : -1.0);
            sum += column.amplitude[i] * (in * f);
        }
    }
    return sum;
}

Interface random_interface(Dice& dice) {
    Interface face{{dice.any(), dice.any()}, dice.direction()};
    if (dice.uniform(0.0, 1.0) < 0.2)
        face.medium[1] = make_uniaxial(face.medium[0].n, face.medium[0].n + 0.1, dice.direction());
    return face;
}

TEST(Scattering, IsReciprocalInComplexAmplitudes) {
    Dice dice(8);
    int compared = 0, with_phase = 0;
    for (int i = 0; i < 1500; ++i) {
        const Interface face = random_interface(dice);
        const auto waves = waves_of_wave_normal(face.medium[0], dice.direction());
        for (int w = 0; w < waves.count; ++w) {
            const auto forward = scatter(face, 0, waves.wave[w]);
            std::vector<int> sides;
            const auto out = waves_out(face, 0, waves.wave[w], sides);
            for (std::size_t o = 0; o < out.size(); ++o) {
                const auto backward = scatter(face, sides[o], reversed(out[o]));
                ASSERT_FALSE(backward.empty());
                for (const Column& column : forward) {
                    for (std::size_t c = 0; c < column.out.size(); ++c) {
                        if (column.out[c].medium != sides[o] || column.out[c].kind != out[o].kind) continue;
                        const Complex<double> there = column.amplitude[c];
                        const Complex<double> back = amplitude_between(backward, column.out[c], column.in);
                        // 1e-10: as for energy, nearly critical or grazing waves among the random ones.
                        EXPECT_LT(abs(there - back), 1e-10);
                        ++compared;
                        with_phase += std::abs(there.im) > 1e-3;
                    }
                }
            }
        }
    }
    EXPECT_GT(compared, 3000);
    EXPECT_GT(with_phase, 300);
}

TEST(Scattering, IsUnitary) {
    // Columns of different incoming channels with the same k_t: s and p of a pair; and a wave with the reverses of what
    // leaves for its reverse. S^H S = 1: columns are orthonormal, complex phases included.
    Dice dice(21);
    int compared = 0;
    for (int i = 0; i < 1500; ++i) {
        const Interface face = random_interface(dice);
        const auto waves = waves_of_wave_normal(face.medium[0], dice.direction());
        for (int w = 0; w < waves.count; ++w) {
            std::vector<Column> columns = scatter(face, 0, waves.wave[w]);
            if (columns.empty()) continue;
            // Reverse one outgoing wave; what then leaves, reversed again, comes in with the original k_t.
            std::vector<int> sides;
            const auto out = waves_out(face, 0, waves.wave[w], sides);
            std::vector<int> in_sides;
            const auto in = waves_out(face, sides[0], reversed(out[0]), in_sides);
            for (std::size_t n = 0; n < in.size(); ++n) {
                if (in_sides[n] == 0 && in[n].kind == waves.wave[w].kind) continue;  // the wave itself
                for (const Column& column : scatter(face, in_sides[n], reversed(in[n]))) columns.push_back(column);
            }
            for (std::size_t a = 0; a < columns.size(); ++a) {
                for (std::size_t b = 0; b < columns.size(); ++b) {
                    Complex<double> sum;
                    for (std::size_t x = 0; x < columns[a].out.size(); ++x) {
                        for (std::size_t y = 0; y < columns[b].out.size(); ++y) {
                            const Channel& p = columns[a].out[x];
                            const Channel& q = columns[b].out[y];
                            if (p.medium != q.medium || p.kind != q.kind) continue;
                            double overlap = dot(p.field, q.field);
                            if (p.kind != WaveKind::pair) overlap = overlap > 0.0 ? 1.0 : -1.0;
                            sum += conj(columns[a].amplitude[x]) * columns[b].amplitude[y] * overlap;
                        }
                    }
                    EXPECT_LT(abs(sum - Complex<double>(a == b ? 1.0 : 0.0)), 1e-10);
                    ++compared;
                }
            }
        }
    }
    EXPECT_GT(compared, 10000);
}

}  // namespace
}  // namespace pol::test
