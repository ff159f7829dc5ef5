// SPDX-License-Identifier: Apache-2.0
// Spectra, refractive indices and media of a scene file.
#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/number_text.h"
#include "io/scenes/index_file.h"
#include "io/scenes/scene_reader.h"
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

Spectrum optional_spectrum(const YamlMap& map, const char* key) {
    const auto value = map.find(key);
    return value ? read_spectrum(*value) : Spectrum{ConstantSpectrum{0.0}};
}

UniaxialMedium read_uniaxial(const YamlMap& map, const AssetFolders& folders) {
    UniaxialMedium medium;
    if (map.has("crystal")) {
        CrystalIndices indices = read_crystal(map.at("crystal"), folders);
        medium.ordinary = std::move(indices.ordinary);
        medium.extraordinary = std::move(indices.extraordinary);
    } else {
        medium.ordinary = read_index(map.at("ordinary"), folders);
        medium.extraordinary = read_index(map.at("extraordinary"), folders);
    }
    if (const auto axis = map.find("axis")) medium.axis = axis->vec3();
    if (const auto space = map.find("axis_space")) {
        medium.axis_space = space->choice({"object", "world"}) == "world" ? AxisSpace::world : AxisSpace::object;
    }
    medium.absorption_o = optional_spectrum(map, "absorption_o");
    medium.absorption_e = optional_spectrum(map, "absorption_e");
    return medium;
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
    const YamlMap any = value.map({"index", "absorption", "crystal", "ordinary", "extraordinary", "axis", "axis_space",
                                   "absorption_o", "absorption_e", "conductor"});
    if (any.has("conductor")) {
        const YamlMap map = value.map({"conductor"});
        medium.matter = ConductorMedium{read_index(map.at("conductor"), folders)};
    } else if (any.has("crystal")) {
        const YamlMap map = value.map({"crystal", "axis", "axis_space", "absorption_o", "absorption_e"});
        medium.matter = read_uniaxial(map, folders);
    } else if (any.has("ordinary") || any.has("extraordinary")) {
        const YamlMap map =
            value.map({"ordinary", "extraordinary", "axis", "axis_space", "absorption_o", "absorption_e"});
        medium.matter = read_uniaxial(map, folders);
    } else {
        const YamlMap map = value.map({"index", "absorption"});
        medium.matter = IsotropicMedium{read_index(map.at("index"), folders), optional_spectrum(map, "absorption")};
    }
    return medium;
}

}  // namespace pol
