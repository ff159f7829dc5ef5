// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace pol {

/// What the tracer of a plan must be able to do; the rest is not compiled into it (tracer/with_kernel.h).
struct Kernel {
    bool anisotropic = false;  ///< some region holds a crystal
    bool absorbing = false;    ///< some region absorbs along the ray
    friend bool operator==(const Kernel&, const Kernel&) = default;
};

/// "anisotropic, lossless"
inline std::string to_string(const Kernel& kernel) {
    return std::string(kernel.anisotropic ? "anisotropic" : "isotropic") +
           (kernel.absorbing ? ", absorbing" : ", lossless");
}

}  // namespace pol
