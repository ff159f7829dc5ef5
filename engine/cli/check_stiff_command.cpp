// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
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
    std::vector<std::string> rows;
    std::string folder;
    bool json = false;
};

/// The cases that a name means: the case itself, or all of a row's number.
Result<std::vector<const DegenerateCase*>> chosen_cases(const StiffRequest& request) {
    std::vector<const DegenerateCase*> chosen;
    for (const DegenerateCase& one : verify::degenerate_cases()) {
        const auto means_it = [&one](const std::string& word) {
            return word == one.name || word == std::to_string(one.row);
        };
        if (request.rows.empty() || std::any_of(request.rows.begin(), request.rows.end(), means_it))
            chosen.push_back(&one);
    }
    for (const std::string& word : request.rows) {
        const auto fits = [&word](const DegenerateCase* one) {
            return word == one->name || word == std::to_string(one->row);
        };
        if (std::any_of(chosen.begin(), chosen.end(), fits)) continue;
        Error error{ErrorKind::usage, fmt::format("there is no case '{}'", word), {}, "--row", {}};
        std::vector<std::string_view> names;
        for (const DegenerateCase& one : verify::degenerate_cases()) names.push_back(one.name);
        const auto nearest = nearest_word(word, names);
        error.hint = nearest ? fmt::format("did you mean '{}'?", *nearest) : "polariscope check stiff lists all cases";
        for (const verify::UntestedRow& row : verify::untested_rows())
            if (word == std::to_string(row.row)) error.hint = fmt::format("row {} has no case: {}", row.row, row.why);
        return error;
    }
    return chosen;
}

void print_heading() {
    fmt::print("{:>3}  {:<38}{:<22}{:>9}  {:>9}  {:>9}  {:>6}  {}\n", "row", "case", "knob", "error", "condition",
               "err/cond", "limit", "verdict");
}

void print_line(const DegenerateResult& r) {
    fmt::print("{:>3}  {:<38}{:<22}{:>9.1e}  {:>9.1e}  {:>9.2g}  {:>6g}  {}\n", r.of->row, r.of->name,
               verify::range_text(*r.of), r.worst.finding.error, r.worst.finding.condition, r.ratio, r.limit,
               r.sound     ? "sound"
               : !r.finite ? "UNSOUND: not a number"
                           : "UNSOUND");
}

void print_ending(const std::vector<DegenerateResult>& results, double seconds) {
    fmt::print(
        "\nerror: largest deviation from the reference; condition: how far one ulp of the inputs moves that result,\n"
        "and one ulp of itself; limit: rounded operations on the longest way from an input to a result.\n");
    if (results.size() == verify::degenerate_cases().size() && !verify::untested_rows().empty()) {
        fmt::print("\nRows without a case:\n");
        for (const verify::UntestedRow& row : verify::untested_rows())
            fmt::print("{:>3}  {}: {}\n", row.row, row.subject, row.why);
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
        nlohmann::ordered_json entry{{"row", r.of->row},
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
    for (const verify::UntestedRow& row : verify::untested_rows())
        out["untested"].push_back({{"row", row.row}, {"subject", row.subject}, {"why", row.why}});
    fmt::print("{}\n", out.dump(2));
}

Result<Done> write_folder(const fs::path& folder, const std::vector<DegenerateResult>& results) {
    for (const DegenerateResult& r : results) {
        const auto written = write_file(folder / (r.of->name + ".svg"), plot_svg(verify::degenerate_plot(r)));
        if (!written) return written.error();
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

void add_check_stiff_command(CLI::App& check, int& exit_code) {
    auto request = std::make_shared<StiffRequest>();
    CLI::App* command = check.add_subcommand(
        "stiff", "Drive every degenerate case towards its singular point and compare with more digits");
    command->add_option("--row", request->rows, "Only this case, or all cases of a row's number; may be repeated");
    command->add_option("-o,--output", request->folder, "Folder for plots (SVG) and one page with all of them");
    command->add_flag("--json", request->json, "Print JSON instead of a table, every point with its inputs");
    command->footer(
        "Exit codes: 0 all cases are sound; 1 one is not.\n"
        "\nExamples:\n"
        "  polariscope check stiff -o stiff\n"
        "  polariscope check stiff --row grazing-crystal --json");
    command->callback([request, &exit_code] { exit_code = run(*request); });
}

}  // namespace pol
