// SPDX-License-Identifier: Apache-2.0
#include "viewer/bench.h"

#include <algorithm>
#include <cmath>

namespace pol {

bool Bench::empty() const {
    return std::none_of(elements.begin(), elements.end(), [](const BenchElement& e) { return e.in_beam; });
}

MuellerMatrix<double> Bench::mueller() const {
    const DVec3 x(1.0, 0.0, 0.0);
    const DVec3 y(0.0, 1.0, 0.0);
    const DVec3 k(0.0, 0.0, 1.0);
    JonesMatrix<double> train{1.0, 0.0, 0.0, 1.0};
    for (const BenchElement& element : elements) {
        if (!element.in_beam) continue;
        const DVec3 axis(std::cos(element.axis), std::sin(element.axis), 0.0);
        const Sheet sheet = element.kind == BenchElementKind::polarizer ? Sheet{LinearPolarizer{axis}}
                                                                        : Sheet{Retarder{axis, element.retardance}};
        const auto f = sheet_jones(sheet, k, x, y);
        train = JonesMatrix<double>{f[0][0], f[0][1], f[1][0], f[1][1]} * train;
    }
    return to_mueller(train);
}

PixelLight behind(const MuellerMatrix<double>& train, const PixelLight& light) {
    PixelLight result = light;
    result.stokes = train * light.stokes;
    if (light.scale == 0.0) result.scale = light.stokes.s0;
    return result;
}

}  // namespace pol
