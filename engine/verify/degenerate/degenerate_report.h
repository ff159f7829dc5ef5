// SPDX-License-Identifier: Apache-2.0
// The results of the suite of degenerate cases as plots and as one page that can be mailed.
#pragma once

#include <string>
#include <vector>

#include "report/plot_svg.h"
#include "verify/degenerate/degenerate_case.h"

namespace pol::verify {

/// Error, condition and limit over the knob; settings nearer to the singular point to the right.
Plot degenerate_plot(const DegenerateResult& result);

/// "1e-01 .. 1e-16, 0".
std::string range_text(const DegenerateCase& degenerate_case);

/// Verdicts, what no sweep drives and all plots as a part of a page, and as a self-contained page.
std::string degenerate_section(const std::vector<DegenerateResult>& results);
std::string degenerate_page(const std::vector<DegenerateResult>& results);

}  // namespace pol::verify
