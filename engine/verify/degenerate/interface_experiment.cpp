// SPDX-License-Identifier: Apache-2.0
#include "verify/degenerate/interface_experiment.h"

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

#include "optics/boundary_solver.h"

namespace pol::verify {

namespace {

/// Rounding a unit vector to doubles makes its length wrong by an ulp; more digits show that and must take it back.
template <class Real>
Vec3<Real> true_direction(const Vec3<Real>& v) {
    return std::is_same_v<Real, Quad> ? unit(v) : v;
}

template <class Real>
Dielectric<Real> take_medium(MediumKind kind, std::span<const Real>& x) {
    const auto take = [&x](std::size_t count) {
        const auto head = x.first(count);
        x = x.subspan(count);
        return head;
    };
    if (kind == MediumKind::isotropic) return make_isotropic(take(1)[0]);
    if (kind == MediumKind::conductor) {
        const auto n = take(2);
        return make_conductor(n[0], n[1]);
    }
    const auto n = take(5);
    return {MediumKind::uniaxial, n[0], n[1], Real(0), true_direction(Vec3<Real>{n[2], n[3], n[4]})};
}

void append_medium(std::vector<double>& inputs, const Dielectric<double>& m) {
    inputs.push_back(m.n);
    if (m.kind == MediumKind::conductor) inputs.push_back(m.kappa);
    if (m.kind == MediumKind::uniaxial) inputs.insert(inputs.end(), {m.n_e, m.axis.x, m.axis.y, m.axis.z});
}

/// Two linear states, in general position to everything.
template <class Real>
std::array<Vec3<Real>, 2> incident_states() {
    return {Vec3<Real>{Real(0.48), Real(-0.6), Real(0.64)}, Vec3<Real>{Real(0.8), Real(0.0), Real(-0.6)}};
}

/// The formula: inputs as interface_inputs lists them.
struct InterfaceFormula {
    MediumKind from = MediumKind::isotropic;
    MediumKind to = MediumKind::isotropic;
    InterfaceResults asked = InterfaceResults::waves;

    template <class Real>
    std::vector<Real> operator()(std::span<const Real> x) const {
        const Vec3<Real> normal = true_direction(Vec3<Real>{x[0], x[1], x[2]});
        const Vec3<Real> wave_normal = true_direction(Vec3<Real>{x[3], x[4], x[5]});
        x = x.subspan(6);
        const Dielectric<Real> medium1 = take_medium<Real>(from, x);
        const Dielectric<Real> medium2 = take_medium<Real>(to, x);
        const WavesOfNormal<Real> waves = waves_of_wave_normal(medium1, wave_normal);
        std::vector<BoundaryResponse<Real>> responses;
        for (std::size_t w = 0; w < static_cast<std::size_t>(waves.count); ++w)
            responses.push_back(respond(medium1, medium2, normal, waves.wave[w]));
        if (asked == InterfaceResults::merged_fields) return merged_fields(responses);
        if (asked == InterfaceResults::unpolarized_powers) return unpolarized_powers(responses);
        return wave_results(responses);
    }

private:
    static constexpr int slots = 6;

    template <class Real>
    static std::size_t slot(const OutgoingWave<Real>& out) {
        return (out.side == Side::reflected ? 0U : 3U) + static_cast<std::size_t>(out.wave.kind);
    }

    template <class Real>
    [[nodiscard]] bool asks_for(std::size_t slot) const {
        if (asked == InterfaceResults::transmitted_powers) return slot >= 3;
        if (asked == InterfaceResults::reflected_powers) return slot < 3;
        return true;
    }

    /// Amplitudes of the outgoing modes when state `f` arrives: column j weighs field_j . f; a crystal mode is itself.
    template <class Real>
    static std::array<Complex<Real>, 2> amplitudes(const BoundaryResponse<Real>& r, const OutgoingWave<Real>& out,
                                                   const Vec3<Real>& f, bool projected) {
        std::array<Complex<Real>, 2> a;
        const auto columns = static_cast<std::size_t>(r.incident_modes);
        for (std::size_t i = 0; i < static_cast<std::size_t>(out.wave.mode_count()); ++i) {
            if (!projected && columns == 1) {
                a[i] = out.amplitude[i][0];
                continue;
            }
            for (std::size_t j = 0; j < columns; ++j) a[i] = a[i] + out.amplitude[i][j] * dot(r.incident_field[j], f);
        }
        return a;
    }

