// SPDX-License-Identifier: Apache-2.0
// Preconditions that hold in every build: a broken one is a bug of the caller.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace pol::detail {

[[noreturn]] inline void contract_broken(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: precondition broken: %s\n", file, line, condition);
    std::abort();
}

}  // namespace pol::detail

#if defined(__FILE_NAME__)
#define POL_FILE __FILE_NAME__  // and not where somebody built it
#else
#define POL_FILE __FILE__
#endif

/// Aborts with file and line if `condition` is false, in every build.
#define POL_EXPECTS(condition) \
    ((condition) ? static_cast<void>(0) : ::pol::detail::contract_broken(#condition, POL_FILE, __LINE__))
