// SPDX-License-Identifier: Apache-2.0
#include "cli/maps_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/messages.h"
#include "cli/output_checks.h"
#include "cli/picture_options.h"
#include "core/result.h"
#include "io/pictures/png_file.h"
#include "maps/colorize.h"
#include "maps/quantity.h"
#include "maps/wilkie_picture.h"
#include "report/map_picture.h"
#include "spectrum/wavelength_grid.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

/// What the user typed.
struct MapsRequest {
    PictureOptions input;
    std::string map;
    std::string output;
    std::optional<double> wavelength_nm;
    std::string band;
    std::string style = "scientific";
    double exposure = 0.0;
    std::vector<double> range;
    bool fade_by_bar = false;
    bool plain = false;

    /// The file that messages and captions name.
    [[nodiscard]] fs::path path() const {
        const auto source = input.source();
        return source ? source.value().path() : fs::path();
    }
};

Result<std::vector<Quantity>> wanted_quantities(const std::string& name) {
    std::vector<Quantity> wanted;
    if (name == "all") {
        for (const QuantityInfo& about : quantities()) wanted.push_back(about.quantity);
        return wanted;
    }
    if (const auto quantity = quantity_named(name)) return std::vector<Quantity>{*quantity};
    std::string names;
    for (const QuantityInfo& about : quantities()) names += fmt::format("{}, ", about.name);
    return usage_error("--map", fmt::format("there is no map '{}'", name),
                       fmt::format("did you mean {}? Maps: {}all", info(nearest_quantity(name)).name, names));
}

Result<MapOptions> wanted_options(const MapsRequest& request) {
    const std::map<std::string_view, MapStyle> styles{
        {"scientific", MapStyle::scientific}, {"paper", MapStyle::paper}, {"wilkie", MapStyle::wilkie}};
    const auto style = styles.find(request.style);
    if (style == styles.end()) {
        return usage_error("--style", fmt::format("there is no style '{}'", request.style),
                           "scientific, paper or wilkie");
    }
    MapOptions options{style->second, std::nullopt, request.exposure};
    options.fade_by_bar = request.fade_by_bar;
    if (!std::isfinite(request.exposure) || std::abs(request.exposure) > 1000.0) {
        return usage_error("--exposure", fmt::format("{} is no number of stops", request.exposure), "for example -2");
    }
    if (request.range.empty()) return options;
    const bool is_range = request.range.size() == 2 && std::isfinite(request.range[0]) &&
                          std::isfinite(request.range[1]) && request.range[0] < request.range[1] &&
                          std::isfinite(request.range[1] - request.range[0]);
    if (!is_range) return usage_error("--range", "is not two ascending numbers", "for example --range 0,0.2");
    options.range = MapRange{request.range[0], request.range[1]};
    return options;
}

std::string list_of(const std::vector<Band>& bands) {
    std::string list;
    for (const Band& band : bands) list += (list.empty() ? "" : ", ") + band.label();
    return list;
}

/// The wavelength that the user asks for, or the default one.
Result<std::size_t> wanted_wavelength(const StokesImage& image, std::optional<double> asked_nm) {
    constexpr double same_nm = 1e-3;
    const std::vector<double> known = wavelengths_of(image.bands);
    if (known.empty())
        return usage_error("--wavelength", "the picture has bands without wavelengths",
                           fmt::format("--band, one of {}", list_of(image.bands)));
    const std::size_t nearest = nearest_wavelength(known, asked_nm.value_or(default_wavelength_nm));
    if (asked_nm && !(std::abs(known[nearest] - *asked_nm) <= same_nm)) {
        if (const auto problem = wavelength_problem(*asked_nm))
            return usage_error("--wavelength", problem->what, problem->hint);
        return usage_error("--wavelength", fmt::format("the picture has no plane at {} nm", *asked_nm),
                           fmt::format("it has {}", list_of(image.bands)));
    }
    return nearest;
}

