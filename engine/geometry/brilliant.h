// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/result.h"
#include "geometry/mesh.h"
#include "geometry/shape.h"

namespace pol {

/// The 73 planes of the modern round brilliant (Tolkowsky 1919 with today's star and lower halves), meeting the way a
/// cutter meets them: mains and girdle facets share corners on a regular 16-gon, stars and halves share corners on the
/// edges between mains. Order as in shapes.h. Error if the parameters leave some facet without area.
Result<Mesh> make_brilliant(const BrilliantShape& shape);

}  // namespace pol
