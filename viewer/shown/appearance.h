// SPDX-License-Identifier: Apache-2.0
// By what everything that is drawn is colored.
#pragma once

#include <cstdint>

namespace pol {

enum class Theme : std::uint8_t { dark, light };

/// Of what the window has to tell.
enum class Severity : std::uint8_t { note, warning, error };

}  // namespace pol
