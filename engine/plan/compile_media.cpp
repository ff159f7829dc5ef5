// SPDX-License-Identifier: Apache-2.0
#include "plan/compile_media.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/number_text.h"
#include "core/overloaded.h"
#include "core/units.h"
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
    const auto index = index_at(matter.index, nm);
    if (!index) return index.error();
    const auto alpha = evaluate(matter.absorption, nm);
    if (!alpha) return alpha.error();
    const double total = alpha.value() + absorption_of(index.value().k, nm, unit_nm);
    const double kappa = index.value().k + extinction_of(alpha.value(), nm, unit_nm);
    return MediumAt{make_isotropic(index.value().n, kappa), {total, total}};
}

Result<MediumAt> uniaxial_at(const UniaxialMedium& matter, const DVec3& axis_world, double nm, double unit_nm) {
    const auto n_o = index_at(matter.ordinary, nm);
    if (!n_o) return n_o.error();
    const auto n_e = index_at(matter.extraordinary, nm);
    if (!n_e) return n_e.error();
    const auto alpha_o = evaluate(matter.absorption_o, nm);
    if (!alpha_o) return alpha_o.error();
    const auto alpha_e = evaluate(matter.absorption_e, nm);
    if (!alpha_e) return alpha_e.error();
    const AbsorptionAt absorption{alpha_o.value() + absorption_of(n_o.value().k, nm, unit_nm),
                                  alpha_e.value() + absorption_of(n_e.value().k, nm, unit_nm)};
    if (n_o.value().n == n_e.value().n && absorption.ordinary != absorption.extraordinary)
        return Error{ErrorKind::input,
                     "a crystal with equal indices cannot absorb its two rays differently",
                     {},
                     {},
                     "the two rays do not exist without birefringence; give absorption_o = absorption_e"};
    const double kappa = std::max(n_o.value().k + extinction_of(alpha_o.value(), nm, unit_nm),
                                  n_e.value().k + extinction_of(alpha_e.value(), nm, unit_nm));
    if (n_o.value().n == n_e.value().n) return MediumAt{make_isotropic(n_o.value().n, kappa), absorption};
    if (kappa >= strongest_crystal_extinction)
        return Error{ErrorKind::input,
                     "an extinction k = " + number_text(kappa) + " at " + number_text(nm) +
                         " nm is too much for a crystal: its faces are followed with real indices",
                     {},
                     {},
                     "k (or absorption * lambda / 4 pi) below " + number_text(strongest_crystal_extinction) +
                         "; a metal or opaque matter is written {conductor: [n, k]}"};
    return MediumAt{make_uniaxial(n_o.value().n, n_e.value().n, axis_world), absorption};
}

}  // namespace

Result<MediumAt> medium_at(const Medium& medium, const DVec3& axis_world, double wavelength_nm, double unit_nm) {
    return std::visit(Overloaded{
                          [&](const IsotropicMedium& m) { return isotropic_at(m, wavelength_nm, unit_nm); },
                          [&](const UniaxialMedium& m) { return uniaxial_at(m, axis_world, wavelength_nm, unit_nm); },
                          [&](const ConductorMedium& m) -> Result<MediumAt> {
                              const auto index = index_at(m.index, wavelength_nm);
                              if (!index) return index.error();
                              return MediumAt{make_conductor(index.value().n, index.value().k), {}};
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
