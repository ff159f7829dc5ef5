// SPDX-License-Identifier: Apache-2.0
#include "cli/check_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "cli/messages.h"
#include "cli/picture_options.h"
#include "core/nearest_word.h"
#include "io/scenes/scene_file.h"
#include "verify/invariants/image_check.h"
#include "verify/invariants/invariants.h"
#include "verify/invariants/scene_twins.h"

namespace pol {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using verify::ImageDefect;
using verify::ImageReport;
using verify::Invariant;
using verify::InvariantResult;
using verify::Outcome;

struct FileRequest {
    PictureOptions picture;
    std::string file;  ///< the first of them, or that of S0
    int size = 16;
    bool json = false;
};

void print(const ordered_json& report) {
    fmt::print("{}\n", report.dump(2, ' ', false, ordered_json::error_handler_t::replace));
}

// Pictures.

std::string place_of(const StokesImage& image, const verify::PixelValue& at) {
    return at.is_luminance ? "luminance" : image.bands[at.band].label();
}

void print_origin(const StokesImage& image) {
    const PictureOrigin& origin = image.origin;
    if (!origin.layout.empty()) fmt::print("read as: {}\n", printable(origin.layout));
    if (origin.convention != StokesConvention{}) fmt::print("taken for: {}\n", origin.convention.text());
    for (const std::string& sentence : origin.assumed) fmt::print("assumed: {}\n", printable(sentence));
    for (const std::string& sentence : origin.remarks) fmt::print("remark: {}\n", printable(sentence));
}

void print_text(const std::string& file, const StokesImage& image, const ImageReport& report) {
    const std::size_t planes = image.bands.size();
    const bool is_crop = image.left != 0 || image.top != 0;
    const std::string kind = wavelengths_of(image.bands).empty() ? "band" : "wavelength";
    fmt::print("{}: {}x{} pixels{}, {} {}{}\n", printable(file), image.width, image.height,
               is_crop ? fmt::format(" from pixel {},{} of the picture on", image.left, image.top) : "", planes, kind,
               planes == 1 ? "" : "s");
    print_origin(image);
    fmt::print("\n");
    for (const ImageDefect& defect : report.defects) {
        fmt::print("{:<46}{:>10}  {}", defect.name, defect.count, defect.count == 0 ? "pass" : "FAIL");
        if (defect.worst)
            fmt::print("   worst: pixel {},{} at {}, {} = {:.6g}", defect.worst->x, defect.worst->y,
                       printable(place_of(image, *defect.worst)), defect.value_name, defect.worst->value);
        fmt::print("\n");
    }
    const verify::DopStatistics& dop = report.dop;
    fmt::print("\n{} values with light, {} dark\n", dop.lit, dop.dark);
    if (dop.measured > 0)
        fmt::print(
            "degree of {}polarization: least {:.6g}, 1 % below {:.6g}, median {:.6g}, 99 % below {:.6g}, most {:.6g}; "
            "mean "
            "{:.6g}\n",
            dop.is_linear ? "linear " : "", dop.least, dop.percentile_1, dop.median, dop.percentile_99, dop.most,
            dop.mean);
    for (const std::string& remark : report.remarks) fmt::print("note: {}\n", printable(remark));
}

std::vector<std::string> band_names(const StokesImage& image) {
    std::vector<std::string> names;
    for (const Band& band : image.bands) names.push_back(band.label());
    return names;
}

ordered_json as_json(const std::string& file, const StokesImage& image, const ImageReport& report) {
    ordered_json out{{"file", file},
                     {"width", image.width},
                     {"height", image.height},
                     {"first_pixel", {image.left, image.top}},
                     {"bits", image.stored.bits},
                     {"spacing", image.stored.spacing},
                     {"lossy_compression", image.stored.lossy},
                     {"bands", band_names(image)},
                     {"wavelengths_nm", wavelengths_of(image.bands)},
                     {"layout", image.origin.layout},
                     {"convention", image.origin.convention.text()},
                     {"assumed", image.origin.assumed},
                     {"read_remarks", image.origin.remarks},
                     {"physical", report.physical()}};
    for (const ImageDefect& defect : report.defects) {
        ordered_json entry{{"name", defect.name}, {"count", defect.count}};
        if (defect.worst)
            entry["worst"] = {{"pixel", {defect.worst->x, defect.worst->y}},
                              {"band", place_of(image, *defect.worst)},
                              {"what", defect.value_name},
                              {"value", defect.worst->value}};
        out["defects"].push_back(entry);
    }
    const verify::DopStatistics& dop = report.dop;
    out["dop"] = {{"lit", dop.lit},           {"dark", dop.dark},
                  {"measured", dop.measured}, {"of", dop.is_linear ? "linear polarization" : "polarization"},
                  {"least", dop.least},       {"percentile_1", dop.percentile_1},
                  {"median", dop.median},     {"percentile_99", dop.percentile_99},
                  {"most", dop.most},         {"mean", dop.mean}};
    out["remarks"] = report.remarks;
    return out;
}

int check_picture(const FileRequest& request) {
    const Result<StokesImage> image = request.picture.read();
    if (!image) return report(image.error());
    const ImageReport found = verify::check_image(image.value());
    if (request.json)
        print(as_json(request.file, image.value(), found));
    else
        print_text(request.file, image.value(), found);
    return found.physical() ? 0 : self_check_failed;
}

// Scenes.

/// The command that shows the pixel where an invariant is worst.
std::string explain_command(const FileRequest& request, const verify::WorstPixel& at) {
    return fmt::format("polariscope explain {} --size {}x{} --pixel {},{} --wavelength {}", request.file, request.size,
                       request.size, at.x, at.y, at.wavelength_nm);
}

void print_text(const FileRequest& request, const Invariant& invariant, const InvariantResult& result) {
    fmt::print("{:<19}{}\n{:<19}", invariant.name, invariant.sentence, "");
    if (result.outcome == Outcome::does_not_apply) {
        fmt::print("{}: {}\n", outcome_text(result.outcome), result.note);
        return;
    }
    fmt::print("{}: {} of {} beyond the tolerance", outcome_text(result.outcome), result.violated, result.tested);
    if (result.allowed > 0) fmt::print(", {} allowed", result.allowed);
    fmt::print("; worst {:.3g} tolerances\n", result.worst);
    if (result.violated == 0) return;
    if (!result.note.empty()) fmt::print("{:<19}{}\n", "", result.note);
    if (result.worst_pixel) fmt::print("{:<19}{}\n", "", explain_command(request, *result.worst_pixel));
}

ordered_json as_json(const FileRequest& request, const Invariant& invariant, const InvariantResult& result) {
    ordered_json entry{{"name", invariant.name},
                       {"sentence", invariant.sentence},
                       {"outcome", outcome_text(result.outcome)},
                       {"tested", result.tested},
                       {"violated", result.violated},
                       {"allowed", result.allowed},
                       {"worst_in_tolerances", result.worst},
                       {"note", result.note}};
    if (result.worst_pixel) {
        entry["worst_pixel"] = {result.worst_pixel->x, result.worst_pixel->y};
        entry["explain"] = explain_command(request, *result.worst_pixel);
    }
    return entry;
}

int check_scene(const FileRequest& request) {
    const Result<Scene> scene = load_scene(request.file);
    if (!scene) return report(scene.error());
    const auto test = verify::under_test(verify::small(scene.value(), request.size));
    if (!test) return report(test.error());
    ordered_json out{{"scene", request.file}, {"size", {request.size, request.size}}};
    const std::vector<std::string>& doubts = test.value().plan->features.doubts;
    if (!request.json) {
        fmt::print("{}: {}x{} pixels\n\n", printable(request.file), request.size, request.size);
        for (const std::string& doubt : doubts) fmt::print("doubt: {}\n\n", printable(doubt));
    }
    out["doubts"] = doubts;
    bool failed = false;
    for (const Invariant& invariant : verify::invariants()) {
        const InvariantResult result = invariant.check(test.value());
        failed |= result.outcome == Outcome::fail;
        if (request.json)
            out["invariants"].push_back(as_json(request, invariant, result));
        else
            print_text(request, invariant, result);
    }
    if (request.json) print(out);
    return failed ? self_check_failed : 0;
}

/// A file that is not there may be a misspelled subcommand.
int report_missing(const ProgramCommand& command, const std::string& word) {
    const std::vector<std::string> names = command.subcommand_names();
    const auto nearest = nearest_word(word, std::vector<std::string_view>(names.begin(), names.end()));
    if (!nearest) return report({ErrorKind::input, "cannot be opened", Place{word}, {}, "is the name right?"});
    return report({ErrorKind::usage,
                   fmt::format("there is no file and no check '{}'", word),
                   {},
                   {},
                   fmt::format("did you mean '{}'?", *nearest)});
}

int run(const ProgramCommand& command, const FileRequest& request) {
    if (request.file.empty() && !request.picture.given())
        return report({ErrorKind::usage,
                       "nothing to check",
                       {},
                       {},
                       "a scene, a picture or 'facts'; see polariscope check --help"});
    constexpr int largest = 512;
    if (request.size < 1 || request.size > largest)
        return report({ErrorKind::usage,
                       fmt::format("{} is no size of a picture", request.size),
                       {},
                       "--size",
                       fmt::format("1 to {} pixels a side", largest)});
    if (request.picture.given()) return check_picture(request);
    std::error_code status;
    if (!fs::exists(request.file, status)) return report_missing(command, request.file);
    return is_picture(request.file) ? check_picture(request) : check_scene(request);
}

}  // namespace

