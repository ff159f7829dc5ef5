// SPDX-License-Identifier: Apache-2.0
#include <string_view>

#include "cli/completions.h"

namespace pol {

namespace {

constexpr std::string_view before = R"zsh(#compdef polariscope
# Written by: polariscope manual zsh

# Offers folders, and files that end in .ENDING...; shipped scenes where no file fits.
_polariscope_files() {
    local folder program=${commands[polariscope]:A}
    _files -g "${(j: :)${@/#/*.}}" && return
    [[ " $* " == *' yaml '* ]] || return 1
    for folder in $POLARISCOPE_ASSETS ${program:h:h}/share/polariscope ${program:h}/share/polariscope; do
        [[ -d $folder/scenes ]] || continue
        local -a files=($folder/scenes/$PREFIX*.yaml(N))
        local -a names=(${files:t})
        compadd -U -J shipped -d names -- $files
        return
    done
    return 1
}

)zsh";

/// `text` inside single quotes, for _arguments, where brackets and colons mean something.
std::string zsh_quoted(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
        if (c == '\'')
            out += "'\\''";
        else
            out += c;
    }
    return out;
}

/// The function that completes a command: _polariscope_check_facts.
std::string function_of(const CommandEntry& command) {
    std::string name = "_" + command.name;
    for (char& c : name)
        if (c == ' ') c = '_';
    return name;
}

/// What _arguments does to offer these values.
std::string action_of(const Values& values) {
    std::string words;
    for (const std::string& word : values.words) words += (words.empty() ? "(" : " ") + word;
    if (!words.empty()) return words + ")";
    std::string endings;
    for (const std::string& ending : values.endings) endings += " " + (ending.empty() ? "*" : ending);
    if (endings == " *") return "_files";
    if (!endings.empty()) return " _polariscope_files" + endings;
    return values.folders ? "_files -/" : " ";
}

std::string arguments_of(const CommandEntry& command) {
    std::string out = " \\\n        -s -S";
    for (const OptionEntry& option : command.options) {
        const std::string value =
            option.type.empty() ? std::string() : ':' + zsh_quoted(option.type) + ':' + action_of(option.values);
        if (option.is_argument) {
            out += " \\\n        '";
            if (option.repeated) out += '*';
            out += value + '\'';
            continue;
        }
        std::string others;
        for (const std::string& name : option.names) others += (others.empty() ? "(" : " ") + name;
        for (const std::string& name : option.names) {
            // A value may follow as a word of its own or, with a long name, behind "=".
            const bool is_long = name.starts_with("--");
            out += " \\\n        '";
            out += option.repeated ? "*" : others + ")";
            out += name;
            if (!value.empty()) out += is_long ? "=" : "+";
            out += '[' + zsh_quoted(option.description) + ']';
            out += value + '\'';
        }
    }
    return out;
}

void add_functions(const CommandEntry& command, std::string& out) {
    for (const CommandEntry& one : command.commands) add_functions(one, out);
    out += function_of(command) + "() {\n";
    if (command.commands.empty()) {
        out += "    _arguments" + arguments_of(command) + "\n}\n\n";
        return;
    }
    out += "    local -a below=(\n";
    std::string chosen;
    for (const CommandEntry& one : command.commands) {
        const std::string name = one.name.substr(one.name.rfind(' ') + 1);
        out += "        '" + name + ":" + zsh_quoted(one.description) + "'\n";
        chosen += "    " + name + ") shift words; ((CURRENT -= 1)); " + function_of(one) + "; return ;;\n";
    }
    out +=
        "    )\n    (( CURRENT > 2 )) && case $words[2] in\n" + chosen +
        "    esac\n    [[ CURRENT -gt 2 || $words[2] == -* ]] || _describe -t commands command below\n    _arguments" +
        arguments_of(command) + "\n}\n\n";
}

}  // namespace

std::string zsh_completion(const CommandEntry& program) {
    std::string out(before);
    add_functions(program, out);
    return out + "_polariscope \"$@\"\n";
}

}  // namespace pol
