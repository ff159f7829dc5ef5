// SPDX-License-Identifier: Apache-2.0
// Invariants of one picture and of the trees that make it.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/hypot.h"
#include "polarization/measures.h"
#include "tracer/explain.h"
#include "verify/invariants/invariants.h"

namespace pol::verify {

namespace {

/// Wavelengths at which a pixel's trees are looked at: the first, the middle and the last at every pixel, the others in
/// turn from pixel to pixel, so that the picture as a whole leaves none out.
std::vector<int> wavelengths_at(int pixel, int pixels, int wavelengths) {
    std::vector<int> chosen{0, wavelengths / 2, wavelengths - 1, pixel % wavelengths};
    for (int w = pixel + pixels; w < wavelengths; w += pixels) chosen.push_back(w);
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

/// Calls `look` with the explanations of every pixel, first sample of the picture, at its wavelengths.
template <class Look>
void for_each_tree(const SceneUnderTest& test, const Look& look) {
    const std::vector<double>& nm = test.plan->wavelengths_nm;
    const int pixels = test.image.width * test.image.height;
    const auto sample = static_cast<std::uint32_t>(test.plan->settings.first_sample());
    for (int y = 0; y < test.image.height; ++y)
        for (int x = 0; x < test.image.width; ++x)
            for (const int w : wavelengths_at(y * test.image.width + x, pixels, static_cast<int>(nm.size())))
                look(explain(*test.plan, x, y, sample, w), WorstPixel{x, y, nm[static_cast<std::size_t>(w)]});
}

}  // namespace

InvariantResult conserves_energy(const SceneUnderTest& test) {
    Tally tally;
    for_each_tree(test, [&](const Explanation& e, const WorstPixel& at) {
        const TraceResult& r = e.result;
        const double sum = r.resolved + r.absorbed + r.residual + r.tail;
        tally.add(r.failures > 0 ? std::nan("") : std::abs(sum - 1.0) / tree_rounding(r.nodes), at);
    });
    InvariantResult result = tally.result();
    if (test.statistics.failures == 0) return result;
    result.outcome = Outcome::fail;
    result.note = "samples failed: a number went bad or a solid leaked";
    return result;
}

InvariantResult is_physical(const SceneUnderTest& test) {
    Tally tally;
    for (std::size_t w = 0; w < test.image.bands.size(); ++w)
        for (int y = 0; y < test.image.height; ++y)
            for (int x = 0; x < test.image.width; ++x) {
                const Stokes<double>& s = test.image.at(w, test.image.pixel(x, y));
                const WorstPixel at{x, y, *test.image.bands[w].wavelength_nm};
                const double brightest = test.image.brightest[w];
                const double length = polarized_part(s);
                if (brightest == 0.0 || !std::isfinite(s.s0) || !std::isfinite(length)) {
                    tally.add_exact(s == Stokes<double>{}, at);
                    continue;
                }
                const double beyond = std::max({0.0, -s.s0, s.s0 - brightest, length - s.s0});
                tally.add(beyond / (tree_rounding(test.statistics.most_nodes) * brightest), at);
            }
    return tally.result();
}

InvariantResult conserves_energy_at_every_node(const SceneUnderTest& test) {
    // One interface: 60 operations, with slopes up to 1e3 close to critical angles.
    constexpr double tolerance = 1e-11;
    const auto loses_at_faces = [&] {
        for (const WavelengthGroup& group : test.plan->groups)
            for (const MediumAt& medium : group.media)
                if (medium.dielectric.is_complex()) return true;
        return false;
    }();
    // In an absorbing medium the powers of incident and reflected wave do not add (AbsorbingFresnel::mixed_s).
    const auto is_mixed = [&](const Explanation& e, const RayTreeNode& node) {
        const Region& region = test.plan->regions[static_cast<std::size_t>(node.end.region)];
        const WavelengthGroup& group = test.plan->groups[static_cast<std::size_t>(e.task.group)];
        return group.media[static_cast<std::size_t>(region.medium)].dielectric.is_complex();
    };
    Tally tally;
    for_each_tree(test, [&](const Explanation& e, const WorstPixel& at) {
        for (const RayTreeNode& node : e.tree.nodes) {
            if (node.reason || node.children.empty() || is_mixed(e, node)) continue;
            double sum = 0.0;
            bool estimated = node.estimated;
            for (const int child : node.children) {
                const RayTreeNode& next = e.tree.nodes[static_cast<std::size_t>(child)];
                sum += next.start.weight;
                estimated |= next.estimated;
            }
            if (estimated) continue;  // a random tail follows one child and stands for all
            const double change = sum / node.end.weight - 1.0;
            const bool lossless = test.plan->is_solid(node.crossing.body) && !loses_at_faces;
            tally.add((lossless ? std::abs(change) : std::max(change, 0.0)) / tolerance, at);
        }
    });
    if (tally.result().tested == 0) return does_not_apply("no ray meets an interface");
    return tally.result();
}

InvariantResult has_physical_coherence_everywhere(const SceneUnderTest& test) {
    Tally tally;
    for_each_tree(test, [&](const Explanation& e, const WorstPixel& at) {
        const double tolerance = tree_rounding(e.result.nodes);
        for (const RayTreeNode& node : e.tree.nodes) {
            if (!node.arriving) continue;
            const CoherenceMatrix<double>& j = *node.arriving;
            const double trace = j.xx + j.yy;
            if (trace == 0.0 && norm2(j.xy) == 0.0) continue;
            // Minus the smaller eigenvalue, without cancelling squares.
            const double negative = pol::hypot(0.5 * (j.xx - j.yy), abs(j.xy)) - 0.5 * trace;
            tally.add(std::max(negative, 0.0) / (tolerance * trace), at);
        }
    });
    if (tally.result().tested == 0) return does_not_apply("no light arrives anywhere");
    return tally.result();
}

InvariantResult is_the_sum_of_its_leaves(const SceneUnderTest& test) {
    Tally tally;
    for_each_tree(test, [&](const Explanation& e, const WorstPixel& at) {
        const bool one_sample = test.plan->settings.samples_per_pixel == 1;
        const bool same = !one_sample || e.sample_light == test.image.at(static_cast<std::size_t>(e.wavelength),
                                                                         test.image.pixel(at.x, at.y));
        tally.add_exact(e.exact() && same, at);
    });
    return tally.result();
}

}  // namespace pol::verify
