// SPDX-License-Identifier: Apache-2.0
// Files about the pinned pixel: its tree, and the pixel as a test case.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "viewer/session.h"

namespace pol {

enum class RayFormat : std::uint8_t { csv, json, obj };

/// A name beside the scene, or in the current folder for scenes without a file, that does not exist yet:
/// "cube-256,200.csv", then "cube-256,200-2.csv".
std::filesystem::path free_name(const Session& session, const std::string& ending);

/// Writes the pinned pixel's tree in the background; the log says where, or why not.
/// Requires: session.explanation().
void export_rays(Session& session, RayFormat format);

/// Writes scene, pixel, sample and matrix as a case that `polariscope explain --case` checks (io/pixel_case_file.h);
/// the log says where, or why not. Requires: session.explanation().
void save_pixel_case(Session& session);

}  // namespace pol
