// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/gl/name.h"

namespace pol {

/// A texture that is drawn into, and its framebuffer. begin() may change what texture unit 0 is bound to.
class RenderTarget {
public:
    /// `format` is a sized internal format that can be drawn into: GL_RGBA8, GL_RGBA32F.
    explicit RenderTarget(GLenum format) : format_(format) {}
    /// Makes it the target of drawing, over its whole size. Keeps what it shows unless the size changes.
    void begin(int width, int height);
    /// Drawing goes to the window again.
    static void end() { glBindFramebuffer(GL_FRAMEBUFFER, 0); }
    [[nodiscard]] GLuint texture() const { return texture_.id(); }

private:
    GLenum format_;
    int width_ = 0;
    int height_ = 0;
    TextureName texture_;
    FramebufferName framebuffer_;
};

}  // namespace pol
