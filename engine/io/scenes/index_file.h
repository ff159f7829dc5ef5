// SPDX-License-Identifier: Apache-2.0
// Records of the refractiveindex.info database: YAML files with dispersion formulas and tables.
#pragma once

#include <filesystem>
#include <string>

#include "core/result.h"
#include "spectrum/refractive_index.h"

namespace pol {

/// Reads an index record. `name_or_path` is a path if it contains a slash or ends in .yml or .yaml (relative to the
/// working folder), else the name of a record in `assets_dir`/refractive_index ("calcite-o").
///
/// Of the record only DATA is read: formulas 1 to 9 and "tabulated n", "tabulated nk" give n, "tabulated k" and
/// "tabulated nk" give k; "tabulated n2" is passed over. Rows may stand in any order. Its wavelengths
/// (micrometres) become nanometres by moving the decimal point, so that a range that ends at 0.57 ends at 570 exactly.
/// Errors (kind input) name file, line, column, field and what would be right; an unknown name, the nearest record.
Result<RefractiveIndex> load_index(const std::string& name_or_path, const std::filesystem::path& assets_dir);

struct CrystalIndices {
    RefractiveIndex ordinary;
    RefractiveIndex extraordinary;
};

/// Reads the two records of a uniaxial crystal, NAME-o.yml and NAME-e.yml: files if `name` has a slash ("./spar",
/// relative to the working folder), else records of `assets_dir`/refractive_index. Errors as for load_index, and for a
/// name of one file (`spar.yml`) and a biaxial crystal (NAME-alpha, -beta, -gamma).
Result<CrystalIndices> load_crystal(const std::string& name, const std::filesystem::path& assets_dir);

/// True if `name`, which load_crystal would take, has a record NAME-o or NAME-e, or those of a biaxial crystal.
bool is_crystal(const std::string& name, const std::filesystem::path& assets_dir);

/// True if `name` ends like one file: in .yml or .yaml.
bool is_one_record(const std::string& name);

}  // namespace pol
