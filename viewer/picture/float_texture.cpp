// SPDX-License-Identifier: Apache-2.0
#include "viewer/picture/float_texture.h"

#include "core/contract.h"

namespace pol {

void FloatTexture::resize(int width, int height, GLint filter) {
    glBindTexture(GL_TEXTURE_2D, name_.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

void FloatTexture::write(const TileRect& rect, std::span<const Float4> pixels) {
    POL_EXPECTS(pixels.size() == rect.pixel_count());
    glBindTexture(GL_TEXTURE_2D, name_.id());
    glTexSubImage2D(GL_TEXTURE_2D, 0, rect.x0, rect.y0, rect.width(), rect.y1 - rect.y0, GL_RGBA, GL_FLOAT,
                    pixels.data());
}

void FloatTexture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, name_.id());
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace pol
