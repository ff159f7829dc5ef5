// SPDX-License-Identifier: Apache-2.0
#include "cli/convert_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "cli/messages.h"
#include "cli/output_checks.h"
#include "cli/picture_options.h"
#include "core/result.h"
#include "io/pictures/picture_writer.h"

namespace pol {

namespace {

namespace fs = std::filesystem;

struct ConvertRequest {
    PictureOptions input;
    std::string output;
    std::size_t form = 0;  ///< in picture_forms()
    bool half = false;
    ConventionOptions convention;
};

void say(const ConvertRequest& request, const std::string& sentence) {
    remark(fmt::format("{}: {}\n", printable(request.output), printable(sentence)));
}

Result<Done> run_convert(const ConvertRequest& request) {
    const PictureFormInfo& form = picture_forms()[request.form];
    const auto usage_error = [](std::string field, std::string what, std::string hint) {
        return Error{ErrorKind::usage, std::move(what), {}, std::move(field), std::move(hint)};
    };
    if (request.half && form.form != PictureForm::mitsuba)
        return usage_error("--half", fmt::format("{} has no 16-bit floats", form.name), "it goes with --as mitsuba");
    POL_TRY(const auto source, request.input.source());
    std::vector<fs::path> inputs = source.files;
    for (const fs::path& file : source.stokes_files)
        if (!file.empty()) inputs.push_back(file);
    if (const auto problem = output_problem(request.output, form.ending, inputs)) return *problem;

    POL_TRY(const auto image, request.input.read());
    for (const fs::path& file : files_of_form(image, request.output, form.form))
        if (const auto problem = output_problem(file, form.ending, inputs)) return *problem;
    const FormOptions options{form.form, request.half, request.convention.over({})};
    POL_TRY(const auto lost, write_picture(image, request.output, options));
    for (const std::string& sentence : image.origin.assumed) say(request, "assumed: " + sentence);
    for (const std::string& sentence : image.origin.remarks) say(request, "note: " + sentence);
    for (const std::string& sentence : lost) say(request, "lost: " + sentence);
    return Done{};
}

std::string convert_footer() {
    std::string text = "Forms:\n";
    for (const PictureFormInfo& form : picture_forms()) text += fmt::format("  {:<18} {}\n", form.name, form.about);
    text += "\n" + picture_layouts_text();
    text +=
        "\nWhat the file does not hold is said on stderr; without a line \"lost\" the numbers come back to the bit.\n"
        "\nSave Stokes from Mitsuba so that nothing is lost, after img = mi.render(scene) with an rgb film:\n"
        "  mi.Bitmap(img, channel_names=['R','G','B'] + scene.integrator().aov_names()).write('x.exr')\n"
        "\nExamples:\n"
        "  polariscope convert stone.exr -o stone.npz --as npz\n"
        "  polariscope convert tensor.npy -o tensor.exr --as mitsuba --half\n"
        "  polariscope convert camera_000.png -o camera.npy --as npy --y down\n"
        "  polariscope convert a.png b.png c.png --angles 0,60,120 -o light.fits --as fits\n"
        "  polariscope convert --stokes s0=i.exr,s1=q.exr,s2=u.exr -o light.npz --as npz\n";
    return text;
}

}  // namespace

void add_convert_command(ProgramCommand app, int& exit_code) {
    const auto request = std::make_shared<ConvertRequest>();
    ProgramCommand command = app.add_subcommand("convert", "Write a Stokes picture in the form of another program");
    command.add_option("IN", request->input.files, "Stokes picture of any program; several with --angles")
        .type_name(picture_names);
    command.add_option("-o,--output", request->output, "File; of several, what their names begin with and their ending")
        .type_name("FILE")
        .required();
    std::vector<std::string> words;
    for (const PictureFormInfo& form : picture_forms()) words.emplace_back(form.name);
    command
        .add_choice(
            "--as", words, [request](std::size_t word) { request->form = word; }, "What to write, see below")
        .required();
    command.add_flag("--half", request->half, "mitsuba: 16-bit floats");
    add_convention_options(command, request->convention, {}, "What is written");
    add_picture_options(command, request->input);
    command.footer(convert_footer());
    command.callback([request, &exit_code] {
        const Result<Done> done = run_convert(*request);
        exit_code = done ? 0 : report(done.error());
    });
}

}  // namespace pol
