// SPDX-License-Identifier: Apache-2.0
#include "polariscope/explain.h"

#include <cmath>
#include <cstddef>

#include "polariscope/inside.h"
#include "report/explain_report.h"
#include "tracer/tree_names.h"

namespace polariscope {

using detail::guarded;
using detail::inner;
using detail::Inside;
using detail::outer;
using detail::usage;

namespace {

Branch branch(const pol::Plan& plan, const pol::Explanation& explanation, int index) {
    const pol::RayTreeNode& node = explanation.tree.nodes[static_cast<std::size_t>(index)];
    Branch out;
    out.parent = node.parent;
    out.interaction = pol::interaction_of(plan, explanation, index);
    out.mode = pol::mode_of(node.start.wave);
    out.medium = pol::medium_name(plan, node.start.region);
    out.from = outer(node.start.origin);
    out.to = outer(node.end.origin);
    out.direction = outer(node.start.wave.ray);
    out.k = outer(node.start.wave.k);
    if (node.crossing.body >= 0) out.body = plan.body_name(node.crossing.body);
    out.weight = node.start.weight;
    out.weight_at_end = node.end.weight;
    if (node.reason) out.end = pol::name_of(*node.reason);
    out.light = outer(node.light);
    out.share = outer(node.share);
    return out;
}

}  // namespace

Stokes Explanation::stokes() const {
    return outer(data_->explanation.sample_light);
}

Coherence Explanation::coherence() const {
    return polariscope::coherence(stokes());
}

bool Explanation::exact() const {
    return data_->explanation.exact();
}

const std::vector<Branch>& Explanation::branches() const {
    return data_->branches;
}

Result<std::string> Explanation::as_text(double least_weight) const {
    if (!(least_weight >= 0.0)) return usage("least_weight", "is no share", "0 to 1");
    return guarded([&]() -> Result<std::string> {
        return pol::explanation_as_text(inner(data_->plan), data_->explanation, least_weight);
    });
}

Result<std::string> Explanation::as_json() const {
    return guarded(
        [&]() -> Result<std::string> { return pol::explanation_as_json(inner(data_->plan), data_->explanation); });
}

Result<Explanation> explain(const Plan& plan, int x, int y, int wavelength, std::uint32_t sample,
                            const std::stop_token& stop) {
    return guarded([&]() -> Result<Explanation> {
        const pol::Plan& p = inner(plan);
        if (x < 0 || y < 0 || x >= p.settings.width || y >= p.settings.height)
            return usage("x, y",
                         "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") lies outside of the picture",
                         "it has " + std::to_string(p.settings.width) + " x " + std::to_string(p.settings.height));
        if (wavelength < 0 || static_cast<std::size_t>(wavelength) >= p.wavelengths_nm.size())
            return usage("wavelength", "there is no wavelength " + std::to_string(wavelength),
                         "0 to " + std::to_string(p.wavelengths_nm.size() - 1));
        auto explanation =
            pol::explain(p, x, y, sample, wavelength, [&stop](std::size_t) { return !stop.stop_requested(); });
        if (!explanation || stop.stop_requested()) return detail::stopped();
        std::vector<Branch> branches;
        branches.reserve(explanation->tree.nodes.size());
        for (std::size_t i = 0; i < explanation->tree.nodes.size(); ++i)
            branches.push_back(branch(p, *explanation, static_cast<int>(i)));
        return Inside::pack(detail::ExplanationData{plan, std::move(*explanation), std::move(branches)});
    });
}

}  // namespace polariscope
