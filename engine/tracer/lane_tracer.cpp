// SPDX-License-Identifier: Apache-2.0
#include "tracer/lane_tracer.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "core/contract.h"
#include "plan/lanes.h"
#include "tracer/determined.h"
#include "tracer/leaf_light.h"
#include "tracer/sample_task.h"

namespace pol {

namespace {

/// Visits the numbers of one branch, always in the same order.
template <class Branches, class Visit>
void for_each_number(Branches& branches, int lane, const Visit& visit) {
    int index = 0;
    for (int axis = 0; axis < 3; ++axis) {
        visit(index++, branches.rays.origin[axis][lane]);
        visit(index++, branches.rays.direction[axis][lane]);
        visit(index++, branches.s[axis][lane]);
        visit(index++, branches.p[axis][lane]);
    }
    for (auto& element : branches.throughput) visit(index++, element[lane]);
    visit(index++, branches.weight[lane]);
    visit(index++, branches.index[lane]);
}

}  // namespace

template <bool absorbing>
LaneTracer<absorbing>::LaneTracer(PlanForKernel<false, absorbing> plan)
    : plan_(plan.plan()), ball_(std::get_if<Sphere>(&plan_.solids.front().shape)), scalar_(plan, observer_) {
    POL_EXPECTS(why_not_in_lanes(plan_).empty());
    if (ball_ == nullptr) planes_.emplace(std::get<HalfSpaceSolid>(plan_.solids.front().shape));
    for (const int body : plan_.regions[0].surfaces)
        surfaces_.push_back(&std::get<OpenSurface>(plan_.surface(body).shape));
}

template <bool absorbing>
typename LaneTracer<absorbing>::Place LaneTracer<absorbing>::place(std::size_t number) const {
    const std::size_t index = samples_.first_pixel + number / samples_.samples;
    const auto pixel = static_cast<int>(samples_.listed.empty() ? index : samples_.listed[index]);
    return {samples_.x0 + pixel % samples_.tile_width, samples_.y0 + pixel / samples_.tile_width,
            samples_.first_sample + static_cast<std::uint32_t>(number % samples_.samples)};
}

template <bool absorbing>
TraceTask LaneTracer<absorbing>::task(std::size_t number) const {
    const Place at = place(number);
    return sample_task(plan_, at.x, at.y, at.sample, samples_.group);
}

template <bool absorbing>
bool LaneTracer<absorbing>::trace(const LaneSamples& samples, const KeepGoing& keep_going) {
    samples_ = samples;
    observer_.keep_going = &keep_going;
    group_ = &plan_.groups[static_cast<std::size_t>(samples.group)];
    wavelengths_ = group_->wavelengths.size();
    outside_medium_ = group_->media[static_cast<std::size_t>(plan_.regions[0].medium)];
    inside_medium_ = group_->media[static_cast<std::size_t>(plan_.regions[1].medium)];
    absorbs_ = absorbing && inside_medium_.dielectric.is_complex();
    count_ = samples.pixels * samples.samples;
    next_ = 0;
    results_.assign(count_, {});
    light_.assign(count_ * wavelengths_, {});
    emitted_.resize(wavelengths_);
    waiting_.clear();
    active_ = 0;
    std::fill(std::begin(facet_), std::end(facet_), PlaneScan::no_ray);
    for (;;) {
        if (!keep_going(next_)) return false;
        while (active_ + static_cast<int>(waiting_.size()) < width && next_ < count_) begin_samples();
        for (int lane = 0; lane < width && !waiting_.empty(); ++lane) {
            if (facet_[lane] != PlaneScan::no_ray) continue;
            const Waiting& from = waiting_.back();
            for_each_number(*inside_, lane, [&](int i, double& number) { number = from.value[i]; });
            facet_[lane] = from.facet;
            sample_[lane] = from.sample;
            ++active_;
            waiting_.pop_back();
        }
        if (active_ == 0) return true;
        follow_inside();
    }
}

template <bool absorbing>
void LaneTracer<absorbing>::cross(const LaneBranches& from, double side, const MediumAt& from_medium,
                                  const MediumAt& to_medium, LaneBranches& reflected, LaneBranches& transmitted) {
    const Dielectric<double>& first = from_medium.dielectric;
    const Dielectric<double>& second = to_medium.dielectric;
    if (!absorbs_) return cross_in_lanes(from, hits_, side, first.n, second.n, reflected, transmitted, reaches_);
    if constexpr (absorbing)
        cross_absorbing_in_lanes(from, hits_, side,
                                 {{first.n, first.kappa}, {second.n, second.kappa}, from_medium.absorption}, reflected,
                                 transmitted, reaches_, absorbed_);
}

/// Sixteen camera rays, to the lamps or into the solid.
template <bool absorbing>
void LaneTracer<absorbing>::begin_samples() {
    const std::size_t first = next_;
    const int rays = static_cast<int>(std::min<std::size_t>(width, count_ - first));
    next_ += static_cast<std::size_t>(rays);
    alignas(64) double x[width]{};
    alignas(64) double y[width]{};
    for (int lane = 0; lane < rays; ++lane) {
        const Place at = place(first + static_cast<std::size_t>(lane));
        const DVec2 in_picture = sample_place(plan_, at.x, at.y, at.sample, samples_.group);
        x[lane] = in_picture.x;
        y[lane] = in_picture.y;
    }
    begin_in_lanes(plan_.camera, x, y, camera_);
    if (ball_ != nullptr)
        enter_ball_in_lanes(*ball_, camera_.rays, hits_);
    else
        planes_->enter(camera_.rays, rays, hits_);
    look_in_lanes(camera_, surfaces_, sights_);
    bool enters[width]{};
    bool any = false;
    for (int lane = 0; lane < rays; ++lane) {
        const std::size_t sample = first + static_cast<std::size_t>(lane);
        if (plan_.settings.residual_in_force() >= 1.0 || plan_.settings.node_budget.value() < 1) {
            results_[sample] = scalar_.trace(task(sample), sums(sample));
            continue;
        }
        // On a tie the surface is met: next_crossing() asks it first.
        enters[lane] = hits_.facet[lane] >= 0 && !(sights_.distance[lane] <= hits_.distance[lane]);
        any = any || enters[lane];
        if (enters[lane]) continue;
        results_[sample].nodes = 1;
        end_outside(camera_, lane, -1, sample);
        finish(sample);
    }
    if (any) enter_solid(first, enters);
}

template <bool absorbing>
void LaneTracer<absorbing>::enter_solid(std::size_t first, const bool (&enters)[width]) {
    cross(camera_, -1.0, outside_medium_, inside_medium_, outside_, begun_);
    look_in_lanes(outside_, surfaces_, sights_);
    for (int lane = 0; lane < width; ++lane) {
        if (!enters[lane]) continue;
        const std::size_t sample = first + static_cast<std::size_t>(lane);
        if (reaches_[lane] == 0.0 || !std::isfinite(outside_.weight[lane] + begun_.weight[lane])) {
            results_[sample] = scalar_.trace(task(sample), sums(sample));
            continue;
        }
        results_[sample].nodes = 1;
        if (absorbs_) results_[sample].absorbed += absorbed_[1][lane];
        if (outside_.weight[lane] != 0.0) {
            ++results_[sample].nodes;
            end_outside(outside_, lane, hits_.facet[lane], sample);
        }
        if (!goes_on(begun_, lane, hits_.facet[lane], sample)) continue;
        Waiting& branch = waiting_.emplace_back();
        for_each_number(begun_, lane, [&](int i, double& number) { branch.value[i] = number; });
        branch.facet = hits_.facet[lane];
        branch.sample = sample;
    }
}

/// One step of all branches in flight.
template <bool absorbing>
void LaneTracer<absorbing>::follow_inside() {
    if (ball_ != nullptr)
        exit_ball_in_lanes(*ball_, inside_->rays, hits_);
    else
        planes_->exit(inside_->rays, facet_, width, hits_);
    cross(*inside_, 1.0, inside_medium_, outside_medium_, *reflected_, outside_);
    look_in_lanes(outside_, surfaces_, sights_);
    for (int lane = 0; lane < width; ++lane) {
        if (facet_[lane] == PlaneScan::no_ray) continue;
        const std::size_t sample = sample_[lane];
        if (hits_.facet[lane] < 0 || reaches_[lane] == 0.0 ||
            !std::isfinite(reflected_->weight[lane] + outside_.weight[lane])) {
            hand_over(*inside_, lane, facet_[lane], sample);
            facet_[lane] = PlaneScan::no_ray;
            --active_;
            continue;
        }
        ++results_[sample].nodes;
        if (absorbs_) {
            results_[sample].absorbed += absorbed_[0][lane];
            results_[sample].absorbed += absorbed_[1][lane];
        }
        if (outside_.weight[lane] != 0.0) {
            ++results_[sample].nodes;
            end_outside(outside_, lane, hits_.facet[lane], sample);
        }
        facet_[lane] = hits_.facet[lane];
        if (goes_on(*reflected_, lane, facet_[lane], sample)) continue;
        facet_[lane] = PlaneScan::no_ray;
        --active_;
    }
    std::swap(inside_, reflected_);
}

template <bool absorbing>
bool LaneTracer<absorbing>::goes_on(const LaneBranches& branches, int lane, int facet, std::size_t sample) {
    const double weight = branches.weight[lane];
    const RenderSettings& settings = plan_.settings;
    const double residual = settings.residual_in_force();
    if (is_followed(residual, settings.until_determined(), *group_, results_[sample], weight)) {
        if (results_[sample].nodes < static_cast<std::uint32_t>(settings.node_budget.value())) return true;
        if (weight > residual) {
            hand_over(branches, lane, facet, sample);
            return false;
        }
    }
    results_[sample].residual += weight;
    finish(sample);
    return false;
}

template <bool absorbing>
Node LaneTracer<absorbing>::node_of(const LaneBranches& branches, int lane, int region, int facet) const {
    Node node;
    node.origin = origin_of(branches.rays, lane);
    node.wave.ray = direction_of(branches.rays, lane);
    const MediumAt& medium = region == 0 ? outside_medium_ : inside_medium_;
    node.wave.k = node.wave.ray * (medium.dielectric.is_complex() ? branches.index[lane] : medium.dielectric.n);
    node.wave.field[0] = {branches.s[0][lane], branches.s[1][lane], branches.s[2][lane]};
    node.wave.field[1] = {branches.p[0][lane], branches.p[1][lane], branches.p[2][lane]};
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column)
            node.throughput.m[row][column] = {branches.throughput[4 * row + 2 * column][lane],
                                              branches.throughput[4 * row + 2 * column + 1][lane]};
    node.weight = branches.weight[lane];
    if (facet >= 0) node.left = {0, facet, -1};
    node.region = region;
    return node;
}

