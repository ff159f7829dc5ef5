// SPDX-License-Identifier: Apache-2.0
// The reference of the stiffness suite against the 110-digit oracle, which
// shares no code with it: data/stiff_vectors.jsonl, written by
// make_stiff_vectors.py.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/quad.h"
#include "optics/boundary_solver.h"

namespace pol::verify {
namespace {

using Json = nlohmann::json;

Vec3<Quad> direction(const Json& x, std::size_t at) {
    return unit(Vec3<Quad>{Quad(x[at].get<double>()), Quad(x[at + 1].get<double>()), Quad(x[at + 2].get<double>())});
}

Dielectric<Quad> medium(const Json& x, std::size_t& at, bool crystal) {
    const Quad n(x[at++].get<double>());
    if (!crystal) return make_isotropic(n);
    const Quad n_e(x[at].get<double>());
    const Vec3<Quad> axis = direction(x, at + 1);
    at += 4;
    return make_uniaxial(n, n_e, axis);
}

std::string name_of(WaveKind kind) {
    return kind == WaveKind::pair ? "pair" : kind == WaveKind::ordinary ? "o" : "e";
}

/// Power per outgoing wave, summed over the modes of the incident wave.
std::map<std::string, Quad> powers(const BoundaryResponse<Quad>& response) {
    std::map<std::string, Quad> sums;
    for (std::size_t i = 0; i < static_cast<std::size_t>(response.outgoing_count); ++i) {
        const OutgoingWave<Quad>& out = response.outgoing[i];
        Quad& sum =
            sums.try_emplace((out.side == Side::reflected ? "R " : "T ") + name_of(out.wave.kind), 0).first->second;
        for (const auto& row : out.amplitude) sum += norm2(row[0]) + norm2(row[1]);
    }
    return sums;
}

/// 34 digits less what an angle of 1e-14 to the optic axis costs.
constexpr double reference_error = 1e-18;

TEST(StiffReference, AgreesWithTheOracle) {
    std::ifstream file(POL_TESTS_DIR "/verify/data/stiff_vectors.jsonl");
    std::size_t compared = 0;
    for (std::string line; std::getline(file, line);) {
        const Json json = Json::parse(line);
        SCOPED_TRACE(json["case"].get<std::string>() + " at " + json["setting"].dump());
        const Json& x = json["inputs"];
        std::size_t at = 6;
        const Dielectric<Quad> from = medium(x, at, json["crystals"][0].get<bool>());
        const Dielectric<Quad> to = medium(x, at, json["crystals"][1].get<bool>());
        const auto waves = waves_of_wave_normal(from, direction(x, 3));
        for (int w = 0; w < waves.count; ++w) {
            const auto response = respond(from, to, direction(x, 0), waves.wave[w]);
            const std::string kind = name_of(waves.wave[w].kind);
            ASSERT_EQ(response.incident, json["powers"].contains(kind)) << kind;
            if (!response.incident) continue;
            std::map<std::string, Quad> got = powers(response);
            for (const auto& [wave, parts] : json["powers"][kind].items()) {
                const Quad expected = Quad(parts[0].get<double>()) + Quad(parts[1].get<double>());
                EXPECT_LT(static_cast<double>(abs(got[wave] - expected)), reference_error) << kind << " -> " << wave;
                got.erase(wave);
                ++compared;
            }
            for (const auto& [wave, power] : got) EXPECT_LT(static_cast<double>(power), reference_error) << wave;
        }
    }
    EXPECT_GT(compared, 1000U);
}

}  // namespace
}  // namespace pol::verify
