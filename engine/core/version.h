// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pol {

/// "0.1.0": what CMake calls PROJECT_VERSION.
const char* program_version();

}  // namespace pol
