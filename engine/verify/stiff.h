// SPDX-License-Identifier: Apache-2.0
// The stiffness suite: every degenerate case of the physics notes as a sweep of one knob towards its singular point,
// with the error against more digits at each setting (verify/experiment.h).
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/vec.h"
#include "verify/experiment.h"

namespace pol::verify {

/// A rotation out of all symmetry with the axes of the world: the same case, other roundings.
class Turn {
public:
    explicit Turn(int number);
    DVec3 operator()(const DVec3& v) const { return v.x * x_ + v.y * y_ + v.z * z_; }

private:
    DVec3 x_, y_, z_;
};

/// One case: `at` sets the knob.
struct StiffCase {
    std::string name;
    int row = 0;           ///< of the table of degenerate cases, physics notes section 4
    std::string sentence;  ///< what is held to be true
    std::string knob;      ///< with its unit
    std::string results;   ///< which results are compared
    std::string reference;
    std::vector<double> settings;  ///< at least 12; 0 is the singular point itself
    std::function<Experiment(double, const Turn&)> at;
    int turns = 1;  ///< in how many orientations every setting is tried; the worst one counts
};

struct StiffPoint {
    double setting = 0.0;
    Finding finding{};
    std::vector<double> inputs;
};

/// A case is sound if at every point every number is finite and error / condition stays within the limit, which is the
/// number of rounded operations on the longest way from an input to a result.
struct StiffResult {
    const StiffCase* of = nullptr;
    std::vector<StiffPoint> points;
    StiffPoint worst;  ///< largest error
    double ratio = 0.0;
    double limit = 0.0;  ///< of the point with the largest ratio / limit
    bool finite = true;
    bool sound = false;
};

/// A row of the physics notes that no case covers.
struct UntestedRow {
    int row = 0;
    std::string subject;
    std::string why;
};

/// All cases, in the order of the rows.
const std::vector<StiffCase>& stiff_cases();
const std::vector<UntestedRow>& untested_rows();

StiffResult run(const StiffCase& stiff_case);

/// Powers of ten (and `per_decade` - 1 settings between each two) from 10^from to 10^to, in that order.
std::vector<double> decades(int from, int to, int per_decade = 1);

}  // namespace pol::verify
