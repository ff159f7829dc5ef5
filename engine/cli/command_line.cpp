// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/join.h"

namespace pol {

ProgramOption& ProgramOption::required() {
    option_->required();
    return *this;
}

ProgramOption& ProgramOption::type_name(const std::string& name) {
    option_->type_name(name);
    return *this;
}

ProgramOption& ProgramOption::capture_default_str() {
    option_->capture_default_str();
    return *this;
}

ProgramOption& ProgramOption::list(char delimiter, int least, int most) {
    option_->delimiter(delimiter)->expected(least, most);
    return *this;
}

ProgramOption& ProgramOption::check(const std::function<std::string(const std::string&)>& problem) {
    option_->check(CLI::Validator([problem](std::string& word) { return problem(word); }, {}));
    return *this;
}

ProgramOption& ProgramOption::optional_value() {
    option_->expected(0, 1);
    return *this;
}

ProgramOption& ProgramOption::hidden() {
    option_->group({});
    return *this;
}

ProgramCommand ProgramCommand::add_subcommand(const std::string& name, const std::string& description) {
    return ProgramCommand(*app_->add_subcommand(name, description));
}

template <class Value>
ProgramOption ProgramCommand::add_option(const std::string& names, Value& value, const std::string& description) {
    return ProgramOption(*app_->add_option(names, value, description));
}

template ProgramOption ProgramCommand::add_option(const std::string&, std::string&, const std::string&);
template ProgramOption ProgramCommand::add_option(const std::string&, std::filesystem::path&, const std::string&);
template ProgramOption ProgramCommand::add_option(const std::string&, int&, const std::string&);
template ProgramOption ProgramCommand::add_option(const std::string&, double&, const std::string&);
template ProgramOption ProgramCommand::add_option(const std::string&, std::optional<int>&, const std::string&);
template ProgramOption ProgramCommand::add_option(const std::string&, std::optional<double>&, const std::string&);
template ProgramOption ProgramCommand::add_option(const std::string&, std::vector<int>&, const std::string&);
template ProgramOption ProgramCommand::add_option(const std::string&, std::vector<double>&, const std::string&);
template ProgramOption ProgramCommand::add_option(const std::string&, std::vector<std::string>&, const std::string&);

template <class Value>
ProgramOption ProgramCommand::add_option_function(const std::string& names,
                                                  const std::function<void(const Value&)>& take,
                                                  const std::string& description) {
    return ProgramOption(*app_->add_option_function<Value>(names, take, description));
}

template ProgramOption ProgramCommand::add_option_function(const std::string&,
                                                           const std::function<void(const std::string&)>&,
                                                           const std::string&);
template ProgramOption ProgramCommand::add_option_function(const std::string&, const std::function<void(const int&)>&,
                                                           const std::string&);
template ProgramOption ProgramCommand::add_option_function(const std::string&,
                                                           const std::function<void(const double&)>&,
                                                           const std::string&);
template ProgramOption ProgramCommand::add_option_function(const std::string&,
                                                           const std::function<void(const std::uint64_t&)>&,
                                                           const std::string&);

ProgramOption ProgramCommand::add_choice(const std::string& names, const std::vector<std::string>& words,
                                         const std::function<void(std::size_t)>& take, const std::string& description) {
    const auto index_of = [words](const std::string& word) {
        return static_cast<std::size_t>(std::find(words.begin(), words.end(), word) - words.begin());
    };
    const auto problem = [words, index_of](const std::string& word) {
        return index_of(word) < words.size() ? std::string()
                                             : fmt::format("'{}' is none of {}", word, join(words, ", "));
    };
    const std::function<void(const std::string&)> taken = [take, index_of](const std::string& word) {
        take(index_of(word));
    };
    return add_option_function(names, taken, description).type_name(join(words, "|")).check(problem);
}

ProgramOption ProgramCommand::add_flag(const std::string& names, bool& value, const std::string& description) {
    return ProgramOption(*app_->add_flag(names, value, description));
}

ProgramOption ProgramCommand::add_flag_callback(const std::string& names, const std::function<void()>& take,
                                                const std::string& description) {
    return ProgramOption(*app_->add_flag_callback(names, take, description));
}

void ProgramCommand::footer(const std::string& text) {
    app_->footer(text);
}

void ProgramCommand::callback(const std::function<void()>& run) {
    app_->callback(run);
}

void ProgramCommand::may_have_subcommand() {
    app_->require_subcommand(0, 1);
}

bool ProgramCommand::has_chosen_subcommand() const {
    return !app_->get_subcommands().empty();
}

std::vector<std::string> ProgramCommand::subcommand_names() const {
    std::vector<std::string> names;
    for (const CLI::App* one : app_->get_subcommands({})) names.push_back(one->get_name());
    return names;
}

std::vector<std::string> ProgramCommand::given_options() const {
    std::vector<std::string> names;
    for (const CLI::Option* option : app_->get_options())
        if (option->count() > 0) names.push_back(option->get_name());
    return names;
}

}  // namespace pol
