// SPDX-License-Identifier: Apache-2.0
#include "viewer/picture_renderer.h"

#include "viewer/gl/gl.h"

namespace pol {

struct PictureRenderer::Gpu {
    GLuint target = 0;
    GLuint framebuffer = 0;
};

PictureRenderer::PictureRenderer(std::unique_ptr<Gpu> gpu) : gpu_(std::move(gpu)) {}

PictureRenderer::~PictureRenderer() {
    glDeleteFramebuffers(1, &gpu_->framebuffer);
    glDeleteTextures(1, &gpu_->target);
}

Result<std::unique_ptr<PictureRenderer>> PictureRenderer::create() {
    auto gpu = std::make_unique<Gpu>();
    glGenTextures(1, &gpu->target);
    glGenFramebuffers(1, &gpu->framebuffer);
    return std::unique_ptr<PictureRenderer>(new PictureRenderer(std::move(gpu)));
}

void PictureRenderer::upload(Session& session) {
    if (Document* document = session.current()) document->take_changes();
}

std::uint32_t PictureRenderer::render(const Session& /*session*/, int width, int height, double /*pixel_ratio*/) {
    glBindTexture(GL_TEXTURE_2D, gpu_->target);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, gpu_->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, gpu_->target, 0);
    glViewport(0, 0, width, height);
    glClearColor(0.1F, 0.1F, 0.1F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return gpu_->target;
}

}  // namespace pol
