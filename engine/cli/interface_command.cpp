// SPDX-License-Identifier: Apache-2.0
#include "cli/interface_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/interface_cases.h"
#include "cli/messages.h"
#include "core/hypot.h"
#include "core/result.h"
#include "core/units.h"
#include "io/files/assets.h"
#include "io/scenes/index_file.h"
#include "scene/medium.h"
#include "spectrum/wavelength_grid.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

/// What the user typed.
struct InterfaceRequest {
    std::string from;
    std::string to;
    std::vector<double> from_axis;
    std::vector<double> to_axis;
    double angle_deg = 0.0;
    double wavelength_nm = 580.0;
    std::string cases;
};

/// "1.5", "1.6584,1.4864" or "0.3+2.84i", with nothing beside.
struct Numbers {
    std::vector<double> values;
    bool is_complex = false;
};

/// Empty unless all of `text` is that: infrasil.yml and 4H-SiC begin like numbers, too.
std::optional<Numbers> numbers_in(std::string_view text) {
    Numbers found;
    found.is_complex = text.ends_with('i');
    if (found.is_complex) text.remove_suffix(1);
    const char separator = found.is_complex ? '+' : ',';
    for (;;) {
        text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
        double value = 0.0;
        const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (status != std::errc{}) return std::nullopt;
        found.values.push_back(value);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        if (text.empty()) return found;
        if (text.front() != separator) return std::nullopt;
        text.remove_prefix(1);
    }
}

Result<DVec3> direction(const std::vector<double>& axis, const std::string& option) {
    const DVec3 v = axis.size() == 3 ? DVec3(axis[0], axis[1], axis[2]) : DVec3(0.0);
    const double size2 = length2(v);
    if (!(size2 > 1e-200 && size2 < 1e200)) {
        return usage_error(option, "is not a direction", fmt::format("three numbers, for example {} 1,0,1", option));
    }
    return unit(v);
}

/// What is wrong with a record that an option names, at the option unless it is in a file.
Error in_option(Error error, const std::string& option) {
    if (error.place.file.empty()) error.field = option;
    return error;
}

/// Surfaces are those of n + i k whatever k is; from this k on, what enters is listed as absorbed and not as a wave:
/// its field dies within a few wavelengths.
constexpr double metal_extinction = 0.01;

Dielectric<double> matter(const ComplexIndex& index) {
    return index.k >= metal_extinction ? make_conductor(index.n, index.k) : make_isotropic(index.n, index.k);
}

Result<Dielectric<double>> crystal(double n_o, double n_e, const std::vector<double>& axis,
                                   const std::string& axis_option) {
    if (axis.empty())
        return usage_error(axis_option, "is missing: the medium is a crystal", fmt::format("{} 1,0,1", axis_option));
    POL_TRY(const auto c, direction(axis, axis_option));
    return make_uniaxial(n_o, n_e, c);
}

Result<Dielectric<double>> medium(const std::string& text, const std::vector<double>& axis, double wavelength_nm,
                                  const std::string& option, const std::string& axis_option) {
    const auto in_range = [](double n) { return n > 0.0 && n <= 1000.0; };
    if (text == "air" || text == "vacuum") return make_isotropic(1.0);
    const bool looks_like_numbers = text.find_first_not_of("0123456789.,+-eEi ") == std::string::npos;
    if (const auto numbers = numbers_in(text); numbers || looks_like_numbers) {
        const std::vector<double> v = numbers ? numbers->values : std::vector<double>{};
        const bool two = v.size() == 2 && in_range(v[0]);
        if (two && numbers->is_complex && v[1] >= 0.0 && v[1] <= 1000.0) return matter({v[0], v[1]});
        if (two && !numbers->is_complex && in_range(v[1])) return crystal(v[0], v[1], axis, axis_option);
        if (v.size() == 1 && !numbers->is_complex && in_range(v[0])) return make_isotropic(v[0]);
        return usage_error(option, fmt::format("'{}' is no medium", text),
                           "an index 1.5, a crystal n_o,n_e, a metal n+ki, or the name of an index record");
    }
    if (is_crystal(text, assets_dir())) {
        const Result<CrystalIndices> records = load_crystal(text, assets_dir());
        if (!records) return in_option(records.error(), option);
        POL_TRY(const auto n_o, index_at(records.value().ordinary, wavelength_nm));
        POL_TRY(const auto n_e, index_at(records.value().extraordinary, wavelength_nm));
        const double k = std::max(n_o.k, n_e.k);
        if (k >= strongest_crystal_extinction)
            return usage_error(option, fmt::format("'{}' has an extinction of {:g}: too much for a crystal", text, k),
                               "crystals are followed with real indices; a metal is written n+ki");
        return crystal(n_o.n, n_e.n, axis, axis_option);
    }
    const Result<RefractiveIndex> record = load_index(text, assets_dir());
    if (!record) return in_option(record.error(), option);
    POL_TRY(const auto n, index_at(record.value(), wavelength_nm));
    if (extinction_is_unknown(record.value(), wavelength_nm))
        remark(
            fmt::format("polariscope: k of '{}' is not known at {} nm: 0 is used\n", printable(text), wavelength_nm));
    return matter(n);
}

