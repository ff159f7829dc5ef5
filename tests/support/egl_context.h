// SPDX-License-Identifier: Apache-2.0
// OpenGL without a window or an X server: EGL surfaceless, software rasterizer or not.
#pragma once

#include <memory>
#include <string>

namespace pol {

/// An OpenGL 3.3 core context that is current as long as this object lives.
class EglContext {
public:
    EglContext();
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    /// Why there is no context; empty: there is one.
    [[nodiscard]] const std::string& problem() const { return problem_; }

private:
    void* context_ = nullptr;
    std::string problem_;
};

}  // namespace pol
