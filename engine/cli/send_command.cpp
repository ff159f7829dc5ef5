// SPDX-License-Identifier: Apache-2.0
#include "cli/send_command.h"

#include <fmt/format.h>

#include <memory>
#include <string>

#include "cli/messages.h"
#include "cli/picture_options.h"
#include "core/result.h"
#include "io/live/live_sender.h"

namespace pol {
namespace {

struct SendRequest {
    PictureOptions input;
    std::string to;
    std::string name;
};

Result<Done> run_send(const SendRequest& request) {
    POL_TRY(const auto address, read_live_address(request.to));
    POL_TRY(const auto source, request.input.source());
    POL_TRY(const auto picture, request.input.read());
    const std::string name = request.name.empty() ? source.path().filename().string() : request.name;
    constexpr double patience_s = 600.0;  // a receiver that stands still is given up long before (LiveSender)
    LiveSender sender(address, source_of(picture, name));
    return sender.finish(patience_s);
}

}  // namespace

void add_send_command(ProgramCommand app, int& exit_code) {
    const auto request = std::make_shared<SendRequest>();
    ProgramCommand command =
        app.add_subcommand("send", "Show a Stokes picture in a viewer that runs: tev, or another window");
    command.add_option("IN", request->input.files, "Stokes picture, of any layout that is read")
        .type_name(picture_names);
    add_picture_options(command, request->input);
    command.add_option("--to", request->to, "where the viewer listens (default: 127.0.0.1:14158)")
        .type_name("HOST:PORT");
    command.add_option("--name", request->name, "what the viewer calls it (default: the name of the file)");
    command.footer(
        "R, G and B go first, so that every viewer shows something, then S0 to S3 of each band.\n"
        "\nExamples:\n"
        "  polariscope send stone.exr\n"
        "  polariscope send stone.exr --to 127.0.0.1:14159\n");
    command.callback([request, &exit_code] {
        const Result<Done> done = run_send(*request);
        exit_code = done ? 0 : report(done.error());
    });
}

}  // namespace pol
