// SPDX-License-Identifier: Apache-2.0
#include "cli/command_tree.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <string_view>
#include <system_error>

#include "io/files/assets.h"
#include "maps/quantity.h"
#include "verify/degenerate/degenerate_case.h"
#include "verify/facts/fact.h"

namespace pol {

namespace {

/// Names of the shipped records; calcite for calcite-o and calcite-e, which stand for one medium.
std::vector<std::string> media() {
    namespace fs = std::filesystem;
    std::set<std::string> names{"air"};
    std::error_code failed;
    for (fs::directory_iterator it(assets_dir() / "refractive_index", failed), end; !failed && it != end;
         it.increment(failed)) {
        if (it->path().extension() != ".yml") continue;
        std::string name = it->path().stem().string();
        if (name.ends_with("-o") || name.ends_with("-e")) name.resize(name.size() - 2);
        names.insert(name);
    }
    return {names.begin(), names.end()};
}

/// The names that stand behind one word of a type name in capitals.
std::vector<std::string> known_names(std::string_view type) {
    std::vector<std::string> names;
    if (type == "MAP") {
        for (const QuantityInfo& about : quantities()) names.emplace_back(about.name);
        names.emplace_back("all");
    } else if (type == "MEDIUM") {
        names = media();
    } else if (type == "FACT") {
        for (const verify::Fact& fact : verify::facts()) names.push_back(fact.id);
    } else if (type == "SWEEP") {
        for (const verify::DegenerateCase& one : verify::degenerate_cases()) {
            if (std::find(names.begin(), names.end(), one.group) == names.end()) names.push_back(one.group);
            names.push_back(one.name);
        }
    }
    return names;
}

bool is_word(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; });
}

Values values_of(const std::string& type) {
    constexpr std::string_view file = "NAME.";
    Values values;
    std::istringstream words(type);
    for (std::string one; std::getline(words, one, '|');) {
        if (one.starts_with(file)) {
            values.endings.push_back(one.substr(file.size()));
        } else if (one == "FILE") {
            values.endings.emplace_back();
        } else if (one == "FOLDER") {
            values.folders = true;
        } else if (is_word(one)) {
            values.words.push_back(one);
        } else {
            values.words = known_names(one);
        }
    }
    return values;
}

OptionEntry entry_of(const CLI::Option& option) {
    OptionEntry entry;
    for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
    entry.is_argument = entry.names.empty();
    if (entry.is_argument) entry.names.push_back(option.get_name());
    if (option.get_items_expected_max() > 0) {
        entry.type = option.get_type_name();
        entry.values = values_of(entry.type);
    }
    entry.preset = option.get_default_str();
    entry.description = option.get_description();
    entry.required = option.get_required();
    entry.repeated = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
    return entry;
}

CommandEntry tree_below(const CLI::App& app, const std::string& before) {
    CommandEntry entry;
    entry.name = before + app.get_name();
    entry.description = app.get_description();
    entry.footer = app.get_footer();
    for (const CLI::Option* option : app.get_options())
        if (!option->get_group().empty()) entry.options.push_back(entry_of(*option));
    for (const CLI::App* command : app.get_subcommands({}))
        entry.commands.push_back(tree_below(*command, entry.name + " "));
    return entry;
}

}  // namespace

CommandEntry command_tree(const CLI::App& app) {
    return tree_below(app, "");
}

}  // namespace pol
