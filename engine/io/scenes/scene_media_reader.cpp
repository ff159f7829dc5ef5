// SPDX-License-Identifier: Apache-2.0
// Spectra, refractive indices and media of a scene file.
#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/number_text.h"
#include "core/overloaded.h"
#include "io/scenes/index_file.h"
#include "io/scenes/scene_reader.h"
#include "scene/medium_fields.h"
#include "spectrum/wavelength_grid.h"

namespace pol {
namespace {

/// Numbers that are all far below any light are micrometres.
void ask_for_nanometres(const YamlValue& value, double longest_nm) {
    if (longest_nm >= shortest_light_nm) return;
    value.fail("the wavelengths end at " + number_text(longest_nm) + " nm, which is no light: were micrometres meant?",
               "here wavelengths are in nm: 0.58 um is 580");
}

/// [[nm, value], ...] in any order, not empty; rows that contradict each other are kept.
IndexTable read_table(const YamlValue& value) {
    std::vector<std::pair<double, double>> rows;
    for (const YamlValue& row : value.list()) {
        const DVec2 pair = row.vec2();
        rows.emplace_back(pair.x, pair.y);
    }
    if (rows.empty()) value.fail("the table is empty", "write [[400, 1.53], [700, 1.51]]");
    IndexTable table = index_table(std::move(rows));
    ask_for_nanometres(value, table.wavelength_nm.back());
    return table;
}

DispersionFormula read_formula(const YamlMap& map) {
    DispersionFormula formula;
    formula.number = map.at("formula").whole();
    if (formula.number < 1 || formula.number > last_formula) {
        map.at("formula").fail("there is no such dispersion formula",
                               "1 to " + std::to_string(last_formula) + ", as refractiveindex.info numbers them");
    }
    formula.coefficients = map.at("coefficients").numbers();
    const std::size_t count = formula.coefficients.size();
    if (const std::string form = coefficient_problem(formula.number, count); !form.empty()) {
        map.at("coefficients")
            .fail(
                "formula " + std::to_string(formula.number) + " cannot have " + std::to_string(count) + " coefficients",
                form);
    }
    const DVec2 range = map.at("range").vec2();
    if (!(range.x > 0.0 && range.x < range.y)) map.at("range").fail("is not a range", "write [400, 700], in nm");
    ask_for_nanometres(map.at("range"), range.y);
    formula.min_nm = range.x;
    formula.max_nm = range.y;
    return formula;
}

IndexBlock read_block(const YamlMap& map) {
    if (!map.has("formula")) return read_table(map.at("table"));
    if (map.has("table")) map.at("table").fail("the index has a formula already", "keep one of the two");
    return read_formula(map);
}

RefractiveIndex read_record(const YamlValue& value, const AssetFolders& folders) {
    std::string source = value.text();
    if (source.find('/') != std::string::npos || is_one_record(source))
        source = find_asset(value, folders, "refractive_index").string();
    Result<RefractiveIndex> index = load_index(source, folders.assets);
    if (index) return std::move(index).value();
    fail_because_of(value, index.error());
}

CrystalIndices read_crystal(const YamlValue& value, const AssetFolders& folders) {
    std::string source = value.text();
    if (source.find('/') != std::string::npos && !is_one_record(source)) {
        source = find_asset(value, folders, "refractive_index",
                            {"-o.yml", "-e.yml", "-alpha.yml", "-beta.yml", "-gamma.yml"})
                     .string();
    }
    Result<CrystalIndices> indices = load_crystal(source, folders.assets);
    if (indices) return std::move(indices).value();
    fail_because_of(value, indices.error());
}

/// Stands for both indices of a crystal.
constexpr std::string_view crystal_record = "crystal";

template <class Kind>
std::vector<std::string_view> keys_of(const Kind& kind, std::initializer_list<Presence> asked) {
    std::vector<std::string_view> keys;
    for_each_field(kind, [&](const auto& row, const auto& /*value*/) {
        if (std::find(asked.begin(), asked.end(), row.presence) != asked.end()) keys.push_back(row.key);
    });
    return keys;
}

/// The properties of that presence, those that are missing too.
template <class Kind>
void read_fields(Kind& kind, Presence presence, const YamlMap& map, const AssetFolders& folders) {
    const auto read = Overloaded{
        [&](const YamlValue& value, RefractiveIndex& index) { index = read_index(value, folders); },
        [](const YamlValue& value, Absorption& absorption) { absorption = read_spectrum(value); },
        [](const YamlValue& value, DVec3& axis) { axis = value.vec3(); },
        [](const YamlValue& value, AxisSpace& space) {
            space = static_cast<AxisSpace>(value.choice_of({axis_space_words.begin(), axis_space_words.end()}));
        },
    };
    for_each_field(kind, [&](const auto& row, auto& value) {
        const std::string key(row.key);
        if (row.presence == presence && (presence == Presence::required || map.has(key))) read(map.at(key), value);
    });
}

template <class Kind>
Kind read_kind(const YamlValue& value, const AssetFolders& folders) {
    Kind kind;
    const YamlMap map = value.map(keys_of(kind, {Presence::required, Presence::optional}));
    read_fields(kind, Presence::required, map, folders);
    read_fields(kind, Presence::optional, map, folders);
    return kind;
}

UniaxialMedium read_crystal_record(const YamlValue& value, const AssetFolders& folders) {
    UniaxialMedium medium;
    std::vector<std::string_view> keys{crystal_record};
    for (const std::string_view key : keys_of(medium, {Presence::optional})) keys.push_back(key);
    const YamlMap map = value.map(keys);
    CrystalIndices indices = read_crystal(map.at(std::string(crystal_record)), folders);
    medium.ordinary = std::move(indices.ordinary);
    medium.extraordinary = std::move(indices.extraordinary);
    read_fields(medium, Presence::optional, map, folders);
    return medium;
}

/// The last kind of which a required key is there, else isotropic.
Matter read_matter(const YamlValue& value, const AssetFolders& folders) {
    std::vector<std::string_view> known{crystal_record};
    for_each_kind([&](const auto& kind) {
        for (const std::string_view key : keys_of(kind, {Presence::required, Presence::optional})) known.push_back(key);
    });
    const YamlMap any = value.map(known);
    std::optional<Matter> matter;
    for_each_kind([&](const auto& kind) {
        using Kind = std::remove_cvref_t<decltype(kind)>;
        if (matter) return;
        if (std::is_same_v<Kind, UniaxialMedium> && any.has(std::string(crystal_record))) {
            matter = read_crystal_record(value, folders);
            return;
        }
        const auto keys = keys_of(kind, {Presence::required});
        const bool is_named =
            std::any_of(keys.begin(), keys.end(), [&](std::string_view key) { return any.has(std::string(key)); });
        if (is_named) matter = read_kind<Kind>(value, folders);
    });
    return matter ? std::move(*matter) : Matter{read_kind<IsotropicMedium>(value, folders)};
}

}  // namespace

Spectrum read_spectrum(const YamlValue& value) {
    if (!value.is_map()) return ConstantSpectrum{value.number()};
    const auto [kind, content] = value.tagged({"d65", "table"});
    if (kind == "d65") return D65Spectrum{content.number()};
    IndexTable table = read_table(content);
    const auto twice = std::adjacent_find(table.wavelength_nm.begin(), table.wavelength_nm.end());
    if (twice != table.wavelength_nm.end())
        content.fail("two values at " + number_text(*twice) + " nm", "only one can be right");
    return TabulatedSpectrum{std::move(table.wavelength_nm), std::move(table.value)};
}

RefractiveIndex read_index(const YamlValue& value, const AssetFolders& folders) {
    if (value.is_list()) {
        const DVec2 pair = value.vec2();
        return ConstantIndex{{pair.x, pair.y}};
    }
    if (value.is_map()) {
        const YamlMap map = value.map({"name", "formula", "coefficients", "range", "table", "k", "more"});
        DispersiveIndex index;
        index.name = map.has("name") ? map.at("name").text() : value.path();
        index.n = read_block(map);
        if (map.has("k")) index.k = read_table(map.at("k"));
        if (const auto more = map.find("more")) {
            for (const YamlValue& block : more->list()) {
                const YamlMap part = block.map({"formula", "coefficients", "range", "table", "k"});
                if (part.has("k"))
                    index.more_k.push_back(read_table(block.map({"k"}).at("k")));
                else
                    index.more_n.push_back(read_block(part));
            }
        }
        return index;
    }
    if (value.is_scalar() && !value.looks_like_number()) return read_record(value, folders);
    return ConstantIndex{{value.number(), 0.0}};
}

Medium read_medium(const std::string& name, const YamlValue& value, const AssetFolders& folders) {
    Medium medium;
    medium.name = name;
    medium.place = value.place();
    if (value.is_scalar()) {
        medium.matter = IsotropicMedium{read_index(value, folders), ConstantSpectrum{0.0}};
        return medium;
    }
    if (!value.is_map()) value.fail("this is no medium", "write 1.5, the name of a record or {index: ...}");
    medium.matter = read_matter(value, folders);
    return medium;
}

}  // namespace pol
