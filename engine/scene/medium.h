// SPDX-License-Identifier: Apache-2.0
// What fills a solid, as the user writes it: a closed set.
#pragma once

#include <string>
#include <variant>

#include "core/source_place.h"
#include "core/vec.h"
#include "spectrum/refractive_index.h"
#include "spectrum/spectrum.h"

namespace pol {

/// Absorption coefficient alpha in 1/scene unit: power falls as exp(-alpha length). The spectrum is alpha(lambda).
using Absorption = Spectrum;

/// Glass, liquid, air; a metal, too. The extinction k of the index, if it has one, adds 4 pi k / lambda to the
/// absorption, and the surface is that of the index n + i k, with the k of all absorption.
struct IsotropicMedium {
    RefractiveIndex index = ConstantIndex{};
    Absorption absorption = ConstantSpectrum{0.0};
};

enum class AxisSpace { object, world };

/// A crystal whose k is as large is refused: its faces are followed with real indices. What they reflect is then off by
/// 4 n k^2/(n + 1)^4 at normal incidence, 1e-6 from k = 2.6e-3 on for n = 1.5, and where reflection is total, off or
/// inside of the crystal, by about 3 k.
constexpr double strongest_crystal_extinction = 0.01;

/// Uniaxial crystal. `absorption_o` is for E perpendicular to the axis, `absorption_e` for E along it.
struct UniaxialMedium {
    RefractiveIndex ordinary = ConstantIndex{};
    RefractiveIndex extraordinary = ConstantIndex{};
    DVec3 axis{0.0, 0.0, 1.0};  ///< optic axis; need not be unit
    AxisSpace axis_space = AxisSpace::object;
    Absorption absorption_o = ConstantSpectrum{0.0};
    Absorption absorption_e = ConstantSpectrum{0.0};
};

/// Metal: complex index, nothing is followed into it.
struct ConductorMedium {
    RefractiveIndex index = ConstantIndex{};
};

/// Always visited in full, so that a new kind does not compile before everything has been told of it; what the kinds
/// are made of: medium_fields.h.
using Matter = std::variant<IsotropicMedium, UniaxialMedium, ConductorMedium>;

struct Medium {
    std::string name;
    Matter matter;
    SourcePlace place{};
};

/// Has one real index: light goes through it as one wave.
bool is_isotropic(const Matter& matter);

/// Null: no crystal.
const UniaxialMedium* crystal_in(const Matter& matter);

}  // namespace pol
