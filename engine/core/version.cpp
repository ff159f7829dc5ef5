// SPDX-License-Identifier: Apache-2.0
#include "core/version.h"

namespace pol {

const char* program_version() {
    return POL_VERSION;
}

}  // namespace pol
