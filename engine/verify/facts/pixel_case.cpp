// SPDX-License-Identifier: Apache-2.0
#include "verify/facts/pixel_case.h"

#include <algorithm>
#include <cmath>

#include "core/hypot.h"
#include "core/result.h"
#include "plan/compile.h"

namespace pol {

Result<PixelCaseVerdict> check(const PixelCase& c) {
    POL_TRY(auto plan, compile(c.scene));
    PixelCaseVerdict verdict;
    verdict.plan = std::move(plan);
    const std::vector<double>& wavelengths = verdict.plan->wavelengths_nm;
    const auto wavelength = std::find(wavelengths.begin(), wavelengths.end(), c.wavelength_nm) - wavelengths.begin();
    verdict.explanation = explain(*verdict.plan, c.x, c.y, c.sample, static_cast<int>(wavelength));
    verdict.computed = to_coherence(verdict.explanation.sample_light);
    const auto off = [](double a, double b) { return std::abs(a - b); };
    verdict.difference = off(verdict.computed.xx, c.expected.xx);
    for (const double d :
         {off(verdict.computed.yy, c.expected.yy),
          pol::hypot(verdict.computed.xy.re - c.expected.xy.re, verdict.computed.xy.im - c.expected.xy.im)})
        if (!(d <= verdict.difference)) verdict.difference = d;
    const double allowed = c.tolerance * trace(c.expected);
    verdict.holds = verdict.computed == c.expected || verdict.difference <= allowed;
    return verdict;
}

}  // namespace pol
