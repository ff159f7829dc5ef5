// SPDX-License-Identifier: Apache-2.0
#include "viewer/session/preferences.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "core/result.h"
#include "io/files/input_file.h"
#include "io/files/output_file.h"

namespace pol {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uintmax_t max_bytes = 1U << 20U;

constexpr std::array<std::pair<MapStyle, const char*>, 3> style_names{
    {{MapStyle::scientific, "scientific"}, {MapStyle::paper, "paper"}, {MapStyle::wilkie, "wilkie"}}};

/// A finite number in the range, else `usual`.
double number(const json& object, const char* key, double low, double high, double usual) {
    const double value = object.value(key, usual);
    return value >= low && value <= high ? value : usual;
}

Preferences from_json(const json& file) {
    Preferences read;
    if (file.value("theme", "dark") == "light") read.theme = Theme::light;
    read.ui_scale = number(file, "ui_scale", 0.0, 8.0, read.ui_scale);
    const json layout = file.value("layout", json::object());
    read.layout.left_width = number(layout, "left_width", 50.0, 5000.0, read.layout.left_width);
    read.layout.right_width = number(layout, "right_width", 50.0, 5000.0, read.layout.right_width);
    read.layout.upper_share = number(layout, "upper_share", 0.1, 0.9, read.layout.upper_share);
    read.quantity = quantity_named(file.value("map", "")).value_or(read.quantity);
    for (const auto& [style, name] : style_names)
        if (file.value("style", "") == name) read.style = style;
    for (const json& path : file.value("recent_files", json::array()))
        read.recent_files.emplace_back(path.get<std::string>());
    for (const json& chosen : file.value("conventions", json::array())) {
        StokesConvention convention;
        convention.left_handed = chosen.value("left_handed", false);
        convention.y_down = chosen.value("y_down", false);
        convention.azimuth_zero_deg = number(chosen, "azimuth_zero_deg", -360.0, 360.0, 0.0);
        read.chosen_conventions.push_back({chosen.value("picture", ""), convention});
    }
    return read;
}

}  // namespace

fs::path preferences_path() {
    const char* config = std::getenv("XDG_CONFIG_HOME");
    if (config != nullptr && fs::path(config).is_absolute()) return fs::path(config) / "polariscope/preferences.json";
    const char* home = std::getenv("HOME");
    if (home == nullptr || home[0] == '\0') return {};
    return fs::path(home) / ".config/polariscope/preferences.json";
}

Result<Preferences> read_preferences(const fs::path& path) {
    std::error_code ignored;
    if (path.empty() || !fs::exists(path, ignored)) return Preferences{};
    POL_TRY(const auto text, read_input_file(path, max_bytes));
    try {
        return from_json(json::parse(text));
    } catch (const json::exception& exception) {
        return Error{ErrorKind::input,
                     std::string("cannot be read: ") + exception.what(),
                     {path.string()},
                     {},
                     "the usual settings are used; the file is written anew when the window closes"};
    }
}

Result<Done> write_preferences(const Preferences& preferences, const fs::path& path) {
    json file;
    file["theme"] = preferences.theme == Theme::light ? "light" : "dark";
    file["ui_scale"] = preferences.ui_scale;
    file["layout"] = {{"left_width", preferences.layout.left_width},
                      {"right_width", preferences.layout.right_width},
                      {"upper_share", preferences.layout.upper_share}};
    file["map"] = std::string(info(preferences.quantity).name);
    for (const auto& [style, name] : style_names)
        if (preferences.style == style) file["style"] = name;
    file["recent_files"] = json::array();
    for (const fs::path& recent : preferences.recent_files) file["recent_files"].push_back(recent.string());
    file["conventions"] = json::array();
    for (const auto& [picture, convention] : preferences.chosen_conventions)
        file["conventions"].push_back({{"picture", picture},
                                       {"left_handed", convention.left_handed},
                                       {"y_down", convention.y_down},
                                       {"azimuth_zero_deg", convention.azimuth_zero_deg}});
    std::error_code failed;
    fs::create_directories(path.parent_path(), failed);
    if (failed)
        return Error{ErrorKind::output,
                     "the folder cannot be made: " + failed.message(),
                     {path.parent_path().string()},
                     {},
                     "set XDG_CONFIG_HOME to a folder that you may write to"};
    return write_file(path, file.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

Preferences preferences_of(const Session& session) {
    return {session.window().theme, session.window().ui_scale, session.window().layout,     session.view().quantity,
            session.view().style,   session.recent_files(),    session.chosen_conventions()};
}

void apply(const Preferences& preferences, Session& session) {
    WindowState& window = session.change_window();
    window.theme = preferences.theme;
    window.ui_scale = preferences.ui_scale;
    window.layout = preferences.layout;
    session.show(preferences.quantity);
    session.change_view().style = preferences.style;
    session.set_recent_files(preferences.recent_files);
    session.set_chosen_conventions(preferences.chosen_conventions);
}

}  // namespace pol
