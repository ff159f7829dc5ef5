// SPDX-License-Identifier: Apache-2.0
// What holds for every scene, whatever is in it: conservation, symmetry, determinism, and error bars that tell the
// truth. `polariscope check SCENE` runs the list.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "film/stokes_image.h"
#include "plan/plan.h"
#include "render/render_progress.h"
#include "scene/scene.h"

namespace pol::verify {

/// A scene with its plan and its picture, which all invariants look at.
struct SceneUnderTest {
    Scene scene;
    std::shared_ptr<const Plan> plan;
    StokesImage image;
    RenderStatistics statistics;
};

/// Makes the picture. Error: the scene does not compile.
Result<SceneUnderTest> under_test(const Scene& scene);

enum class Outcome {
    pass,
    fail,
    does_not_apply,
};
/// "pass", "FAIL", "does not apply".
std::string_view outcome_text(Outcome outcome);

/// Where an invariant is worst: a pixel of the picture, and the wavelength.
struct WorstPixel {
    int x = 0;
    int y = 0;
    double wavelength_nm = 0.0;
};

struct InvariantResult {
    Outcome outcome = Outcome::fail;
    std::size_t tested = 0;    ///< numbers compared
    std::size_t violated = 0;  ///< numbers beyond the tolerance
    std::size_t allowed = 0;   ///< numbers that may be beyond it
    double worst = 0.0;        ///< largest deviation, as a share of the tolerance
    std::optional<WorstPixel> worst_pixel;
    std::string note;  ///< why it does not apply, or what the numbers cannot say
};

struct Invariant {
    std::string name;      ///< "energy"
    std::string sentence;  ///< what holds
    std::function<InvariantResult(const SceneUnderTest&)> check;
};

/// In the order in which a report shows them. Those that look at trees do so at the first, middle and last wavelength
/// of every pixel, and at the others in turn from pixel to pixel.
const std::vector<Invariant>& invariants();

// One function each.
InvariantResult conserves_energy(const SceneUnderTest& test);
InvariantResult is_physical(const SceneUnderTest& test);
InvariantResult conserves_energy_at_every_node(const SceneUnderTest& test);
InvariantResult has_physical_coherence_everywhere(const SceneUnderTest& test);
InvariantResult is_the_sum_of_its_leaves(const SceneUnderTest& test);
InvariantResult is_invisible_in_a_furnace(const SceneUnderTest& test);
InvariantResult is_the_same_for_any_threads_and_tiles(const SceneUnderTest& test);
InvariantResult looks_the_same_moved_turned_and_scaled(const SceneUnderTest& test);
InvariantResult flips_s2_and_s3_in_a_mirror(const SceneUnderTest& test);
InvariantResult is_glass_with_equal_indices(const SceneUnderTest& test);
InvariantResult is_reciprocal(const SceneUnderTest& test);
InvariantResult has_true_error_bars(const SceneUnderTest& test);

/// Rounding of a sum over a tree, relative to the light it stands for: each of `nodes` additions rounds a sum that is
/// at most 1, and the weights of the leaves, 1 in all, carry the rounding of some 60 operations per surface on their
/// way (40 surfaces).
double tree_rounding(double nodes);

/// Counts numbers and how far they are from where they must be.
class Tally {
public:
    /// One number, `deviation` as a share of its tolerance. NaN is a violation.
    void add(double deviation, const WorstPixel& at);
    /// Something that must be exactly so.
    void add_exact(bool holds, const WorstPixel& at);
    /// Fails if more than `allowed` numbers are beyond their tolerance, or if there were none.
    [[nodiscard]] InvariantResult result(std::size_t allowed = 0, std::string note = {}) const;

private:
    InvariantResult sum_;
};

InvariantResult does_not_apply(std::string why);

}  // namespace pol::verify
