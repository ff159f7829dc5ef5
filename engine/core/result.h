// SPDX-License-Identifier: Apache-2.0
// Errors are values with an address: what is wrong, where it stands, and what to do about it.
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "core/contract.h"

namespace pol {

/// Which exit status an error leads to (see README, "Exit codes").
enum class ErrorKind {
    internal = 1,  ///< a defect of this program
    usage = 2,     ///< the command line asks for something impossible
    input = 3,     ///< a scene or one of its assets is wrong
    output = 4,    ///< a result cannot be written
};

/// Where in a text an error stands. Lines and columns count from 1; 0 means unknown.
struct Place {
    std::string file;
    int line = 0;
    int column = 0;
};

/// One complaint for the user. `what` says what is wrong, `field` names the key path or channel
/// ("objects[2].medium"), `hint` says what would be right.
struct Error {
    ErrorKind kind = ErrorKind::input;
    std::string what;
    Place place{};
    std::string field{};
    std::string hint{};
};

/// "file:line:column: field: what (hint)", leaving out what is unknown.
inline std::string to_string(const Error& error) {
    std::string text;
    if (!error.place.file.empty()) {
        text += error.place.file + ":";
        if (error.place.line > 0) text += std::to_string(error.place.line) + ":";
        if (error.place.line > 0 && error.place.column > 0) text += std::to_string(error.place.column) + ":";
        text += " ";
    }
    if (!error.field.empty()) text += error.field + ": ";
    text += error.what;
    if (!error.hint.empty()) text += "\n  hint: " + error.hint;
    return text;
}

/// Stands for "nothing" in Result<Done>.
struct Done {};

/// A value or the reason why there is none.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::move(value)) {}      // NOLINT: implicit on purpose
    Result(Error error) : state_(std::move(error)) {}  // NOLINT: implicit on purpose

    explicit operator bool() const { return std::holds_alternative<T>(state_); }

    /// Requires: holds a value.
    const T& value() const& {
        POL_EXPECTS(*this);
        return std::get<T>(state_);
    }
    T& value() & {
        POL_EXPECTS(*this);
        return std::get<T>(state_);
    }
    T&& value() && {
        POL_EXPECTS(*this);
        return std::get<T>(std::move(state_));
    }
    /// Requires: holds an error.
    const Error& error() const {
        POL_EXPECTS(!*this);
        return std::get<Error>(state_);
    }

private:
    std::variant<T, Error> state_;
};

}  // namespace pol

/// POL_TRY(const auto mesh, read_mesh(path)); declares what a call gives, or leaves the function with the call's error.
#define POL_TRY(declaration, ...) POL_TRY_AS(POL_JOINED(tried_in_line_, __LINE__), declaration, __VA_ARGS__)
/// The same for a call that gives nothing but an error, if any.
#define POL_TRY_DONE(...) \
    if (auto tried = (__VA_ARGS__); !tried) return tried.error()

#define POL_TRY_AS(tried, declaration, ...) \
    auto tried = (__VA_ARGS__);             \
    if (!(tried)) return (tried).error();   \
    declaration = std::move(tried).value()  // NOLINT(bugprone-macro-parentheses): a declaration
#define POL_JOINED(a, b) POL_JOINED_AS(a, b)
#define POL_JOINED_AS(a, b) a##b
