// SPDX-License-Identifier: Apache-2.0
// Messages that programs send to tev, and malformed ones: tests/data/tev_messages/messages.json. Those of the Python
// package tevclient 1.0.4 were recorded; types 0, 3 and 5 follow pbrt-v4 and tev's source.
#pragma once

#include <cstddef>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace pol::test {

struct TevVector {
    std::string name;
    std::vector<std::byte> bytes;
    nlohmann::json decoded;  ///< what it says; null for a malformed one
};

/// Requires: `kind` is "good" or "bad".
inline std::vector<TevVector> tev_vectors(const std::string& kind) {
    std::ifstream file(std::string(POL_TESTS_DIR) + "/data/tev_messages/messages.json");
    std::vector<TevVector> vectors;
    const auto all = nlohmann::json::parse(file);
    for (const auto& one : all.at(kind)) {
        TevVector vector{one.at("name"), {}, one.value("decoded", nlohmann::json())};
        const std::string hex = one.at("hex");
        for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
            vector.bytes.push_back(static_cast<std::byte>(std::stoi(hex.substr(i, 2), nullptr, 16)));
        vectors.push_back(std::move(vector));
    }
    return vectors;
}

/// Requires: there is one of that name.
inline TevVector tev_vector(const std::string& name) {
    for (const char* kind : {"good", "bad"})
        for (const TevVector& vector : tev_vectors(kind))
            if (vector.name == name) return vector;
    throw std::runtime_error("no vector " + name);
}

}  // namespace pol::test
