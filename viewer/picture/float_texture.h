// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "film/film.h"
#include "viewer/gl/name.h"
#include "viewer/picture/picture_floats.h"

namespace pol {

/// Texture of four floats a pixel, without mipmaps. resize() and write()
/// change what texture unit 0 is bound to. Row 0 is the row that is written first.
class FloatTexture {
public:
    /// Makes room for width x height pixels; what they hold is undefined. `filter` is that of texture(): GL_NEAREST or
    /// GL_LINEAR, clamped at the edges.
    void resize(int width, int height, GLint filter = GL_NEAREST);
    /// Requires: `rect` lies inside the texture, one value for each of its pixels, row by row.
    void write(const TileRect& rect, std::span<const Float4> pixels);
    /// Makes it the texture of a sampler with value `unit`.
    void bind(int unit) const;

private:
    TextureName name_;
};

}  // namespace pol
