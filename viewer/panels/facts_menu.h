// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/wishes.h"

namespace pol {

/// Menu of the facts of polarization optics, by tens: an entry opens the fact's scene with its pixel pinned. Facts that
/// the tracer does not model are there, but cannot be opened; their tooltip says why.
void draw_facts_menu(Wishes& wishes);

}  // namespace pol
