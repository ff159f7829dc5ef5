// SPDX-License-Identifier: Apache-2.0
#include "verify/ablation/ablation.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <new>
#include <utility>

#include "compare/error_metrics.h"
#include "core/random.h"
#include "render/renderer.h"
#include "verify/convergence/machine.h"

namespace pol::verify {

namespace {

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// A picture and what one render of it takes.
struct Shot {
    StokesImage picture;
    double cpu_s = 0.0;
};

class Ablation {
public:
    Ablation(const AblationRequest& request, const AblationWatch& watch)
        : request_(request), watch_(watch), scene_(request.scene) {}

    Result<AblationResult> run() {
        if (request_.longest_render_s) {
            POL_TRY_DONE(fit(*request_.longest_render_s));
        }
        POL_TRY_DONE(list_variants());
        const RenderSettings& settings = scene_.render;
        result_.width = settings.width;
        result_.height = settings.height;
        result_.samples = settings.samples_per_pixel;
        measure();
        return std::move(result_);
    }

private:
    /// A plan that keeps something, and how it did.
    struct Variant {
        AblationRow row;
        std::shared_ptr<const Plan> plan;
        bool same_bits = true;
        std::vector<double> without;
        std::vector<double> with;
        std::vector<double> ratios;
    };

    bool tell() {
        if (!watch_(done_, doing_)) stopped_ = true;
        return !stopped_;
    }

    /// None if it was stopped.
    std::optional<Shot> shoot(const std::shared_ptr<const Plan>& plan, int times) {
        constexpr double look_every_s = 0.1;
        const double start = cpu_seconds();
        for (int i = 0; i < times; ++i) {
            renderer_.start(plan);
            while (!renderer_.wait_for(look_every_s))
                if (!tell()) return std::nullopt;
            if (renderer_.progress().reason == StopReason::memory) throw std::bad_alloc();
        }
        return Shot{renderer_.snapshot(), (cpu_seconds() - start) / times};
    }

    /// Makes the picture small enough, by the time that a tiny one takes.
    Result<Done> fit(double longest_s) {
        constexpr int smallest = 8;
        constexpr int largest = 96;
        doing_ = "how large a picture may be";
        const int width = scene_.render.width;
        const int height = scene_.render.height;
        const int longest = std::max(width, height);
        const auto resize = [&](int side) {
            const double scale = std::min(1.0, static_cast<double>(side) / longest);
            scene_.render.width = std::max(1, static_cast<int>(std::lround(scale * width)));
            scene_.render.height = std::max(1, static_cast<int>(std::lround(scale * height)));
            return scene_.render.width * scene_.render.height;
        };
        int side = smallest;
        for (const int probed : {smallest, 4 * smallest}) {  // the second is not lost in what a render takes anyway
            if (probed > side) break;
            const int pixels = resize(probed);
            POL_TRY(const auto plan, request_.make_plan(scene_, {}));
            const auto shot = shoot(plan, 1);
            if (!shot) return Done{};
            const double affordable = pixels * longest_s / std::max(shot->cpu_s, 1e-6);
            side = std::clamp(static_cast<int>(probed * std::sqrt(affordable / pixels)), smallest, largest);
        }
        resize(side);
        return Done{};
    }

    Result<Done> list_variants() {
        POL_TRY(plain_, request_.make_plan(scene_, {}));
        SpareParts all;
        for (const Feature& feature : plain_->features.list) {
            if (feature.needed) continue;
            if (feature.spare == nullptr) {
                result_.nothing_to_keep.push_back(feature);
                continue;
            }
            SpareParts kept;
            kept.*feature.spare = true;
            const bool same_bits = !kept.meshes;
            auto plan = request_.make_plan(scene_, kept);
            if (!plan) {
                result_.not_keepable.push_back({feature.name, false, plan.error().what, nullptr});
                continue;
            }
            if (same_bits) all.*feature.spare = true;
            add_variant(feature.name, feature.reason, std::move(plan).value(), same_bits);
        }
        if (std::count_if(variants_.begin(), variants_.end(), [](const Variant& v) { return v.same_bits; }) < 2)
            return Done{};
        POL_TRY(auto plan, request_.make_plan(scene_, all));
        add_variant("all of them together", "", std::move(plan), true);
        has_all_ = true;
        return Done{};
    }

