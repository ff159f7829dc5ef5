# SPDX-License-Identifier: Apache-2.0
# The tables of assets/observer as a source file, so that the program looks up no file for them.
set(pol_spectrum_tables ${CMAKE_CURRENT_BINARY_DIR}/spectrum_tables.cpp)
set(pol_observer_folder ${PROJECT_SOURCE_DIR}/assets/observer)
add_custom_command(OUTPUT ${pol_spectrum_tables}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${pol_observer_folder} -DOUTPUT=${pol_spectrum_tables}
        -P ${CMAKE_CURRENT_SOURCE_DIR}/spectrum/embed_tables.cmake
    DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/spectrum/embed_tables.cmake
        ${pol_observer_folder}/cie_1931_2deg_xyz_1nm.csv ${pol_observer_folder}/cie_d65_5nm.csv
        ${pol_observer_folder}/srgb_basis_5nm.csv
    COMMENT "Embedding the observer and illuminant tables" VERBATIM)
set_source_files_properties(${pol_spectrum_tables} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
