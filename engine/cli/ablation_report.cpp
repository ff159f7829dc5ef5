// SPDX-License-Identifier: Apache-2.0
#include "cli/ablation_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "cli/messages.h"
#include "core/result.h"

namespace pol {

namespace {

std::string hash_text(std::uint64_t hash) {
    return fmt::format("{:016x}", hash);
}

std::string picture_text(const verify::AblationRow& row) {
    if (!row.agreement) return row.holds ? "same bits" : "OTHER BITS: " + hash_text(row.hash);
    return fmt::format("{}{:.1f} % of the pixels agree", row.holds ? "" : "ANOTHER PICTURE: ", 100.0 * *row.agreement);
}

std::string line(const verify::AblationRow& row) {
    return fmt::format("{:<28}{:>10.2f}{:>10.2f}{:>8.3f}{:>8.1f} %  {}\n", row.feature, 1e3 * row.without_s,
                       1e3 * row.with_s, row.ratio, 100.0 * row.saved(), picture_text(row));
}

std::string list(const std::string& title, const std::vector<Feature>& features) {
    if (features.empty()) return {};
    std::string text = "\n" + title + "\n";
    for (const Feature& feature : features)
        text += fmt::format("  {:<28}{}\n", feature.name, printable(feature.reason));
    return text;
}

nlohmann::ordered_json json_of(const verify::AblationRow& row) {
    nlohmann::ordered_json out{{"feature", row.feature}, {"reason", row.reason},       {"without_s", row.without_s},
                               {"with_s", row.with_s},   {"ratio", row.ratio},         {"saved", row.saved()},
                               {"holds", row.holds},     {"hash", hash_text(row.hash)}};
    if (row.agreement) out["agreement"] = *row.agreement;
    return out;
}

nlohmann::ordered_json json_of(const std::vector<Feature>& features) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const Feature& feature : features) out.push_back({{"feature", feature.name}, {"reason", feature.reason}});
    return out;
}

/// All that were measured, the one of all together last.
std::vector<verify::AblationRow> measured(const verify::AblationResult& result) {
    std::vector<verify::AblationRow> rows = result.rows;
    if (result.all) rows.push_back(*result.all);
    return rows;
}

}  // namespace

std::string ablation_text(const verify::AblationResult& result) {
    std::string text =
        fmt::format("{} x {} pixels of {} {}, one thread; CPU milliseconds of a render\npicture: {}\n\n", result.width,
                    result.height, result.samples, result.samples == 1 ? "sample" : "samples", hash_text(result.hash));
    text +=
        fmt::format("{:<28}{:>10}{:>10}{:>8}{:>10}  {}\n", "left out", "without", "with", "ratio", "saved", "picture");
    for (const verify::AblationRow& row : measured(result)) text += line(row);
    for (const verify::AblationRow& row : result.rows)
        if (row.agreement)
            text += fmt::format(
                "\n{}: flat solids as meshes, not part of all together. They round otherwise: pixels agree that differ "
                "by\n"
                "less than both left untraced and 1e-11 of the brightest light; a ray may take either side of an "
                "edge.\n",
                row.feature);
    text += list("cannot be kept in this scene", result.not_keepable);
    text += list("no code would run for", result.nothing_to_keep);
    return text;
}

std::string ablation_json(const verify::AblationResult& result) {
    nlohmann::ordered_json out{{"width", result.width},
                               {"height", result.height},
                               {"samples", result.samples},
                               {"hash", hash_text(result.hash)},
                               {"holds", result.holds()}};
    out["features"] = nlohmann::ordered_json::array();
    for (const verify::AblationRow& row : result.rows) out["features"].push_back(json_of(row));
    if (result.all) out["all"] = json_of(*result.all);
    out["not_keepable"] = json_of(result.not_keepable);
    out["nothing_to_keep"] = json_of(result.nothing_to_keep);
    return out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

int conclude(const verify::AblationResult& result) {
    for (const verify::AblationRow& row : measured(result))
        if (!row.holds)
            remark(fmt::format("polariscope: defect: with '{}' kept the picture is another one: {} instead of {}\n",
                               row.feature, hash_text(row.hash), hash_text(result.hash)));
    return result.holds() ? 0 : static_cast<int>(ErrorKind::internal);
}

}  // namespace pol
