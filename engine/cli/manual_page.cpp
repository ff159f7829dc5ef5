// SPDX-License-Identifier: Apache-2.0
#include "cli/manual_page.h"

#include <sstream>
#include <string_view>

namespace pol {

namespace {

/// `text` such that roff prints it as it stands: hyphens can be searched for and copied.
std::string literal(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '\\':
                out += "\\e";
                break;
            case '-':
                out += "\\-";
                break;
            case '\'':
                out += "\\(aq";
                break;
            case '`':
                out += "\\(ga";
                break;
            case '^':
                out += "\\(ha";
                break;
            case '~':
                out += "\\(ti";
                break;
            case '"':
                out += "\\(dq";
                break;
            default:
                out += c;
        }
    }
    return out.starts_with('.') ? "\\&" + out : out;
}

std::string bold(std::string_view text) {
    return "\\fB" + literal(text) + "\\fR";
}

std::string italic(std::string_view text) {
    return "\\fI" + literal(text) + "\\fR";
}

/// The text below the options of a help: paragraphs, which are filled; examples, which are not; and lists, whose lines
/// have a term and, two spaces on, what it means.
std::string footer_text(const std::string& footer) {
    constexpr std::string_view indent = "  ";
    constexpr std::string_view example = "  polariscope ";
    std::string out;
    bool begins = true;  // of a paragraph
    bool in_list = false;
    bool in_example = false;
    std::istringstream lines(footer);
    for (std::string line; std::getline(lines, line);) {
        const bool is_example = line.starts_with(example);
        if (in_example && !is_example) {
            out += ".EE\n";
            begins = true;
        } else if (is_example && !in_example) {
            out += ".PP\n.EX\n";
        }
        in_example = is_example;
        if (is_example) {
            out += literal(line) + '\n';
            continue;
        }
        const std::size_t first = line.find_first_not_of(' ');
        if (first == std::string::npos) {
            begins = true;
            continue;
        }
        const std::size_t gap = line.find(indent, first);
        const std::size_t meaning = line.find_first_not_of(' ', gap);
        const bool is_term = first == indent.size() && meaning != std::string::npos;
        if (is_term) {
            out += ".TP\n" + bold(line.substr(first, gap - first)) + '\n' + literal(line.substr(meaning)) + '\n';
        } else {
            const bool goes_on = !begins && (first > 0) == in_list;
            out += (goes_on ? "" : ".PP\n") + literal(line.substr(first)) + '\n';
        }
        in_list = first > 0;
        begins = false;
    }
    if (in_example) out += ".EE\n";
    return out;
}

/// "-o NAME.exr, --output NAME.exr" is said once: "-o, --output NAME.exr".
std::string option_text(const OptionEntry& option) {
    std::string out = ".TP\n";
    for (std::size_t i = 0; i < option.names.size(); ++i) {
        out += i == 0 ? "" : ", ";
        out += option.is_argument ? italic(option.names[i]) : bold(option.names[i]);
    }
    if (!option.type.empty()) out += option.is_argument ? " (" + literal(option.type) + ")" : " " + italic(option.type);
    out += '\n' + literal(option.description);
    if (!option.preset.empty()) out += " [" + literal(option.preset) + "]";
    if (option.required && !option.is_argument) out += " (required)";
    return out + '\n';
}

std::string synopsis_of(const CommandEntry& command) {
    std::string out = bold(command.name) + " [" + italic("options") + "]";
    for (const OptionEntry& option : command.options) {
        if (!option.is_argument && option.required) out += " " + bold(option.names.front()) + " " + italic(option.type);
        if (!option.is_argument) continue;
        const std::string name = italic(option.names.front()) + (option.repeated ? "..." : "");
        out += option.required ? " " + name : " [" + name + "]";
    }
    return out;
}

void add_synopses(const CommandEntry& command, std::string& out) {
    for (const CommandEntry& one : command.commands) {
        out += synopsis_of(one) + '\n';
        add_synopses(one, out);
    }
}

void add_commands(const CommandEntry& command, std::string& out) {
    for (const CommandEntry& one : command.commands) {
        out += ".SS " + literal(one.name) + '\n' + literal(one.description) + ".\n";
        for (const OptionEntry& option : one.options)
            if (option.names.back() != "--help") out += option_text(option);
        out += footer_text(one.footer);
        add_commands(one, out);
    }
}

constexpr const char* places = R"(.SH ENVIRONMENT
.TP
\fBPOLARISCOPE_ASSETS\fR
Folder of the files that ship with the program, in place of those named below.
.TP
\fBXDG_CONFIG_HOME\fR
Folder of settings, in place of \fI\(ti/.config\fR.
.SH FILES
.TP
\fI/usr/share/polariscope\fR
Scenes, textures, refractive indices and pixel cases that ship with the program, where it was installed in \fI/usr/bin\fR;
in general \fI../share/polariscope\fR beside the folder of the program. The texts above call it \fIassets\fR.
.TP
\fI\(ti/.config/polariscope/preferences.json\fR
What the window remembers.
)";

}  // namespace

std::string manual_page(const CommandEntry& program, const std::string& version) {
    const std::string colon = ": ";
    const std::string purpose = program.description.substr(program.description.find(colon) + colon.size());
    std::string out = ".\\\" Written by: polariscope manual page\n.TH POLARISCOPE 1 \"\" \"polariscope " + version +
                      "\" \"User Commands\"\n.SH NAME\npolariscope \\- " + literal(purpose) + "\n.SH SYNOPSIS\n.nf\n";
    add_synopses(program, out);
    out += ".fi\n.SH OPTIONS\n";
    for (const OptionEntry& option : program.options) out += option_text(option);
    out += footer_text(program.footer) + ".SH COMMANDS\n";
    add_commands(program, out);
    return out + places;
}

}  // namespace pol
