// SPDX-License-Identifier: Apache-2.0
// One calculation of the program beside the same calculation with more digits: how wrong it is, and how wrong nobody
// could help being.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/quad.h"
#include "verify/degenerate/chain.h"

namespace pol::verify {

/// What one ulp of a result is measured against.
enum class Accuracy {
    absolute,  ///< results are shares of 1, or parts of unit vectors
    relative,  ///< every result to its own size: for what is tiny and matters all the same
};

/// A calculation, its inputs, and a reference.
struct Experiment {
    std::vector<double> inputs;
    /// What the program makes of the inputs.
    std::function<std::vector<double>(std::span<const double>)> program;
    /// The same results of the same inputs with 113 bits: the program's own formulas, or a closed form.
    std::function<std::vector<Quad>(std::span<const Quad>)> reference;
    /// Rounded operations on the longest way from an input to a result of the program.
    int chain = 0;
    Accuracy accuracy = Accuracy::absolute;
};

/// Error and condition of an experiment.
///
/// `condition` of a result: how far it moves, computed with 113 bits, when the inputs move by one ulp (the sum over the
/// inputs one by one, or all at once if that is more), and one ulp of the result itself. A calculation whose roundings
/// each do no more harm than an ulp of the inputs has error <= chain * condition.
struct Finding {
    double error = 0.0;      ///< largest over the results
    double condition = 0.0;  ///< of the result with the largest error
    double ratio = 0.0;      ///< largest error / condition over the results
    int chain = 0;
    bool finite = true;  ///< no result is NaN or infinite
};

/// Requires: program and reference give equally many results.
Finding examine(const Experiment& experiment);

/// Experiment on a formula that runs over any number type:
/// template <class Real> std::vector<Real> operator()(std::span<const Real>) const.
template <class Formula>
Experiment experiment_on(const Formula& formula, std::vector<double> inputs, Accuracy accuracy = Accuracy::absolute) {
    Experiment experiment;
    std::vector<Chain> counted;
    for (const double x : inputs) counted.emplace_back(x);
    for (const Chain& result : formula(std::span<const Chain>(counted)))
        experiment.chain = std::max(experiment.chain, result.length);
    experiment.inputs = std::move(inputs);
    experiment.program = formula;
    experiment.reference = formula;
    experiment.accuracy = accuracy;
    return experiment;
}

}  // namespace pol::verify
