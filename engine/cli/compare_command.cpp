// SPDX-License-Identifier: Apache-2.0
#include "cli/compare_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/compare_report.h"
#include "cli/messages.h"
#include "cli/picture_options.h"
#include "core/join.h"
#include "core/result.h"
#include "io/scenes/picture_attributes.h"
#include "io/scenes/scene_file.h"
#include "plan/compile.h"
#include "render/render_to_end.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

struct CompareRequest {
    std::vector<std::string> files;  ///< A, then B; with a scene B alone will do
    std::string scene;
    std::string band;
    std::optional<double> tolerance;
    bool adopt = false;
    bool json = false;
    PictureOptions a;
    PictureOptions b;
};

/// Pixels of `picture` along a side of the boxes that ours is rendered for: the fewest with which it is at most 64 x
/// 64; 1 where no such boxes fit, or if it is a part of a picture.
int render_box(const StokesImage& picture) {
    constexpr int enough = 64;
    if (picture.whole_width > 0) return 1;
    const int most = std::min(picture.width, picture.height);
    for (int box = 1; box <= most; ++box)
        if (picture.width % box == 0 && picture.height % box == 0 && picture.width / box <= enough &&
            picture.height / box <= enough)
            return box;
    return 1;
}

/// Enough for the color of a scene that was written for one wavelength: 380 to 780 nm in steps of 20 nm.
std::vector<double> wavelengths_of_colors() {
    std::vector<double> wavelengths;
    for (int nm = 380; nm <= 780; nm += 20) wavelengths.push_back(nm);
    return wavelengths;
}

/// Our picture of the scene, to hold against `other`.
Result<StokesImage> render_for(Scene scene, const fs::path& file, const StokesImage& other) {
    const int box = render_box(other);
    scene.render.width = (other.whole_width > 0 ? other.whole_width : other.width) / box;
    scene.render.height = (other.whole_height > 0 ? other.whole_height : other.height) / box;
    if (std::vector<double> wavelengths = wavelengths_of(other.bands); !wavelengths.empty())
        scene.render.wavelengths_nm = std::move(wavelengths);
    else if (rgb_bands(other.bands) && scene.render.wavelengths_nm.size() == 1)
        scene.render.wavelengths_nm = wavelengths_of_colors();
    POL_TRY(auto plan, compile(scene));
    StokesImage image = render_to_end(std::move(plan)).picture;
    for (auto& [name, text] : picture_attributes(scene, image.samples, file)) image.attributes[name] = text;
    return image;
}

/// Tangent of the view angle of a pixel of `ours`.
std::optional<double> pixel_tangent(const Scene& scene, const StokesImage& ours) {
    if (scene.camera.projection != Projection::perspective) return std::nullopt;
    const int width = ours.whole_width > 0 ? ours.whole_width : ours.width;
    return 2.0 * std::tan(0.5 * scene.camera.horizontal_fov) / width;
}

ComparedPicture described(const std::string& name, const StokesImage& image) {
    ComparedPicture picture{name, image.width, image.height, image.left, image.top, {}, image.origin};
    for (const Band& band : image.bands) picture.bands.push_back(band.label());
    return picture;
}

Distance distance_of(const StokesImage& a, const StokesImage& b, const compare::Pairing& pairing) {
    const compare::CommonPictures common = compare::common_pictures(a, b, pairing);
    return {error_metrics(common.b.image, common.a.image), compare::agreement(common)};
}

/// The files of both pictures: with --angles or --stokes B has several or none of its own.
std::optional<Error> share_files(CompareRequest& request) {
    std::vector<std::string>& files = request.files;
    const bool a_is_rendered = !request.scene.empty() && (request.b.stokes.empty() ? files.size() < 2 : files.empty());
    if (!a_is_rendered && request.a.stokes.empty()) {
        if (files.empty()) return usage_error("", "there are no pictures to compare", "name two, or one and --scene");
        request.a.files = {files.front()};
        files.erase(files.begin());
    }
    if (files.size() > 1 && request.b.angles.empty())
        return usage_error("", fmt::format("{} pictures are named, but two are compared", files.size() + 1),
                           "leave some out; --angles takes several files for B");
    request.b.files = std::move(files);
    if (request.b.files.empty() && request.b.stokes.empty())
        return usage_error("", "there is one picture only",
                           "name another one, or the scene that it shows: --scene NAME.yaml");
    return std::nullopt;
}

std::optional<Error> wrong_options(const CompareRequest& request) {
    if (request.tolerance && !(*request.tolerance >= 0.0))
        return Error{ErrorKind::usage, "is no share of the light", {}, "--tolerance", "for example 0.02 for 2 %"};
    if (!request.scene.empty() && is_picture_name(request.scene))
        return Error{ErrorKind::usage,
                     fmt::format("'{}' is a picture", request.scene),
                     {},
                     "--scene",
                     "name the scene that the pictures show; pictures stand without an option"};
    for (const std::string& file : request.files)
        if (fs::path(file).extension() == ".yaml")
            return usage_error("", fmt::format("'{}' is a scene, not a picture", file),
                               fmt::format("to render ours from it: --scene {}", file));
    return std::nullopt;
}

