// SPDX-License-Identifier: Apache-2.0
// An emitter at the wavelengths of the plan.
#pragma once

#include <array>
#include <memory>
#include <variant>
#include <vector>

#include "core/vec.h"
#include "optics/dielectric.h"
#include "scene/light.h"

namespace pol {

/// Texture in the plan: spectral radiance = sum over c of rgb[c] * basis[c][wavelength], `scale` included in the basis,
/// luminance = sum over c of rgb[c] * luminance[c], too.
struct PlanTexture {
    std::shared_ptr<const RgbImage> image;
    std::array<std::vector<double>, 3> basis;
    std::array<double, 3> luminance{};
};

/// FixedState in world space. `x_axis` is unit.
struct PlanFixedState {
    double s1 = 0.0;
    double s2 = 0.0;
    double s3 = 0.0;
    DVec3 x_axis{1.0, 0.0, 0.0};
};

/// CrystalPlateState with its medium evaluated per wavelength group, axis in world space.
struct PlanCrystalPlate {
    std::vector<Dielectric<double>> crystal;  ///< by wavelength group
    CrystalRay passed = CrystalRay::extraordinary;
    bool fresnel = false;
};

struct Emitter {
    std::variant<std::vector<double>, PlanTexture> radiance;  ///< per wavelength, or a texture
    std::variant<Unpolarized, PlanFixedState, PlanCrystalPlate> state;
    bool two_sided = false;
    double luminance = 0.0;  ///< spectrum/illuminant.h, of the brightest texel if there is a texture
    /// Twice the largest eigenvalue of any coherence matrix it emits, per wavelength: the L_max of the error bound.
    std::vector<double> brightest;
};

}  // namespace pol
