// SPDX-License-Identifier: Apache-2.0
// Index records: what can be read answers or refuses at every wavelength.
#include <initializer_list>

#include "fuzz/fuzz_input.h"
#include "io/scenes/index_file.h"
#include "spectrum/refractive_index.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto path = pol::test::as_file(pol::test::as_text(data, size), ".yml");
    const auto index = pol::load_index(path.string(), "/nonexistent");
    if (!index) return 0;
    for (const double nm : {0.0, 1e-300, 200.0, 580.0, 1e5, 1e300}) static_cast<void>(pol::index_at(index.value(), nm));
    return 0;
}
