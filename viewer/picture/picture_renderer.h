// SPDX-License-Identifier: Apache-2.0
// The picture on the GPU: float textures of the light at the shown wavelength and of the color picture, from which
// shaders/map.frag makes any map in any style. Another map, range, style or zoom costs no upload.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "core/result.h"
#include "viewer/session/session.h"

namespace pol {

/// Needs a current OpenGL 3.3 core context in every call, destructor included.
class PictureRenderer {
public:
    /// Error (kind internal): a shader does not compile or link; the message has the driver's log.
    /// Of the picture on screen, or of the reference beside it (Session::side).
    static Result<std::unique_ptr<PictureRenderer>> create(PictureSide side = PictureSide::current);
    ~PictureRenderer();
    PictureRenderer(const PictureRenderer&) = delete;
    PictureRenderer& operator=(const PictureRenderer&) = delete;

    /// Takes over what changed in the session's picture since the last call, for about `seconds`: a new picture of a
    /// hundred million numbers would stop the window. True if something is left for the next call.
    bool upload(const Session& session, double seconds = std::numeric_limits<double>::infinity());

    /// Draws the session's map into a texture of `width` x `height` device pixels, which shows the viewport of
    /// `width / pixel_ratio` logical points. The texture's first row is the lowest of the view. Returns the name of the
    /// texture; it belongs to this object. Draws nothing if the texture shows just that already.
    std::uint32_t render(const Session& session, int width, int height, double pixel_ratio);

private:
    void upload_difference(const Session& session, const ShownSide& side);
    struct Gpu;
    explicit PictureRenderer(std::unique_ptr<Gpu> gpu);
    std::unique_ptr<Gpu> gpu_;
};

}  // namespace pol
