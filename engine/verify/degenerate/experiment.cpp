// SPDX-License-Identifier: Apache-2.0
#include "verify/degenerate/experiment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/contract.h"
#include "core/random.h"

namespace pol::verify {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Random patterns of ups and downs in which all inputs move at once, by one ulp and by a few. Near a square root that
/// begins (a critical angle) only such a move may cross the line that roundings cross.
constexpr std::uint32_t patterns = 8;
constexpr int few = 8;

/// Per result the largest of: the sum over the inputs of how far it moves when that input moves by one ulp, how far it
/// moves when all inputs do, and the eighth of how far it moves when all inputs move by eight.
class Conditions {
public:
    Conditions(const Experiment& experiment, const std::vector<Quad>& exact) : experiment_(experiment), exact_(exact) {}

    [[nodiscard]] std::vector<Quad> measured() const {
        const std::vector<double>& at = experiment_.inputs;
        std::vector<Quad> apart(exact_.size(), Quad(0));
        for (std::size_t i = 0; i < at.size(); ++i) {
            std::vector<Quad> largest(exact_.size(), Quad(0));
            if (at[i] == 0.0) continue;  // one ulp of nothing is nothing
            for (const double towards : {-infinite, infinite}) {
                std::vector<double> moved = at;
                moved[i] = std::nextafter(at[i], towards);
                keep_larger(largest, moved, 1);
            }
            for (std::size_t j = 0; j < exact_.size(); ++j) apart[j] += largest[j];
        }
        std::vector<Quad> condition = apart;
        for (std::uint32_t pattern = 0; pattern < patterns; ++pattern) {
            for (const int ulps : {1, few}) keep_larger(condition, jolted(pattern, ulps), ulps);
        }
        return condition;
    }

private:
    /// All inputs moved by some ulps, up or down as `pattern` says.
    [[nodiscard]] std::vector<double> jolted(std::uint32_t pattern, int ulps) const {
        std::vector<double> moved = experiment_.inputs;
        for (std::size_t i = 0; i < moved.size(); ++i) {
            const bool up = random_unit(RandomKey{2, pattern, 0, 0}, static_cast<std::uint32_t>(i)) < 0.5;
            for (int k = 0; k < ulps && experiment_.inputs[i] != 0.0; ++k)
                moved[i] = std::nextafter(moved[i], up ? infinite : -infinite);
        }
        return moved;
    }

    void keep_larger(std::vector<Quad>& largest, const std::vector<double>& inputs, int divisor) const {
        const std::vector<Quad> moved = experiment_.reference(std::vector<Quad>(inputs.begin(), inputs.end()));
        for (std::size_t j = 0; j < exact_.size(); ++j) {
            const Quad change = abs(moved[j] - exact_[j]) / Quad(divisor);
            if (isfinite(change) && change > largest[j]) largest[j] = change;
        }
    }

    const Experiment& experiment_;
    const std::vector<Quad>& exact_;
};

}  // namespace

Finding examine(const Experiment& experiment) {
    const std::vector<double> results = experiment.program(experiment.inputs);
    const std::vector<Quad> exact =
        experiment.reference(std::vector<Quad>(experiment.inputs.begin(), experiment.inputs.end()));
    POL_EXPECTS(results.size() == exact.size());
    const std::vector<Quad> condition = Conditions(experiment, exact).measured();

    Finding finding;
    finding.chain = experiment.chain;
    for (std::size_t j = 0; j < exact.size(); ++j) {
        if (!std::isfinite(results[j]) || !isfinite(exact[j])) {
            finding.finite = false;
            continue;
        }
        const bool relative = experiment.accuracy == Accuracy::relative;
        const Quad size = relative ? abs(exact[j]) : Quad(1);
        const Quad off = abs(Quad(results[j]) - exact[j]);
        // A result that is exactly nothing has to be exactly nothing where its own size is the measure.
        const bool nothing = size == Quad(0);
        const double error = nothing ? (off == Quad(0) ? 0.0 : infinite) : static_cast<double>(off / size);
        const double ulp = std::numeric_limits<double>::epsilon();
        const double unavoidable = nothing ? ulp : static_cast<double>(condition[j] / size) + ulp;
        finding.ratio = std::max(finding.ratio, error / unavoidable);
        if (j == 0 || error > finding.error) {
            finding.error = error;
            finding.condition = unavoidable;
        }
    }
    return finding;
}

}  // namespace pol::verify
