// SPDX-License-Identifier: Apache-2.0
// Time of the convention doctor on two pictures of a million pixels. Aim: 100 ms with one band.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "compare/pairing.h"

namespace pol::compare {
namespace {

/// 1000 x 1000 pixels of waves in all components.
StokesImage waves(std::size_t bands) {
    StokesImage image;
    image.width = 1000;
    image.height = 1000;
    std::vector<double> wavelengths;
    for (std::size_t b = 0; b < bands; ++b) {
        wavelengths.push_back(400.0 + 10.0 * static_cast<double>(b));
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                image.stokes.push_back({2.0 + std::sin(0.004 * x + 0.007 * y), 0.5 * std::sin(0.003 * x - 0.006 * y),
                                        0.4 * std::cos(0.008 * x), 0.3 * std::sin(0.005 * y + 1.0)});
    }
    image.bands = bands_at(wavelengths);
    return image;
}

void diagnose_pair(benchmark::State& state) {
    const StokesImage a = waves(static_cast<std::size_t>(state.range(0)));
    StokesImage b = a;
    for (Stokes<double>& s : b.stokes) s.s3 = -s.s3;
    const auto pairing = pair_up(a, b);
    for (auto _ : state) benchmark::DoNotOptimize(diagnose(a, b, pairing.value()));
}
BENCHMARK(diagnose_pair)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pol::compare