/// Index of the band that the user asks for; none: of the default wavelength, of G, or the first.
Result<std::size_t> wanted_band(const StokesImage& image, const MapsRequest& request) {
    if (!request.band.empty()) {
        const auto found = std::find_if(image.bands.begin(), image.bands.end(), [&](const Band& band) {
            return band.label() == request.band || band.label() == request.band + " nm";
        });
        if (found != image.bands.end()) return static_cast<std::size_t>(found - image.bands.begin());
        return usage_error("--band", fmt::format("the picture has no band '{}'", request.band),
                           fmt::format("it has {}", list_of(image.bands)));
    }
    if (request.wavelength_nm || !wavelengths_of(image.bands).empty())
        return wanted_wavelength(image, request.wavelength_nm);
    const auto primaries = rgb_bands(image.bands);
    return primaries ? (*primaries)[1] : 0;
}

std::string caption_of(const StokesImage& image, const fs::path& input) {
    const auto scene = image.attributes.find("scene");
    return scene == image.attributes.end() ? input.filename().string() : fs::path(scene->second).filename().string();
}

Result<Done> write_map(const StokesImage& image, Quantity quantity, std::size_t band, const MapOptions& options,
                       const MapsRequest& request, const fs::path& output) {
    POL_TRY(const auto map, draw_map(image, quantity, band, options));
    const auto warn_of = [&](PixelState state, std::string_view what) {
        const std::size_t bad = map.state_count[static_cast<std::size_t>(state)];
        if (bad > 0)
            remark(fmt::format("{}: {} pixels of '{}' {}\n", request.path().string(), bad, info(quantity).name, what));
    };
    warn_of(PixelState::not_a_number, "are not a number");
    const bool is_of_bounds = info(quantity).is_of_bounds();
    const std::size_t unknown = map.state_count[static_cast<std::size_t>(PixelState::not_measured)];
    if (unknown > 0 && quantity == Quantity::samples)
        remark(fmt::format("{}: '{}' is not known: the picture does not tell\n", request.path().string(),
                           info(quantity).name));
    else if (unknown > 0 && !is_of_bounds)
        remark(fmt::format("{}: '{}' needs a Stokes component that was not measured\n", request.path().string(),
                           info(quantity).name));
    if (unknown > 0 && is_of_bounds)
        remark(fmt::format("{}: '{}' is not known: the picture has no residual, which tells what was not traced\n",
                           request.path().string(), info(quantity).name));
    warn_of(PixelState::unphysical, "are unphysical: negative S0 or residual, or polarized light without S0");
    if (request.plain) return write_png(map.picture, output);
    POL_TRY(const auto picture, map_picture(map, caption_of(image, request.path())));
    return write_png(picture, output);
}

Result<Done> make_folder(const fs::path& folder, const char* why) {
    std::error_code status;
    fs::create_directory(folder, status);
    if (fs::is_directory(folder, status)) return Done{};
    return Error{ErrorKind::output, "cannot be made a folder", Place{folder.string()}, {}, why};
}

/// The four standard pictures, NAME_dop.png and so on, as polvis calls them.
Result<Done> write_wilkie_pictures(const StokesImage& image, const MapsRequest& request) {
    std::optional<std::size_t> band;
    if (!request.band.empty() || !wavelengths_of(image.bands).empty()) {
        POL_TRY(const auto found, wanted_band(image, request));
        band = found;
    }
    // All of them before the first is written: some need components that others do not, and half a set misleads.
    std::vector<RgbPicture> pictures;
    for (const WilkiePictureInfo& each : wilkie_pictures) {
        auto picture = wilkie_picture(image, band, each);
        if (!picture) {
            Error error = picture.error();
            error.place.file = request.path().string();
            return error;
        }
        pictures.push_back(std::move(picture.value()));
    }
    POL_TRY_DONE(make_folder(request.output, "--style wilkie without --map writes four files"));
    const std::string stem = request.path().stem().string();
    for (std::size_t i = 0; i < pictures.size(); ++i)
        POL_TRY_DONE(
            write_png(pictures[i], fs::path(request.output) / fmt::format("{}_{}.png", stem, wilkie_pictures[i].name)));
    return Done{};
}

