// SPDX-License-Identifier: Apache-2.0
// One backward step of sixteen branches side by side: the formulas of the scalar kernel over Lanes, compiled once per
// instruction set and chosen at run time. Same bits as the scalar kernel with any of them.
#pragma once

#include <span>

#include "core/complex.h"
#include "geometry/open_surface.h"
#include "geometry/plane_scan.h"
#include "geometry/sphere.h"
#include "optics/attenuation.h"
#include "plan/camera_model.h"

namespace pol {

/// Branches side by side: what a Node of an isotropic medium holds.
struct alignas(64) LaneBranches {
    RayBlock rays;
    double s[3][RayBlock::size];           ///< Wave::field[0]
    double p[3][RayBlock::size];           ///< Wave::field[1]
    double throughput[8][RayBlock::size];  ///< [4 row + 2 column + part], part 1: imaginary
    double weight[RayBlock::size];
    double index[RayBlock::size];  ///< |k|, real part, where cross_absorbing_in_lanes() has made them
};

/// Camera rays through the places (x, y) of the picture.
void begin_in_lanes(const CameraModel& camera, const double (&x)[RayBlock::size], const double (&y)[RayBlock::size],
                    LaneBranches& branches);

/// As PlaneScan::exit and enter, of a ball; what leaves it begins on its surface.
void exit_ball_in_lanes(const Sphere& ball, const RayBlock& rays, HitBlock& hits);
void enter_ball_in_lanes(const Sphere& ball, const RayBlock& rays, HitBlock& hits);

/// At the points `hits`, from index n1 to n2; `side` is that of the normals which lean along the rays. A child of
/// weight zero is not there. `reaches`: 0 where the ray does not go towards the boundary, a numerical failure.
void cross_in_lanes(const LaneBranches& from, const HitBlock& hits, double side, double n1, double n2,
                    LaneBranches& reflected, LaneBranches& transmitted, double (&reaches)[RayBlock::size]);

/// Two media of which one absorbs or both.
struct AbsorbingMedia {
    Complex<double> n1{};
    Complex<double> n2{};
    AbsorptionAt absorption{};  ///< of the first, from where the branches begin on
};

/// As cross_in_lanes(), after the way to `hits` has dimmed the branches. absorbed: weight that was lost on it, and at
/// the boundary.
void cross_absorbing_in_lanes(const LaneBranches& from, const HitBlock& hits, double side, const AbsorbingMedia& media,
                              LaneBranches& reflected, LaneBranches& transmitted, double (&reaches)[RayBlock::size],
                              double (&absorbed)[2][RayBlock::size]);

/// The nearest open surface on the way of each ray, and the Stokes vector at the camera of unpolarized light from
/// there.
struct alignas(64) LaneSights {
    double surface[RayBlock::size];  ///< index into what was asked for; -1: nothing
    double distance[RayBlock::size];
    double along[RayBlock::size];  ///< normal.ray
    double u[RayBlock::size];
    double v[RayBlock::size];
    double unpolarized[4][RayBlock::size];
};
void look_in_lanes(const LaneBranches& branches, std::span<const OpenSurface* const> surfaces, LaneSights& sights);

}  // namespace pol
