// SPDX-License-Identifier: Apache-2.0
// OpenGL 3.3 core, straight from libOpenGL: no loader.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>