template <bool absorbing>
void LaneTracer<absorbing>::end_outside(const LaneBranches& branches, int lane, int left_facet, std::size_t sample) {
    TraceResult& result = results_[sample];
    const std::span<Stokes<double>> sum = sums(sample);
    const Stokes<double> unpolarized{sights_.unpolarized[0][lane], sights_.unpolarized[1][lane],
                                     sights_.unpolarized[2][lane], sights_.unpolarized[3][lane]};
    // Outside is where the camera is: radiance_factor() is 1 there.
    const auto add = [&](const std::vector<double>& radiance, double luminance) {
        for (std::size_t i = 0; i < wavelengths_; ++i)
            sum[i] += radiance[static_cast<std::size_t>(group_->wavelengths[i])] * unpolarized;
        if (plan_.settings.until_determined()) result.seen += luminance * unpolarized;
        result.resolved += branches.weight[lane];
    };
    if (sights_.surface[lane] < 0.0) return add(plan_.background, plan_.background_luminance);
    const int body = plan_.regions[0].surfaces[static_cast<std::size_t>(sights_.surface[lane])];
    const auto* role = std::get_if<EmitterRole>(&plan_.surface(body).role);
    const Emitter* emitter = role == nullptr ? nullptr : &plan_.emitters[static_cast<std::size_t>(role->emitter)];
    const bool front = sights_.along[lane] < 0.0;
    if (emitter == nullptr || (!front && !emitter->two_sided)) {
        result.absorbed += branches.weight[lane];
        return;
    }
    const auto* radiance = std::get_if<std::vector<double>>(&emitter->radiance);
    if (radiance != nullptr && std::holds_alternative<Unpolarized>(emitter->state))
        return add(*radiance, emitter->luminance);

    Node node = node_of(branches, lane, 0, left_facet);
    if (!has_state_along(*emitter, node.wave.ray)) {
        ++result.failures;
        result.residual += node.weight;
        return;
    }
    Crossing crossing{sights_.distance[lane], body, 0, -1, {}, {sights_.u[lane], sights_.v[lane]}};
    crossing.normal = std::get<OpenSurface>(plan_.surface(body).shape).plane().normal;
    node.origin += node.wave.ray * crossing.distance;
    std::fill(emitted_.begin(), emitted_.end(), Stokes<double>{});
    result.seen +=
        emitter_light(plan_, samples_.group, *emitter, node, crossing, outside_medium_.dielectric.n, emitted_);
    for (std::size_t i = 0; i < wavelengths_; ++i) sum[i] += emitted_[i];
    result.resolved += node.weight;
}

template <bool absorbing>
void LaneTracer<absorbing>::hand_over(const LaneBranches& branches, int lane, int facet, std::size_t sample) {
    results_[sample] = scalar_.resume(task(sample), node_of(branches, lane, 1, facet), results_[sample], sums(sample));
}

template <bool absorbing>
void LaneTracer<absorbing>::finish(std::size_t sample) {
    TraceResult& result = results_[sample];
    const double total = result.resolved + result.absorbed + result.residual + result.tail;
    if (!(std::abs(total - 1.0) <= energy_tolerance)) ++result.failures;
}

template class LaneTracer<false>;
template class LaneTracer<true>;

}  // namespace pol
