// SPDX-License-Identifier: Apache-2.0
#include "cli/manual_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "cli/command_line.h"
#include "cli/command_tree.h"
#include "cli/completions.h"
#include "cli/manual_page.h"

namespace pol {

namespace {

enum class Form { page, bash, zsh };

std::string text_of(CLI::App& app, Form form) {
    const CommandEntry program = command_tree(app);
    switch (form) {
        case Form::page:
            return manual_page(program, app.version());
        case Form::bash:
            return bash_completion(program);
        case Form::zsh:
            return zsh_completion(program);
    }
    return {};
}

}  // namespace

void add_manual_command(CLI::App& app) {
    ProgramCommand program(app);
    auto form = std::make_shared<Form>();
    ProgramCommand command =
        program.add_subcommand("manual", "Print the manual page, or what completes commands in a shell");
    command
        .add_choice(
            "FORM", {"page", "bash", "zsh"}, [form](std::size_t index) { *form = static_cast<Form>(index); },
            "What to print")
        .required();
    command.footer(
        "All of it is made from what --help prints. An installed program has it in place already.\n"
        "\nExamples:\n"
        "  polariscope manual page | man -l -\n"
        "  polariscope manual bash > ~/.local/share/bash-completion/completions/polariscope\n"
        "  polariscope manual zsh > _polariscope   (into a folder of fpath)");
    command.callback([&app, form] { std::fputs(text_of(app, *form).c_str(), stdout); });
}

}  // namespace pol
