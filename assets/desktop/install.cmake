# What `cmake --install` puts where besides the library, and the Debian packages (`cmake --build build/release --target
# package`, configured with -DCMAKE_INSTALL_PREFIX=/usr). Components: "program", and "development" for the library.

set(desktop ${CMAKE_CURRENT_LIST_DIR})
set(made ${PROJECT_BINARY_DIR}/desktop)
file(MAKE_DIRECTORY ${made})
find_program(GZIP gzip REQUIRED)
set(id io.github.polariscope.Polariscope)

install(TARGETS polariscope RUNTIME COMPONENT program)
foreach(kind cases refractive_index scenes textures)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/${kind} DESTINATION ${CMAKE_INSTALL_DATADIR}/polariscope COMPONENT program
        PATTERN "*.py" EXCLUDE)
endforeach()
# What reports and facts cite.
install(FILES ${PROJECT_SOURCE_DIR}/engine/PHYSICS.md ${PROJECT_SOURCE_DIR}/engine/CUTTING.md
    ${PROJECT_SOURCE_DIR}/engine/polarization/CONVENTIONS.md
    DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)

# Manual page and completions are what the program itself prints, so that they say what --help says.
if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
    message(STATUS "Without CMAKE_CROSSCOMPILING_EMULATOR no manual page and completions are made")
else()
    add_custom_command(OUTPUT ${made}/polariscope.1.gz ${made}/polariscope.bash ${made}/_polariscope
        COMMAND polariscope manual page > polariscope.1
        COMMAND ${GZIP} -9nf polariscope.1
        COMMAND polariscope manual bash > polariscope.bash
        COMMAND polariscope manual zsh > _polariscope
        WORKING_DIRECTORY ${made} DEPENDS polariscope COMMENT "Writing manual page and completions")
    add_custom_target(polariscope_manual ALL DEPENDS ${made}/polariscope.1.gz)
    install(FILES ${made}/polariscope.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
    install(FILES ${made}/polariscope.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME polariscope COMPONENT program)
    set(zsh_folder site-functions)
    if(EXISTS /etc/debian_version AND CMAKE_INSTALL_PREFIX STREQUAL "/usr")
        set(zsh_folder vendor-completions)
    endif()
    install(FILES ${made}/_polariscope DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${zsh_folder} COMPONENT program)
endif()

set(POL_RELEASE_DATE 2026-11-29)
set(POL_RELEASE_TIME "Sun, 29 Nov 2026 12:00:00 +0000")
if(POL_VIEWER)
    configure_file(${desktop}/${id}.metainfo.xml.in ${made}/${id}.metainfo.xml @ONLY)
    install(FILES ${made}/${id}.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT program)
    install(FILES ${desktop}/${id}.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT program)
    install(FILES ${desktop}/${id}.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT program)
    install(FILES ${desktop}/polariscope.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT program)
endif()

if(NOT PROJECT_IS_TOP_LEVEL OR NOT EXISTS /etc/debian_version)
    return()
endif()

# What Debian wants beside the files of every package.
configure_file(${desktop}/changelog.in ${made}/changelog.Debian @ONLY)
add_custom_command(OUTPUT ${made}/changelog.Debian.gz ${made}/changelog.gz
    COMMAND ${GZIP} -9nkf changelog.Debian
    COMMAND ${GZIP} -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md > changelog.gz
    WORKING_DIRECTORY ${made} DEPENDS ${made}/changelog.Debian ${PROJECT_SOURCE_DIR}/CHANGELOG.md)
add_custom_target(polariscope_changelog ALL DEPENDS ${made}/changelog.Debian.gz)
install(FILES ${desktop}/copyright ${made}/changelog.Debian.gz ${made}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/polariscope COMPONENT program)
install(FILES ${desktop}/copyright ${made}/changelog.Debian.gz ${made}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libpolariscope-dev COMPONENT development)

set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)

set(CPACK_PACKAGE_NAME polariscope)
set(CPACK_PACKAGE_CONTACT "The polariscope authors <polariscope@example.org>")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME polariscope)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "debugging viewer for polarized renders
Traces polarized light backward through glass, crystals and metals, shows
Stokes images of any renderer, and says of every pixel how its light is
polarized, how sure that is, and along which paths it came.")
# What the window looks for while it runs.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "fonts-dejavu-core, libgl1-mesa-dri")

# A program that uses the library needs the assets, and its linker the libraries that ours is made of.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libpolariscope-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "polariscope (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}), \
libcairo2-dev, libembree-dev, libfmt-dev, libhwy-dev, libopenexr-dev, libpng-dev, libtinygltf-dev, libxxhash-dev, libyaml-cpp-dev, pkg-config, zlib1g-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "library of polariscope, a tracer of polarized light
Headers, static library and CMake package: load a scene, trace a ray, render,
explain a pixel, read and write Stokes images.")

include(CPack)