    void add_variant(const std::string& name, const std::string& reason, std::shared_ptr<const Plan> plan,
                     bool same_bits) {
        Variant variant;
        variant.row.feature = name;
        variant.row.reason = reason;
        variant.row.holds = true;
        variant.plan = std::move(plan);
        variant.same_bits = same_bits;
        variants_.push_back(std::move(variant));
    }

    /// With and without in turn, and features in turn, so that a slow minute hits all of them.
    void measure() {
        constexpr double shortest_s = 0.05;
        doing_ = "without any";
        const auto plain = shoot(plain_, 1);
        if (!plain) return;
        const bool halves = !plain->picture.sampling_error.empty();
        result_.hash = picture_hash(plain->picture, halves);
        const int times = std::clamp(static_cast<int>(shortest_s / std::max(plain->cpu_s, 1e-6)), 1, 100);
        const auto pairs = static_cast<double>(variants_.size()) * request_.rounds;
        int pair = 0;
        for (int round = 0; round < request_.rounds; ++round)
            for (Variant& variant : variants_) {
                done_ = pair++ / pairs;
                doing_ = variant.row.feature;
                if (!tell() || !measure_pair(variant, pair % 2 == 0, times, halves)) return;
            }
        for (Variant& variant : variants_) {
            variant.row.without_s = median(variant.without);
            variant.row.with_s = median(variant.with);
            variant.row.ratio = median(variant.ratios);
            result_.rows.push_back(std::move(variant.row));
        }
        if (has_all_) {
            result_.all = std::move(result_.rows.back());
            result_.rows.pop_back();
        }
        result_.complete = true;
    }

    bool measure_pair(Variant& variant, bool with_first, int times, bool halves) {
        std::optional<Shot> with;
        if (with_first) with = shoot(variant.plan, times);
        const auto without = stopped_ ? std::nullopt : shoot(plain_, times);
        if (!with_first && !stopped_) with = shoot(variant.plan, times);
        if (!with || !without) return false;
        variant.without.push_back(without->cpu_s);
        variant.with.push_back(with->cpu_s);
        variant.ratios.push_back(with->cpu_s / without->cpu_s);
        judge(variant, with->picture, without->picture, halves);
        return true;
    }

    void judge(Variant& variant, const StokesImage& with, const StokesImage& without, bool halves) const {
        constexpr double enough = 0.99;  // a ray that meets an edge may take either side of it
        AblationRow& row = variant.row;
        row.hash = picture_hash(with, halves);
        bool same = picture_hash(without, halves) == result_.hash;
        if (variant.same_bits) {
            same = same && row.hash == result_.hash;
        } else {
            row.agreement = bound_coverage(with, without, double_rounding).covered;
            same = same && *row.agreement >= enough;
        }
        row.holds = row.holds && same;
    }

    const AblationRequest& request_;
    const AblationWatch& watch_;
    Scene scene_;
    Renderer renderer_{1};
    std::shared_ptr<const Plan> plain_;
    std::vector<Variant> variants_;
    bool has_all_ = false;  // the last of them
    AblationResult result_;
    double done_ = 0.0;
    std::string doing_;
    bool stopped_ = false;
};

}  // namespace

bool AblationResult::holds() const {
    return std::all_of(rows.begin(), rows.end(), [](const AblationRow& row) { return row.holds; }) &&
           (!all || all->holds);
}

Result<AblationResult> ablate(const AblationRequest& request, const AblationWatch& watch) {
    return Ablation(request, watch).run();
}

std::uint64_t picture_hash(const StokesImage& picture, bool with_sampling_error) {
    std::uint64_t hash = 0;
    const auto add = [&hash](std::uint64_t bits) { hash = mix_bits(hash + 0x9e3779b97f4a7c15ULL) ^ mix_bits(bits); };
    const auto add_number = [&add](double number) { add(std::bit_cast<std::uint64_t>(number)); };
    const auto add_stokes = [&add_number](const std::vector<Stokes<double>>& plane) {
        for (const Stokes<double>& s : plane) add_number(s.s0), add_number(s.s1), add_number(s.s2), add_number(s.s3);
    };
    add_stokes(picture.stokes);
    if (with_sampling_error) add_stokes(picture.sampling_error);
    for (std::size_t band = 0; band < picture.bands.size(); ++band)
        for (std::size_t pixel = 0; pixel < picture.pixel_count(); ++pixel) {
            add_number(picture.plane_value(picture.residual, band, pixel));
            add_number(picture.plane_value(picture.tail, band, pixel));
        }
    for (const std::uint32_t failures : picture.failures) add(failures);
    return hash;
}

}  // namespace pol::verify
