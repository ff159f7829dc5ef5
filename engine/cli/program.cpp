// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/check_command.h"
#include "cli/compare_command.h"
#include "cli/converge_command.h"
#include "cli/convert_command.h"
#include "cli/explain_command.h"
#include "cli/interface_command.h"
#include "cli/manual_command.h"
#include "cli/maps_command.h"
#include "cli/messages.h"
#include "cli/plan_command.h"
#include "cli/render_command.h"
#include "cli/send_command.h"
#include "core/nearest_word.h"
#include "core/result.h"
#include "core/version.h"

namespace pol {

namespace {

/// What CLI11 has to complain about, with the nearest command or option for a word that is neither.
Error usage_error_of(const CLI::App& app, const CLI::Error& complaint) {
    const CLI::App* chosen = &app;
    std::string names = "polariscope ";
    while (!chosen->get_subcommands().empty()) {
        chosen = chosen->get_subcommands().front();
        names += chosen->get_name() + " ";
    }
    const CLI::App& command = *chosen;
    Error error{ErrorKind::usage, complaint.what()};
    error.hint = fmt::format("see {}--help", names);

    std::vector<std::string> known;
    const std::vector<std::string> unknown = command.remaining();
    if (unknown.empty()) return error;
    const bool is_option = unknown.front().starts_with("-");
    const std::vector<const CLI::App*> commands = command.get_subcommands({});
    if (!is_option && commands.empty()) return error;
    error.what = fmt::format("there is no {} '{}'", is_option ? "option" : "command", unknown.front());
    for (const CLI::App* one : commands) known.push_back(one->get_name());
    if (is_option) {
        known.clear();
        for (const CLI::Option* option : command.get_options())
            for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    }
    const auto nearest = nearest_word(unknown.front(), std::vector<std::string_view>(known.begin(), known.end()));
    if (nearest) error.hint = fmt::format("did you mean '{}'?", *nearest);
    return error;
}

int run(int argc, char** argv, std::span<const AddCommand> more) {
    CLI::App app{"polariscope: trace polarized light backward through glass, metal and crystals, and look at it"};
    app.name("polariscope");
    app.set_version_flag("--version", program_version());
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 done; 1 defect of this program, or a fact that fails; 2 usage; 3 scene or asset; 4 output;\n"
        "5 self-check failed (energy, not-a-number), or pictures differ; 10 time limit before the samples asked for; "
        "33 out of memory; "
        "130, 141, 143 stopped.\n"
        "\nExample:\n"
        "  polariscope render assets/scenes/paper-calcite-unpolarized.yaml -o calcite.exr\n"
        "  polariscope maps calcite.exr --map dop -o dop.png");
    int exit_code = 0;
    ProgramCommand program(app);
    add_render_command(program, exit_code);
    add_maps_command(program, exit_code);
    add_compare_command(program, exit_code);
    add_send_command(program, exit_code);
    add_explain_command(program, exit_code);
    add_interface_command(program, exit_code);
    add_plan_command(program, exit_code);
    add_check_command(program, exit_code);
    add_convert_command(program, exit_code);
    add_converge_command(program, exit_code);
    for (const AddCommand add : more) add(program, exit_code);
    add_manual_command(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& request_for_help) {
        exit_code = app.exit(request_for_help);
    } catch (const CLI::ParseError& complaint) {
        return report(usage_error_of(app, complaint));
    }
    return exit_code;
}

/// A closed stream would hand its number to the first file that is opened, and messages would land in that file. It is
/// opened for reading instead, so that writing to it fails.
void fill_closed_streams() {
    int descriptor = 0;
    while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = ::open("/dev/null", O_RDONLY);
    if (descriptor >= 0) ::close(descriptor);
}

int report_lost_output() {
    return report({ErrorKind::output, "standard output cannot be written", {}, {}, "is the disk full?"});
}

}  // namespace

int run_program(int argc, char** argv, std::span<const AddCommand> more) {
    constexpr int out_of_memory = 33;  // what render farms look for
    fill_closed_streams();
    // A limit on the size of files is reported like a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
    // Who closes the pipe (`| head -1`) has seen enough, also where a parent ignores the signal: end without a word.
    std::signal(SIGPIPE, SIG_DFL);
    try {
        const int exit_code = run(argc, argv, more);
        // A failed write of the help, through std::cout, or of progress is only remembered.
        const bool lost = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
        if (lost && exit_code == 0) return report_lost_output();
        return exit_code;
    } catch (const std::bad_alloc&) {
        std::fputs("polariscope: out of memory\n  hint: choose a smaller picture or fewer wavelengths\n", stderr);
        return out_of_memory;
    } catch (const std::exception& error) {
        // fmt throws where standard output cannot be written.
        if (std::ferror(stdout) != 0) return report_lost_output();
        remark(fmt::format("polariscope: defect: {}\n", error.what()));
        return static_cast<int>(ErrorKind::internal);
    }
}

}  // namespace pol
