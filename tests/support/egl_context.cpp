// SPDX-License-Identifier: Apache-2.0
#include "support/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace pol {

namespace {

/// One for the whole process. eglTerminate would unload the driver, and LeakSanitizer would then report the caches that
/// it keeps as ours.
EGLDisplay display() {
    static const EGLDisplay one = [] {
        const EGLDisplay opened = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        const bool works = opened != EGL_NO_DISPLAY && eglInitialize(opened, nullptr, nullptr) == EGL_TRUE;
        return works ? opened : EGL_NO_DISPLAY;
    }();
    return one;
}

}  // namespace

EglContext::EglContext() {
    if (display() == EGL_NO_DISPLAY) {
        problem_ = "no surfaceless EGL display";
        return;
    }
    constexpr EGLint config_wishes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                        EGL_NONE};
    constexpr EGLint context_wishes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglBindAPI(EGL_OPENGL_API);
    if (eglChooseConfig(display(), config_wishes, &config, 1, &count) == EGL_FALSE || count == 0)
        problem_ = "no EGL configuration for OpenGL";
    else if (context_ = eglCreateContext(display(), config, EGL_NO_CONTEXT, context_wishes); context_ == EGL_NO_CONTEXT)
        problem_ = "no OpenGL 3.3 core context";
    else if (eglMakeCurrent(display(), EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
        problem_ = "the OpenGL context cannot be made current";
}

EglContext::~EglContext() {
    if (display() == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display(), context_);
}

}  // namespace pol
