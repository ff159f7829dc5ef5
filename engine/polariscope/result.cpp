// SPDX-License-Identifier: Apache-2.0
#include "polariscope/result.h"

#include "polariscope/inside.h"

namespace polariscope {

std::string to_string(const Error& error) {
    return pol::to_string(pol::Error{
        pol::ErrorKind::input, error.message, {error.file, error.line, error.column}, error.field, error.hint});
}

namespace detail {

Error outer(const pol::Error& error) {
    const auto kind = [&error] {
        switch (error.kind) {
            case pol::ErrorKind::usage:
                return ErrorKind::usage;
            case pol::ErrorKind::input:
                return ErrorKind::input;
            case pol::ErrorKind::output:
                return ErrorKind::output;
            case pol::ErrorKind::internal:
                break;
        }
        return ErrorKind::internal;
    };
    return {kind(), error.what, error.place.file, error.place.line, error.place.column, error.field, error.hint};
}

Error usage(std::string field, std::string message, std::string hint) {
    return {ErrorKind::usage, std::move(message), {}, 0, 0, std::move(field), std::move(hint)};
}

Error stopped() {
    return {ErrorKind::stopped, "stopped before the end", {}, 0, 0, {}, {}};
}

}  // namespace detail
}  // namespace polariscope
