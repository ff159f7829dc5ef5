// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "cli/check_command.h"
#include "cli/messages.h"
#include "cli/output_checks.h"
#include "core/nearest_word.h"
#include "io/files/output_file.h"
#include "verify/facts/fact.h"

namespace pol {

namespace {

namespace fs = std::filesystem;
using verify::Fact;
using verify::FactResult;
using verify::Reading;
using verify::ReadingResult;
using verify::Verdict;

struct FactsRequest {
    std::vector<std::string> ids;
    bool json = false;
    std::string scenes;
};

struct Judged {
    const Fact* fact;
    FactResult result;
};

/// The facts that were asked for, in the order of the list; all of them without ids.
Result<std::vector<const Fact*>> wanted_facts(const std::vector<std::string>& ids) {
    std::vector<const Fact*> wanted;
    if (ids.empty())
        for (const Fact& fact : verify::facts()) wanted.push_back(&fact);
    for (const std::string& id : ids) {
        if (const Fact* fact = verify::find_fact(id)) {
            if (std::find(wanted.begin(), wanted.end(), fact) == wanted.end()) wanted.push_back(fact);
            continue;
        }
        std::vector<std::string_view> known;
        for (const Fact& fact : verify::facts()) known.push_back(fact.id);
        const auto nearest = nearest_word(id, known);
        return Error{ErrorKind::usage,
                     fmt::format("there is no fact '{}'", id),
                     {},
                     {},
                     nearest ? fmt::format("did you mean '{}'?", *nearest)
                             : fmt::format("they are {} to {}", known.front(), known.back())};
    }
    std::sort(wanted.begin(), wanted.end());  // they stand in one list
    return wanted;
}

std::string number(double value, const std::string& unit) {
    return unit.empty() ? fmt::format("{:.12g}", value) : fmt::format("{:.12g} {}", value, unit);
}

/// "+0.13", "-2.1e+09", "nan".
std::string deviation_text(double deviation) {
    if (std::abs(deviation) < 0.005) return "0";
    return std::abs(deviation) < 1000.0 ? fmt::format("{:+.2f}", deviation) : fmt::format("{:+.1e}", deviation);
}

void print_text(const std::vector<Judged>& judged) {
    std::size_t width = std::string_view("reading").size();
    for (const auto& [fact, result] : judged)
        for (const Reading& reading : fact->readings) width = std::max(width, label(*fact, reading).size());
    fmt::print("{:<5}{:<{}}  {:>18}  {:>18}  {:>9}  {}\n", "", "reading", width, "expected", "measured", "deviation*",
               "verdict");
    for (const auto& [fact, result] : judged) {
        fmt::print("\n{:<5}{}\n", fact->id, fact->sentence);
        if (result.error) fmt::print("{:<5}FAIL: {}\n", "", to_string(*result.error));
        if (!fact->not_modelled.empty())
            fmt::print("{:<5}{}: {}\n", "", verdict_text(Verdict::not_modelled), fact->not_modelled);
        for (std::size_t i = 0; i < result.readings.size(); ++i) {
            const Reading& reading = fact->readings[i];
            const ReadingResult& got = result.readings[i];
            fmt::print("{:<5}{:<{}}  {:>18}  {:>18}  {:>9}  {}\n", "", label(*fact, reading), width,
                       number(reading.expected, reading.unit), number(got.measured, reading.unit),
                       deviation_text(got.deviation), verdict_text(got.verdict));
            if (got.verdict == Verdict::fail)
                fmt::print("{:<7}tolerance {:.3g}: {}\n", "", reading.tolerance.value, reading.tolerance.from);
        }
    }
}

std::ptrdiff_t count(const std::vector<Judged>& judged, Verdict verdict) {
    return std::count_if(judged.begin(), judged.end(),
                         [verdict](const Judged& one) { return one.result.verdict == verdict; });
}

void print_json(const std::vector<Judged>& judged) {
    nlohmann::ordered_json out;
    out["passed"] = count(judged, Verdict::pass);
    out["failed"] = count(judged, Verdict::fail);
    out["not_modelled"] = count(judged, Verdict::not_modelled);
    out["facts"] = nlohmann::ordered_json::array();
    for (const auto& [fact, result] : judged) {
        nlohmann::ordered_json entry{{"id", fact->id},
                                     {"sentence", fact->sentence},
                                     {"source", fact->source},
                                     {"verdict", verdict_text(result.verdict)}};
        if (!fact->not_modelled.empty()) entry["why_not_modelled"] = fact->not_modelled;
        if (result.error) entry["error"] = to_string(*result.error);
        entry["readings"] = nlohmann::ordered_json::array();
        for (std::size_t i = 0; i < result.readings.size(); ++i) {
            const Reading& reading = fact->readings[i];
            const ReadingResult& got = result.readings[i];
            entry["readings"].push_back({{"view", fact->views[reading.view].name},
                                         {"what", reading.what},
                                         {"unit", reading.unit},
                                         {"expected", reading.expected},
                                         {"measured", got.measured},
                                         {"deviation", got.deviation},
                                         {"tolerance", reading.tolerance.value},
                                         {"tolerance_from", reading.tolerance.from},
                                         {"verdict", verdict_text(got.verdict)}});
        }
        out["facts"].push_back(entry);
    }
    fmt::print("{}\n", out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

/// The scene of one view with what it shows as comments.
std::string commented_scene(const Fact& fact, std::size_t view_index, const std::string& file) {
    const verify::FactView& view = fact.views[view_index];
    std::string text = fmt::format("# {}: {}\n# Source: {}\n", fact.id, fact.sentence, fact.source);
    if (!view.name.empty()) text += fmt::format("# This view: {}\n", view.name);
    for (const Reading& reading : fact.readings)
        if (reading.view == view_index)
            text += fmt::format("# {}: {:.15g}{}{}\n", reading.what, reading.expected, reading.unit.empty() ? "" : " ",
                                reading.unit);
    text += fmt::format("# Seen at the middle pixel: polariscope explain {} --pixel {},{}\n", file, view.x, view.y);
    return text + view.yaml;
}

int write_scenes(const std::vector<const Fact*>& facts, const fs::path& folder) {
    if (const auto made = make_folder(folder); !made) return report(made.error());
    for (const Fact* fact : facts)
        for (std::size_t view = 0; view < fact->views.size(); ++view) {
            const fs::path file = folder / fmt::format("{}-{}.yaml", fact->id, view + 1);
            const std::string text = commented_scene(*fact, view, file.string());
            if (const auto written = write_file(file, text); !written) return report(written.error());
        }
    return 0;
}

int run(const FactsRequest& request) {
    const auto wanted = wanted_facts(request.ids);
    if (!wanted) return report(wanted.error());
    if (!request.scenes.empty()) return write_scenes(wanted.value(), request.scenes);
    std::vector<Judged> judged;
    for (const Fact* fact : wanted.value()) judged.push_back({fact, run_fact(*fact)});
    const std::ptrdiff_t failed = count(judged, Verdict::fail);
    if (request.json) {
        print_json(judged);
    } else {
        print_text(judged);
        fmt::print("\n{} facts hold, {} fail, {} are not modelled.  * measured minus expected, in tolerances\n",
                   count(judged, Verdict::pass), failed, count(judged, Verdict::not_modelled));
    }
    return failed == 0 ? 0 : static_cast<int>(ErrorKind::internal);
}

}  // namespace

void add_check_facts_command(ProgramCommand check, int& exit_code) {
    auto request = std::make_shared<FactsRequest>();
    ProgramCommand command =
        check.add_subcommand("facts", "Hold the tracer to facts of polarization optics that have a closed form");
    command.add_option("ID", request->ids, "Which facts: T1, T2, ... (default: all)").type_name("FACT");
    command.add_flag("--json", request->json, "Print JSON with every reading at full precision and its tolerance");
    command.add_option("--scenes", request->scenes, "Write the facts' scenes into this folder instead, to look at them")
        .type_name("FOLDER");
    command.footer(
        "Every fact is a small scene, a pixel, a closed form from the literature and a tolerance that is derived. The\n"
        "scene goes through the loader, compiler and kernel of any picture.\n"
        "Exit codes: 0 all facts hold; 1 a fact fails.\n"
        "\nExamples:\n"
        "  polariscope check facts\n"
        "  polariscope check facts T9 T11 --json\n"
        "  polariscope check facts T25 --scenes facts/ && polariscope explain facts/T25-1.yaml --pixel 16,16");
    command.callback([request, &exit_code] { exit_code = run(*request); });
}

}  // namespace pol
