// SPDX-License-Identifier: Apache-2.0
// The list of facts, one case per fact: the same that `polariscope check facts` runs.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "verify/fact.h"

namespace pol::verify {
namespace {

std::vector<std::string> all_ids() {
    std::vector<std::string> ids;
    for (const Fact& fact : facts()) ids.push_back(fact.id);
    return ids;
}

class EveryFact : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Of, EveryFact, testing::ValuesIn(all_ids()), [](const auto& id) { return id.param; });

TEST_P(EveryFact, HoldsAtItsPixel) {
    const Fact& fact = *find_fact(GetParam());
    const FactResult result = run_fact(fact);
    ASSERT_FALSE(result.error) << to_string(*result.error);
    if (!fact.not_modelled.empty()) {
        EXPECT_EQ(result.verdict, Verdict::not_modelled);
        GTEST_SKIP() << fact.not_modelled;
    }
    ASSERT_EQ(result.readings.size(), fact.readings.size());
    EXPECT_FALSE(fact.readings.empty());
    for (std::size_t i = 0; i < fact.readings.size(); ++i) {
        const Reading& reading = fact.readings[i];
        const ReadingResult& got = result.readings[i];
        EXPECT_EQ(got.verdict, Verdict::pass)
            << label(fact, reading) << ": expected " << reading.expected << ", measured " << got.measured << ", "
            << got.deviation << " tolerances (" << reading.tolerance.from << ")";
    }
    EXPECT_EQ(result.verdict, Verdict::pass);
}

}  // namespace
}  // namespace pol::verify
