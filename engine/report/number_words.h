// SPDX-License-Identifier: Apache-2.0
// Numbers as people write them.
#pragma once

#include <cstdint>
#include <string>

namespace pol {

/// "430 ms", "5.3 s", "2 min 10 s", "3 h 5 min".
std::string duration_text(double seconds);

/// "870", "1.47 million", "2.30 billion".
std::string count_text(std::uint64_t count);

}  // namespace pol
