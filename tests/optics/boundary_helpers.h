// SPDX-License-Identifier: Apache-2.0
// Short words for what the boundary tests ask.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "optics/boundary_solver.h"

namespace pol::test {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double degree = std::numbers::pi / 180.0;
const DVec3 up(0.0, 0.0, 1.0);

inline const Dielectric<double> air = make_isotropic(1.0);
inline const Dielectric<double> glass = make_isotropic(1.5);
/// The literal calcite of PHYSICS.md 5.
inline Dielectric<double> calcite(const DVec3& axis) {
    return make_uniaxial(1.6584, 1.4864, axis);
}

/// Unit vector in the xz plane at `angle` from +z.
inline DVec3 tilted(double angle) {
    return {std::sin(angle), 0.0, std::cos(angle)};
}

/// Power that goes into one kind of wave on one side, for unit flux in incident mode `column`.
template <class Real>
Real power(const BoundaryResponse<Real>& r, Side side, WaveKind kind, std::size_t column) {
    Real sum(0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(r.outgoing_count); ++i) {
        if (r.outgoing[i].side != side || r.outgoing[i].wave.kind != kind) continue;
        for (const auto& row : r.outgoing[i].amplitude) sum += norm2(row[column]);
    }
    return sum;
}

template <class Real>
Real side_power(const BoundaryResponse<Real>& r, Side side, std::size_t column) {
    return power(r, side, WaveKind::pair, column) + power(r, side, WaveKind::ordinary, column) +
           power(r, side, WaveKind::extraordinary, column);
}

/// R + T + absorbed.
template <class Real>
Real total_power(const BoundaryResponse<Real>& r, std::size_t column) {
    return side_power(r, Side::reflected, column) + side_power(r, Side::transmitted, column) +
           r.absorption[column][column].re;
}

/// The outgoing wave of that kind, or nullptr.
template <class Real>
const OutgoingWave<Real>* find(const BoundaryResponse<Real>& r, Side side, WaveKind kind) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(r.outgoing_count); ++i) {
        if (r.outgoing[i].side == side && r.outgoing[i].wave.kind == kind) return &r.outgoing[i];
    }
    return nullptr;
}

/// What leaves when the only wave (a pair), or the o (0) or e (1) wave, with wave normal `s` arrives.
inline BoundaryResponse<double> arrive(const Dielectric<double>& from, const Dielectric<double>& to,
                                       const DVec3& normal, const DVec3& s, int wave = 0) {
    return respond(from, to, normal, waves_of_wave_normal(from, s).wave[wave]);
}

/// Directions and media from a fixed seed.
class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    DVec3 direction() {
        for (;;) {
            const DVec3 v(uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-1.0, 1.0));
            if (length2(v) > 0.01 && length2(v) < 1.0) return unit(v);
        }
    }
    Dielectric<double> isotropic() { return make_isotropic(uniform(1.0, 2.6)); }
    Dielectric<double> crystal() { return make_uniaxial(uniform(1.3, 2.6), uniform(1.3, 2.6), direction()); }
    Dielectric<double> any() { return uniform(0.0, 1.0) < 0.4 ? isotropic() : crystal(); }

private:
    std::mt19937_64 engine_;
};

}  // namespace pol::test
