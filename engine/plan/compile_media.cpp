// SPDX-License-Identifier: Apache-2.0
#include "plan/compile_media.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/number_text.h"
#include "core/overloaded.h"
#include "core/result.h"
#include "core/units.h"
#include "scene/medium_fields.h"
#include "scene/place.h"
#include "spectrum/illuminant.h"

namespace pol {

namespace {

/// Extinction k as absorption coefficient: alpha = 4 pi k / lambda.
double absorption_of(double k, double wavelength_nm, double unit_nm) {
    return 4.0 * pi * k / wavelength_nm * unit_nm;
}

/// And back.
double extinction_of(double alpha, double wavelength_nm, double unit_nm) {
    return alpha * wavelength_nm / (4.0 * pi * unit_nm);
}

Result<MediumAt> isotropic_at(const IsotropicMedium& matter, double nm, double unit_nm) {
    POL_TRY(const auto index, index_at(matter.index, nm));
    POL_TRY(const auto alpha, evaluate(matter.absorption, nm));
    const double total = alpha + absorption_of(index.k, nm, unit_nm);
    const double kappa = index.k + extinction_of(alpha, nm, unit_nm);
    return MediumAt{make_isotropic(index.n, kappa), {total, total}};
}

Result<MediumAt> uniaxial_at(const UniaxialMedium& matter, const DVec3& axis_world, double nm, double unit_nm) {
    POL_TRY(const auto n_o, index_at(matter.ordinary, nm));
    POL_TRY(const auto n_e, index_at(matter.extraordinary, nm));
    POL_TRY(const auto alpha_o, evaluate(matter.absorption_o, nm));
    POL_TRY(const auto alpha_e, evaluate(matter.absorption_e, nm));
    const AbsorptionAt absorption{alpha_o + absorption_of(n_o.k, nm, unit_nm),
                                  alpha_e + absorption_of(n_e.k, nm, unit_nm)};
    if (n_o.n == n_e.n && absorption.ordinary != absorption.extraordinary)
        return Error{ErrorKind::input,
                     "a crystal with equal indices cannot absorb its two rays differently",
                     {},
                     {},
                     "the two rays do not exist without birefringence; give absorption_o = absorption_e"};
    const double kappa =
        std::max(n_o.k + extinction_of(alpha_o, nm, unit_nm), n_e.k + extinction_of(alpha_e, nm, unit_nm));
    if (n_o.n == n_e.n) return MediumAt{make_isotropic(n_o.n, kappa), absorption};
    if (kappa >= strongest_crystal_extinction)
        return Error{ErrorKind::input,
                     "an extinction k = " + number_text(kappa) + " at " + number_text(nm) +
                         " nm is too much for a crystal: its faces are followed with real indices",
                     {},
                     {},
                     "k (or absorption * lambda / 4 pi) below " + number_text(strongest_crystal_extinction) +
                         "; a metal or opaque matter is written {conductor: [n, k]}"};
    return MediumAt{make_uniaxial(n_o.n, n_e.n, axis_world), absorption};
}

}  // namespace

Result<MediumAt> medium_at(const Medium& medium, const DVec3& axis_world, double wavelength_nm, double unit_nm) {
    return std::visit(Overloaded{
                          [&](const IsotropicMedium& m) { return isotropic_at(m, wavelength_nm, unit_nm); },
                          [&](const UniaxialMedium& m) { return uniaxial_at(m, axis_world, wavelength_nm, unit_nm); },
                          [&](const ConductorMedium& m) -> Result<MediumAt> {
                              POL_TRY(const auto index, index_at(m.index, wavelength_nm));
                              return MediumAt{make_conductor(index.n, index.k), {}};
                          },
                      },
                      medium.matter);
}

MediaTable::MediaTable(const Scene& scene) : scene_(scene) {
    if (scene.ambient.empty()) entries_.push_back({Medium{"vacuum", IsotropicMedium{}, {}}, {}});
}

Result<int> MediaTable::entry(const std::string& name, const DMat4& to_world) {
    const auto found =
        std::find_if(scene_.media.begin(), scene_.media.end(), [&](const Medium& m) { return m.name == name; });
    if (found == scene_.media.end()) return Error{ErrorKind::input, "unknown medium '" + name + "'", {}, "medium", {}};
    const DVec3 any_axis{0.0, 0.0, 1.0};
    const DVec3 axis = std::visit(Overloaded{
                                      [&](const IsotropicMedium&) { return any_axis; },
                                      [&](const UniaxialMedium& crystal) {
                                          return crystal.axis_space == AxisSpace::object
                                                     ? direction_to_world(to_world, crystal.axis)
                                                     : unit(crystal.axis);
                                      },
                                      [&](const ConductorMedium&) { return any_axis; },
                                  },
                                  found->matter);
    for (std::size_t i = 0; i < entries_.size(); ++i)
        if (entries_[i].medium.name == name && entries_[i].axis_world == axis) return static_cast<int>(i);
    entries_.push_back({*found, axis});
    return static_cast<int>(entries_.size()) - 1;
}

std::vector<std::string> MediaTable::names() const {
    std::vector<std::string> names;
    for (const Entry& entry : entries_) names.push_back(entry.medium.name);
    return names;
}

bool MediaTable::disperses() const {
    return std::any_of(entries_.begin(), entries_.end(), [](const Entry& entry) {
        bool any = false;
        for_each_field(entry.medium.matter,
                       Overloaded{[&](const auto&, const RefractiveIndex& index) {
                                      any = any || std::visit(Overloaded{[](const ConstantIndex&) { return false; },
                                                                         [](const DispersiveIndex&) { return true; }},
                                                              index);
                                  },
                                  [](const auto&, const auto&) {}});
        return any;
    });
}

Result<std::vector<MediumAt>> MediaTable::at(double wavelength_nm) const {
    std::vector<MediumAt> media;
    for (const Entry& entry : entries_) {
        auto medium = medium_at(entry.medium, entry.axis_world, wavelength_nm, scene_.unit_nm);
        if (!medium) {
            Error error = medium.error();
            if (error.field.empty()) error.field = "media." + entry.medium.name;
            return at_place(std::move(error), scene_, entry.medium.place);
        }
        media.push_back(medium.value());
    }
    return media;
}

}  // namespace pol
