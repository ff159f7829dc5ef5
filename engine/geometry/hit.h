// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pol {

/// Where a ray o + t d meets a solid: t, and which facet of that solid. The facet goes back into the next query as
/// `skip`: a straight ray never meets the plane it starts on again, so no epsilon is needed.
struct FacetHit {
    double distance = 0.0;
    int facet = -1;  ///< -1: nothing was met

    explicit operator bool() const { return facet >= 0; }
};

}  // namespace pol
