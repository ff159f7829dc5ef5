// SPDX-License-Identifier: Apache-2.0
// Files about the pinned pixel: its tree, and the pixel as a test case.
#pragma once

#include <cstdint>

#include "viewer/session/session.h"

namespace pol {

enum class RayFormat : std::uint8_t { csv, json, obj };

/// Writes the pinned pixel's tree in the background; the log says where, or why not. Without a tree: does nothing.
void export_rays(Session& session, RayFormat format);

/// Writes scene, pixel, sample and matrix as a case that `polariscope explain --case` checks
/// (io/scenes/pixel_case_file.h); the log says where, or why not. Without a tree: does nothing.
void save_pixel_case(Session& session);

}  // namespace pol