std::string describe(const Dielectric<double>& m) {
    if (m.kind == MediumKind::isotropic)
        return fmt::format("isotropic, n = {:.9g}", m.n) + (m.is_complex() ? fmt::format(" + {:.9g} i", m.kappa) : "");
    if (m.kind == MediumKind::conductor) return fmt::format("conductor, n = {:.9g} + {:.9g} i", m.n, m.kappa);
    return fmt::format("uniaxial, n_o = {:.9g}, n_e = {:.9g}, axis ({:.6f}, {:.6f}, {:.6f})", m.n, m.n_e, m.axis.x,
                       m.axis.y, m.axis.z);
}

DVec3 vector_of(const nlohmann::ordered_json& list) {
    return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

/// Degrees between a direction and the normal's line.
double tilt(const DVec3& v) {
    return degrees(std::atan2(pol::hypot(v.x, v.y), std::abs(v.z)));
}

void print_table(const InterfaceCase& interface, const InterfaceRequest& request) {
    fmt::print("from  {}\nto    {}\n", describe(interface.medium1), describe(interface.medium2));
    fmt::print("normal (0, 0, 1), plane of incidence xz, wave normal at {:g} deg, {:g} nm\n", request.angle_deg,
               request.wavelength_nm);
    const auto result = solve_interface_case(interface);
    for (const auto& in : result["incident"]) {
        const DVec3 k_in = vector_of(in["k"]);
        fmt::print("\nincident {}, index {:.7f}, ray at {:.6f} deg\n", in["label"].get<std::string>(),
                   std::sqrt(length2(k_in)), tilt(vector_of(in["ray"])));
        if (in.contains("not_incident")) {
            fmt::print("  its energy does not reach the interface\n");
            continue;
        }
        fmt::print("  {:<12}{:<6}{:>11}{:>12}{:>12}{:>14}{:>11}   {}\n", "side", "wave", "index", "k [deg]",
                   "ray [deg]", "power", "phase", "ray");
        double sum = 0.0;
        for (const auto& out : in["out"]) {
            const char* side = out["side"] == "R" ? "reflected" : "transmitted";
            const std::string label = out["label"].get<std::string>();
            const DVec3 k = vector_of(out["k"]);
            if (out["kind"] == "evanescent") {
                fmt::print("  {:<12}{:<6}evanescent, decays as exp(-{:.6f} k0 z)\n", side, label,
                           std::sqrt(length2(vector_of(out["k_im"]))));
                continue;
            }
            const DVec3 ray = vector_of(out["ray"]);
            const double power = out["power"].get<double>();
            sum += power;
            fmt::print("  {:<12}{:<6}{:>11.7f}{:>12.6f}{:>12.6f}{:>14.10f}{:>11.5f}   ({:.8f}, {:.8f}, {:.8f})\n", side,
                       label, std::sqrt(length2(k)), tilt(k), tilt(ray), power,
                       degrees(std::atan2(out["amp"][1].get<double>(), out["amp"][0].get<double>())), ray.x, ray.y,
                       ray.z);
        }
        if (in.contains("absorbed")) {
            fmt::print("  {:<53}{:>14.10f}\n", "absorbed", in["absorbed"].get<double>());
            sum += in["absorbed"].get<double>();
        }
        fmt::print("  {:<53}{:>14.10f}\n", "sum", sum);
    }
}

Result<Done> run_table(const InterfaceRequest& request) {
    if (request.from.empty() || request.to.empty()) {
        return usage_error("interface", "needs --from and --to, or --cases",
                           "polariscope interface --from air --to 1.5 --angle 30");
    }
    if (!(request.angle_deg >= 0.0 && request.angle_deg < 90.0)) {
        return usage_error("--angle", fmt::format("{} is not from 0 to below 90 degrees", request.angle_deg),
                           "for example 30");
    }
    if (const auto problem = wavelength_problem(request.wavelength_nm))
        return usage_error("--wavelength", problem->what, problem->hint);
    POL_TRY(const auto from, medium(request.from, request.from_axis, request.wavelength_nm, "--from", "--from-axis"));
    if (from.kind == MediumKind::conductor)
        return usage_error("--from", "light does not come out of a metal", "exchange --from and --to");
    POL_TRY(const auto to, medium(request.to, request.to_axis, request.wavelength_nm, "--to", "--axis"));
    const double angle = radians(request.angle_deg);
    print_table({{0.0, 0.0, 1.0}, {std::sin(angle), 0.0, std::cos(angle)}, from, to, {}}, request);
    return Done{};
}

/// Answers every line that can be answered, complains about the others, and fails if there were any.
Result<Done> run_cases(const std::string& path) {
    std::error_code failed;
    const char* hint = "name a file of JSON lines, or - for standard input";
    if (fs::is_directory(path, failed))
        return Error{ErrorKind::input, "is a folder, not a file", Place{path}, {}, hint};
    std::ifstream file;
    if (path != "-") {
        file.open(path);
        if (!file) return Error{ErrorKind::input, "cannot be opened", Place{path}, {}, hint};
    }
    std::istream& lines = path == "-" ? std::cin : file;
    int number = 0;
    int bad = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        const Result<InterfaceCase> interface = read_interface_case(line);
        if (interface) {
            fmt::print("{}\n", solve_interface_case(interface.value()).dump());
            continue;
        }
        ++bad;
        Error error = interface.error();
        error.place = Place{path, number};
        report(error);
    }
    if (lines.bad())
        return Error{ErrorKind::input, "cannot be read to its end", Place{path, number}, {}, "is the disk in order?"};
    if (bad > 0)
        return Error{ErrorKind::input,
                     fmt::format("{} of {} lines could not be used", bad, number),
                     Place{path},
                     {},
                     "see above; the other lines are answered"};
    return Done{};
}

