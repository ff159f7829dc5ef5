// SPDX-License-Identifier: Apache-2.0
#include "cli/interruption.h"

#include <csignal>

namespace pol {

namespace {

volatile std::sig_atomic_t last_signal = 0;

void remember(int signal) {
    last_signal = signal;
}

}  // namespace

void remember_signals() {
    std::signal(SIGINT, remember);
    std::signal(SIGTERM, remember);
}

int caught_signal() {
    return static_cast<int>(last_signal);
}

int interrupted_exit_code() {
    return 128 + caught_signal();
}

}  // namespace pol
