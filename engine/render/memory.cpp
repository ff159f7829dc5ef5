// SPDX-License-Identifier: Apache-2.0
#include "render/memory.h"

#include <sys/mman.h>

#include <cstddef>

#include "polarization/stokes.h"

namespace pol {

bool fits_memory(const Plan& plan) {
    const std::size_t values = std::size_t{2} * static_cast<std::size_t>(plan.settings.width) *
                               static_cast<std::size_t>(plan.settings.height) * plan.wavelengths_nm.size();
    const std::size_t bytes = values * sizeof(Stokes<double>);
    void* probe = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return probe != MAP_FAILED && munmap(probe, bytes) == 0;
}

}  // namespace pol