constexpr const char* footer =
    "Media: air; an index (1.5); a crystal n_o,n_e (1.6584,1.4864); a metal n+ki (0.3+2.84i); a record of\n"
    "assets/refractive_index (n-bk7, gold) or a path to one; calcite means the records calcite-o and calcite-e,\n"
    "./spar the files ./spar-o.yml and ./spar-e.yml.\n"
    "The surface of an absorbing medium is that of n+ki. From k = 0.01 on what enters counts as absorbed, below it as\n"
    "a wave. Light in an absorbing first medium interferes with its reflection: 'absorbed' has what that takes or\n"
    "adds. Crystals are solved with real indices, and refused from k = 0.01 on.\n"
    "Frame: the normal is z, from the first medium to the second; the wave normal lies in the xz plane.\n"
    "Waves: s and p (s along y), o and e in crystals. Powers are shares of the incident energy flux, phases are in\n"
    "degrees for fields as exp(-i omega t).\n"
    "\nExamples:\n"
    "  polariscope interface --from air --to calcite --axis 1,2,3 --angle 40 --wavelength 589.3\n"
    "  polariscope interface --from 1.6584,1.4864 --from-axis 1,1,1 --to air --angle 60\n"
    "  polariscope interface --from air --to gold --angle 45\n"
    "  polariscope interface --cases cases.jsonl > results.jsonl\n"
    "\nA line of CASES: {\"normal\": [0,0,1], \"wave_normal\": [0.6,0,0.8], \"medium1\": {\"type\": \"isotropic\", "
    "\"n\": 1},\n"
    "\"medium2\": {\"type\": \"uniaxial\", \"no\": 1.6584, \"ne\": 1.4864, \"axis\": [1,2,3]}}; an optional \"case\" "
    "is repeated in the\n"
    "answer. Lines that cannot be used are named on stderr; the others are answered, and the exit code is 3.\n";

}  // namespace

void add_interface_command(ProgramCommand app, int& exit_code) {
    const auto request = std::make_shared<InterfaceRequest>();
    ProgramCommand command = app.add_subcommand("interface", "What one interface does to light");
    command.add_option("--from", request->from, "medium that the light comes from").type_name("MEDIUM");
    command.add_option("--to", request->to, "medium behind the interface").type_name("MEDIUM");
    command.add_option("--from-axis", request->from_axis, "X,Y,Z: optic axis of the first medium").list(',', 1, 3);
    command.add_option("--axis,--to-axis", request->to_axis, "X,Y,Z: optic axis of the second medium").list(',', 1, 3);
    command.add_option("--angle", request->angle_deg, "degrees between wave normal and normal").capture_default_str();
    command.add_option("--wavelength", request->wavelength_nm, "nm, for index records").capture_default_str();
    command.add_option("--cases", request->cases, "JSON lines, one interface each; - is standard input")
        .type_name("FILE");
    command.footer(footer);
    command.callback([request, &exit_code] {
        const Result<Done> done = request->cases.empty() ? run_table(*request) : run_cases(request->cases);
        exit_code = done ? 0 : report(done.error());
    });
}

}  // namespace pol
