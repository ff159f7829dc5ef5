// SPDX-License-Identifier: Apache-2.0
#include "plan/standpoint.h"

#include <algorithm>

#include "core/overloaded.h"
#include "geometry/mesh_check.h"
#include "geometry/overlap.h"

namespace pol {

bool is_isotropic(const Plan& plan, int region) {
    const auto medium = static_cast<std::size_t>(plan.regions[static_cast<std::size_t>(region)].medium);
    return plan.groups[0].media[medium].dielectric.kind == MediumKind::isotropic;
}

bool is_fit_for_camera(const Plan& plan, int region) {
    const auto medium = static_cast<std::size_t>(plan.regions[static_cast<std::size_t>(region)].medium);
    return is_isotropic(plan, region) &&
           std::all_of(plan.groups.begin(), plan.groups.end(), [&](const WavelengthGroup& group) {
               return group.media[medium].dielectric.kappa < strongest_camera_extinction;
           });
}

const Surface* body_around(const Plan& plan, const DVec3& point) {
    for (const Surface& surface : plan.surfaces) {
        const bool inside =
            std::visit(Overloaded{[](const OpenSurface&) { return false; },
                                  [&](const HalfSpaceSolid& s) { return s.contains(point, s.slack()); },
                                  [&](const Sphere& s) { return s.contains(point, slack(SolidRef{&s})); },
                                  [&](const MeshBody& s) { return s.closed && encloses(s.mesh, point); }},
                       surface.shape);
        if (inside) return &surface;
    }
    return nullptr;
}

}  // namespace pol
