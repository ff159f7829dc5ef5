// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <hwy/targets.h>

#include <cstdint>
#include <vector>

namespace pol::test {

/// Highway chooses the best instruction set again when this goes.
struct EveryInstructionSet {
    ~EveryInstructionSet() { hwy::SetSupportedTargetsForTest(0); }
};

/// Those that were compiled and that this machine has, for hwy::SetSupportedTargetsForTest().
inline std::vector<std::int64_t> instruction_sets() {
    hwy::SetSupportedTargetsForTest(0);
    std::vector<std::int64_t> all;
    for (std::int64_t bits = hwy::SupportedTargets(); bits != 0; bits &= bits - 1) all.push_back(bits & -bits);
    return all;
}

}  // namespace pol::test
