// SPDX-License-Identifier: Apache-2.0
#include "cli/interface_cases.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/result.h"
#include "optics/boundary_solver.h"
#include "optics/evanescent_modes.h"

namespace pol {
namespace {

using Json = nlohmann::ordered_json;

Error wrong(const std::string& field, const std::string& what, const std::string& hint = {}) {
    return Error{ErrorKind::input, what, {}, field, hint};
}

Result<double> read_number(const Json& object, const std::string& field, const char* key, double above, bool or_equal) {
    if (!object.contains(key)) return wrong(field, fmt::format("key \"{}\" is missing", key));
    if (!object[key].is_number()) return wrong(field + "." + key, "is not a number");
    const double value = object[key].get<double>();
    const bool in_range = (or_equal ? value >= above : value > above) && value <= 1000.0;
    if (!in_range) return wrong(field + "." + key, fmt::format("{} is no index of refraction", value));
    return value;
}

Result<DVec3> read_direction(const Json& object, const std::string& field, const char* key) {
    if (!object.contains(key)) return wrong(field, fmt::format("key \"{}\" is missing", key));
    const Json& list = object[key];
    const std::string path = field.empty() ? key : field + "." + key;
    if (!list.is_array() || list.size() != 3) return wrong(path, "is not a list of three numbers");
    DVec3 v;
    for (int i = 0; i < 3; ++i) {
        const Json& number = list[static_cast<std::size_t>(i)];
        if (!number.is_number()) return wrong(path, "is not a list of three numbers");
        v[i] = number.get<double>();
    }
    const double size2 = length2(v);
    if (!(size2 > 1e-200 && size2 < 1e200)) return wrong(path, "has no direction", "lengths from 1e-100 to 1e100");
    return unit(v);
}

Result<Dielectric<double>> read_medium(const Json& object, const char* key) {
    if (!object.contains(key)) return wrong("", fmt::format("key \"{}\" is missing", key));
    const Json& medium = object[key];
    if (!medium.is_object() || !medium.contains("type") || !medium["type"].is_string()) {
        return wrong(key, "is not an object with a \"type\"");
    }
    const std::string type = medium["type"].get<std::string>();
    if (type == "isotropic") {
        POL_TRY(const auto n, read_number(medium, key, "n", 0.0, false));
        if (!medium.contains("k")) return make_isotropic(n);
        POL_TRY(const auto k, read_number(medium, key, "k", 0.0, true));
        return make_isotropic(n, k);
    }
    if (type == "uniaxial") {
        POL_TRY(const auto n_o, read_number(medium, key, "no", 0.0, false));
        POL_TRY(const auto n_e, read_number(medium, key, "ne", 0.0, false));
        POL_TRY(const auto axis, read_direction(medium, key, "axis"));
        return make_uniaxial(n_o, n_e, axis);
    }
    if (type == "conductor" && std::string(key) == "medium2") {
        POL_TRY(const auto n, read_number(medium, key, "n", 0.0, false));
        POL_TRY(const auto k, read_number(medium, key, "k", 0.0, true));
        return make_conductor(n, k);
    }
    return wrong(std::string(key) + ".type", fmt::format("\"{}\" is not supported", type),
                 "isotropic or uniaxial; medium 2 may also be a conductor");
}

Json list_of(const DVec3& v) {
    return Json::array({v.x, v.y, v.z});
}

const char* label_of(WaveKind kind, std::size_t mode) {
    if (kind == WaveKind::ordinary) return "o";
    if (kind == WaveKind::extraordinary) return "e";
    return mode == 0 ? "s" : "p";
}

const char* letter_of(Side side) {
    return side == Side::reflected ? "R" : "T";
}

Json mode_json(const Wave<double>& wave, std::size_t mode, const DVec3& field) {
    return Json{{"label", label_of(wave.kind, mode)},
                {"degenerate", wave.kind == WaveKind::pair},
                {"kind", "propagating"},
                {"k", list_of(wave.k)},
                {"E", list_of(field)},
                {"ray", list_of(wave.ray)}};
}

/// Waves that leave on one side for incident mode `column`, propagating ones first.
void add_side(Json& out, Side side, const BoundaryResponse<double>& response, std::size_t column,
              const std::vector<EvanescentMode<double>>& evanescent) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(response.outgoing_count); ++i) {
        const OutgoingWave<double>& wave = response.outgoing[i];
        if (wave.side != side) continue;
        for (std::size_t m = 0; m < static_cast<std::size_t>(wave.wave.mode_count()); ++m) {
            const Complex<double> a = wave.amplitude[m][column];
            Json mode{{"side", letter_of(side)}};
            mode.update(mode_json(wave.wave, m, wave.wave.field[m]));
            mode["amp"] = Json::array({a.re, a.im});
            mode["power"] = norm2(a);
            out.push_back(std::move(mode));
        }
    }
    for (const EvanescentMode<double>& mode : evanescent) {
        if (mode.side != side) continue;
        out.push_back(Json{{"side", letter_of(side)},
                           {"label", label_of(mode.kind, static_cast<std::size_t>(mode.index_in_pair))},
                           {"degenerate", mode.kind == WaveKind::pair},
                           {"kind", "evanescent"},
                           {"k", list_of(mode.k_re)},
                           {"k_im", list_of(mode.k_im)},
                           {"power", 0.0}});
    }
}

}  // namespace

Result<InterfaceCase> read_interface_case(const std::string& line) {
    const Json object = Json::parse(line, nullptr, false);
    if (object.is_discarded() || !object.is_object()) return wrong("", "is not a JSON object");
    InterfaceCase result;
    POL_TRY(const auto normal, read_direction(object, "", "normal"));
    POL_TRY(const auto wave_normal, read_direction(object, "", "wave_normal"));
    POL_TRY(const auto medium1, read_medium(object, "medium1"));
    POL_TRY(const auto medium2, read_medium(object, "medium2"));
    return InterfaceCase{normal, wave_normal, medium1, medium2, object.value("case", Json())};
}

Json solve_interface_case(const InterfaceCase& interface) {
    Json incident = Json::array();
    const WavesOfNormal<double> waves = waves_of_wave_normal(interface.medium1, interface.wave_normal);
    for (int w = 0; w < waves.count; ++w) {
        const Wave<double>& wave = waves.wave[w];
        const auto response = respond_in_full(interface.medium1, interface.medium2, interface.normal, wave);
        const auto evanescent = evanescent_modes(interface.medium1, interface.medium2, interface.normal, wave);
        for (std::size_t j = 0; j < static_cast<std::size_t>(wave.mode_count()); ++j) {
            Json mode = mode_json(wave, j, response.incident ? response.incident_field[j] : wave.field[j]);
            if (response.incident) {
                Json out = Json::array();
                add_side(out, Side::reflected, response, j, evanescent);
                add_side(out, Side::transmitted, response, j, evanescent);
                mode["out"] = std::move(out);
                if (response.absorbs) mode["absorbed"] = response.absorption[j][j].re;
            } else {
                mode["not_incident"] = true;
            }
            incident.push_back(std::move(mode));
        }
    }
    return Json{{"case", interface.name}, {"incident", std::move(incident)}};
}

}  // namespace pol
