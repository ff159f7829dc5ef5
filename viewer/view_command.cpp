// SPDX-License-Identifier: Apache-2.0
#include "viewer/view_command.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "cli/report.h"
#include "viewer/app.h"

namespace pol {

void add_view_command(CLI::App& app, int& exit_code) {
    auto files = std::make_shared<std::vector<std::string>>();
    CLI::App* command = app.add_subcommand("view", "Open scenes and EXR pictures in a window");
    command->add_option("files", *files, "Scenes (*.yaml) and Stokes pictures (*.exr)");
    command->footer("Example:\n  polariscope view assets/scenes/paper-calcite-unpolarized.yaml");
    command->callback([files, &exit_code] {
        const auto ended = run_app({files->begin(), files->end()});
        exit_code = ended ? 0 : report(ended.error());
    });
}

}  // namespace pol
