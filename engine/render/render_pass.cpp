// SPDX-License-Identifier: Apache-2.0
#include "render/render_pass.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "plan/lanes.h"
#include "tracer/lane_tracer.h"
#include "tracer/observers.h"
#include "tracer/sample_task.h"
#include "tracer/trace.h"

namespace pol {

namespace {

struct SilentUntilCancelled : Silent {
    const std::atomic<bool>* flag = nullptr;
    [[nodiscard]] bool cancelled() const { return flag->load(std::memory_order_relaxed); }
};

template <bool anisotropic, bool absorbing>
class KernelPass final : public PassTracer {
public:
    KernelPass(PlanForKernel<anisotropic, absorbing> plan, Follow follow)
        : plan_(plan.plan()), tracer_(plan, observer_) {
        if constexpr (!anisotropic)
            if (follow == Follow::side_by_side && why_not_in_lanes(plan_).empty())
                lanes_ = std::make_unique<LaneTracer<absorbing>>(plan);
    }

    RenderStatistics trace(const SampleSpan& samples, const std::atomic<bool>& cancelled, TileBuffer& buffer) override {
        observer_.flag = &cancelled;
        const std::size_t pixels = buffer.pixel_count();
        const std::size_t wavelengths = plan_.wavelengths_nm.size();
        const std::size_t groups = plan_.groups.size();
        buffer.samples = samples.end - samples.begin;
        buffer.stokes.assign(pixels * wavelengths, {});
        const bool halved = plan_.settings.has_halves() || plan_.kept.halves;
        buffer.odd_minus_even.assign(halved ? pixels * wavelengths : 0, {});
        buffer.residual.assign(pixels * groups, 0.0);
        buffer.tail.assign(pixels * groups, 0.0);
        buffer.failures.assign(pixels, 0);

        RenderStatistics statistics;
        if (lanes_)
            trace_side_by_side(samples, cancelled, buffer, statistics);
        else
            trace_one_by_one(samples, cancelled, buffer, statistics);
        return statistics;
    }

    void preview(const PreviewGrid& grid, const std::atomic<bool>& cancelled, PreviewStrip& strip) override {
        observer_.flag = &cancelled;
        const auto columns = static_cast<std::size_t>(grid.columns);
        const std::size_t wavelengths = plan_.wavelengths_nm.size();
        const std::size_t groups = plan_.groups.size();
        strip.stride = grid.stride;
        strip.stokes.assign(columns * wavelengths, {});
        strip.residual.assign(columns * groups, 0.0);
        strip.tail.assign(columns * groups, 0.0);
        const int y = std::min(strip.row * grid.stride + grid.stride / 2, plan_.settings.height - 1);
        for (std::size_t column = 0; column < columns; ++column) {
            if (cancelled.load(std::memory_order_relaxed)) return;
            const int x = std::min(static_cast<int>(column) * grid.stride + grid.stride / 2, plan_.settings.width - 1);
            for (std::size_t group = 0; group < groups; ++group) {
                TraceTask task = sample_task(plan_, x, y, 0, static_cast<int>(group));
                task.residual = std::max(task.residual, preview_residual);
                task.until_determined = false;
                task.node_budget = std::min(task.node_budget, preview_node_budget);
                const TraceResult result = trace_light(task);
                add_light(group, light_, &strip.stokes[column * wavelengths], 1.0);
                strip.residual[column * groups + group] = result.residual;
                strip.tail[column * groups + group] = result.tail;
            }
        }
    }

private:
    void trace_one_by_one(const SampleSpan& samples, const std::atomic<bool>& cancelled, TileBuffer& buffer,
                          RenderStatistics& statistics) {
        for (std::size_t i = 0; i < buffer.pixel_count(); ++i) {
            if (cancelled.load(std::memory_order_relaxed)) return;
            const auto pixel = static_cast<int>(buffer.pixel(i));
            const int x = buffer.rect.x0 + pixel % buffer.rect.width();
            const int y = buffer.rect.y0 + pixel / buffer.rect.width();
            for (std::uint32_t index = samples.begin; index < samples.end; ++index) {
                const auto sample = static_cast<std::uint32_t>(plan_.settings.first_sample()) + index;
                for (std::size_t group = 0; group < plan_.groups.size(); ++group) {
                    const TraceResult result = trace_light(sample_task(plan_, x, y, sample, static_cast<int>(group)));
                    add_sample(i, group, index, result, light_, buffer, statistics);
                }
                ++statistics.samples;
            }
        }
    }

