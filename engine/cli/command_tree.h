// SPDX-License-Identifier: Apache-2.0
// The commands and options of the program as plain data, read from the tables that --help prints, so that manual page
// and completions cannot say anything else.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pol {

/// What may stand for a value, read from its type name in the help: `point|area` are words, NAME.exr is a file with
/// that ending, FILE any file, FOLDER a folder, and MAP, MEDIUM, FACT and SWEEP are the names the program knows. Of any
/// other value nothing is known.
struct Values {
    std::vector<std::string> words;
    std::vector<std::string> endings;  ///< of files; "" is any
    bool folders = false;

    bool known() const { return folders || !words.empty() || !endings.empty(); }
};

/// An option, a flag or an argument.
struct OptionEntry {
    std::vector<std::string> names;  ///< "-o", "--output"; of an argument one name without dashes
    std::string type;                ///< as the help prints it; empty for a flag
    std::string preset;              ///< the value without the option; empty: none, or said in the description
    std::string description;
    bool is_argument = false;
    bool required = false;
    bool repeated = false;
    Values values;
};

struct CommandEntry {
    std::string name;  ///< "polariscope check facts"
    std::string description;
    std::string footer;
    std::vector<OptionEntry> options;
    std::vector<CommandEntry> commands;
};

/// All that the help shows, in its order.
CommandEntry command_tree(const CLI::App& app);

}  // namespace pol
