// SPDX-License-Identifier: Apache-2.0
#include <string_view>

#include "cli/completions.h"

namespace pol {

namespace {

constexpr std::string_view script_before = R"bash(# bash completion of polariscope. Written by: polariscope manual bash

# Offers the WORD... that go on with what is typed.
_polariscope_words() {
    COMPREPLY+=($(compgen -W "$*" -- "$word"))
}

# Offers folders, and files that end in .ENDING..., '' any; shipped scenes where no file fits.
_polariscope_files() {
    local ending files=() folders=() shipped=() program folder typed=${word//\\/}
    compopt -o filenames 2>/dev/null
    for ending; do
        mapfile -t -O "${#files[@]}" files < <(compgen -f ${ending:+-X "!*.$ending"} -- "$typed")
    done
    mapfile -t folders < <(compgen -d -- "$typed")
    COMPREPLY+=("${files[@]}" "${folders[@]}")
    [[ " $* " == *' yaml '* && ${#files[@]} -eq 0 && $typed != */* ]] || return 0
    program=$(readlink -f -- "$(type -P -- "${COMP_WORDS[0]}")")
    for folder in "$POLARISCOPE_ASSETS" "${program%/*/*}/share/polariscope" "${program%/*}/share/polariscope"; do
        [ -d "$folder/scenes" ] || continue
        mapfile -t shipped < <(compgen -G "$folder/scenes/$typed*.yaml")
        COMPREPLY+=("${shipped[@]}")
        break
    done
}

_polariscope() {
    local word=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD - 1]} command='' i
    COMPREPLY=()
    # --option=value comes as three words.
    if [ "$word" = = ]; then
        word=
    elif [ "$option" = = ]; then
        option=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case "$command ${COMP_WORDS[i]}" in
)bash";

constexpr std::string_view after = R"bash(}

complete -F _polariscope polariscope
)bash";

/// What a command is called in the script: " check facts", and of the program itself nothing.
std::string path_of(const CommandEntry& command) {
    const std::size_t end = command.name.find(' ');
    return end == std::string::npos ? std::string() : command.name.substr(end);
}

std::string joined(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) out += ' ' + word;
    return out;
}

/// The lines that offer these values.
std::string offer(const Values& values, const std::string& indent) {
    std::string out;
    if (!values.words.empty()) out += indent + "_polariscope_words" + joined(values.words) + '\n';
    std::vector<std::string> endings;
    for (const std::string& ending : values.endings) endings.push_back(ending.empty() ? "''" : ending);
    if (!endings.empty() || values.folders) out += indent + "_polariscope_files" + joined(endings) + '\n';
    return out;
}

template <typename Do>
void for_each_command(const CommandEntry& command, const Do& act) {
    act(command);
    for (const CommandEntry& one : command.commands) for_each_command(one, act);
}

/// Options with a value: what is offered behind them, which may be nothing.
std::string option_cases(const CommandEntry& command) {
    std::string out;
    for (const OptionEntry& option : command.options) {
        if (option.is_argument || option.type.empty()) continue;
        std::string pattern;
        for (const std::string& name : option.names)
            pattern += (pattern.empty() ? "'" : " | '") + path_of(command) + ' ' + name + '\'';
        out += "    " + pattern + ")\n" + offer(option.values, "        ") + "        return ;;\n";
    }
    return out;
}

std::string argument_case(const CommandEntry& command) {
    std::vector<std::string> options;
    std::vector<std::string> commands;
    std::string values;
    for (const OptionEntry& option : command.options) {
        if (option.is_argument)
            values += offer(option.values, "            ");
        else
            options.insert(options.end(), option.names.begin(), option.names.end());
    }
    for (const CommandEntry& one : command.commands) commands.push_back(one.name.substr(one.name.rfind(' ') + 1));
    if (!commands.empty()) values = "            _polariscope_words" + joined(commands) + '\n' + values;
    if (values.empty()) values = "            :\n";
    return "    '" + path_of(command) + "')\n        if [[ $word == -* ]]; then\n            _polariscope_words" +
           joined(options) + "\n        else\n" + values + "        fi ;;\n";
}

}  // namespace

std::string bash_completion(const CommandEntry& program) {
    std::string paths;
    std::string options;
    std::string arguments;
    for_each_command(program, [&](const CommandEntry& command) {
        if (!path_of(command).empty()) paths += (paths.empty() ? "'" : " | '") + path_of(command) + '\'';
        options += option_cases(command);
        arguments += argument_case(command);
    });
    return std::string(script_before) + "        " + paths +
           ") command+=\" ${COMP_WORDS[i]}\" ;;\n        esac\n    done\n" + "    case \"$command $option\" in\n" +
           options + "    esac\n    case $command in\n" + arguments + "    esac\n" + std::string(after);
}

}  // namespace pol
