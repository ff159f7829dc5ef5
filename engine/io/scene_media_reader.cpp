// SPDX-License-Identifier: Apache-2.0
// Spectra, refractive indices and media of a scene file.
#include <string>
#include <utility>
#include <vector>

#include "io/index_file.h"
#include "io/scene_reader.h"

namespace pol {
namespace {

/// [[nm, value], ...], not empty.
std::pair<std::vector<double>, std::vector<double>> read_table(const YamlValue& value) {
    std::pair<std::vector<double>, std::vector<double>> columns;
    for (const YamlValue& row : value.list()) {
        const DVec2 pair = row.vec2();
        columns.first.push_back(pair.x);
        columns.second.push_back(pair.y);
    }
    if (columns.first.empty()) value.fail("the table is empty", "write [[400, 1.53], [700, 1.51]]");
    for (std::size_t i = 1; i < columns.first.size(); ++i) {
        if (columns.first[i] > columns.first[i - 1]) continue;
        value.fail("wavelengths must ascend: row " + std::to_string(i + 1) + " does not",
                   "sort the rows and leave out repeated ones");
    }
    return columns;
}

IndexTable read_index_table(const YamlValue& value) {
    auto [wavelength_nm, values] = read_table(value);
    return {std::move(wavelength_nm), std::move(values)};
}

/// Coefficients that formula 1 to 6 may have: formula 4 takes up to 17, the others any odd number (one constant, then
/// pairs).
DispersionFormula read_formula(const YamlMap& map) {
    DispersionFormula formula;
    formula.number = map.at("formula").whole();
    if (formula.number < 1 || formula.number > 6) {
        map.at("formula").fail("there is no such dispersion formula", "1 to 6, as refractiveindex.info numbers them");
    }
    formula.coefficients = map.at("coefficients").numbers();
    const std::size_t count = formula.coefficients.size();
    const bool fits = formula.number == 4 ? count >= 1 && count <= 17 : count % 2 == 1;
    if (!fits) {
        map.at("coefficients")
            .fail(
                "formula " + std::to_string(formula.number) + " cannot have " + std::to_string(count) + " coefficients",
                "one constant, then pairs");
    }
    const DVec2 range = map.at("range").vec2();
    if (!(range.x > 0.0 && range.x < range.y)) map.at("range").fail("is not a range", "write [400, 700], in nm");
    formula.min_nm = range.x;
    formula.max_nm = range.y;
    return formula;
}

RefractiveIndex read_record(const YamlValue& value, const std::string& name, const AssetFolders& folders) {
    std::string source = name;
    const bool is_path = name.find('/') != std::string::npos || name.ends_with(".yml") || name.ends_with(".yaml");
    if (is_path) source = find_asset(value, folders, "refractive_index").string();
    Result<RefractiveIndex> index = load_index(source, folders.assets);
    if (index) return std::move(index).value();
    fail_because_of(value, index.error());
}

Spectrum optional_spectrum(const YamlMap& map, const char* key) {
    const auto value = map.find(key);
    return value ? read_spectrum(*value) : Spectrum{ConstantSpectrum{0.0}};
}

UniaxialMedium read_uniaxial(const YamlMap& map, const AssetFolders& folders) {
    UniaxialMedium medium;
    if (map.has("crystal")) {
        const YamlValue crystal = map.at("crystal");
        const std::string name = crystal.text();
        medium.ordinary = read_record(crystal, name + "-o", folders);
        medium.extraordinary = read_record(crystal, name + "-e", folders);
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
    auto [wavelength_nm, values] = read_table(content);
    return TabulatedSpectrum{std::move(wavelength_nm), std::move(values)};
}

RefractiveIndex read_index(const YamlValue& value, const AssetFolders& folders) {
    if (value.is_list()) {
        const DVec2 pair = value.vec2();
        return ConstantIndex{{pair.x, pair.y}};
    }
    if (value.is_map()) {
        const YamlMap map = value.map({"name", "formula", "coefficients", "range", "table", "k"});
        DispersiveIndex index;
        index.name = map.has("name") ? map.at("name").text() : value.path();
        if (map.has("formula")) {
            if (map.has("table")) map.at("table").fail("the index has a formula already", "keep one of the two");
            index.n = read_formula(map);
        } else {
            index.n = read_index_table(map.at("table"));
        }
        if (map.has("k")) index.k = read_index_table(map.at("k"));
        return index;
    }
    if (value.is_scalar() && !value.looks_like_number()) return read_record(value, value.text(), folders);
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
