// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/vec.h"
#include "optics/wave.h"
#include "plan/body.h"
#include "tracer/throughput.h"

namespace pol {

/// An open branch of a backward tree: a ray that has not yet been followed to its next surface.
struct Node {
    DVec3 origin{};
    Wave<double> wave{};              ///< k, ray and field vectors; the ray points away from the camera
    Throughput<double> throughput{};  ///< from wave.field to the camera frame
    double weight = 0.0;              ///< throughput.weight()
    Left left{};
    int region = 0;
    int depth = 0;  ///< interfaces met so far
    int id = 0;     ///< order of creation within the sample; 0 is the camera ray
};

/// How a branch came to be.
enum class Interaction {
    camera,
    reflected,
    transmitted,
    sheet,  ///< went through an ideal polarizer or retarder
};

/// Why a branch ended.
enum class LeafReason {
    emitter,
    background,
    absorbed,     ///< by a black surface, the back of an emitter, or an endless absorbing medium
    residual,     ///< the share still open fell below the residual target
    depth,        ///< the depth limit
    node_budget,  ///< the node budget ended and the random tail went elsewhere
    tail_limit,   ///< the random tail did not come to an end
    failure,      ///< a number went bad or a solid leaked: counted, shown, never repaired
};

}  // namespace pol
