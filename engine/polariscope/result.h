// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace polariscope {

enum class ErrorKind {
    input,     ///< a scene, a picture or one of their files is wrong
    output,    ///< a result cannot be written
    usage,     ///< the call asks for something that is not there: a pixel outside the picture, a map without a name
    memory,    ///< there is not enough
    stopped,   ///< the stop token said so
    internal,  ///< a defect of this library
};

/// What is wrong, where it stands, and what would be right.
struct Error {
    ErrorKind kind = ErrorKind::internal;
    std::string message;
    std::string file;   ///< scene or picture; empty if it is about none
    int line = 0;       ///< in it, from 1; 0: not known
    int column = 0;     ///< from 1; 0: not known
    std::string field;  ///< key path in the scene ("objects[2].medium") or name of the argument; may be empty
    std::string hint;   ///< may be empty
};

/// "file:line:column: field: message", and the hint on a line of its own.
std::string to_string(const Error& error);

/// Stands for "nothing" in Result<Done>.
struct Done {};

/// A value, or the reason why there is none.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::move(value)) {}      // NOLINT: implicit on purpose
    Result(Error error) : state_(std::move(error)) {}  // NOLINT: implicit on purpose

    /// True if there is a value.
    explicit operator bool() const { return std::holds_alternative<T>(state_); }

    /// Who asks for what is not there gets std::bad_variant_access, the only exception of this library.
    const T& value() const& { return std::get<T>(state_); }
    T& value() & { return std::get<T>(state_); }
    T&& value() && { return std::get<T>(std::move(state_)); }
    const Error& error() const { return std::get<Error>(state_); }

    /// next(value()), which is a Result again, or the error: load_scene(file).and_then(compile).
    template <class Next>
    auto and_then(const Next& next) const -> std::invoke_result_t<Next, const T&> {
        if (*this) return std::invoke(next, value());
        return error();
    }

private:
    std::variant<T, Error> state_;
};

}  // namespace polariscope
