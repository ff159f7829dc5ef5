// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "core/result.h"

namespace pol {

/// An input error. (Not a designated initializer at the place of use: GCC 12 then warns of uninitialized strings.)
inline Error complaint(std::string field, std::string what, std::string hint) {
    Error error;
    error.what = std::move(what);
    error.field = std::move(field);
    error.hint = std::move(hint);
    return error;
}

}  // namespace pol
