// SPDX-License-Identifier: Apache-2.0
// Interfaces as JSON: one case in, everything that leaves the interface out.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/result.h"
#include "core/vec.h"
#include "optics/dielectric.h"

namespace pol {

/// One interface and the wave normal that meets it; vectors are unit.
struct InterfaceCase {
    DVec3 normal{0.0, 0.0, 1.0};  ///< from medium 1 to medium 2
    DVec3 wave_normal{0.0, 0.0, 1.0};
    Dielectric<double> medium1 = make_isotropic(1.0);
    Dielectric<double> medium2 = make_isotropic(1.0);
    nlohmann::ordered_json name;  ///< value of the key "case"; null if there is none
};

/// Reads {"normal": [x,y,z], "wave_normal": [x,y,z], "medium1": M, "medium2": M}; other keys are ignored. M is
/// {"type": "isotropic", "n"} with a "k" if it absorbs, {"type": "uniaxial", "no", "ne", "axis"}, or for medium 2
/// {"type": "conductor", "n", "k"}. Vectors need not be unit. Errors (kind input) name the key.
Result<InterfaceCase> read_interface_case(const std::string& line);

/// {"case": its name, "incident": [one object per eigenwave of medium 1: label, kind, degenerate, k, E, ray and out, or
/// not_incident]}. `out` holds the waves that leave, reflected first: side (R, T), label (s, p, o, e), kind,
/// degenerate, k, E, ray, amp (flux-normalised, [re, im]) and power; evanescent ones side, label, kind, k, k_im and
/// power 0. An absorbing medium adds `absorbed`
/// (BoundaryResponse::absorption). degenerate: the wave has any polarization, so (s, p) is a choice. Waves inside
/// like matter that reflect nothing at all are not listed.
nlohmann::ordered_json solve_interface_case(const InterfaceCase& interface);

}  // namespace pol
