// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pol {

/// Code that plans leave out where the scene does not need it, and that compile() keeps if told to: the picture is the
/// same, and what leaving it out saves can be measured (verify/ablation). Nothing else has a reason to keep any.
struct SpareParts {
    bool crystals = false;             ///< the kernel that asks at every boundary whether there is a crystal
    bool absorption = false;           ///< the kernel that asks along every ray whether the medium absorbs
    bool tree_per_wavelength = false;  ///< even where wavelengths have the same one
    bool meshes = false;               ///< flat convex solids are met by Embree: the same hits but for rounding
    bool contacts = false;             ///< at every face the list of the faces that touch it is looked through
    bool covers = false;               ///< and that of the lamps and absorbers that lie in it
    bool every_surface = false;        ///< surfaces are looked for even from where they cannot be met
    bool start_search = false;         ///< the region that a camera ray starts in is looked for
    bool depth_limit = false;          ///< there is one, which no ray reaches
    bool halves = false;               ///< the two halves of the samples are kept apart

    friend bool operator==(const SpareParts&, const SpareParts&) = default;
};

}  // namespace pol