Result<Done> run_maps(const MapsRequest& request) {
    POL_TRY(const auto options, wanted_options(request));
    const bool is_standard = request.map.empty() && options.style == MapStyle::wilkie;
    if (request.map.empty() && !is_standard)
        return usage_error("--map", "is missing", "a map, see polariscope maps --help; or --style wilkie for its four");
    std::vector<Quantity> wanted;
    if (!is_standard) {
        POL_TRY(wanted, wanted_quantities(request.map));
    }
    const bool is_folder = request.map == "all" || is_standard;
    if (!is_folder) {
        if (const auto problem = output_problem(request.output, ".png", {request.path().string()})) return *problem;
    } else if (std::error_code status;
               fs::path(request.output).extension() == ".png" && !fs::is_directory(request.output, status)) {
        return usage_error("--output", fmt::format("several pictures do not go into one file, {}", request.output),
                           "name a folder, for example maps/");
    }
    POL_TRY(const auto image, request.input.read());
    if (is_standard) return write_wilkie_pictures(image, request);
    POL_TRY(const auto band, wanted_band(image, request));
    if (is_folder) POL_TRY_DONE(make_folder(request.output, "--map all writes one file per map"));
    for (const Quantity quantity : wanted) {
        const fs::path output = is_folder ? fs::path(request.output) / fmt::format("{}.png", info(quantity).name)
                                          : fs::path(request.output);
        const Result<Done> written = write_map(image, quantity, band, options, request, output);
        if (!written) return written.error();
    }
    return Done{};
}

std::string maps_footer() {
    std::string text = "Maps:\n";
    for (const QuantityInfo& about : quantities()) text += fmt::format("  {:<18} {}\n", about.name, about.definition);
    text +=
        "  all                every map, as NAME.png in the folder OUT\n"
        "\nStyles:\n"
        "  scientific         scales that can be read without color vision; gray where a map is undefined,\n"
        "                     hatched where too much light was left out to know, darkly where S0 is below a\n"
        "                     thousandth of the brightest pixel's, magenta where not a number, dark magenta where S0\n"
        "                     is negative\n"
        "  paper              value times D65: white is 1; black is 0, no light or unpolarized. Signed maps and the\n"
        "                     azimuth, which the paper does not draw, as scientific\n"
        "  wilkie             the colors of Wilkie & Weidlich 2010 as polvis of Mitsuba 3 has them. Without --map: "
        "its\n"
        "                     four standard pictures IN_dop, IN_top, IN_lin and IN_cir.png in the folder OUT\n"
        "\nExamples:\n"
        "  polariscope maps stone.exr --map dop -o dop.png\n"
        "  polariscope maps stone.exr --map azimuth --wavelength 440 -o azimuth.png\n"
        "  polariscope maps stone.exr --map ellipticity --style paper --plain -o figure.png\n"
        "  polariscope maps stone.exr --map dop --range 0,0.2 -o weak.png\n"
        "  polariscope maps stone.exr --map all -o maps/\n"
        "  polariscope maps mitsuba.exr --style wilkie -o maps/\n"
        "  polariscope maps mitsuba.exr --map azimuth --band R -o azimuth.png\n";
    text += "\n" + picture_layouts_text();
    return text;
}

}  // namespace

void add_maps_command(ProgramCommand app, int& exit_code) {
    const auto request = std::make_shared<MapsRequest>();
    ProgramCommand command = app.add_subcommand("maps", "Draw a map of a Stokes picture as PNG");
    command.add_option("IN", request->input.files, "Stokes picture of any program, see Layouts below")
        .type_name(picture_names);
    add_picture_options(command, request->input);
    command.add_option("--map", request->map, "what to draw, see below").type_name("MAP");
    command.add_option("-o,--output", request->output, "PNG file; a folder for --map all and the four of wilkie")
        .type_name("NAME.png|FOLDER")
        .required();
    command.add_option("--wavelength", request->wavelength_nm, "wavelength in nm (default: the one nearest to 580)");
    command.add_option("--band", request->band, "band of a picture without wavelengths (default: G, or the first)")
        .type_name("NAME");
    command.add_option("--style", request->style, "how it looks, see below")
        .type_name("scientific|paper|wilkie")
        .capture_default_str();
    command.add_option("--exposure", request->exposure, "stops, for color and intensity").capture_default_str();
    command.add_option("--range", request->range, "LO,HI: values at the ends of the color bar").list(',', 1, 2);
    command.add_flag("--fade-by-bar", request->fade_by_bar,
                     "fade as the error bar widens, to gray where it covers half of the range; not on gray scales");
    command.add_flag("--plain", request->plain, "the pixels of the map alone, without bar and legend");
    command.footer(maps_footer());
    command.callback([request, &exit_code] {
        const Result<Done> done = run_maps(*request);
        exit_code = done ? 0 : report(done.error());
    });
}

}  // namespace pol
