// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pol {

/// From now on Ctrl-C (SIGINT) and SIGTERM are remembered and do nothing else.
void remember_signals();

/// The signal that came; 0: none.
int caught_signal();

/// Exit code of a program that a signal ended, as shells have it. Requires: one came.
int interrupted_exit_code();

}  // namespace pol
