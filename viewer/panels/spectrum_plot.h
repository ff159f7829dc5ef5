// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "viewer/pages/pixel_page.h"

namespace pol {

/// A curve over wavelength (over the bands in their order if they have none), as wide as the window, with its range at
/// the sides, gaps where it is undefined, and the band `current` marked. Returns the index of a band that was clicked.
std::optional<std::size_t> draw_spectrum_plot(const PageCurve& curve, const std::vector<Band>& bands,
                                              std::size_t current, float height);

}  // namespace pol
