// SPDX-License-Identifier: Apache-2.0
#include "viewer/shown/polarimeter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/units.h"

namespace pol {

bool Polarimeter::empty() const {
    return std::none_of(elements.begin(), elements.end(), [](const PolarimeterElement& e) { return e.in_beam; });
}

MuellerMatrix<double> Polarimeter::mueller() const {
    const DVec3 x(1.0, 0.0, 0.0);
    const DVec3 y(0.0, 1.0, 0.0);
    const DVec3 k(0.0, 0.0, 1.0);
    JonesMatrix<double> train = JonesMatrix<double>::identity();
    for (const PolarimeterElement& element : elements) {
        if (!element.in_beam) continue;
        const DVec3 axis(std::cos(element.axis), std::sin(element.axis), 0.0);
        const Sheet sheet = element.kind == PolarimeterElementKind::polarizer
                                ? Sheet{LinearPolarizer{axis, PolarizerModel::passing}}
                                : Sheet{Retarder{axis, element.retardance}};
        train = sheet_jones(sheet, k, k, x, y) * train;
    }
    return to_mueller(train);
}

std::span<const StandardAnalyzer> standard_analyzers() {
    const auto linear = [](double axis) { return Polarimeter{{{PolarimeterElementKind::polarizer, true, axis, 0.0}}}; };
    // A quarter wave with its fast axis along x turns right circular light into linear light at +45 degrees.
    const auto circular = [](double axis) {
        return Polarimeter{{{PolarimeterElementKind::retarder, true, 0.0, 0.5 * pi},
                            {PolarimeterElementKind::polarizer, true, axis, 0.0}}};
    };
    static const std::array<StandardAnalyzer, 6> analyzers{{
        {{1.0, 1.0, 0.0, 0.0}, linear(0.0)},
        {{1.0, -1.0, 0.0, 0.0}, linear(0.5 * pi)},
        {{1.0, 0.0, 1.0, 0.0}, linear(0.25 * pi)},
        {{1.0, 0.0, -1.0, 0.0}, linear(0.75 * pi)},
        {{1.0, 0.0, 0.0, 1.0}, circular(0.25 * pi)},
        {{1.0, 0.0, 0.0, -1.0}, circular(0.75 * pi)},
    }};
    return analyzers;
}

PixelLight behind(const MuellerMatrix<double>& train, const PixelLight& light) {
    PixelLight result = light;
    result.known = known_behind(train, light.known);
    result.stokes = only(result.known, train * light.stokes);
    if (light.scale == 0.0) result.scale = light.stokes.s0;
    return result;
}

}  // namespace pol
