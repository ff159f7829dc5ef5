// SPDX-License-Identifier: Apache-2.0
// What the selected region is made of, as text: its mean light, the maps of that light, and how far it is from the
// reference. No ImGui.
#pragma once

#include <cstdint>
#include <string>

#include "viewer/pages/pixel_page.h"
#include "viewer/session/session.h"

namespace pol {

struct RegionPage {
    std::string title;  ///< "12 x 9 pixels from 4,3"
    /// Count, mean Stokes vector with standard deviations, measures of the mean, in the shown band and convention.
    PageGroup light;
    /// Error metrics of the region against the reference, in that band; without rows if `why_not` says why.
    PageGroup metrics;
    std::string why_not;
};

/// Everything that the page depends on: it is made anew when that changes.
struct RegionPageKey {
    TileRect region{};
    std::uint64_t layout = 0;
    std::uint64_t version = 0;
    std::size_t band = 0;
    Polarimeter polarimeter;
    Convention convention;
    const Document* reference = nullptr;
    std::uint64_t reference_layout = 0;
    std::uint64_t reference_version = 0;
};
bool operator==(const RegionPageKey& a, const RegionPageKey& b);

/// Requires: a region is selected.
RegionPageKey region_page_key(const Session& session);
/// Requires: a region is selected.
RegionPage make_region_page(const Session& session);

/// The whole page, one line per number at full precision.
std::string text_of(const RegionPage& page);

}  // namespace pol