int run(CompareRequest& request) {
    if (const auto problem = wrong_options(request)) return report(*problem);
    if (const auto problem = share_files(request)) return report(*problem);
    std::optional<Scene> scene;
    if (!request.scene.empty()) {
        auto loaded = load_scene(request.scene);
        if (!loaded) return report(loaded.error());
        scene = std::move(loaded).value();
    }
    auto b = request.b.read();
    if (!b) return report(b.error());
    const bool is_rendered = request.a.files.empty() && request.a.stokes.empty();
    auto a = is_rendered ? render_for(*scene, request.scene, b.value()) : request.a.read();
    if (!a) return report(a.error());
    const auto pairing = compare::pair_up(a.value(), b.value(), request.band);
    if (!pairing) return report(pairing.error());

    ComparisonReport found;
    const auto name_of = [](const PictureOptions& options) {
        return options.files.empty() ? options.stokes : join(options.files, ", ");
    };
    found.a = described(is_rendered ? request.scene : name_of(request.a), a.value());
    found.b = described(name_of(request.b), b.value());
    found.remarks = pairing.value().remarks;
    found.tolerance = request.tolerance;
    for (const compare::BandPair& pair : pairing.value().bands) found.compared_bands.push_back(pair.label);
    found.box = pairing.value().box_a;
    found.left = a.value().left + pairing.value().in_a.x;
    found.top = a.value().top + pairing.value().in_a.y;
    found.verdict = compare::diagnose(a.value(), b.value(), pairing.value(),
                                      scene ? pixel_tangent(*scene, a.value()) : std::nullopt);
    found.adoptable = compare::adoptable(found.verdict, b.value().origin.convention);
    found.adopted = request.adopt && found.adoptable;
    if (!pairing.value().lies_across) {
        if (!found.adopted) found.distance = distance_of(a.value(), b.value(), pairing.value());
        if (found.adoptable) {
            read_in(b.value(), *found.adoptable);
            const Distance then = distance_of(a.value(), b.value(), pairing.value());
            if (found.adopted)
                found.distance = then;
            else
                found.with_adoptable = then.metrics;
        }
    }
    fmt::print("{}", request.json ? comparison_json(found) : comparison_text(found));
    return found.is_same() || found.is_within_tolerance() ? 0 : self_check_failed;
}

}  // namespace

void add_compare_command(ProgramCommand app, int& exit_code) {
    auto request = std::make_shared<CompareRequest>();
    ProgramCommand command = app.add_subcommand("compare",
                                                "Hold another program's picture B against ours, A: which convention "
                                                "makes the one from the other, and how far they are apart");
    command
        .add_option("FILES", request->files,
                    "A, ours, and B, the other one; B alone with --scene; several of B with --angles")
        .type_name(picture_names);
    command
        .add_option("--scene", request->scene,
                    "The scene that both show, from which ours is rendered if A is left out; see below")
        .type_name("NAME.yaml");
    command.add_option("--band", request->band, "Compare this one only: a wavelength, or a name such as R")
        .type_name("BAND");
    command.add_option("--tolerance", request->tolerance, "Exit 0, too, if fro_c is at most this share of the light")
        .type_name("FRO_C");
    command.add_flag("--adopt", request->adopt,
                     "Take B to be written in the convention that explains it, if there is one");
    command.add_flag("--json", request->json, "Print JSON");
    add_picture_options(command, request->b);
    add_picture_options(command, request->a, "a-");
    command.footer(
        "Options of pictures are for B; with a- in front for A.\n"
        "\n--scene renders ours with the scene's settings, of boxes of B's pixels such that it is at most 64 x 64; at "
        "21\n"
        "wavelengths if B has R, G, B and the scene one. Its field of view tells frames that depend on the pixel.\n"
        "\nSame: every number differs by no more than both files round it and both pictures left untraced; or the "
        "error "
        "bars\n"
        "of the pictures explain all differences, each Stokes component by itself. Nothing else counts as the same: a "
        "picture\n"
        "without error bars of its own, such as Mitsuba's, differs by its noise; fro_c says how much, and --tolerance "
        "how much\n"
        "may be; another convention or another polarization it never excuses.\n"
        "\nExit codes: 0 the same, or within --tolerance (with --adopt: once the convention is adopted); 5 they "
        "differ, also if\n"
        "only the convention does.\n"
        "\nExamples:\n"
        "  polariscope compare ours.exr mitsuba.exr\n"
        "  polariscope compare ours.exr mitsuba.exr --adopt --json\n"
        "  polariscope compare ours.exr mitsuba.exr --tolerance 0.02\n"
        "  polariscope compare mitsuba.exr --scene assets/scenes/cube-calcite.yaml\n"
        "  polariscope compare ours.exr p000.png p045.png p090.png p135.png --angles 0,45,90,135");
    command.callback([request, &exit_code] { exit_code = run(*request); });
}

}  // namespace pol
