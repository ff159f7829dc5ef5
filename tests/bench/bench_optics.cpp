// SPDX-License-Identifier: Apache-2.0
// Time of one interface per kind of media pair. Aim: 250 ns for a uniaxial interface with its modes, 15 ns for Fresnel.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>

#include "optics/boundary_solver.h"

namespace pol {
namespace {

constexpr std::size_t waves = 64;

/// Wave normals spread over incidence angles up to `steepest` radians.
std::array<DVec3, waves> normals(double steepest) {
    std::array<DVec3, waves> list;
    for (std::size_t i = 0; i < waves; ++i) {
        const double angle = steepest * (static_cast<double>(i) + 0.5) / waves;
        const double azimuth = 2.4 * static_cast<double>(i);
        list[i] = {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
    }
    return list;
}

void respond_to(benchmark::State& state, const Dielectric<double>& from, const Dielectric<double>& to, int mode,
                double steepest = 1.4) {
    std::array<Wave<double>, waves> incident;
    const auto directions = normals(steepest);
    for (std::size_t i = 0; i < waves; ++i) incident[i] = waves_of_wave_normal(from, directions[i]).wave[mode];
    std::size_t i = 0;
    for (auto _ : state) benchmark::DoNotOptimize(respond(from, to, DVec3(0.0, 0.0, 1.0), incident[i++ % waves]));
}

const auto air = make_isotropic(1.0);
const auto glass = make_isotropic(1.5);
const auto gold = make_conductor(0.3, 2.84);
const auto calcite = make_uniaxial(1.6584, 1.4864, DVec3(1.0, 2.0, 3.0));
const auto twin = make_uniaxial(1.6584, 1.4864, DVec3(-1.0, 2.0, 3.0));

void fresnel_alone(benchmark::State& state) {
    std::array<double, waves> q;
    for (std::size_t i = 0; i < waves; ++i) q[i] = std::cos(1.4 * static_cast<double>(i) / waves);
    std::size_t i = 0;
    for (auto _ : state) benchmark::DoNotOptimize(fresnel(1.0, 1.5, q[i++ % waves]));
}
void conductor_alone(benchmark::State& state) {
    std::array<double, waves> q;
    for (std::size_t i = 0; i < waves; ++i) q[i] = std::cos(1.4 * static_cast<double>(i) / waves);
    std::size_t i = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(absorbing_fresnel<double>({1.0, 0.0}, {0.3, 2.84}, 1.0, q[i++ % waves]));
}
void isotropic_to_isotropic(benchmark::State& state) {
    respond_to(state, air, glass, 0);
}
void isotropic_to_conductor(benchmark::State& state) {
    respond_to(state, air, gold, 0);
}
void isotropic_to_uniaxial(benchmark::State& state) {
    respond_to(state, air, calcite, 0);
}
void uniaxial_o_to_isotropic(benchmark::State& state) {
    respond_to(state, calcite, air, 0, 0.6);
}
void uniaxial_e_to_isotropic(benchmark::State& state) {
    respond_to(state, calcite, air, 1, 0.6);
}
void uniaxial_total_reflection(benchmark::State& state) {
    respond_to(state, calcite, air, 0);
}
void uniaxial_to_uniaxial(benchmark::State& state) {
    respond_to(state, calcite, twin, 0, 1.0);
}
void uniaxial_to_conductor(benchmark::State& state) {
    respond_to(state, calcite, gold, 1, 1.0);
}

BENCHMARK(fresnel_alone);
BENCHMARK(conductor_alone);
BENCHMARK(isotropic_to_isotropic);
BENCHMARK(isotropic_to_conductor);
BENCHMARK(isotropic_to_uniaxial);
BENCHMARK(uniaxial_o_to_isotropic);
BENCHMARK(uniaxial_e_to_isotropic);
BENCHMARK(uniaxial_total_reflection);
BENCHMARK(uniaxial_to_uniaxial);
BENCHMARK(uniaxial_to_conductor);

}  // namespace
}  // namespace pol
