// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/resource.h>
#include <unistd.h>

namespace pol {

/// The calling thread gives way to the window's, so that a frame waits for nothing: where they compete, that gets nine
/// times its time. On Linux every thread has a niceness of its own; where it cannot be had, only promptness is lost.
inline void give_way() {
    constexpr int niceness = 10;
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), niceness);
}

}  // namespace pol
