// SPDX-License-Identifier: Apache-2.0
// Which knobs are turned, and how far.
#include <string>
#include <utility>

#include "core/number_text.h"
#include "scene/node_budget.h"
#include "verify/convergence/convergence.h"

namespace pol::verify {

std::vector<RunSetting> convergence_settings(const Scene& scene, bool crystals) {
    Scene cut_by_energy = scene;
    cut_by_energy.render.depth.reset();
    RenderSettings base = cut_by_energy.render;
    base.node_budget = node_budget_in_force(cut_by_energy);
    std::vector<RunSetting> list;
    const auto add = [&](const std::string& series, const auto& change) {
        RenderSettings settings = base;
        change(settings);
        list.push_back({series, settings});
    };
    const bool area = base.mode == SampleMode::area;
    if (area) {
        for (const double residual : {1e-1, 1e-2, 1e-3})
            for (const int samples : {1, 4, 16})
                add("samples at residual " + number_text(residual), [&](RenderSettings& s) {
                    s.residual = residual;
                    s.samples_per_pixel = samples;
                });
    } else {
        for (const double residual : {3e-1, 1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 1e-4})
            add("residual", [&](RenderSettings& s) {
                s.residual = residual;
                s.samples_per_pixel = 1;
            });
    }
    const int samples = area ? few_convergence_samples : 1;
    if (crystals)
        for (const int budget : {10, 30, 100, 300, 1000})
            add("branches", [&](RenderSettings& s) {
                s.residual = 1e-4;
                s.node_budget = budget;
                s.samples_per_pixel = samples;
            });
    for (const int depth : {1, 3, 5, 7, 9})
        add("depth", [&](RenderSettings& s) {
            s.cut_by_depth_alone(depth);
            s.node_budget = RenderSettings::whole_tree;
            s.samples_per_pixel = samples;
        });
    if (base.wavelengths_nm.size() > 4) {
        std::vector<double> some = base.wavelengths_nm;
        while (some.size() > 2) {
            add("wavelengths", [&](RenderSettings& s) {
                s.wavelengths_nm = some;
                s.residual = 1e-3;
                s.samples_per_pixel = samples;
            });
            std::vector<double> half;
            for (std::size_t i = 0; i < some.size(); i += 2) half.push_back(some[i]);
            some = std::move(half);
        }
    }
    return list;
}

}  // namespace pol::verify
