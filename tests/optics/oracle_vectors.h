// SPDX-License-Identifier: Apache-2.0
// Reads data/oracle_vectors.jsonl (written by make_oracle_vectors.py) and fills in what the file leaves out.
#pragma once

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/complex.h"
#include "optics/boundary.h"
#include "optics/dielectric.h"

namespace pol::test {

using Json = nlohmann::json;

struct OracleMode {
    Side side = Side::reflected;
    std::string label;  // s, p, o, e
    bool evanescent = false;
    DVec3 k{}, k_im{}, ray{};
    std::optional<DVec3> field;  // propagating modes of every tenth case
    Complex<double> amplitude{};
    double power = 0.0;
    [[nodiscard]] bool in_pair() const { return label == "s" || label == "p"; }
};

struct OracleIncident {
    OracleMode mode;
    bool incident = true;
    std::vector<OracleMode> out;
};

struct OracleCase {
    int number = 0;
    std::string category;
    DVec3 normal{}, wave_normal{};
    Dielectric<double> medium1, medium2;
    std::vector<OracleIncident> incident;
    double sensitivity = 0.0;  // largest change of a mode power when the inputs move by about one ulp
};

inline DVec3 vector_of(const Json& list) {
    return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

inline Dielectric<double> medium_of(const Json& medium) {
    if (medium["type"] == "isotropic") return make_isotropic(medium["n"].get<double>());
    return make_uniaxial(medium["no"].get<double>(), medium["ne"].get<double>(), vector_of(medium["axis"]));
}

/// `before` are the modes listed so far, `twin` the mode at the same place for the first mode of an incident pair.
inline OracleMode mode_of(const Json& json, const Dielectric<double>& medium, const std::vector<OracleMode>& before,
                          const OracleMode* twin) {
    OracleMode mode;
    mode.label = json["label"].get<std::string>();
    mode.evanescent = json.contains("kind");
    if (json.contains("side") && json["side"] == "T") mode.side = Side::transmitted;
    if (json.contains("power")) mode.power = json["power"].get<double>();
    const OracleMode* source = twin != nullptr ? twin : (before.empty() ? nullptr : &before.back());
    if (json.contains("k")) {
        mode.k = vector_of(json["k"]);
        if (mode.evanescent) mode.k_im = vector_of(json["k_im"]);
        mode.ray = json.contains("ray") ? vector_of(json["ray"]) : mode.k / medium.n;
    } else if (source != nullptr) {
        mode.k = source->k;
        mode.k_im = source->k_im;
        mode.ray = source->ray;
    }
    if (json.contains("E") && !mode.evanescent) mode.field = vector_of(json["E"]);
    if (json.contains("amp")) mode.amplitude = {json["amp"][0].get<double>(), json["amp"][1].get<double>()};
    return mode;
}

inline OracleCase case_of(const Json& json) {
    OracleCase result;
    result.number = json["case"].get<int>();
    result.category = json["category"].get<std::string>();
    result.normal = unit(vector_of(json["normal"]));
    result.wave_normal = unit(vector_of(json["wave_normal"]));
    result.medium1 = medium_of(json["medium1"]);
    result.medium2 = medium_of(json["medium2"]);
    result.sensitivity = json["ulp_sensitivity_mode"].get<double>();
    for (const Json& in : json["incident"]) {
        OracleIncident incident;
        incident.mode = mode_of(in, result.medium1, {}, nullptr);
        if (result.medium1.kind == MediumKind::isotropic) incident.mode.k = result.medium1.n * result.wave_normal;
        incident.incident = in.contains("out");
        const bool second = incident.mode.label == "p" && !result.incident.empty() && result.incident[0].incident;
        if (incident.incident) {
            for (const Json& out : in["out"]) {
                const Dielectric<double>& medium = out["side"] == "R" ? result.medium1 : result.medium2;
                const OracleMode* twin = second ? &result.incident[0].out[incident.out.size()] : nullptr;
                incident.out.push_back(mode_of(out, medium, incident.out, twin));
            }
        }
        result.incident.push_back(std::move(incident));
    }
    return result;
}

inline std::vector<OracleCase> load_oracle_cases() {
    std::ifstream file(POL_TESTS_DIR "/optics/data/oracle_vectors.jsonl");
    std::vector<OracleCase> cases;
    for (std::string line; std::getline(file, line);) cases.push_back(case_of(Json::parse(line)));
    return cases;
}

}  // namespace pol::test
