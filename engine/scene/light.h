// SPDX-License-Identifier: Apache-2.0
// What an emitter sends out: a spectrum, perhaps textured, in a polarization state.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/source_place.h"
#include "core/vec.h"
#include "optics/elements.h"
#include "spectrum/spectrum.h"

namespace pol {

/// Linear sRGB picture, row 0 at the top, 3 values a pixel.
struct RgbImage {
    int width = 0;
    int height = 0;
    std::vector<float> rgb;
};

/// Radiance that varies over the emitter: texel color turned into a spectrum under D65 (spectrum/rgb_spectrum.h), times
/// `scale`. Rectangles map the picture upright with u along +x and v along +y of the object. Nearest texel.
struct TexturedRadiance {
    std::string path;
    std::shared_ptr<const RgbImage> image;
    double scale = 1.0;
};

using Radiance = std::variant<Spectrum, TexturedRadiance>;

struct Unpolarized {};

/// The same state in every direction: Stokes vector divided by S0, written in a right-handed frame about the light
/// whose x axis is `x_axis` (object space) made transverse. |(s1, s2, s3)| <= 1.
struct FixedState {
    double s1 = 0.0;
    double s2 = 0.0;
    double s3 = 0.0;
    DVec3 x_axis{1.0, 0.0, 0.0};
};

/// The paper's virtual crystal plate (5.3): the emitter is covered by a plane-parallel plate of a uniaxial medium, of
/// which only one of the two rays is passed. The rest of the light is lost: without Fresnel factor an emitter of
/// radiance L shows L/2. With it the transmittance of the exit face for that ray is applied as well.
struct CrystalPlateState {
    std::string medium;         ///< name of a uniaxial medium
    DVec3 axis{1.0, 0.0, 0.0};  ///< optic axis, object space; replaces the axis of the medium
    CrystalRay passed = CrystalRay::extraordinary;
    bool fresnel = false;
};

using EmittedState = std::variant<Unpolarized, FixedState, CrystalPlateState>;

/// A surface that emits from its front side (the side of its outward normal) and absorbs what falls on it, on both
/// sides.
struct Emission {
    Radiance radiance = Spectrum{ConstantSpectrum{1.0}};
    EmittedState state = Unpolarized{};
    bool two_sided = false;
};

/// Uniform, unpolarized surroundings; radiance 0 is black.
struct Background {
    Spectrum radiance = ConstantSpectrum{0.0};
    SourcePlace place{};
};

}  // namespace pol