    /// In parts, so that the results of their samples stay in the cache until they are summed in order.
    void trace_side_by_side(const SampleSpan& span, const std::atomic<bool>& cancelled, TileBuffer& buffer,
                            RenderStatistics& statistics) {
        constexpr std::size_t samples_at_once = 2048;
        const std::size_t pixels = buffer.pixel_count();
        const std::size_t part = std::max<std::size_t>(1, samples_at_once / buffer.samples);
        const KeepGoing keep_going = [&](std::size_t) { return !cancelled.load(std::memory_order_relaxed); };
        LaneSamples samples;
        samples.x0 = buffer.rect.x0;
        samples.y0 = buffer.rect.y0;
        samples.tile_width = buffer.rect.width();
        samples.listed = buffer.pixels;
        samples.first_sample = static_cast<std::uint32_t>(plan_.settings.first_sample()) + span.begin;
        samples.samples = buffer.samples;
        for (std::size_t pixel = 0; pixel < pixels; pixel += part) {
            samples.first_pixel = pixel;
            samples.pixels = std::min(part, pixels - pixel);
            for (std::size_t group = 0; group < plan_.groups.size(); ++group) {
                samples.group = static_cast<int>(group);
                if (!lanes_->trace(samples, keep_going)) return;
                std::size_t number = 0;
                for (std::size_t i = 0; i < samples.pixels; ++i)
                    for (std::uint32_t index = span.begin; index < span.end; ++index, ++number)
                        add_sample(pixel + i, group, index, lanes_->result(number), lanes_->light(number), buffer,
                                   statistics);
            }
            statistics.samples += samples.pixels * samples.samples;
        }
    }

    void add_sample(std::size_t pixel, std::size_t group, std::uint32_t index, const TraceResult& result,
                    std::span<const Stokes<double>> light, TileBuffer& buffer, RenderStatistics& statistics) const {
        const std::size_t wavelengths = plan_.wavelengths_nm.size();
        const std::size_t groups = plan_.groups.size();
        add_light(group, light, &buffer.stokes[pixel * wavelengths], 1.0);
        if (!buffer.odd_minus_even.empty())
            add_light(group, light, &buffer.odd_minus_even[pixel * wavelengths], index % 2 == 1 ? 1.0 : -1.0);
        buffer.residual[pixel * groups + group] += result.residual;
        buffer.tail[pixel * groups + group] += result.tail;
        buffer.failures[pixel] += result.failures;
        statistics.nodes += result.nodes;
        statistics.failures += result.failures;
        statistics.most_nodes = std::max(statistics.most_nodes, result.nodes);
        const double defect = std::abs(result.resolved + result.absorbed + result.residual + result.tail - 1.0);
        statistics.worst_energy_defect = std::max(statistics.worst_energy_defect, defect);
    }

    /// Leaves the light of the sample in light_, one Stokes vector per wavelength of the group.
    TraceResult trace_light(const TraceTask& task) {
        light_.assign(plan_.groups[static_cast<std::size_t>(task.group)].wavelengths.size(), {});
        return tracer_.trace(task, light_);
    }

    /// Adds the light of a sample, times `sign`, to the sums of a pixel.
    void add_light(std::size_t group, std::span<const Stokes<double>> light, Stokes<double>* sums, double sign) const {
        const std::vector<int>& members = plan_.groups[group].wavelengths;
        for (std::size_t i = 0; i < members.size(); ++i) sums[members[i]] += sign * light[i];
    }

    const Plan& plan_;
    SilentUntilCancelled observer_;
    Tracer<anisotropic, absorbing, SilentUntilCancelled> tracer_;
    std::vector<Stokes<double>> light_;
    std::unique_ptr<LaneTracer<absorbing>> lanes_;  ///< null: one branch at a time
};

}  // namespace

std::unique_ptr<PassTracer> make_pass_tracer(const Plan& plan, Follow follow) {
    return with_kernel(plan, [follow](auto plan_for_kernel) -> std::unique_ptr<PassTracer> {
        return std::make_unique<decltype(KernelPass(plan_for_kernel, follow))>(plan_for_kernel, follow);
    });
}

}  // namespace pol
