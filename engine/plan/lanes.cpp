// SPDX-License-Identifier: Apache-2.0
#include "plan/lanes.h"

#include <algorithm>
#include <variant>

namespace pol {

namespace {

/// Glass, of a complex index where it absorbs at all.
bool is_glass(const MediumAt& medium) {
    return medium.dielectric.kind == MediumKind::isotropic &&
           (medium.dielectric.is_complex() || !medium.absorption.absorbs());
}

bool is_transparent_glass(const MediumAt& medium) {
    return is_glass(medium) && !medium.dielectric.is_complex();
}

bool at_all_wavelengths(const Plan& plan, const Region& region, bool (*is_so)(const MediumAt&)) {
    return std::all_of(plan.groups.begin(), plan.groups.end(), [&](const WavelengthGroup& group) {
        return is_so(group.media[static_cast<std::size_t>(region.medium)]);
    });
}

bool is_lamp_or_black(const Surface& surface) {
    return std::holds_alternative<OpenSurface>(surface.shape) && !std::holds_alternative<SheetRole>(surface.role);
}

}  // namespace

std::string why_not_in_lanes(const Plan& plan) {
    if (plan.kernel().anisotropic) return "the kernel is " + to_string(plan.kernel());
    SpareParts beside_the_kernel;
    beside_the_kernel.halves = plan.kept.halves;
    beside_the_kernel.tree_per_wavelength = plan.kept.tree_per_wavelength;
    if (plan.kept != beside_the_kernel) return "code is kept that lanes leave out";
    if (plan.settings.unpolarized) return "polarization is left out";
    if (plan.settings.depth) return "the depth is limited";
    if (plan.solids.size() != 1) return plan.solids.empty() ? "there is no solid" : "there is more than one solid";
    const Solid& solid = plan.solids.front();
    if (std::holds_alternative<MeshBody>(solid.shape))
        return "'" + solid.name + "' is neither flat-faced and convex nor a ball";
    if (!solid.covers.empty() || !solid.contacts.empty()) return "something touches '" + solid.name + "'";
    if (!solid.black.empty()) return "'" + solid.name + "' has black faces";
    for (const Surface& surface : plan.surfaces)
        if (!is_lamp_or_black(surface)) return "'" + surface.name + "' is not a flat lamp or absorber";
    if (plan.camera_region != 0 || plan.regions.size() != 2) return "the camera stands inside '" + solid.name + "'";
    if (!plan.regions[1].surfaces.empty()) return "there is a surface inside '" + solid.name + "'";
    const auto medium_of = [&](const Region& region) {
        return "'" + plan.medium_names[static_cast<std::size_t>(region.medium)] + "'";
    };
    if (!at_all_wavelengths(plan, plan.regions[0], is_transparent_glass))
        return medium_of(plan.regions[0]) + " around '" + solid.name + "' absorbs";
    if (!at_all_wavelengths(plan, plan.regions[1], is_glass)) return medium_of(plan.regions[1]) + " is no glass";
    return {};
}

}  // namespace pol
