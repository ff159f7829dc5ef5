// SPDX-License-Identifier: Apache-2.0
// The list of facts, one case per fact: the same that `polariscope check facts` runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "verify/facts/fact.h"

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

struct Printed {
    const char* id;
    const char* label;
    double value;
    int decimals;
};

// PHYSICS.md 5 prints these numbers, computed apart from this program: the closed forms were typed right.
TEST(ClosedForms, GiveTheNumbersOfTheNotes) {
    const Printed table[] = {
        {"T1", "reflectance of s", 0.1479289941, 10},
        {"T2", "degree of polarization", 0.0798722045, 10},
        {"T3", "45 degrees: reflectance of s", 0.0920133630, 10},
        {"T3", "45 degrees: degree of polarization", 0.8314794193, 10},
        {"T4", "1 plate: degree of polarization", 0.1587317687, 10},
        {"T4", "2 plates: degree of polarization", 0.3096613791, 10},
        {"T4", "5 plates: degree of polarization", 0.6642754620, 10},
        {"T4", "10 plates: degree of polarization", 0.9217970265, 10},
        {"T5", "1 plate: degree of polarization", 0.1479289941, 10},
        {"T5", "2 plates: degree of polarization", 0.2577319588, 10},
        {"T6", "30 degrees: degree of polarization, straight path", 0.0339471543, 10},
        {"T6", "60 degrees: degree of polarization, straight path", 0.1901328326, 10},
        {"T6", "75 degrees: degree of polarization, straight path", 0.3772480996, 10},
        {"T6", "30 degrees: degree of polarization, all passes", 0.0325945241, 10},
        {"T6", "60 degrees: degree of polarization, all passes", 0.1748251748, 10},
        {"T6", "75 degrees: degree of polarization, all passes", 0.3056218126, 10},
        {"T7", "transmittance", 12.0 / 13.0, 15},
        {"T8", "shift over thickness", 0.329142, 6},
        {"T9", "60 degrees: ellipticity", 0.368514, 6},
        {"T11", "54.6 degrees: delay", 90.024178, 6},
        {"T11", "54.6 degrees: ellipticity", 0.9995781, 7},
        {"T11", "largest delay: delay of one reflection", 45.941667, 6},
        {"T15", "radius of the bow", 42.078107, 6},
        {"T15", "light of s", 0.0877915, 7},
        {"T15", "light of p", 0.0034653, 7},
        {"T15", "degree of polarization", 0.924054, 6},
        {"T16", "normal incidence: reflectance", 0.172006, 6},
        {"T17", "gold, normal incidence: reflectance", 0.877272, 6},
        {"T17", "gold, 45 degrees: degree of polarization", 0.0449203, 7},
        {"T17", "gold, 45 degrees, diagonal light: ellipticity", 0.2393842, 7},
        {"T17", "silver, normal incidence: reflectance", 0.987229, 6},
        {"T17", "silver, 45 degrees: degree of polarization", 0.0044692, 7},
        {"T17", "silver, 45 degrees, diagonal light: ellipticity", 0.1810244, 7},
        {"T17", "aluminium, normal incidence: reflectance", 0.912862, 6},
        {"T17", "aluminium, 45 degrees: degree of polarization", 0.0320678, 7},
        {"T17", "aluminium, 45 degrees, diagonal light: ellipticity", 0.0983249, 7},
        {"T20", "radiance", 0.4266667, 7},
        {"T22", "reflected: reflectance of o", 0.0613393, 7},
        {"T22", "reflected: degree of polarization", 0.2316126, 7},
        {"T22", "transmitted: transmittance of o", 0.8844115, 7},
        {"T22", "transmitted: transmittance of e", 0.9262834, 7},
        {"T22", "transmitted: degree of polarization", 0.0231248, 7},
        {"T23", "axis at 45 degrees: e displaced, thicknesses", 0.1090607, 7},
        {"T23", "axis at 45 degrees: angle", 6.2241176, 7},
        {"T23", "cleavage rhomb: e displaced, thicknesses", 0.1092127, 7},
        {"T23", "cleavage rhomb: angle", 6.2327262, 7},
        {"T23", "steepest: angle", 6.2611709, 7},
        {"T24", "share of o", 0.4693303, 7},
        {"T24", "share of e", 0.4757160, 7},
        {"T26", "in contact, 30 degrees: o to o", 0.7496875, 7},
        {"T26", "in contact, 30 degrees: o to e", 0.2501042, 7},
        {"T27", "o at minimum deviation: deviation", 52.0332923, 7},
        {"T27", "e at minimum deviation: deviation", 36.0094493, 7},
        {"T28", "Foucault, cut 38.5 degrees: e passed by a face", 0.7416319, 7},
        {"T28", "Taylor, cut 38.5 degrees: e passed by a face", 0.9735547, 7},
        {"T29", "calcite: e then o leaves at", 2.6317701, 7},
        {"T29", "calcite: o then e leaves at", -2.6526170, 7},
        {"T34", "axis along the normal, 30 degrees: e ray", 21.7288873, 7},
        {"T34", "axis along the normal, 60 degrees: e ray", 38.6539716, 7},
        {"T34", "axis in the face, 30 degrees: e ray", 15.8234678, 7},
        {"T34", "axis in the face, 60 degrees: e ray", 28.7588923, 7},
        {"T34", "axis in the face, 30 degrees: o ray", 17.5474435, 7},
        {"T34", "axis in the face, 60 degrees: o ray", 31.4803007, 7},
        {"T35", "n_e - n_o = 1e-12: degree of polarization", 0.0798722045, 10},
        {"T35", "n_e = n_o: degree of polarization", 0.1587317687, 10},
        {"T37", "o reflected at the seam", 0.0029914, 7},
    };
    for (const Printed& row : table) {
        SCOPED_TRACE(std::string(row.id) + " " + row.label);
        const Fact& fact = *find_fact(row.id);
        const auto reading = std::find_if(fact.readings.begin(), fact.readings.end(),
                                          [&](const Reading& r) { return label(fact, r) == row.label; });
        ASSERT_NE(reading, fact.readings.end());
        EXPECT_NEAR(reading->expected, row.value, 0.5000001 * std::pow(10.0, -row.decimals));
    }
}

