// SPDX-License-Identifier: Apache-2.0
// Two pictures of one view, ours and another's: which change of convention makes the one from the other?
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/convention_fit.h"
#include "compare/stokes_plane.h"
#include "polarization/stokes_convention.h"

namespace pol::compare {

enum class Finding {
    same_convention,
    explained,         ///< by the fit
    disagree,          ///< no convention explains it: the polarizations differ
    another_picture,   ///< S0 is not even alike
    unpolarized,       ///< neither is polarized above its noise
    one_unpolarized,   ///< only one of them is
    not_measured,      ///< no component besides S0 is known in both
    nothing_in_common  ///< sizes that do not fit, or hardly a box in which both have light
};
/// "same convention", "explained", "no convention explains it", ...
std::string_view name_of(Finding finding);

/// How B keeps S1 to S3.
enum class Coding {
    plain,
    offset,       ///< 0.5 + s/2, for numbers that have no sign
    ratio_offset  ///< 0.5 + s/(2 S0)
};
/// "s", "0.5 + s/2", "0.5 + s/(2 S0)".
std::string_view name_of(Coding coding);

/// What was found. A is ours, B the other one: what is said of signs, turns and scale makes B from A.
struct ConventionVerdict {
    Finding finding = Finding::nothing_in_common;
    ConventionFit fit;           ///< the simplest one within 5 % of the best; default where there is none
    std::vector<Geometry> tied;  ///< geometries that fit as well, `fit.geometry` among them: a symmetric scene
    StokesComponents judged;     ///< S1, S2, S3 that both have
    StokesComponents undecided;  ///< judged, but below the noise
    /// Unless plain, everything here is of B's numbers without it, and they are `explained` or nothing is.
    Coding coding = Coding::plain;
    std::optional<Clip> clip;     ///< everything else is of the boxes that have no part in it
    std::optional<double> gamma;  ///< as s0_gamma
    double s0_correlation = 0.0;
    double polarization_residual = 0.0;  ///< sqrt of what is left over, S1 to S3, relative to B
    /// sqrt(sum |dC|^2 / sum |C|^2) after the fit, C the coherence matrices of the boxes, of judged components and S0.
    double difference = 0.0;
    double floor = 0.0;  ///< standard error of a component below which nothing is told, relative to S0
    int boxes = 0;       ///< that both have light in
};

/// `pixel_tangent` as in fit_conventions.
ConventionVerdict diagnose(const StokesPlane& a, const StokesPlane& b,
                           std::optional<double> pixel_tangent = std::nullopt);

/// A change of signs that has a name.
struct SignChange {
    std::array<int, 3> signs;
    std::string_view name;  ///< "the other handedness"
    std::string_view who;   ///< a clause: "it uses the source's view, or the handedness of radio and IEEE"
};
/// All of them, the simplest first; the first changes nothing.
const std::array<SignChange, 8>& sign_changes();

/// Those that differ from the fit in undecided or unmeasured components only, the simplest first. Empty unless the fit
/// is one of signs alone.
std::vector<SignChange> fitting_sign_changes(const ConventionVerdict& verdict);

/// What B's numbers have to be taken to be written in, so that they are in A's convention, if `current` is what they
/// were taken for. Where S3 is not decided, its sign is that of the simplest change. Empty if nothing has to change, or
/// if no convention can say it: numbers with an offset, another order or picture symmetry, a frame that depends on the
/// pixel, no explanation.
std::optional<StokesConvention> adoptable(const ConventionVerdict& verdict, const StokesConvention& current);

/// The verdict in words for the user: what B has, who writes so, what is not decided, whether S0 is alike. `current` as
/// in adoptable().
std::string sentence(const ConventionVerdict& verdict, const StokesConvention& current);

}  // namespace pol::compare
