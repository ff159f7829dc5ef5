// SPDX-License-Identifier: Apache-2.0
#include "verify/invariants/invariants.h"

#include <cmath>
#include <limits>
#include <utility>

#include "core/result.h"
#include "plan/compile.h"
#include "render/render_to_end.h"

namespace pol::verify {

Result<SceneUnderTest> under_test(const Scene& scene) {
    POL_TRY(auto plan, compile(scene));
    FinishedRender render = render_to_end(plan, {}, {.threads = 1});
    return SceneUnderTest{scene, std::move(plan), std::move(render.picture), render.progress.statistics};
}

std::string_view outcome_text(Outcome outcome) {
    switch (outcome) {
        case Outcome::pass:
            return "pass";
        case Outcome::fail:
            return "FAIL";
        case Outcome::does_not_apply:
            return "does not apply";
    }
    return "";
}

const std::vector<Invariant>& invariants() {
    static const std::vector<Invariant> all{
        {"energy", "resolved, absorbed and open light of every sample add up to 1", conserves_energy},
        {"physical", "0 <= |s| <= S0 <= the brightest light, at every pixel", is_physical},
        {"energy at nodes", "what leaves an interface is what came to it, or less where it absorbs",
         conserves_energy_at_every_node},
        {"coherence", "the coherence matrix on every branch is positive semidefinite",
         has_physical_coherence_everywhere},
        {"leaves", "the leaves of a pixel's tree add up to the pixel, to the last bit", is_the_sum_of_its_leaves},
        {"furnace", "in uniform unpolarized surroundings everything is invisible: P = 0", is_invisible_in_a_furnace},
        {"threads and tiles", "the picture is the same to the last bit for any threads and tiles",
         is_the_same_for_any_threads_and_tiles},
        {"place and size", "the whole scene moved, turned or scaled looks the same",
         looks_the_same_moved_turned_and_scaled},
        {"mirror", "in a mirror S2 and S3 change sign, S0 and S1 do not", flips_s2_and_s3_in_a_mirror},
        {"isotropic twin", "a crystal with n_e = n_o is glass, to the last bit", is_glass_with_equal_indices},
        {"reciprocity", "a path and its reverse have transposed amplitudes", is_reciprocal},
        {"error bars", "a deeper picture lies within the error bars of a shallow one", has_true_error_bars},
    };
    return all;
}

double tree_rounding(double nodes) {
    return std::numeric_limits<double>::epsilon() * (nodes + 40.0 * 60.0);
}

void Tally::add(double deviation, const WorstPixel& at) {
    constexpr double broken = std::numeric_limits<double>::infinity();
    const double size = std::isnan(deviation) ? broken : deviation;
    ++sum_.tested;
    if (size > 1.0) ++sum_.violated;
    if (sum_.worst_pixel && size <= sum_.worst) return;
    sum_.worst = size;
    sum_.worst_pixel = at;
}

void Tally::add_exact(bool holds, const WorstPixel& at) {
    add(holds ? 0.0 : std::numeric_limits<double>::infinity(), at);
}

InvariantResult Tally::result(std::size_t allowed, std::string note) const {
    InvariantResult result = sum_;
    result.allowed = allowed;
    result.outcome = result.tested > 0 && result.violated <= allowed ? Outcome::pass : Outcome::fail;
    result.note = std::move(note);
    return result;
}

InvariantResult does_not_apply(std::string why) {
    InvariantResult result;
    result.outcome = Outcome::does_not_apply;
    result.note = std::move(why);
    return result;
}

}  // namespace pol::verify
