// SPDX-License-Identifier: Apache-2.0
#include "viewer/gl/program.h"

#include <string>
#include <utility>
#include <vector>

#include "core/result.h"

namespace pol {

namespace {

/// Owner of one stage.
class Shader {
public:
    explicit Shader(GLenum stage) : id_(glCreateShader(stage)) {}
    ~Shader() { glDeleteShader(id_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    [[nodiscard]] GLuint id() const { return id_; }

private:
    GLuint id_;
};

template <class GetLog>
std::string log_text(GLint length, const GetLog& get_log) {
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    get_log(static_cast<GLsizei>(log.size()), log.data());
    log.resize(log.find_last_not_of(std::string_view("\0\n ", 3)) + 1);
    return log;
}

Result<Done> compile(const Shader& shader, std::string_view stage, std::initializer_list<std::string_view> parts) {
    constexpr std::string_view version = "#version 330 core\n";
    std::vector<const char*> texts{version.data()};
    std::vector<GLint> lengths{static_cast<GLint>(version.size())};
    for (const std::string_view part : parts) {
        texts.push_back(part.data());
        lengths.push_back(static_cast<GLint>(part.size()));
    }
    glShaderSource(shader.id(), static_cast<GLsizei>(texts.size()), texts.data(), lengths.data());
    glCompileShader(shader.id());
    GLint is_good = 0;
    GLint length = 0;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &is_good);
    glGetShaderiv(shader.id(), GL_INFO_LOG_LENGTH, &length);
    if (is_good != 0) return Done{};
    const std::string log =
        log_text(length, [&](GLsizei size, char* text) { glGetShaderInfoLog(shader.id(), size, nullptr, text); });
    return Error{ErrorKind::internal, "the " + std::string(stage) + " shader does not compile:\n" + log, {}, {}, {}};
}

}  // namespace

Result<Program> Program::link(std::initializer_list<std::string_view> vertex,
                              std::initializer_list<std::string_view> fragment) {
    const Shader vertex_shader(GL_VERTEX_SHADER);
    POL_TRY_DONE(compile(vertex_shader, "vertex", vertex));
    const Shader fragment_shader(GL_FRAGMENT_SHADER);
    POL_TRY_DONE(compile(fragment_shader, "fragment", fragment));

    Program program(glCreateProgram());
    glAttachShader(program.id_, vertex_shader.id());
    glAttachShader(program.id_, fragment_shader.id());
    glLinkProgram(program.id_);
    glDetachShader(program.id_, vertex_shader.id());
    glDetachShader(program.id_, fragment_shader.id());
    GLint is_good = 0;
    GLint length = 0;
    glGetProgramiv(program.id_, GL_LINK_STATUS, &is_good);
    glGetProgramiv(program.id_, GL_INFO_LOG_LENGTH, &length);
    if (is_good != 0) return program;
    const std::string log =
        log_text(length, [&](GLsizei size, char* text) { glGetProgramInfoLog(program.id_, size, nullptr, text); });
    return Error{ErrorKind::internal, "the shaders do not link:\n" + log, {}, {}, {}};
}

Program::Program(Program&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

Program& Program::operator=(Program&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
}

void Program::set(const char* name, std::span<const std::array<float, 3>> values) const {
    glUniform3fv(location(name), static_cast<GLsizei>(values.size()), values.front().data());
}

}  // namespace pol
