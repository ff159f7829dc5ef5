// SPDX-License-Identifier: Apache-2.0
// How a picture is made. What scene files, the command line, the window and others call these values, and what they may
// be, stands in the table of setting_table.h.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace pol {

enum class SampleMode {
    point,  ///< one ray through the pixel centre, the paper's mode
    area,   ///< box filter over the pixel, quasi-random
};

/// How the picture is made unless the command line says otherwise.
struct RenderSettings {
    int width = 512;
    int height = 512;
    std::vector<double> wavelengths_nm{580.0};
    SampleMode mode = SampleMode::point;
    int samples_per_pixel = 1;
    std::optional<double> residual;  ///< largest share of a pixel that may stay untraced; none: usual_residual
    std::optional<int> depth;        ///< the paper's depth limit; none: cut by energy alone
    std::optional<int> node_budget;  ///< branches a sample may follow before its random tail; none: the usual ones
                                     ///< (scene/node_budget.h)
    std::uint64_t seed = 0;
    bool unpolarized = false;  ///< light is unpolarized again after every surface, as renderers without polarization do
    /// The samples of a pixel that make its picture have the numbers first_sample() to last_sample(). Sample 0 is the
    /// ray through the pixel's centre, which a click and the preview show. In mode area it is none of the picture's: a
    /// sample in a place that is always the same would pull the mean towards what is there.
    [[nodiscard]] int first_sample() const { return mode == SampleMode::area ? 1 : 0; }
    [[nodiscard]] int last_sample() const { return first_sample() + samples_per_pixel - 1; }

    /// Samples that are random are kept apart in two halves, whose difference tells their error.
    [[nodiscard]] bool has_halves() const { return mode == SampleMode::area && samples_per_pixel > 1; }

    /// Untraced at most, and less where a sample is followed until its maps are determined. That is only where the
    /// sample is the pixel: an area picture shows the mean of many, whose bar the bright ones make, and following each
    /// dark one would be waste.
    static constexpr double usual_residual = 1e-3;
    [[nodiscard]] double residual_in_force() const { return residual.value_or(usual_residual); }
    [[nodiscard]] bool until_determined() const { return !residual && mode == SampleMode::point; }

    /// The paper's mode: the depth alone cuts the tree. Residual and node budget can be set again afterwards.
    void cut_by_depth_alone(int limit) {
        depth = limit;
        residual = 0.0;
        node_budget.reset();
    }

    /// As it is unless something else is asked for.
    void cut_by_energy() {
        depth.reset();
        residual.reset();
        node_budget.reset();
    }

    /// The paper's depth of 9 makes 3^9 = 19683 leaves in a crystal, 4^9 = 262144 in a twin. Deeper trees than this
    /// many branches end in a random tail all the same: a branch takes 250 bytes of every thread.
    static constexpr int whole_tree = 1 << 20;

    friend bool operator==(const RenderSettings&, const RenderSettings&) = default;
};

}  // namespace pol
