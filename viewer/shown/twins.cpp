// SPDX-License-Identifier: Apache-2.0
#include "viewer/shown/twins.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <variant>
#include <vector>

#include "core/overloaded.h"
#include "core/result.h"
#include "spectrum/illuminant.h"
#include "spectrum/refractive_index.h"

namespace pol {

namespace {

bool is_crystal(const Medium& medium) {
    return crystal_in(medium.matter) != nullptr;
}

bool is_constant(const Spectrum& spectrum) {
    return std::visit(
        Overloaded{[](const ConstantSpectrum&) { return true; }, [](const TabulatedSpectrum&) { return false; },
                   [](const D65Spectrum&) { return false; }},
        spectrum);
}

/// (2 n_o^2 + n_e^2)/3 at each wavelength; of one record if nothing varies.
Result<RefractiveIndex> mean_index(const UniaxialMedium& crystal, const std::vector<double>& wavelengths_nm) {
    IndexTable table;
    for (const double nm : wavelengths_nm) {
        POL_TRY(const auto o, index_at(crystal.ordinary, nm));
        POL_TRY(const auto e, index_at(crystal.extraordinary, nm));
        const double n_o = o.n;
        const double n_e = e.n;
        table.wavelength_nm.push_back(nm);
        table.value.push_back(std::sqrt((2.0 * n_o * n_o + n_e * n_e) / 3.0));
    }
    const bool varies = !(is_constant(crystal.ordinary) && is_constant(crystal.extraordinary));
    if (!varies || wavelengths_nm.size() == 1) return RefractiveIndex{ConstantIndex{{table.value[0], 0.0}}};
    return RefractiveIndex{DispersiveIndex{{}, std::move(table), {}}};
}

Result<Spectrum> mean_absorption(const UniaxialMedium& crystal, const std::vector<double>& wavelengths_nm) {
    TabulatedSpectrum table;
    for (const double nm : wavelengths_nm) {
        POL_TRY(const auto o, evaluate(crystal.absorption_o, nm));
        POL_TRY(const auto e, evaluate(crystal.absorption_e, nm));
        table.wavelength_nm.push_back(nm);
        table.value.push_back((2.0 * o + e) / 3.0);
    }
    const bool varies = !(is_constant(crystal.absorption_o) && is_constant(crystal.absorption_e));
    if (!varies || wavelengths_nm.size() == 1) return Spectrum{ConstantSpectrum{table.value[0]}};
    return Spectrum{std::move(table)};
}

Result<Matter> glass_for(const UniaxialMedium& crystal, const std::vector<double>& wavelengths_nm) {
    POL_TRY(auto index, mean_index(crystal, wavelengths_nm));
    POL_TRY(auto absorption, mean_absorption(crystal, wavelengths_nm));
    return Matter{IsotropicMedium{std::move(index), std::move(absorption)}};
}

Result<Matter> without_birefringence(const Matter& matter, const std::vector<double>& wavelengths_nm) {
    return std::visit(Overloaded{
                          [](const IsotropicMedium& glass) -> Result<Matter> { return Matter{glass}; },
                          [&](const UniaxialMedium& crystal) { return glass_for(crystal, wavelengths_nm); },
                          [](const ConductorMedium& metal) -> Result<Matter> { return Matter{metal}; },
                      },
                      matter);
}

/// The virtual plates of emitters keep their crystal under another name.
void keep_plates(Scene& scene, const Medium& crystal) {
    const std::string kept = crystal.name + " (plate)";
    bool is_used = false;
    for (Object& object : scene.objects) {
        auto* emission = std::get_if<Emission>(&object.role);
        auto* plate = emission != nullptr ? std::get_if<CrystalPlateState>(&emission->state) : nullptr;
        if (plate == nullptr || plate->medium != crystal.name) continue;
        plate->medium = kept;
        is_used = true;
    }
    if (!is_used) return;
    scene.media.push_back(crystal);
    scene.media.back().name = kept;
}

}  // namespace

Result<Scene> isotropic_twin(const Scene& scene) {
    if (std::none_of(scene.media.begin(), scene.media.end(), is_crystal))
        return Error{ErrorKind::usage, "the scene has no crystal to replace by glass"};
    Scene twin = scene;
    for (std::size_t i = 0; i < scene.media.size(); ++i) {
        POL_TRY(auto matter, without_birefringence(scene.media[i].matter, scene.render.wavelengths_nm));
        if (is_crystal(scene.media[i])) keep_plates(twin, scene.media[i]);
        twin.media[i].matter = std::move(matter);
    }
    return twin;
}

Scene unpolarized_twin(Scene scene) {
    scene.render.unpolarized = true;
    return scene;
}

std::string twin_name(const std::string& name, const std::string& kind) {
    return std::filesystem::path(name).stem().string() + "-" + kind + ".yaml";
}

}  // namespace pol
