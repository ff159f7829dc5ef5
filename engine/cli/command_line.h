// SPDX-License-Identifier: Apache-2.0
// Commands and options, as the commands declare them. CLI11 stands behind it, and is included in few files: its header
// alone takes longer to compile than most of ours.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace pol {

/// An option that was declared; its methods add to that.
class ProgramOption {
public:
    explicit ProgramOption(CLI::Option& option) : option_(&option) {}

    ProgramOption& required();
    /// As the help prints it: "FILE", "WxH", or words to choose from, "dark|light".
    ProgramOption& type_name(const std::string& name);
    /// The help prints the value that it has now.
    ProgramOption& capture_default_str();
    /// Values, from `least` to `most` of them, may be written as one word with this between them.
    ProgramOption& list(char delimiter, int least, int most);
    /// The value may be left out; then it is the empty text.
    ProgramOption& optional_value();
    /// `problem` says what is wrong with a word; nothing if it is right.
    ProgramOption& check(const std::function<std::string(const std::string&)>& problem);
    /// The help does not show it.
    ProgramOption& hidden();

private:
    CLI::Option* option_;
};

/// A command, or the whole program. A copy stands for the same command.
class ProgramCommand {
public:
    explicit ProgramCommand(CLI::App& app) : app_(&app) {}

    ProgramCommand add_subcommand(const std::string& name, const std::string& description);
    /// `names`: "-o,--output"; without dashes an argument. `Value` is a text, a path, a number, an optional of one, or
    /// a vector.
    template <class Value>
    ProgramOption add_option(const std::string& names, Value& value, const std::string& description = {});
    /// The same with a function that takes the value.
    template <class Value>
    ProgramOption add_option_function(const std::string& names, const std::function<void(const Value&)>& take,
                                      const std::string& description);
    /// One of `words`; `take` gets its index.
    ProgramOption add_choice(const std::string& names, const std::vector<std::string>& words,
                             const std::function<void(std::size_t)>& take, const std::string& description);
    ProgramOption add_flag(const std::string& names, bool& value, const std::string& description);
    ProgramOption add_flag_callback(const std::string& names, const std::function<void()>& take,
                                    const std::string& description);
    /// What stands under the options in the help.
    void footer(const std::string& text);
    /// `run` is called when the command was chosen, after all values are in place.
    void callback(const std::function<void()>& run);
    void may_have_subcommand();

    [[nodiscard]] bool has_chosen_subcommand() const;
    [[nodiscard]] std::vector<std::string> subcommand_names() const;
    /// Those that stand on the command line.
    [[nodiscard]] std::vector<std::string> given_options() const;

private:
    CLI::App* app_;
};

}  // namespace pol
