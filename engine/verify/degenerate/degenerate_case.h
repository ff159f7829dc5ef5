// SPDX-License-Identifier: Apache-2.0
// The suite of degenerate cases: every degenerate case of PHYSICS.md 4 as a sweep of one knob towards its singular
// point, with the error against more digits at each setting (verify/degenerate/experiment.h).
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/vec.h"
#include "verify/degenerate/experiment.h"

namespace pol::verify {

/// One of the tries at a setting: a rotation out of all symmetry with the axes of the world, the same case with other
/// roundings.
class Turn {
public:
    explicit Turn(std::size_t number);
    [[nodiscard]] std::size_t number() const { return number_; }
    DVec3 operator()(const DVec3& v) const { return v.x * x_ + v.y * y_ + v.z * z_; }

private:
    std::size_t number_;
    DVec3 x_, y_, z_;
};

/// One case: `at` sets the knob. A case of two knobs tries every setting of the second one at each of the first: turn
/// number i has second_settings[i % size].
struct DegenerateCase {
    std::string name;
    std::string sentence;  ///< what is held to be true
    std::string knob;      ///< with its unit
    std::string results;   ///< which results are compared
    std::string reference;
    std::vector<double> settings;  ///< at least 12; 0 is the singular point itself
    std::function<Experiment(double, const Turn&)> at;
    std::size_t turns = 1;  ///< in how many ways every setting is tried; the worst one counts
    std::string second_knob{};
    std::vector<double> second_settings{};
    /// By how many times the condition the formulas are known to be worse than their roundings allow, at a setting;
    /// the sentence says why. Nothing said: 1.
    double (*loss)(double setting) = nullptr;
    std::string group{};  ///< what it is about, one word; degenerate_cases() fills it in
};

struct DegeneratePoint {
    double setting = 0.0;
    double second_setting = 0.0;  ///< of the worst try, in a case of two knobs
    Finding finding{};
    double limit = 0.0;  ///< on error / condition
    std::vector<double> inputs;
};

/// A case is sound if at every point every number is finite and error / condition stays within the limit, which is the
/// number of rounded operations on the longest way from an input to a result, times the case's known loss.
struct DegenerateResult {
    const DegenerateCase* of = nullptr;
    std::vector<DegeneratePoint> points;
    DegeneratePoint worst;  ///< largest error
    double ratio = 0.0;
    double limit = 0.0;  ///< of the point with the largest ratio / limit
    bool finite = true;
    bool sound = false;
};

/// What PHYSICS.md 4 names and no sweep drives.
struct UntestedCase {
    std::string subject;
    std::string why;
};

/// All cases, group by group: axis, incidence, index, states, paths, scenes, pairs. PHYSICS.md 4 names them.
const std::vector<DegenerateCase>& degenerate_cases();
const std::vector<UntestedCase>& untested_cases();

DegenerateResult run(const DegenerateCase& degenerate_case);

/// Powers of ten (and `per_decade` - 1 settings between each two) from 10^from to 10^to, in that order.
std::vector<double> decades(int from, int to, int per_decade = 1);

}  // namespace pol::verify
