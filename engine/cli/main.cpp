// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "cli/explain_command.h"
#include "cli/interface_command.h"
#include "cli/maps_command.h"
#include "cli/plan_command.h"
#include "cli/render_command.h"
#include "core/result.h"

int main(int argc, char** argv) {
    constexpr int out_of_memory = 33;  // what render farms look for
    try {
        CLI::App app{"polariscope: trace polarized light backward through glass, metal and crystals, and look at it"};
        app.name("polariscope");
        app.set_version_flag("--version", POL_VERSION);
        app.require_subcommand(1);
        app.footer(
            "Exit codes: 0 done; 1 defect of this program; 2 usage; 3 scene or asset; 4 output; 5 self-check failed\n"
            "(energy, not-a-number); 10 time limit before the samples asked for; 33 out of memory; 130, 143 stopped.\n"
            "\nExample:\n"
            "  polariscope render assets/scenes/paper-calcite-unpolarized.yaml -o calcite.exr\n"
            "  polariscope maps calcite.exr --map dop -o dop.png");
        int exit_code = 0;
        pol::add_render_command(app, exit_code);
        pol::add_maps_command(app, exit_code);
        pol::add_explain_command(app, exit_code);
        pol::add_interface_command(app, exit_code);
        pol::add_plan_command(app, exit_code);
        try {
            app.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            return app.exit(error) == 0 ? 0 : static_cast<int>(pol::ErrorKind::usage);
        }
        return exit_code;
    } catch (const std::bad_alloc&) {
        std::fputs("polariscope: out of memory\n  hint: choose a smaller picture or fewer wavelengths\n", stderr);
        return out_of_memory;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "polariscope: defect: %s\n", error.what());
        return static_cast<int>(pol::ErrorKind::internal);
    }
}
