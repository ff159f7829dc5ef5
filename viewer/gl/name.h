// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "viewer/gl/gl.h"

namespace pol {

/// Owner of one OpenGL name. Move-only; a moved-from owner has none (0). The context must be current when an owner is
/// made and when it goes.
template <void (*make)(GLsizei, GLuint*), void (*remove)(GLsizei, const GLuint*)>
class GlName {
public:
    GlName() { make(1, &id_); }
    ~GlName() { remove(1, &id_); }  // the name 0 is ignored
    GlName(GlName&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    [[nodiscard]] GLuint id() const { return id_; }

private:
    GLuint id_ = 0;
};

using TextureName = GlName<glGenTextures, glDeleteTextures>;
using FramebufferName = GlName<glGenFramebuffers, glDeleteFramebuffers>;
using VertexArrayName = GlName<glGenVertexArrays, glDeleteVertexArrays>;

}  // namespace pol
