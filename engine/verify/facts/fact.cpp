// SPDX-License-Identifier: Apache-2.0
#include "verify/facts/fact.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

#include "core/result.h"
#include "io/files/assets.h"
#include "io/scenes/scene_file.h"
#include "plan/compile.h"
#include "verify/facts/chapters.h"

namespace pol::verify {

namespace {

std::vector<Fact> all_chapters() {
    std::vector<Fact> all;
    for (const auto chapter : {reflection_facts, plate_facts, total_reflection_facts, element_facts, drop_facts,
                               crystal_plate_facts, crystal_contact_facts, crystal_prism_facts, crystal_face_facts,
                               algebra_facts, lamp_facts, unmodelled_facts}) {
        std::vector<Fact> facts = chapter();
        std::move(facts.begin(), facts.end(), std::back_inserter(all));
    }
    const auto number = [](const Fact& fact) { return std::stoi(fact.id.substr(1)); };
    std::sort(all.begin(), all.end(), [&](const Fact& a, const Fact& b) { return number(a) < number(b); });
    return all;
}

Result<FactResult> judged(const Fact& fact) {
    FactResult result;
    std::vector<Explanation> explanations;
    for (const FactView& view : fact.views) {
        POL_TRY(auto explanation, explain_view(view));
        explanations.push_back(std::move(explanation));
    }
    for (const Reading& reading : fact.readings) result.readings.push_back(judge(reading, explanations[reading.view]));
    const bool all_pass = std::all_of(result.readings.begin(), result.readings.end(),
                                      [](const ReadingResult& r) { return r.verdict == Verdict::pass; });
    result.verdict = all_pass ? Verdict::pass : Verdict::fail;
    return result;
}

}  // namespace

std::string label(const Fact& fact, const Reading& reading) {
    const std::string& view = fact.views[reading.view].name;
    return view.empty() ? reading.what : view + ": " + reading.what;
}

std::string_view verdict_text(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return "pass";
        case Verdict::fail:
            return "FAIL";
        case Verdict::not_modelled:
            return "not modelled";
    }
    return "";
}

const std::vector<Fact>& facts() {
    static const std::vector<Fact> all = all_chapters();
    return all;
}

const Fact* find_fact(std::string_view id) {
    const auto same = [](char a, char b) {
        return std::toupper(static_cast<unsigned char>(a)) == std::toupper(static_cast<unsigned char>(b));
    };
    for (const Fact& fact : facts())
        if (std::equal(id.begin(), id.end(), fact.id.begin(), fact.id.end(), same)) return &fact;
    return nullptr;
}

ReadingResult judge(const Reading& reading, const Explanation& explanation) {
    ReadingResult result;
    result.measured = reading.measure(explanation);
    const double difference = result.measured - reading.expected;
    if (difference == 0.0)
        result.deviation = 0.0;
    else
        result.deviation = difference / reading.tolerance.value;
    result.verdict = std::abs(result.deviation) <= 1.0 ? Verdict::pass : Verdict::fail;
    return result;
}

Result<Explanation> explain_view(const FactView& view) {
    POL_TRY(const auto scene, parse_scene(view.yaml, "scene of a fact", assets_dir()));
    POL_TRY(const auto plan, compile(scene));
    Explanation explanation = explain(*plan, view.x, view.y, 0, 0);
    if (!explanation.exact())
        return Error{ErrorKind::internal, "the tree of the pixel is not what the picture is made of"};
    if (explanation.result.failures != 0)
        return Error{ErrorKind::internal, "the tree of the pixel has numbers that went bad"};
    return explanation;
}

FactResult run_fact(const Fact& fact) {
    if (!fact.not_modelled.empty()) return {Verdict::not_modelled, {}, {}};
    Result<FactResult> result = judged(fact);
    if (!result) return {Verdict::fail, {}, result.error()};
    return std::move(result).value();
}

}  // namespace pol::verify
