# SPDX-License-Identifier: Apache-2.0
# Script: turns shader files into the definitions that viewer/gl/shader_sources.h declares.
# cmake -DFOLDER=shaders -DOUTPUT=shader_sources.cpp -P embed.cmake

set(code "// Made by shaders/embed.cmake.\n#include \"viewer/gl/shader_sources.h\"\n\nnamespace pol::shader_sources {\n")
foreach(file fullscreen.vert measures.glsl bounds.glsl evaluate.glsl map.frag)
    file(READ "${FOLDER}/${file}" text)
    string(REPLACE "." "_" name "${file}")
    string(APPEND code "\nstd::string_view ${name}() {\n    return R\"glsl(${text})glsl\";\n}\n")
endforeach()
file(WRITE "${OUTPUT}" "${code}\n}  // namespace pol::shader_sources\n")
