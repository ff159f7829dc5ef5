// SPDX-License-Identifier: Apache-2.0
#include "render/render_pass.h"

#include <algorithm>
#include <cmath>

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
    explicit KernelPass(const Plan& plan) : plan_(plan), tracer_(plan, observer_) {}

    RenderStatistics trace(std::uint32_t first, std::uint32_t last, const std::atomic<bool>& cancelled,
                           TileBuffer& buffer) override {
        observer_.flag = &cancelled;
        const std::size_t pixels = buffer.rect.pixel_count();
        const std::size_t wavelengths = plan_.wavelengths_nm.size();
        const std::size_t groups = plan_.groups.size();
        buffer.samples = last - first;
        buffer.stokes.assign(pixels * wavelengths, {});
        buffer.residual.assign(pixels * groups, 0.0);
        buffer.tail.assign(pixels * groups, 0.0);
        buffer.failures.assign(pixels, 0);

        RenderStatistics statistics;
        std::size_t pixel = 0;
        for (int y = buffer.rect.y0; y < buffer.rect.y1; ++y) {
            for (int x = buffer.rect.x0; x < buffer.rect.x1; ++x, ++pixel) {
                if (cancelled.load(std::memory_order_relaxed)) return statistics;
                for (std::uint32_t sample = first; sample < last; ++sample) {
                    for (std::size_t group = 0; group < groups; ++group) {
                        const TraceResult result = trace_group(x, y, sample, group, buffer, pixel);
                        buffer.residual[pixel * groups + group] += result.residual;
                        buffer.tail[pixel * groups + group] += result.tail;
                        buffer.failures[pixel] += result.failures;
                        statistics.nodes += result.nodes;
                        statistics.failures += result.failures;
                        statistics.most_nodes = std::max(statistics.most_nodes, result.nodes);
                        const double defect =
                            std::abs(result.resolved + result.absorbed + result.residual + result.tail - 1.0);
                        statistics.worst_energy_defect = std::max(statistics.worst_energy_defect, defect);
                    }
                    ++statistics.samples;
                }
            }
        }
        return statistics;
    }

private:
    TraceResult trace_group(int x, int y, std::uint32_t sample, std::size_t group, TileBuffer& buffer,
                            std::size_t pixel) {
        const std::vector<int>& members = plan_.groups[group].wavelengths;
        light_.assign(members.size(), {});
        const TraceResult result = tracer_.trace(sample_task(plan_, x, y, sample, static_cast<int>(group)), light_);
        Stokes<double>* sums = &buffer.stokes[pixel * plan_.wavelengths_nm.size()];
        for (std::size_t i = 0; i < members.size(); ++i) sums[members[i]] += light_[i];
        return result;
    }

    const Plan& plan_;
    SilentUntilCancelled observer_;
    Tracer<anisotropic, absorbing, SilentUntilCancelled> tracer_;
    std::vector<Stokes<double>> light_;
};

}  // namespace

std::unique_ptr<PassTracer> make_pass_tracer(const Plan& plan) {
    if (plan.features.anisotropic) {
        if (plan.features.absorbing) return std::make_unique<KernelPass<true, true>>(plan);
        return std::make_unique<KernelPass<true, false>>(plan);
    }
    if (plan.features.absorbing) return std::make_unique<KernelPass<false, true>>(plan);
    return std::make_unique<KernelPass<false, false>>(plan);
}

}  // namespace pol
