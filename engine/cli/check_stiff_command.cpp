// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "cli/check_command.h"
#include "cli/messages.h"
#include "cli/output_checks.h"
#include "core/nearest_word.h"
#include "core/result.h"
#include "io/files/output_file.h"
#include "report/number_words.h"
#include "verify/degenerate/degenerate_case.h"
#include "verify/degenerate/degenerate_report.h"

namespace pol {

namespace {

namespace fs = std::filesystem;
using verify::DegenerateCase;
using verify::DegeneratePoint;
using verify::DegenerateResult;

struct StiffRequest {
    std::vector<std::string> sweeps;
    std::string folder;
    bool json = false;
};

bool is_meant(const DegenerateCase& one, const std::string& word) {
    return word == one.name || word == one.group;
}

/// The groups, in the order of the cases.
std::vector<std::string_view> groups() {
    std::vector<std::string_view> names;
    for (const DegenerateCase& one : verify::degenerate_cases())
        if (names.empty() || names.back() != one.group) names.emplace_back(one.group);
    return names;
}

/// "axis, incidence, ...".
std::string list_of_groups() {
    std::string list;
    for (const std::string_view group : groups()) {
        if (!list.empty()) list += ", ";
        list += group;
    }
    return list;
}

/// The cases that the names mean, each by itself or with its group.
Result<std::vector<const DegenerateCase*>> chosen_cases(const StiffRequest& request) {
    const std::vector<DegenerateCase>& all = verify::degenerate_cases();
    for (const std::string& word : request.sweeps) {
        if (std::any_of(all.begin(), all.end(), [&word](const DegenerateCase& one) { return is_meant(one, word); }))
            continue;
        Error error{ErrorKind::usage, fmt::format("there is no case and no group '{}'", word), {}, "--sweep", {}};
        std::vector<std::string_view> names = groups();
        for (const DegenerateCase& one : all) names.emplace_back(one.name);
        const auto nearest = nearest_word(word, names);
        error.hint = nearest ? fmt::format("did you mean '{}'?", *nearest)
                             : "the groups are " + list_of_groups() + "; polariscope check stiff lists all cases";
        return error;
    }
    std::vector<const DegenerateCase*> chosen;
    for (const DegenerateCase& one : all) {
        const auto means_it = [&one](const std::string& word) { return is_meant(one, word); };
        if (request.sweeps.empty() || std::any_of(request.sweeps.begin(), request.sweeps.end(), means_it))
            chosen.push_back(&one);
    }
    return chosen;
}

void print_heading() {
    fmt::print("{:<11}{:<38}{:<22}{:>9}  {:>9}  {:>9}  {:>6}  {}\n", "group", "case", "knob", "error", "condition",
               "err/cond", "limit", "verdict");
}

void print_line(const DegenerateResult& r) {
    fmt::print("{:<11}{:<38}{:<22}{:>9.1e}  {:>9.1e}  {:>9.2g}  {:>6g}  {}\n", r.of->group, r.of->name,
               verify::range_text(*r.of), r.worst.finding.error, r.worst.finding.condition, r.ratio, r.limit,
               r.sound     ? "sound"
               : !r.finite ? "UNSOUND: not a number"
                           : "UNSOUND");
}

void print_ending(const std::vector<DegenerateResult>& results, double seconds) {
    fmt::print(
        "\nerror: largest deviation from the reference; condition: how far one ulp of the inputs moves that result,\n"
        "and one ulp of itself; limit: rounded operations on the longest way from an input to a result.\n");
    if (results.size() == verify::degenerate_cases().size() && !verify::untested_cases().empty()) {
        fmt::print("\nCases without a sweep:\n");
        for (const verify::UntestedCase& one : verify::untested_cases()) fmt::print("  {}: {}\n", one.subject, one.why);
    }
    const auto sound = std::count_if(results.begin(), results.end(), [](const DegenerateResult& r) { return r.sound; });
    fmt::print("\n{} of {} cases are sound ({}).\n", sound, results.size(), duration_text(seconds));
}

nlohmann::ordered_json number(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

void print_json(const std::vector<DegenerateResult>& results) {
    nlohmann::ordered_json out;
    out["sound"] = std::all_of(results.begin(), results.end(), [](const DegenerateResult& r) { return r.sound; });
    out["cases"] = nlohmann::ordered_json::array();
    for (const DegenerateResult& r : results) {
        nlohmann::ordered_json entry{{"group", r.of->group},
                                     {"case", r.of->name},
                                     {"sentence", r.of->sentence},
                                     {"knob", r.of->knob},
                                     {"compared", r.of->results},
                                     {"reference", r.of->reference},
                                     {"sound", r.sound},
                                     {"worst_error", number(r.worst.finding.error)},
                                     {"condition_there", number(r.worst.finding.condition)},
                                     {"worst_ratio", number(r.ratio)},
                                     {"limit", r.limit}};
        const bool pair = !r.of->second_knob.empty();
        if (pair) entry["second_knob"] = r.of->second_knob;
        for (const DegeneratePoint& p : r.points) {
            nlohmann::ordered_json point{{"setting", p.setting},
                                         {"error", number(p.finding.error)},
                                         {"condition", number(p.finding.condition)},
                                         {"ratio", number(p.finding.ratio)},
                                         {"limit", p.limit},
                                         {"finite", p.finding.finite},
                                         {"inputs", p.inputs}};
            if (pair) point["second_setting"] = p.second_setting;
            entry["points"].push_back(point);
        }
        out["cases"].push_back(entry);
    }
    out["untested"] = nlohmann::ordered_json::array();
    for (const verify::UntestedCase& one : verify::untested_cases())
        out["untested"].push_back({{"subject", one.subject}, {"why", one.why}});
    fmt::print("{}\n", out.dump(2));
}

Result<Done> write_folder(const fs::path& folder, const std::vector<DegenerateResult>& results) {
    for (const DegenerateResult& r : results) {
        POL_TRY_DONE(write_file(folder / (r.of->name + ".svg"), plot_svg(verify::degenerate_plot(r))));
    }
    return write_file(folder / "stiff.html", verify::degenerate_page(results));
}

int run(const StiffRequest& request) {
    const auto chosen = chosen_cases(request);
    if (!chosen) return report(chosen.error());
    if (!request.folder.empty()) {
        const auto made = make_folder(request.folder);
        if (!made) return report(made.error());
    }
    const auto start = std::chrono::steady_clock::now();
    std::vector<DegenerateResult> results;
    if (!request.json) print_heading();
    for (const DegenerateCase* one : chosen.value()) {
        results.push_back(verify::run(*one));
        if (!request.json) print_line(results.back());
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    if (!request.folder.empty())
        if (const auto written = write_folder(request.folder, results); !written) return report(written.error());
    request.json ? print_json(results) : print_ending(results, took.count());
    if (!request.folder.empty() && !request.json)
        fmt::print("wrote {}\n", printable((fs::path(request.folder) / "stiff.html").string()));
    const bool sound = std::all_of(results.begin(), results.end(), [](const DegenerateResult& r) { return r.sound; });
    return sound ? 0 : 1;
}

}  // namespace

void add_check_stiff_command(ProgramCommand check, int& exit_code) {
    auto request = std::make_shared<StiffRequest>();
    ProgramCommand command = check.add_subcommand(
        "stiff", "Drive every degenerate case towards its singular point and compare with more digits");
    command
        .add_option("--sweep", request->sweeps,
                    "Only the sweep of this case, or those of a group (" + list_of_groups() +
                        "); may be repeated. engine/PHYSICS.md 4 says what they are about")
        .type_name("SWEEP");
    command.add_option("-o,--output", request->folder, "Folder for plots (SVG) and one page with all of them")
        .type_name("FOLDER");
    command.add_flag("--json", request->json, "Print JSON instead of a table, every point with its inputs");
    command.footer(
        "Exit codes: 0 all cases are sound; 1 one is not.\n"
        "\nExamples:\n"
        "  polariscope check stiff -o stiff\n"
        "  polariscope check stiff --sweep grazing-crystal --json");
    command.callback([request, &exit_code] { exit_code = run(*request); });
}

}  // namespace pol
