// SPDX-License-Identifier: Apache-2.0
// The stiffness suite: every case is sound, PHYSICS.md 4 names every case, and unsound formulas are found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "io/files/input_file.h"
#include "verify/degenerate/degenerate_case.h"

namespace pol::verify {
namespace {

class Stiff : public testing::TestWithParam<DegenerateCase> {};

TEST_P(Stiff, IsSound) {
    const DegenerateResult result = run(GetParam());
    EXPECT_GE(result.points.size(), 12U);
    EXPECT_TRUE(result.finite);
    EXPECT_TRUE(result.sound) << GetParam().sentence << ": error " << result.worst.finding.error << ", condition "
                              << result.worst.finding.condition << " at " << result.worst.setting
                              << "; worst error / condition " << result.ratio << ", limit " << result.limit;
}

std::string test_name(const testing::TestParamInfo<DegenerateCase>& info) {
    std::string name = info.param.group + "_" + info.param.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Cases, Stiff, testing::ValuesIn(degenerate_cases()), test_name);

TEST(StiffSuite, StandsInTheNotes) {
    const std::string notes = read_input_file(POL_TESTS_DIR "/../engine/PHYSICS.md", 1U << 20U).value();
    const auto names = [&notes](const std::string& word) { return notes.find('`' + word + '`') != std::string::npos; };
    std::set<std::string> seen;
    for (const DegenerateCase& one : degenerate_cases()) {
        EXPECT_TRUE(seen.insert(one.name).second) << one.name << " twice";
        EXPECT_TRUE(one.group == "pairs" || names(one.name)) << one.name;
        EXPECT_NE(notes.find(one.group), std::string::npos) << one.group;
        EXPECT_NE(one.group, one.name);
    }
    for (const UntestedCase& one : untested_cases()) EXPECT_FALSE(one.why.empty());
}

TEST(StiffSuite, DrivesPairsOfKnobsIntoTheirSingularPointsAtOnce) {
    std::set<std::string> pairs;
    for (const DegenerateCase& one : degenerate_cases()) {
        if (one.second_knob.empty()) continue;
        pairs.insert(one.name);
        EXPECT_GE(one.settings.size() * one.turns, 60U) << one.name;
        EXPECT_EQ(one.turns % one.second_settings.size(), 0U) << one.name;
    }
    // Points of matter, neighbour, axis and incidence against each other.
    for (const char* name :
         {"grazing-and-wave-along-axis", "weak-crystal-and-grazing", "matched-o-and-below-o-critical",
          "axis-in-face-and-axis-in-plane", "axis-along-normal-and-normal-incidence", "strong-negative-and-weak-metal",
          "grazing-and-twin"})
        EXPECT_TRUE(pairs.contains(name)) << name;
}

/// The larger root of x^2 - 2 x + c = 0 is fine; the smaller one cancels as 1 -
/// sqrt(1 - c), not as c/(1 + ...).
struct SmallerRoot {
    bool careful = false;
    template <class Real>
    std::vector<Real> operator()(std::span<const Real> x) const {
        using std::sqrt;
        const Real root = sqrt(Real(1) - x[0]);
        return {careful ? x[0] / (Real(1) + root) : Real(1) - root};
    }
};

TEST(Experiments, TellACancelingFormulaFromACarefulOne) {
    const auto ratio = [](bool careful) {
        const Finding finding = examine(experiment_on(SmallerRoot{careful}, {1e-9}, Accuracy::relative));
        EXPECT_EQ(finding.chain, careful ? 4 : 3);
        return finding.ratio;
    };
    EXPECT_LT(ratio(true), 2.0);
    EXPECT_GT(ratio(false), 1e6);
}

struct Reciprocal {
    template <class Real>
    std::vector<Real> operator()(std::span<const Real> x) const {
        return {Real(1) / x[0]};
    }
};

TEST(Experiments, MeasureWhatOneUlpMoves) {
    // 1/x at x = 1e-3 moves by ulp(x)/x^2, and is itself known to an ulp of 1.
    const double ulp = std::nextafter(1e-3, 1.0) - 1e-3;
    EXPECT_NEAR(examine(experiment_on(Reciprocal{}, {1e-3})).condition, 1e6 * ulp + 0x1p-52, 1e-3 * 1e6 * ulp);
}

TEST(Experiments, FindWhatIsNotANumber) {
    EXPECT_FALSE(examine(experiment_on(Reciprocal{}, {0.0})).finite);
}

TEST(Quads, KnowElementaryFunctionsToThirtyDigits) {
    // Values to 36 digits (mpmath), as a double and what it lacks.
    const auto expect = [](const Quad& got, double high, double low) {
        EXPECT_LT(static_cast<double>(abs(got - Quad(high) - Quad(low))), 1e-31);
    };
    expect(exp(Quad(1)), 2.718281828459045, 1.4456468917292502e-16);
    expect(sin(Quad(1)), 0.8414709848078965, 1.776845092935536e-18);
    expect(cos(Quad(1)), 0.5403023058681398, -4.760954612604417e-17);
    expect(atan2(Quad(1), Quad(-3)), 2.819842099193151, 5.903613615775535e-17);
    expect(sqrt(Quad(2)), 1.4142135623730951, -9.667293313452913e-17);
    EXPECT_EQ(sqrt(Quad(1e-300) * Quad(1e-300)), Quad(1e-300));
}

}  // namespace
}  // namespace pol::verify
