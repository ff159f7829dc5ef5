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
/// Of the record only DATA is read: formulas 1 to 6 and "tabulated n", "tabulated nk" give n, "tabulated k" and
/// "tabulated nk" give k; one entry for each. Its wavelengths (micrometres) become nanometres by moving the decimal
/// point, so that a range that ends at 0.57 ends at 570 exactly. Errors (kind input) name file, line, column, field and
/// what would be right; an unknown name, the nearest record.
Result<RefractiveIndex> load_index(const std::string& name_or_path, const std::filesystem::path& assets_dir);

}  // namespace pol
