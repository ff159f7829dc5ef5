// SPDX-License-Identifier: Apache-2.0
// Scenes: what can be read can be written, and reads back as a scene.
#include "core/contract.h"
#include "fuzz/fuzz_input.h"
#include "io/scenes/scene_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(pol::test::as_text(data, size));
    const auto scene = pol::parse_scene(text, "fuzz.yaml", "/nonexistent");
    if (scene)
        POL_EXPECTS(static_cast<bool>(pol::parse_scene(pol::save_scene(scene.value()), "again.yaml", "/nonexistent")));
    return 0;
}
