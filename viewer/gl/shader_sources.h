// SPDX-License-Identifier: Apache-2.0
// The files of shaders/, embedded when the program is built. They have no #version line: gl/program.h adds it.
#pragma once

#include <string_view>

namespace pol::shader_sources {

std::string_view fullscreen_vert();
std::string_view measures_glsl();
std::string_view bounds_glsl();    ///< after measures
std::string_view evaluate_glsl();  ///< after bounds and picture/shader_constants.h
std::string_view map_frag();       ///< after evaluate and the constants of picture/picture_renderer.cpp

}  // namespace pol::shader_sources
