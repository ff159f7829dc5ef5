// SPDX-License-Identifier: Apache-2.0
// The kernel for one flat-faced solid or ball of glass (plan/lanes.h): samples side by side, each with the bits that
// the scalar kernel gives it (trace.h).
//
// Of every sample one branch is in flight. In a convex solid no more is open at a time: what leaves it meets lamps,
// black surfaces or the background, and ends at once. So a sample does not depend on which others share the registers.
// What lanes do not know goes on in the scalar kernel from where it stands: a random tail, a failure.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plan/plan.h"
#include "tracer/lane_step.h"
#include "tracer/observers.h"
#include "tracer/trace.h"
#include "tracer/with_kernel.h"

namespace pol {

/// Samples first_sample .. first_sample + samples - 1 of `pixels` pixels of a tile, row by row, from `first_pixel` on.
struct LaneSamples {
    int x0 = 0;
    int y0 = 0;
    int tile_width = 1;
    std::span<const std::uint32_t> listed;  ///< which pixels of the tile first_pixel counts; empty: all
    std::size_t first_pixel = 0;
    std::size_t pixels = 0;
    std::uint32_t first_sample = 0;
    std::uint32_t samples = 0;
    int group = 0;
};

/// absorbing: as for Tracer.
template <bool absorbing>
class LaneTracer {
public:
    /// The plan must outlive the tracer. Requires: why_not_in_lanes(plan) is empty.
    explicit LaneTracer(PlanForKernel<false, absorbing> plan);
    LaneTracer(const LaneTracer&) = delete;
    LaneTracer& operator=(const LaneTracer&) = delete;

    /// False: `keep_going` has said no; it is asked after every step. Afterwards sample s of pixel p has number p *
    /// samples + s in the functions below.
    bool trace(const LaneSamples& samples, const KeepGoing& keep_going);

    [[nodiscard]] const TraceResult& result(std::size_t number) const { return results_[number]; }
    /// One Stokes vector per wavelength of the group.
    [[nodiscard]] std::span<const Stokes<double>> light(std::size_t number) const {
        return std::span(light_).subspan(number * wavelengths_, wavelengths_);
    }

private:
    static constexpr int width = RayBlock::size;

    /// An open branch in the solid that waits for a lane.
    struct Waiting {
        double value[22];
        int facet = -1;
        std::size_t sample = 0;
    };

    /// A sample's pixel, and which of its samples it is.
    struct Place {
        int x = 0;
        int y = 0;
        std::uint32_t sample = 0;
    };

    [[nodiscard]] Place place(std::size_t number) const;
    [[nodiscard]] TraceTask task(std::size_t number) const;
    /// To the points hits_ and across the boundary there.
    void cross(const LaneBranches& from, double side, const MediumAt& from_medium, const MediumAt& to_medium,
               LaneBranches& reflected, LaneBranches& transmitted);
    void begin_samples();
    void enter_solid(std::size_t first, const bool (&enters)[width]);
    void follow_inside();
    /// The branch in `lane` goes on inside; true if it may.
    [[nodiscard]] bool goes_on(const LaneBranches& branches, int lane, int facet, std::size_t sample);
    /// A branch outside ends on what it sees.
    void end_outside(const LaneBranches& branches, int lane, int left_facet, std::size_t sample);
    void hand_over(const LaneBranches& branches, int lane, int facet, std::size_t sample);
    void finish(std::size_t sample);
    [[nodiscard]] Node node_of(const LaneBranches& branches, int lane, int region, int facet) const;
    [[nodiscard]] std::span<Stokes<double>> sums(std::size_t sample) {
        return std::span(light_).subspan(sample * wavelengths_, wavelengths_);
    }

    const Plan& plan_;
    const Sphere* ball_;               ///< the solid, or null
    std::optional<PlaneScan> planes_;  ///< of the solid, if it is no ball
    std::vector<const OpenSurface*> surfaces_;
    Patient observer_;
    Tracer<false, absorbing, Patient> scalar_;

    LaneSamples samples_{};
    const WavelengthGroup* group_ = nullptr;
    std::size_t wavelengths_ = 0;
    MediumAt outside_medium_{};
    MediumAt inside_medium_{};
    bool absorbs_ = false;  ///< the solid does, in this group
    std::size_t count_ = 0;
    std::size_t next_ = 0;  ///< the first sample that has not begun
    std::vector<TraceResult> results_;
    std::vector<Stokes<double>> light_;
    std::vector<Stokes<double>> emitted_;
    std::vector<Waiting> waiting_;

    int active_ = 0;
    std::size_t sample_[width]{};
    int facet_[width]{};  ///< just left by the branch in this lane; PlaneScan::no_ray: the lane is free
    HitBlock hits_{};
    LaneSights sights_{};
    double reaches_[width]{};
    double absorbed_[2][width]{};  ///< on the way to hits_, and there
    LaneBranches camera_{};
    LaneBranches in_flight_[2]{};
    LaneBranches* inside_ = &in_flight_[0];  ///< the branches in flight
    LaneBranches* reflected_ = &in_flight_[1];
    LaneBranches outside_{};  ///< what ends in this step
    LaneBranches begun_{};    ///< what goes into the solid
};

}  // namespace pol