TEST(Facts, FailWhereTheMeasuredNumberIsNotTheClosedForm) {
    Fact fact = *find_fact("T7");
    fact.readings[0].expected += 2.0 * fact.readings[0].tolerance.value;
    const FactResult result = run_fact(fact);
    EXPECT_EQ(result.verdict, Verdict::fail);
    EXPECT_EQ(result.readings[0].verdict, Verdict::fail);
    EXPECT_NEAR(result.readings[0].deviation, -2.0, 1.0);
    EXPECT_EQ(result.readings[1].verdict, Verdict::pass);
}

TEST(Facts, FailWhereNothingIsMeasuredOrTheSceneIsBroken) {
    Fact fact = *find_fact("T4");
    fact.views[0].yaml = find_fact("T7")->views[0].yaml;  // its straight path is another
    fact.readings[0].measure = [](const Explanation&) { return std::nan(""); };
    EXPECT_EQ(run_fact(fact).readings[0].verdict, Verdict::fail);
    fact.views[0].yaml = "camera: here";
    const FactResult result = run_fact(fact);
    EXPECT_EQ(result.verdict, Verdict::fail);
    EXPECT_TRUE(result.error);
}

TEST(Facts, HaveUniqueLabelsAndWellFormedReadings) {
    for (const Fact& fact : facts()) {
        SCOPED_TRACE(fact.id);
        EXPECT_EQ(fact.readings.empty(), !fact.not_modelled.empty());
        EXPECT_FALSE(fact.sentence.empty() || fact.source.empty());
        std::vector<std::string> labels;
        for (const Reading& reading : fact.readings) {
            ASSERT_LT(reading.view, fact.views.size());
            EXPECT_GE(reading.tolerance.value, 0.0);
            labels.push_back(label(fact, reading));
        }
        std::sort(labels.begin(), labels.end());
        EXPECT_EQ(std::adjacent_find(labels.begin(), labels.end()), labels.end());
    }
}

}  // namespace
}  // namespace pol::verify
