// SPDX-License-Identifier: Apache-2.0
// What leaving code out saves, and that it changes nothing: every feature that the plan of a scene left out is kept,
// one at a time, and the scene is rendered with and without in turn.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "film/stokes_image.h"
#include "plan/compile.h"
#include "scene/scene.h"

namespace pol::verify {

struct AblationRequest {
    Scene scene;
    int rounds = 5;  ///< pairs of renders, with and without, for each feature
    /// The picture is made smaller, not below 8 pixels, until a render takes no longer than this, in CPU seconds; none:
    /// it is rendered as the scene says.
    std::optional<double> longest_render_s;
    /// Makes the plans; a test hands in one that makes a mistake.
    std::function<Result<std::shared_ptr<const Plan>>(const Scene&, const SpareParts&)> make_plan = compile;
};

/// A feature that was left out, kept.
struct AblationRow {
    std::string feature;     ///< as the plan names it
    std::string reason;      ///< why it is left out
    double without_s = 0.0;  ///< CPU seconds of a render, median over the rounds
    double with_s = 0.0;
    double ratio = 1.0;      ///< with / without in the same round, median over the rounds
    std::uint64_t hash = 0;  ///< of the picture
    /// Empty: the picture has to be the same to the bit. Else (flat convex solids met by Embree, which round otherwise)
    /// the share of pixels that agree within what both did not trace, and 1e-11 of the brightest light on top.
    std::optional<double> agreement;
    bool holds = false;  ///< the picture is the same; with `agreement`, in at least 99 of 100 pixels

    /// Share of the time that leaving it out saves.
    [[nodiscard]] double saved() const { return 1.0 - 1.0 / ratio; }
};

struct AblationResult {
    int width = 0;
    int height = 0;
    int samples = 0;         ///< per pixel
    std::uint64_t hash = 0;  ///< of the picture without any of the features
    std::vector<AblationRow> rows;
    /// Of the rows that are the same to the bit, all together; none if there are fewer than two.
    std::optional<AblationRow> all;
    std::vector<Feature> nothing_to_keep;  ///< left out, but no code would run for them
    std::vector<Feature> not_keepable;     ///< with the reason why compile() refuses
    bool complete = false;                 ///< false: stopped early, figures are missing

    /// Every picture is the same.
    [[nodiscard]] bool holds() const;
};

/// `done` from 0 to 1; returns false to stop.
using AblationWatch = std::function<bool(double done, const std::string& doing)>;

/// On one thread; a render shorter than 50 ms is repeated. Error: the scene's.
Result<AblationResult> ablate(const AblationRequest& request, const AblationWatch& watch);

/// Of all numbers of the light in a picture: Stokes vectors, residual, tail, failures; and its sampling error if
/// `with_sampling_error`. Planes that bands share count for each of them, so that it does not matter whether they do.
std::uint64_t picture_hash(const StokesImage& picture, bool with_sampling_error);

}  // namespace pol::verify
