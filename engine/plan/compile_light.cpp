// SPDX-License-Identifier: Apache-2.0
#include "plan/compile_light.h"

#include <algorithm>
#include <cmath>

#include "core/overloaded.h"
#include "core/result.h"
#include "plan/compile_media.h"
#include "scene/place.h"
#include "spectrum/color.h"
#include "spectrum/illuminant.h"
#include "spectrum/rgb_spectrum.h"

namespace pol {

Sheet sheet_in_world(const Sheet& sheet, const DMat4& to_world) {
    return std::visit(Overloaded{
                          [&](const LinearPolarizer& p) -> Sheet {
                              return LinearPolarizer{direction_to_world(to_world, p.axis), p.model};
                          },
                          [&](const Retarder& r) -> Sheet {
                              return Retarder{direction_to_world(to_world, r.fast_axis), r.retardance};
                          },
                          [](const CircularPolarizer& c) -> Sheet { return c; },
                      },
                      sheet);
}

namespace {

/// Object of each emitter, in the order of plan.emitters.
std::vector<int> emitter_objects(const Plan& plan) {
    std::vector<int> objects(plan.emitters.size());
    for (const Surface& surface : plan.surfaces)
        if (const auto* role = std::get_if<EmitterRole>(&surface.role))
            objects[static_cast<std::size_t>(role->emitter)] = surface.object;
    return objects;
}

}  // namespace

Result<std::vector<Dielectric<double>>> plate_crystals(const Scene& scene, const Plan& plan, double wavelength_nm) {
    std::vector<Dielectric<double>> plates;
    for (const int index : emitter_objects(plan)) {
        const Object& object = scene.objects[static_cast<std::size_t>(index)];
        const auto* plate = std::get_if<CrystalPlateState>(&std::get<Emission>(object.role).state);
        if (plate == nullptr) {
            plates.push_back(make_isotropic(1.0));
            continue;
        }
        const auto medium = std::find_if(scene.media.begin(), scene.media.end(),
                                         [&](const Medium& m) { return m.name == plate->medium; });
        if (medium == scene.media.end())
            return at_object({ErrorKind::input,
                              "unknown medium '" + plate->medium + "'",
                              {},
                              "emission.polarization.crystal_plate.medium",
                              {}},
                             scene, index);
        auto constants =
            medium_at(*medium, direction_to_world(object.to_world, plate->axis), wavelength_nm, scene.unit_nm);
        if (!constants) return at_object(constants.error(), scene, index);
        if (constants.value().dielectric.kind != MediumKind::uniaxial)
            return at_object({ErrorKind::input,
                              "the virtual plate's medium '" + plate->medium + "' has only one ray",
                              {},
                              "emission.polarization.crystal_plate.medium",
                              "name a uniaxial medium with two different indices"},
                             scene, index);
        plates.push_back(constants.value().dielectric);
    }
    return plates;
}

bool same_plates(const Plan& plan, int group, const std::vector<Dielectric<double>>& plates) {
    for (std::size_t i = 0; i < plates.size(); ++i)
        if (const auto* plate = std::get_if<PlanCrystalPlate>(&plan.emitters[i].state);
            plate != nullptr && !(plate->crystal[static_cast<std::size_t>(group)] == plates[i]))
            return false;
    return true;
}

void append_plates(Plan& plan, const std::vector<Dielectric<double>>& plates) {
    for (std::size_t i = 0; i < plates.size(); ++i) {
        if (plates[i].kind != MediumKind::uniaxial) continue;
        if (!std::holds_alternative<PlanCrystalPlate>(plan.emitters[i].state))
            plan.emitters[i].state = PlanCrystalPlate{};
        std::get<PlanCrystalPlate>(plan.emitters[i].state).crystal.push_back(plates[i]);
    }
}

namespace {

/// Radiance per wavelength and its largest value per wavelength.
struct CompiledRadiance {
    std::variant<std::vector<double>, PlanTexture> radiance;
    std::vector<double> largest;
    double luminance = 0.0;  // the largest
};

Result<CompiledRadiance> compile_radiance(const Radiance& radiance, const std::vector<double>& wavelengths) {
    CompiledRadiance out;
    if (const auto* spectrum = std::get_if<Spectrum>(&radiance)) {
        for (const double nm : wavelengths) {
            POL_TRY(const auto value, evaluate(*spectrum, nm));
            out.largest.push_back(value);
        }
        out.radiance = out.largest;
        out.luminance = luminance(*spectrum);
        return out;
    }
    const auto& textured = std::get<TexturedRadiance>(radiance);
    PlanTexture texture{textured.image, {}, {}};
    // White emits D65 (spectrum/rgb_spectrum.h), whose luminance is 1.
    for (std::size_t c = 0; c < 3; ++c) {
        Rgb primary{};
        primary[c] = textured.scale;
        texture.luminance[c] = to_xyz(primary)[1];
    }
    const auto largest_with = [&](const auto& weight) {
        double largest = 0.0;
        for (std::size_t i = 0; i + 2 < textured.image->rgb.size(); i += 3) {
            double value = 0.0;
            for (std::size_t c = 0; c < 3; ++c) value += static_cast<double>(textured.image->rgb[i + c]) * weight(c);
            largest = std::max(largest, value);
        }
        return largest;
    };
    for (const double nm : wavelengths) {
        POL_TRY(const auto basis, rgb_basis_at(nm));
        for (std::size_t c = 0; c < 3; ++c) texture.basis[c].push_back(textured.scale * basis[c]);
    }
    for (std::size_t w = 0; w < wavelengths.size(); ++w)
        out.largest.push_back(largest_with([&](std::size_t c) { return texture.basis[c][w]; }));
    out.luminance = largest_with([&](std::size_t c) { return texture.luminance[c]; });
    out.radiance = std::move(texture);
    return out;
}

/// Twice the largest eigenvalue of the emitted coherence matrix per unit radiance.
double brightest_per_radiance(const EmittedState& state) {
    return std::visit(Overloaded{
                          [](const Unpolarized&) { return 1.0; },
                          [](const FixedState& s) { return 1.0 + std::sqrt(s.s1 * s.s1 + s.s2 * s.s2 + s.s3 * s.s3); },
                          [](const CrystalPlateState&) { return 1.0; },  // half the radiance, fully polarized
                      },
                      state);
}

/// Smallest N^2 (PHYSICS.md 2.3) of any mode of the medium; for e waves N^2 = n_e^4 n_o^2 / n_r^4 with n_r between the
/// two indices.
double smallest_ray_index2(const Dielectric<double>& d) {
    const double n_o2 = d.n * d.n;
    if (d.kind != MediumKind::uniaxial) return n_o2;
    const double n_e2 = d.n_e * d.n_e;
    return std::min(n_o2, n_e2 * n_e2 / n_o2);
}

Result<Done> refuse_polarized_in_crystal(const Scene& scene, const Plan& plan, int body, int object) {
    const std::string& name = scene.objects[static_cast<std::size_t>(object)].name;
    for (const Region& region : plan.regions) {
        const bool here =
            std::find(region.surfaces.begin(), region.surfaces.end(), body) != region.surfaces.end() ||
            std::find(region.caster_body.begin(), region.caster_body.end(), body) != region.caster_body.end();
        if (here &&
            plan.groups[0].media[static_cast<std::size_t>(region.medium)].dielectric.kind == MediumKind::uniaxial)
            return at_object(
                {ErrorKind::input,
                 "polarized emitter '" + name + "' reaches into a crystal, whose modes fix the polarization",
                 {},
                 "emission.polarization",
                 "make it unpolarized or move it out of the crystal"},
                scene, object);
    }
    return Done{};
}

}  // namespace

Result<Done> compile_light(const Scene& scene, Plan& plan) {
    plan.brightest.assign(plan.wavelengths_nm.size(), 0.0);
    for (const double nm : plan.wavelengths_nm) {
        const auto value = evaluate(scene.background.radiance, nm);
        if (!value) return at_place(value.error(), scene, scene.background.place);
        plan.background.push_back(value.value());
    }
    plan.background_luminance = luminance(scene.background.radiance);
    const auto group_of = [&](std::size_t w) -> WavelengthGroup& {
        return plan.groups[static_cast<std::size_t>(plan.group_of_wavelength[w])];
    };
    // Radiance seen from a camera in a dense medium grows with n^2.
    std::vector<double> largest_factor(plan.wavelengths_nm.size(), 1.0);
    for (std::size_t w = 0; w < plan.wavelengths_nm.size(); ++w) {
        const auto& media = group_of(w).media;
        double smallest = smallest_ray_index2(media[0].dielectric);
        double camera = 0.0;
        for (std::size_t r = 0; r < plan.regions.size(); ++r) {
            const auto& d = media[static_cast<std::size_t>(plan.regions[r].medium)].dielectric;
            // Nothing is followed into a metal, however it is written.
            if (d.kind != MediumKind::conductor && d.kappa < d.n) smallest = std::min(smallest, smallest_ray_index2(d));
        }
        for (const int r : plan.camera_regions) {
            const auto& d =
                media[static_cast<std::size_t>(plan.regions[static_cast<std::size_t>(r)].medium)].dielectric;
            camera = std::max(camera, d.n * d.n);
        }
        largest_factor[w] = camera / smallest;
        plan.brightest[w] = plan.background[w] * largest_factor[w];
        group_of(w).brightest_luminance = plan.background_luminance * largest_factor[w];
    }
    for (std::size_t i = 0; i < plan.surfaces.size(); ++i) {
        const auto* role = std::get_if<EmitterRole>(&plan.surfaces[i].role);
        if (role == nullptr) continue;
        const int index = plan.surfaces[i].object;
        const Object& object = scene.objects[static_cast<std::size_t>(index)];
        const auto& emission = std::get<Emission>(object.role);
        Emitter& emitter = plan.emitters[static_cast<std::size_t>(role->emitter)];
        if (std::holds_alternative<TexturedRadiance>(emission.radiance) &&
            !std::holds_alternative<OpenSurface>(plan.surfaces[i].shape))
            return at_object({ErrorKind::input,
                              "textured emitter '" + object.name + "' is not flat",
                              {},
                              "emission.radiance.texture",
                              "textures are for rectangles and disks"},
                             scene, index);
        auto radiance = compile_radiance(emission.radiance, plan.wavelengths_nm);
        if (!radiance) return at_object(radiance.error(), scene, index);
        emitter.radiance = std::move(radiance.value().radiance);
        emitter.luminance = radiance.value().luminance;
        emitter.two_sided = emission.two_sided;
        if (!std::holds_alternative<Unpolarized>(emission.state)) {
            const int body = plan.solid_count() + static_cast<int>(i);
            POL_TRY_DONE(refuse_polarized_in_crystal(scene, plan, body, index));
        }
        if (const auto* fixed = std::get_if<FixedState>(&emission.state)) {
            const DVec3 x_axis = direction_to_world(object.to_world, fixed->x_axis);
            const auto* open = std::get_if<OpenSurface>(&plan.surfaces[i].shape);
            const bool linear = fixed->s1 != 0.0 || fixed->s2 != 0.0;
            // As for sheets: an axis within 1e-9 of the normal says nothing about directions in the surface.
            if (linear && open != nullptr && length2(cross(x_axis, open->plane().normal)) < 1e-18)
                return at_object({ErrorKind::input,
                                  "lies along the light that leaves '" + object.name +
                                      "' straight: its polarization has no direction",
                                  {},
                                  "emission.polarization.x_axis",
                                  "take an axis in the plane of the lamp, such as [1, 0, 0]"},
                                 scene, index);
            emitter.state = PlanFixedState{fixed->s1, fixed->s2, fixed->s3, x_axis};
        }
        if (const auto* plate = std::get_if<CrystalPlateState>(&emission.state)) {
            auto& compiled = std::get<PlanCrystalPlate>(emitter.state);
            compiled.passed = plate->passed;
            compiled.fresnel = plate->fresnel;
        }
        for (std::size_t w = 0; w < plan.wavelengths_nm.size(); ++w) {
            const double state = brightest_per_radiance(emission.state);
            emitter.brightest.push_back(radiance.value().largest[w] * state);
            plan.brightest[w] = std::max(plan.brightest[w], emitter.brightest[w] * largest_factor[w]);
            double& luminance = group_of(w).brightest_luminance;
            luminance = std::max(luminance, emitter.luminance * state * largest_factor[w]);
        }
    }
    return Done{};
}

}  // namespace pol
