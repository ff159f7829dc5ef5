// SPDX-License-Identifier: Apache-2.0
// The results of the stiffness suite as plots and as one page that can be mailed.
#pragma once

#include <string>
#include <vector>

#include "verify/plot_svg.h"
#include "verify/stiff.h"

namespace pol::verify {

/// Error, condition and limit over the knob; stiffer settings to the right.
Plot stiff_plot(const StiffResult& result);

/// "1e-01 .. 1e-16, 0".
std::string range_text(const StiffCase& stiff_case);

/// Verdicts, the untested rows and all plots as a part of a page, and as a self-contained page.
std::string stiff_section(const std::vector<StiffResult>& results);
std::string stiff_page(const std::vector<StiffResult>& results);

}  // namespace pol::verify
