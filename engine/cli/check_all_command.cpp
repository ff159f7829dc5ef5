// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/check_command.h"
#include "cli/messages.h"
#include "cli/output_checks.h"
#include "core/result.h"
#include "core/version.h"
#include "io/files/assets.h"
#include "io/files/output_file.h"
#include "io/scenes/scene_file.h"
#include "render/renderer.h"
#include "report/html_page.h"
#include "report/number_words.h"
#include "verify/convergence/convergence.h"
#include "verify/convergence/convergence_report.h"
#include "verify/convergence/convergence_summary.h"
#include "verify/convergence/machine.h"
#include "verify/degenerate/degenerate_case.h"
#include "verify/degenerate/degenerate_report.h"
#include "verify/facts/fact.h"
#include "verify/invariants/invariants.h"
#include "verify/invariants/scene_twins.h"

namespace pol {

namespace {

namespace fs = std::filesystem;

struct AllRequest {
    std::string folder;
    int size = 12;
};

/// A chapter of the report: what it found in a line, and in full.
struct Chapter {
    std::string title;
    std::string verdict;
    std::string body;
    bool good = true;
};

Chapter check_facts() {
    Chapter chapter{"Facts of polarization optics", {}, {}};
    std::size_t pass = 0;
    std::size_t fail = 0;
    std::size_t readings = 0;
    chapter.body =
        "<table><tr><th>fact</th><th>reading</th><th class=\"n\">expected</th><th class=\"n\">measured</th>"
        "<th class=\"n\">off by, tolerances</th><th>verdict</th></tr>\n";
    for (const verify::Fact& fact : verify::facts()) {
        const verify::FactResult result = verify::run_fact(fact);
        pass += result.verdict == verify::Verdict::pass ? 1 : 0;
        fail += result.verdict == verify::Verdict::fail ? 1 : 0;
        chapter.body +=
            fmt::format("<tr><td><b>{}</b></td><td colspan=\"5\">{} <span class=\"soft\">{}{}</span></td></tr>\n",
                        fact.id, xml_text(fact.sentence), xml_text(fact.source),
                        fact.not_modelled.empty() ? "" : ". Not modelled: " + xml_text(fact.not_modelled));
        for (std::size_t i = 0; i < result.readings.size(); ++i, ++readings) {
            const verify::Reading& reading = fact.readings[i];
            const verify::ReadingResult& got = result.readings[i];
            const std::string view = fact.views[reading.view].name;
            chapter.body += fmt::format(
                "<tr><td></td><td title=\"{}\">{}{}</td><td class=\"n\">{:.12g}</td><td class=\"n\">{:.12g} {}</td>"
                "<td class=\"n\">{:.2g}</td><td class=\"{}\">{}</td></tr>\n",
                xml_text(reading.tolerance.from), view.empty() ? "" : xml_text(view) + ": ", xml_text(reading.what),
                reading.expected, got.measured, reading.unit, got.deviation,
                got.verdict == verify::Verdict::pass ? "good" : "bad", verify::verdict_text(got.verdict));
        }
    }
    chapter.body += "</table>\n";
    chapter.good = fail == 0;
    chapter.verdict = fmt::format("{} facts hold with {} readings, {} fail, {} are not modelled", pass, readings, fail,
                                  verify::facts().size() - pass - fail);
    return chapter;
}

Chapter check_stiff() {
    Chapter chapter{"Numbers near singular points", {}, {}};
    std::vector<verify::DegenerateResult> results;
    for (const verify::DegenerateCase& one : verify::degenerate_cases()) results.push_back(verify::run(one));
    const auto sound = static_cast<std::size_t>(
        std::count_if(results.begin(), results.end(), [](const verify::DegenerateResult& r) { return r.sound; }));
    chapter.body = verify::degenerate_section(results);
    chapter.good = sound == results.size();
    chapter.verdict = fmt::format("{} of {} sweeps are sound", sound, results.size());
    return chapter;
}

std::vector<fs::path> shipped_scenes() {
    std::vector<fs::path> scenes;
    std::error_code status;
    for (const auto& entry : fs::directory_iterator(assets_dir() / "scenes", status))
        if (entry.path().extension() == ".yaml") scenes.push_back(entry.path());
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

Result<Chapter> check_scenes(const AllRequest& request) {
    Chapter chapter{"What holds for every scene", {}, {}};
    std::size_t pass = 0;
    std::size_t fail = 0;
    std::size_t numbers = 0;
    chapter.body = fmt::format(
        "<p>Every shipped scene at {0}x{0} pixels. A cell says how near the worst number came to its "
        "tolerance; &ndash;: does not apply.</p>\n<table><tr><th>scene</th>",
        request.size);
    for (const verify::Invariant& invariant : verify::invariants())
        chapter.body += fmt::format("<th title=\"{}\">{}</th>", xml_text(invariant.sentence), xml_text(invariant.name));
    chapter.body += "</tr>\n";
    const std::vector<fs::path> scenes = shipped_scenes();
    if (scenes.empty()) return missing_assets();
    for (const fs::path& path : scenes) {
        POL_TRY(const auto scene, load_scene(path));
        POL_TRY(const auto test, verify::under_test(verify::small(scene, request.size)));
        fmt::print("  {}\n", path.filename().string());
        std::fflush(stdout);
        chapter.body += "<tr><td>" + xml_text(path.stem().string()) + "</td>";
        for (const verify::Invariant& invariant : verify::invariants()) {
            const verify::InvariantResult result = invariant.check(test);
            numbers += result.tested;
            pass += result.outcome == verify::Outcome::pass ? 1 : 0;
            fail += result.outcome == verify::Outcome::fail ? 1 : 0;
            chapter.body += result.outcome == verify::Outcome::does_not_apply
                                ? fmt::format("<td class=\"soft\" title=\"{}\">&ndash;</td>", xml_text(result.note))
                                : fmt::format("<td class=\"{}\">{:.2g}</td>",
                                              result.outcome == verify::Outcome::pass ? "good" : "bad", result.worst);
        }
        chapter.body += "</tr>\n";
    }
    chapter.body += "</table>\n<ul>\n";
    for (const verify::Invariant& invariant : verify::invariants())
        chapter.body += "<li><b>" + xml_text(invariant.name) + "</b>: " + xml_text(invariant.sentence) + "</li>\n";
    chapter.body += "</ul>\n";
    chapter.good = fail == 0 && pass > 0;
    chapter.verdict = fmt::format("{} checks of {} numbers hold, {} fail", pass, numbers, fail);
    return chapter;
}

/// Error against time of one of the paper's scenes, into a folder of its own that a second start goes on with.
Result<Chapter> check_convergence(const AllRequest& request, const std::string& name) {
    Chapter chapter{"Error against run time: " + name, {}, {}};
    POL_TRY(auto scene, load_scene(assets_dir() / "scenes" / (name + ".yaml")));
    verify::ConvergenceRequest work;
    work.scene = std::move(scene);
    work.scene.render.width = work.scene.render.height = 4 * request.size;
    work.scene_name = name;
    work.folder = fs::path(request.folder) / name;
    work.threads = hardware_threads();
    work.tool_version = program_version();
    POL_TRY_DONE(make_folder(work.folder));
    const auto result = verify::converge(work, [](const verify::ConvergenceProgress&) { return true; });
    if (!result) return result.error();
    POL_TRY(const auto pictures, verify::budget_pictures(work, result.value()));
    chapter.body =
        verify::convergence_section(work, result.value(), pictures,
                                    fmt::format("polariscope converge assets/scenes/{}.yaml -o {} --size {}x{}", name,
                                                name, work.scene.render.width, work.scene.render.height));
    chapter.good = verify::bounds_hold(result.value());
    chapter.verdict = verify::text_about_bounds(result.value());
    return chapter;
}

int run(const AllRequest& request) {
    constexpr int smallest = 4;
    constexpr int largest = 128;
    if (request.size < smallest || request.size > largest)
        return report({ErrorKind::usage,
                       fmt::format("{} is no size of a picture", request.size),
                       {},
                       "--size",
                       fmt::format("{} to {} pixels a side", smallest, largest)});
    if (const auto made = make_folder(request.folder); !made) return report(made.error());
    const auto start = std::chrono::steady_clock::now();
    std::vector<Chapter> chapters;
    const auto add = [&](Chapter chapter) {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        fmt::print("{}: {} ({} since the start)\n", chapter.title, chapter.verdict, duration_text(elapsed.count()));
        std::fflush(stdout);
        chapters.push_back(std::move(chapter));
    };
    add(check_facts());
    add(check_stiff());
    auto scenes = check_scenes(request);
    if (!scenes) return report(scenes.error());
    add(std::move(scenes).value());
    for (const char* name : {"paper-glass-unpolarized", "paper-calcite-unpolarized"}) {
        auto chapter = check_convergence(request, name);
        if (!chapter) return report(chapter.error());
        add(std::move(chapter).value());
    }
    const bool good = std::all_of(chapters.begin(), chapters.end(), [](const Chapter& c) { return c.good; });
    std::string body = fmt::format(
        "<p><code>polariscope check all -o {}</code></p>\n<p>polariscope {}, {} threads of {}, {}.</p>\n<ul>\n",
        xml_text(request.folder), program_version(), hardware_threads(), xml_text(verify::cpu_name()),
        verify::utc_now());
    for (std::size_t i = 0; i < chapters.size(); ++i)
        body += fmt::format("<li><a href=\"#chapter{}\">{}</a>: <span class=\"{}\">{}</span></li>\n", i,
                            xml_text(chapters[i].title), chapters[i].good ? "good" : "bad", chapters[i].verdict);
    body += "</ul>\n";
    for (std::size_t i = 0; i < chapters.size(); ++i)
        body += fmt::format("<h2 id=\"chapter{}\">{}</h2>\n<p class=\"{}\">{}</p>\n{}", i, xml_text(chapters[i].title),
                            chapters[i].good ? "good" : "bad", chapters[i].verdict, chapters[i].body);
    const fs::path page = fs::path(request.folder) / "report.html";
    if (const auto written = write_file(page, html_page("Can polariscope be trusted?", body)); !written)
        return report(written.error());
    fmt::print("{}\n", printable(page.string()));
    return good ? 0 : 1;
}

}  // namespace

void add_check_all_command(ProgramCommand check, int& exit_code) {
    auto request = std::make_shared<AllRequest>();
    ProgramCommand command = check.add_subcommand("all", "All checks on all shipped scenes, as one page");
    command.add_option("-o,--output", request->folder, "Folder for report.html and the runs behind its curves")
        .type_name("FOLDER")
        .required();
    command.add_option("--size", request->size, "Pixels along the sides of the scenes' pictures").capture_default_str();
    command.footer(
        "Facts, stiff cases, invariants of every shipped scene, and error against time on the paper's glass and "
        "calcite.\n"
        "Exit codes: 0 all is well; 1 something is not.\n"
        "\nExample:\n"
        "  polariscope check all -o report");
    command.callback([request, &exit_code] { exit_code = run(*request); });
}

}  // namespace pol
