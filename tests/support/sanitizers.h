// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pol::test {

/// By how much a sanitizer may slow a program down: what "at once" means to a test that watches for something that
/// would take many times as long.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double slowdown = 10.0;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr double slowdown = 10.0;
#else
constexpr double slowdown = 1.0;
#endif
#else
constexpr double slowdown = 1.0;
#endif

}  // namespace pol::test
