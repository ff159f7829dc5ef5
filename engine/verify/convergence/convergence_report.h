// SPDX-License-Identifier: Apache-2.0
// Error against run time as a page that can be mailed, and its plots as SVG.
#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "maps/colorize.h"
#include "report/plot_svg.h"
#include "verify/convergence/convergence.h"

namespace pol::verify {

/// A plot and the name of its file, without ending.
struct NamedPlot {
    std::string name;
    Plot plot;
};

/// Work against precision (one line per series with its band over seeds, the reference's own error as floor; points
/// below three times the floor are left out), and the rigorous bound beside the true error of truncation.
std::vector<NamedPlot> convergence_plots(const ConvergenceResult& result);

/// The picture at three budgets, each with the map of its error: re-rendered, so the request must be that of the
/// result.
struct BudgetPicture {
    std::string caption;
    RgbPicture picture;
    RgbPicture error;
};
Result<std::vector<BudgetPicture>> budget_pictures(const ConvergenceRequest& request, const ConvergenceResult& result);

/// Curves, tables and pictures as a part of a page. `command` is the command line that makes it again.
std::string convergence_section(const ConvergenceRequest& request, const ConvergenceResult& result,
                                const std::vector<BudgetPicture>& pictures, const std::string& command);

}  // namespace pol::verify
