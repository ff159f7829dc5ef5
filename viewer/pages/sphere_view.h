// SPDX-License-Identifier: Apache-2.0
// The Poincare sphere as it is looked at, and the points in it. No ImGui.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/vec.h"
#include "polarization/stokes.h"
#include "tracer/explain.h"
#include "viewer/shown/polarimeter.h"
#include "viewer/shown/selection.h"
#include "viewer/shown/shown_picture.h"

namespace pol {

/// Where the viewer stands: longitude and latitude in radians on the sphere with axes S1, S2 and S3 (up).
struct SphereView {
    double longitude = 0.7;
    double latitude = 0.4;

    /// A point of the sphere's space as seen: x right, y up, z towards the viewer.
    [[nodiscard]] DVec3 seen(const DVec3& s) const;
    /// Turns the sphere under the hand that drags it by so many radii; the latitude stays within the poles.
    void drag(const DVec2& by);
};

/// One state of light: (S1, S2, S3)/S0, whose distance from the center is the degree of polarization.
struct SpherePoint {
    DVec3 place{0.0, 0.0, 0.0};
    double intensity = 0.0;  ///< S0
    std::size_t band = 0;
    std::optional<PixelAddress> pixel;  ///< none: share of a leaf of the tree
    std::optional<int> node;
};

/// A name beside the sphere.
struct SphereLabel {
    DVec3 at{0.0, 0.0, 0.0};
    std::string text;
};
/// H, V, +45, -45, R and L where this convention has them.
std::array<SphereLabel, 6> sphere_labels(const Convention& convention);

/// Empty unless S0 > 0 and everything is finite.
std::optional<SpherePoint> sphere_point(const Stokes<double>& light);

/// Pixels of `region` in one band, every n-th so that there are at most about `most`; pixels without light are
/// left out. None where a component was not measured.
std::vector<SpherePoint> sphere_points(const ShownPicture& shown, std::size_t band, const TileRect& region,
                                       std::size_t most);

/// What each leaf brings to the pixel, in the pixel's frame, behind the elements of `polarimeter` and labeled in
/// `convention`: the first `most` of them.
std::vector<SpherePoint> sphere_points(const Explanation& explanation, const Polarimeter& polarimeter,
                                       const Convention& convention, std::size_t most);

/// Every pixel of `region` whose point is seen inside the polygon (in the coordinates of SphereView::seen), on the half
/// that faces the viewer if `front_only`. As long as the picture has pixels.
std::vector<bool> pixels_inside(const ShownPicture& shown, std::size_t band, const TileRect& region,
                                const SphereView& view, const std::vector<DVec2>& polygon, bool front_only);

/// True if `p` lies inside the closed polygon (even-odd rule).
bool is_inside(const std::vector<DVec2>& polygon, const DVec2& p);

}  // namespace pol
