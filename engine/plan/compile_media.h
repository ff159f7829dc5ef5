// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "plan/plan.h"
#include "scene/scene.h"

namespace pol {

/// Media in use, one entry per isotropic medium and per crystal orientation; entry 0 is the ambient medium.
class MediaTable {
public:
    explicit MediaTable(const Scene& scene);

    /// Entry for an object filled with `medium`, its crystal axis turned by the object's transform. Error: unknown
    /// name.
    Result<int> entry(const std::string& medium, const DMat4& to_world);

    /// Name of each entry.
    [[nodiscard]] std::vector<std::string> names() const;

    /// Whether the index of some entry is given as a function of the wavelength.
    [[nodiscard]] bool disperses() const;

    /// Optical constants of every entry at one wavelength.
    [[nodiscard]] Result<std::vector<MediumAt>> at(double wavelength_nm) const;

private:
    struct Entry {
        Medium medium;
        DVec3 axis_world{0.0, 0.0, 1.0};
    };
    const Scene& scene_;
    std::vector<Entry> entries_;
};

/// Optical constants of one medium at one wavelength, with its optic axis (if it has one) along `axis_world`.
Result<MediumAt> medium_at(const Medium& medium, const DVec3& axis_world, double wavelength_nm, double unit_nm);

}  // namespace pol
