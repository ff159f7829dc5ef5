// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/view_command.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "cli/messages.h"
#include "core/result.h"
#include "viewer/app/app.h"
#include "viewer/commands/commands.h"

namespace pol {

namespace {

struct ViewRequest {
    PictureOptions picture;
    std::optional<std::string> listen;
    std::string size = "1280x800";
    AppOptions options;
};

/// Files are documents of their own, unless options make one picture of them.
Result<std::vector<FileToOpen>> files_to_open(const PictureOptions& options) {
    if (!options.stokes.empty() || !options.angles.empty()) {
        POL_TRY(auto source, options.source());
        return std::vector{FileToOpen{std::move(source), true, options.from}};
    }
    std::vector<FileToOpen> files;
    for (const std::string& name : options.files) {
        FileToOpen file{{}, is_picture(name) || !options.layout.empty(), options.from};
        file.source.files = {name};
        file.source.layout = options.layout;
        if (!file.is_picture && options.from.given())
            return Error{ErrorKind::usage,
                         "'" + name + "' is a scene: its numbers are ours",
                         {},
                         "--from-...",
                         "leave the option out, or open the scene on its own"};
        files.push_back(std::move(file));
    }
    return files;
}

/// Where to listen. A word behind --listen that is a file is one: it could be left out.
Result<std::optional<LiveAddress>> listening_address(ViewRequest& request) {
    const bool needs_it = request.options.live_rules.anywhere || !request.options.live_rules.open_folder.empty();
    if (!request.listen) {
        if (!needs_it) return std::optional<LiveAddress>();
        return Error{ErrorKind::usage, "is about listening, which is off", {}, "--listen-...", "add --listen"};
    }
    std::error_code unknown;
    if (std::filesystem::exists(*request.listen, unknown)) {
        request.picture.files.insert(request.picture.files.begin(), *request.listen);
        request.listen->clear();
    }
    POL_TRY(auto address, read_live_address(*request.listen));
    return std::optional(std::move(address));
}

/// "1280x800" as width and height; what is wrong with it if it is not.
std::string check_size(const std::string& text) {
    int width = 0;
    int height = 0;
    char rest = 0;
    constexpr int least = 320;
    constexpr int most = 16384;
    const bool read = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2;
    return read && std::min(width, height) >= least && std::max(width, height) <= most
               ? std::string()
               : "'" + text + "' is no size of a window: WIDTHxHEIGHT, 320 to 16384, as in 1280x800";
}

/// The message if `text` is no folder that can be written to.
std::string scale_problem(const std::string& text) {
    double scale = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), scale);
    const bool right = status == std::errc() && end == text.data() + text.size() && scale >= 0.5 && scale <= 4.0;
    return right ? std::string() : "'" + text + "' is no factor from 0.5 to 4";
}

std::string folder_problem(const std::string& text) {
    std::error_code failed;
    if (!std::filesystem::is_directory(text, failed)) return "there is no folder '" + text + "': make it first";
    return {};
}

std::string check_folder(const std::string& text) {
    if (const std::string problem = folder_problem(text); !problem.empty()) return problem;
    if (::access(text.c_str(), W_OK | X_OK) != 0) return "the folder '" + text + "' cannot be written to";
    return {};
}

/// All keys, from the table that the window itself goes by.
std::string keys_text() {
    std::string text = "Keys:\n";
    for (const Command& command : commands()) {
        std::string keys = name_of(command.chord);
        if (keys.empty()) continue;
        if (command.also.key != Key::none) keys += ", " + name_of(command.also);
        constexpr std::size_t column = 16;
        keys.resize(std::max(column, keys.size() + 2), ' ');
        text += "  " + keys + std::string(command.title) + '\n';
    }
    return text;
}

}  // namespace

void add_view_command(ProgramCommand app, int& exit_code) {
    auto request = std::make_shared<ViewRequest>();
    ProgramCommand command = app.add_subcommand("view", "Open scenes and pictures in a window");
    command.add_option("files", request->picture.files, "Scenes (*.yaml) and pictures (*.exr, *.npy, *.png, ...)")
        .type_name(std::string("NAME.yaml|") + picture_names);
    add_picture_options(command, request->picture);
    command.add_option("--size", request->size, "Size of the window in points")
        .type_name("WxH")
        .check(check_size)
        .capture_default_str();
    command.add_choice(
        "--theme", {"dark", "light"},
        [request](std::size_t index) { request->options.theme = index == 0 ? Theme::dark : Theme::light; },
        "Colors of the window");
    command.add_option("--ui-scale", request->options.ui_scale, "Size of fonts and widgets; without it, the screen's")
        .type_name("FACTOR")
        .check(scale_problem);
    command
        .add_option_function<std::string>(
            "--listen", [request](const std::string& address) { request->listen = address; },
            "Take pictures that other programs send as to the viewer tev; at 127.0.0.1:14158 unless said")
        .type_name("HOST:PORT|unix:PATH")
        .optional_value();
    command.add_flag("--listen-anywhere", request->options.live_rules.anywhere,
                     "Listen where other machines can reach it, too");
    command
        .add_option("--listen-open", request->options.live_rules.open_folder,
                    "Programs that send may have files of this folder opened")
        .type_name("FOLDER")
        .check(folder_problem);
    command.add_option("--probe", request->options.probe).hidden().check(check_folder);
    command.footer(keys_text() + '\n' + picture_layouts_text() +
                   "\nExamples:\n"
                   "  polariscope view assets/scenes/paper-calcite-unpolarized.yaml\n"
                   "  polariscope view before.exr after.exr --theme light\n"
                   "  polariscope view --stokes s0=i.exr,s1=q.exr,s2=u.exr --from-zero up\n"
                   "  polariscope view --listen");
    command.callback([request, &exit_code] {
        AppOptions& options = request->options;
        std::sscanf(request->size.c_str(), "%dx%d", &options.width, &options.height);
        const auto run = [&]() -> Result<Done> {
            POL_TRY(options.listen, listening_address(*request));
            POL_TRY(const auto files, files_to_open(request->picture));
            return run_app(files, options);
        };
        const auto ended = run();
        exit_code = ended ? 0 : report(ended.error());
    });
}

}  // namespace pol
