# SPDX-License-Identifier: Apache-2.0
# Script: turns CSV tables into the definitions that spectrum/tables.h declares.
# cmake -DFOLDER=assets/observer -DOUTPUT=tables.cpp -P embed_tables.cmake

set(code "// Made by embed_tables.cmake from the CSV files.\n#include \"spectrum/tables.h\"\n\nnamespace pol::tables {\n")
foreach(pair "observer 4 cie_1931_2deg_xyz_1nm" "d65 2 cie_d65_5nm" "srgb_basis 4 srgb_basis_5nm")
    separate_arguments(pair)
    list(GET pair 0 name)
    list(GET pair 1 columns)
    list(GET pair 2 file)
    file(STRINGS "${FOLDER}/${file}.csv" lines)
    list(REMOVE_AT lines 0)
    list(LENGTH lines rows)
    list(JOIN lines "},\n    Row<${columns}>{" body)
    string(APPEND code "\nconstexpr std::array<Row<${columns}>, ${rows}> ${name}_rows{\n    Row<${columns}>{${body}}};\n"
        "std::span<const Row<${columns}>> ${name}() { return ${name}_rows; }\n")
endforeach()
file(WRITE "${OUTPUT}" "${code}\n}  // namespace pol::tables\n")
