// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "verify/ablation/ablation.h"

namespace pol {

/// The table for people.
std::string ablation_text(const verify::AblationResult& result);

/// The same for programs.
std::string ablation_json(const verify::AblationResult& result);

/// Names on stderr what changed the picture, and returns the exit code: a defect of this program, or 0.
int conclude(const verify::AblationResult& result);

}  // namespace pol
