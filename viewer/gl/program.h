// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <initializer_list>
#include <span>
#include <string_view>

#include "core/result.h"
#include "viewer/gl/gl.h"

namespace pol {

/// A linked pair of shaders. Move-only; the context must be current when it is made, used and destroyed.
class Program {
public:
    /// Each stage is its parts one after the other, behind `#version 330 core`; the driver counts lines per part, the
    /// version being part 0. Error (kind internal): a stage does not compile or they do not link; the message has the
    /// driver's log.
    static Result<Program> link(std::initializer_list<std::string_view> vertex,
                                std::initializer_list<std::string_view> fragment);
    ~Program() { glDeleteProgram(id_); }  // the name 0 is ignored
    Program(Program&& other) noexcept;
    Program& operator=(Program&& other) noexcept;

    /// Makes it the program of drawing and of set().
    void use() const { glUseProgram(id_); }

    // Sets a uniform. One that the shaders do not use is ignored. Requires: use() was the last one called.
    void set(const char* name, int value) const { glUniform1i(location(name), value); }
    void set(const char* name, float value) const { glUniform1f(location(name), value); }
    void set(const char* name, const std::array<float, 2>& v) const { glUniform2f(location(name), v[0], v[1]); }
    void set(const char* name, const std::array<float, 4>& v) const {
        glUniform4f(location(name), v[0], v[1], v[2], v[3]);
    }
    void set(const char* name, const std::array<float, 3>& v) const { glUniform3f(location(name), v[0], v[1], v[2]); }
    void set(const char* name, std::span<const std::array<float, 3>> values) const;

private:
    explicit Program(GLuint id) : id_(id) {}
    [[nodiscard]] GLint location(const char* name) const { return glGetUniformLocation(id_, name); }
    GLuint id_ = 0;
};

/// Draws the one triangle of fullscreen.vert. Requires: a program and a target, and any vertex array bound.
inline void draw_fullscreen() {
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace pol
