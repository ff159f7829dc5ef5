// SPDX-License-Identifier: Apache-2.0
// The compiled scene: immutable, complete, and without anything that the picture does not need.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"
#include "geometry/ray_caster.h"
#include "optics/attenuation.h"
#include "plan/body.h"
#include "plan/camera_model.h"
#include "plan/emitter.h"
#include "plan/features.h"
#include "plan/kernel.h"
#include "plan/spare_parts.h"
#include "scene/scene.h"

namespace pol {

/// A medium at the wavelengths of one group.
struct MediumAt {
    Dielectric<double> dielectric;
    AbsorptionAt absorption;
    friend bool operator==(const MediumAt&, const MediumAt&) = default;
};

/// Wavelengths at which every medium in use has the same constants: they share one tree of rays. Where a medium in use
/// has an index that depends on the wavelength, every wavelength has a group of its own.
struct WavelengthGroup {
    std::vector<int> wavelengths;  ///< indices into Plan::wavelengths_nm, ascending
    std::vector<MediumAt> media;   ///< by index into Plan::medium_names
    /// Of its random numbers: follows from the constants alone, so that a wavelength has the same ones by itself, in
    /// any list, and with any others in its group.
    std::uint32_t key = 0;
    /// Of the places of its samples in a pixel: 0, those that all wavelengths share, or in a scene with dispersion the
    /// wavelength's own. Light refracts by what it is, not by what the scene's index is: twins keep their places.
    std::uint32_t places = 0;
    /// As Plan::brightest, if the radiance of every lamp were its luminance.
    double brightest_luminance = 0.0;
};

constexpr std::size_t max_nested_meshes = 8;

/// A part of space with one medium: the set of solids that a ray is inside of. Region 0 lies outside all of them.
/// Candidates for the next hit are the ways out of the members, the ways into solids that reach into this region, and
/// the surfaces in it.
struct Region {
    std::vector<int> members;                 ///< solids, ascending
    int owner = -1;                           ///< the member whose medium fills the region; -1: ambient
    int medium = 0;                           ///< index into Plan::medium_names
    std::vector<int> exits;                   ///< members with analytic or half-space boundary that can be left
    std::vector<int> entries;                 ///< other solids, analytic or half-space, that can be entered
    std::vector<int> surfaces;                ///< surfaces that are not meshes
    std::unique_ptr<const RayCaster> caster;  ///< the meshes among them, or null
    std::vector<int> caster_body;             ///< body of each mesh of the caster
    std::vector<LeftFacet>
        caster_inside;  ///< its meshes that a ray in this region is inside of, at most max_nested_meshes
    /// Outside of all solids, and without meshes and sheets: a ray here that enters none of `entries` ends.
    bool is_open = false;
    std::vector<int> toggled;  ///< by solid: the region on the other side of its boundary; -1: cannot be
};

/// Bodies are numbered solids first, then surfaces.
struct Plan {
    RenderSettings settings;
    std::string title;
    std::vector<double> wavelengths_nm;  ///< ascending
    std::vector<std::string> medium_names;
    std::vector<WavelengthGroup> groups;
    std::vector<int> group_of_wavelength;
    std::vector<Solid> solids;
    std::vector<Surface> surfaces;
    std::vector<Emitter> emitters;
    std::vector<double> background;  ///< radiance per wavelength
    double background_luminance = 0.0;
    std::vector<Region> regions;
    CameraModel camera;
    int camera_region = 0;            ///< region of the camera if it is the same for all pixels, else -1
    std::vector<int> camera_regions;  ///< all regions that its rays may start in
    double length_scale = 1.0;        ///< largest coordinate of the scene, for drawings and checks
    SpareParts kept;                  ///< code that it has, needed or not
    std::vector<double> brightest;    ///< bound of 2 lambda_max over all that can be seen, per wavelength
    Features features;

    [[nodiscard]] int solid_count() const { return static_cast<int>(solids.size()); }
    [[nodiscard]] bool is_solid(int body) const { return body >= 0 && body < solid_count(); }
    [[nodiscard]] const Surface& surface(int body) const {
        return surfaces[static_cast<std::size_t>(body - solid_count())];
    }
    [[nodiscard]] const Solid& solid(int body) const { return solids[static_cast<std::size_t>(body)]; }
    [[nodiscard]] const std::string& body_name(int body) const {
        return is_solid(body) ? solid(body).name : surface(body).name;
    }

    /// By all media of all groups, and what is kept.
    [[nodiscard]] Kernel kernel() const;

    /// Region that contains a point (boundaries count as outside).
    [[nodiscard]] int region_at(const DVec3& point) const;
};

}  // namespace pol
