// SPDX-License-Identifier: Apache-2.0
#include "scene/medium.h"

#include "core/overloaded.h"

namespace pol {

bool is_isotropic(const Matter& matter) {
    return std::visit(Overloaded{
                          [](const IsotropicMedium&) { return true; },
                          [](const UniaxialMedium&) { return false; },
                          [](const ConductorMedium&) { return false; },
                      },
                      matter);
}

const UniaxialMedium* crystal_in(const Matter& matter) {
    using Crystal = const UniaxialMedium*;
    return std::visit(Overloaded{
                          [](const IsotropicMedium&) -> Crystal { return nullptr; },
                          [](const UniaxialMedium& crystal) -> Crystal { return &crystal; },
                          [](const ConductorMedium&) -> Crystal { return nullptr; },
                      },
                      matter);
}

}  // namespace pol