    template <class Real>
    std::vector<Real> wave_results(const std::vector<BoundaryResponse<Real>>& responses) const {
        std::vector<Real> results;
        for (const auto& r : responses) {
            for (const Vec3<Real>& f : incident_states<Real>()) {
                std::array<Real, slots> power{};
                std::array<Vec3<Real>, slots> ray{};
                power.fill(Real(0));
                ray.fill(Vec3<Real>(Real(0)));
                for (std::size_t o = 0; o < static_cast<std::size_t>(r.outgoing_count); ++o) {
                    const auto a = amplitudes(r, r.outgoing[o], f, false);
                    const std::size_t s = slot(r.outgoing[o]);
                    power[s] = norm2(a[0]) + norm2(a[1]);
                    ray[s] = power[s] * r.outgoing[o].wave.ray;
                }
                for (std::size_t s = 0; s < slots; ++s) {
                    if (!asks_for<Real>(s)) continue;
                    results.push_back(power[s]);
                    if (asked == InterfaceResults::waves) results.insert(results.end(), {ray[s].x, ray[s].y, ray[s].z});
                }
                if (asked != InterfaceResults::transmitted_powers) append_absorbed(results, r, f);
                if (r.incident_modes == 1) break;
            }
        }
        return results;
    }

    template <class Real>
    static void append_absorbed(std::vector<Real>& results, const BoundaryResponse<Real>& r, const Vec3<Real>& f) {
        const std::size_t columns = r.absorbs ? static_cast<std::size_t>(r.incident_modes) : 0;
        Complex<Real> absorbed(Real(0));
        for (std::size_t i = 0; i < columns; ++i) {
            for (std::size_t j = 0; j < columns; ++j) {
                const Real weight = columns == 1 ? Real(1) : dot(r.incident_field[i], f) * dot(r.incident_field[j], f);
                absorbed += r.absorption[i][j] * weight;
            }
        }
        results.push_back(absorbed.re);
    }

    template <class Real>
    static std::vector<Real> unpolarized_powers(const std::vector<BoundaryResponse<Real>>& responses) {
        Real reflected(0);
        Real transmitted(0);
        Real absorbed(0);
        for (const auto& r : responses) {
            for (std::size_t o = 0; o < static_cast<std::size_t>(r.outgoing_count); ++o) {
                const OutgoingWave<Real>& out = r.outgoing[o];
                Real& side = out.side == Side::reflected ? reflected : transmitted;
                for (const auto& row : out.amplitude) side += norm2(row[0]) + norm2(row[1]);
            }
            absorbed += r.absorption[0][0].re + r.absorption[1][1].re;
        }
        const Real half = Real(1) / Real(2);
        return {reflected * half, transmitted * half, absorbed * half, (reflected + transmitted + absorbed) * half};
    }

    template <class Real>
    static std::vector<Real> merged_fields(const std::vector<BoundaryResponse<Real>>& responses) {
        std::vector<Real> results;
        for (const Vec3<Real>& f : incident_states<Real>()) {
            std::array<Real, 12> sum;
            sum.fill(Real(0));
            for (const auto& r : responses) {
                for (std::size_t o = 0; o < static_cast<std::size_t>(r.outgoing_count); ++o) {
                    const OutgoingWave<Real>& out = r.outgoing[o];
                    const std::size_t at = out.side == Side::reflected ? 0 : 6;
                    const auto a = amplitudes(r, out, f, true);
                    for (std::size_t m = 0; m < static_cast<std::size_t>(out.wave.mode_count()); ++m) {
                        for (int axis = 0; axis < 3; ++axis) {
                            const auto place = at + static_cast<std::size_t>(axis);
                            sum[place] += a[m].re * out.wave.field[m][axis];
                            sum[place + 3] += a[m].im * out.wave.field[m][axis];
                        }
                    }
                }
            }
            results.insert(results.end(), sum.begin(), sum.end());
        }
        return results;
    }
};

}  // namespace

std::vector<double> interface_inputs(const InterfaceSetup& setup) {
    std::vector<double> inputs = {setup.normal.x,      setup.normal.y,      setup.normal.z,
                                  setup.wave_normal.x, setup.wave_normal.y, setup.wave_normal.z};
    append_medium(inputs, setup.from);
    append_medium(inputs, setup.to);
    return inputs;
}

Experiment interface_experiment(const InterfaceSetup& setup, InterfaceResults asked, Accuracy accuracy) {
    return experiment_on(InterfaceFormula{setup.from.kind, setup.to.kind, asked}, interface_inputs(setup), accuracy);
}

}  // namespace pol::verify