void add_check_command(ProgramCommand app, int& exit_code) {
    auto request = std::make_shared<FileRequest>();
    ProgramCommand command =
        app.add_subcommand("check", "Prove the physics of this program, of a scene, or of a picture");
    command.may_have_subcommand();
    command
        .add_option("FILE", request->picture.files,
                    "Scene: invariants that hold whatever is in it. Stokes picture of any program: whether it is light")
        .type_name(std::string("NAME.yaml|") + picture_names);
    add_picture_options(command, request->picture);
    command.add_option("--size", request->size, "Scene: pixels along the sides of the picture").capture_default_str();
    command.add_flag("--json", request->json, "Print JSON");
    command.footer(
        "Exit codes: 0 all is well; 1 a fact or a stiff case fails; 5 a scene breaks an invariant, or a picture is not "
        "light.\n"
        "\nExamples:\n"
        "  polariscope check facts T9 T11\n"
        "  polariscope check stiff\n"
        "  polariscope check assets/scenes/cube-calcite.yaml --size 32\n"
        "  polariscope check stone.exr --json\n"
        "  polariscope check mitsuba.exr\n"
        "  polariscope check --angles 0,60,120 a.png b.png c.png\n");
    command.callback([command, request, &exit_code] {
        if (command.has_chosen_subcommand()) return;
        const auto source = request->picture.source();
        if (!request->picture.files.empty())
            request->file = request->picture.files.front();
        else if (source)
            request->file = source.value().path().string();
        exit_code = source || !request->picture.given() ? run(command, *request) : report(source.error());
    });
    add_check_facts_command(command, exit_code);
    add_check_stiff_command(command, exit_code);
    add_check_all_command(command, exit_code);
}

}  // namespace pol
