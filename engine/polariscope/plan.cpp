// SPDX-License-Identifier: Apache-2.0
#include "polariscope/plan.h"

#include <cmath>
#include <cstddef>

#include "plan/compile.h"
#include "plan/standpoint.h"
#include "polariscope/inside.h"
#include "scene/check.h"
#include "tracer/trace_sample.h"

namespace polariscope {

using detail::guarded;
using detail::inner;
using detail::Inside;
using detail::usage;

namespace {

bool is_believable(const Vector& v) {
    for (const double x : v)
        if (!(std::abs(x) <= pol::max_length)) return false;
    return true;
}

pol::DVec3 inner_vector(const Vector& v) {
    return {v[0], v[1], v[2]};
}

/// The ray with unit vectors. Error: it has no direction, or no axis across it.
Result<pol::CameraRay> unit_ray(const Ray& ray) {
    if (!is_believable(ray.origin) || !is_believable(ray.direction) || !is_believable(ray.x))
        return usage("ray", "a number is not finite, or beyond 1e15", "lengths are in scene units");
    const double length = std::sqrt(pol::length2(inner_vector(ray.direction)));
    if (!(length >= pol::min_length)) return usage("ray.direction", "has no length", "for example {0, 0, 1}");
    const pol::DVec3 direction = pol::unit(inner_vector(ray.direction));
    const double x_length = std::sqrt(pol::length2(inner_vector(ray.x)));
    const pol::DVec3 across = x_length >= pol::min_length
                                  ? cross(direction, cross(pol::unit(inner_vector(ray.x)), direction))
                                  : pol::DVec3(0);
    // 1e-9 leaves seven digits of the frame.
    if (!(std::sqrt(pol::length2(across)) > 1e-9))
        return usage("ray.x", "has no part across the direction", "any vector that is not along the ray");
    pol::CameraRay unit;
    unit.origin = inner_vector(ray.origin);
    unit.direction = direction;
    unit.x = pol::unit(across);
    unit.y = cross(unit.x, direction);
    return unit;
}

}  // namespace

const RenderSettings& Plan::settings() const {
    return data_->scene.settings();
}

const std::vector<double>& Plan::brightest() const {
    return data_->plan->brightest;
}

const std::vector<std::string>& Plan::doubts() const {
    return data_->plan->features.doubts;
}

Result<Plan> compile(const Scene& scene) {
    return guarded([&]() -> Result<Plan> {
        auto plan = pol::compile(Inside::of(scene).scene);
        if (!plan) return detail::outer(plan.error());
        return Inside::pack(detail::PlanData{scene, std::move(plan).value()});
    });
}

Result<Ray> camera_ray(const Plan& plan, double x, double y) {
    if (!std::isfinite(x) || !std::isfinite(y)) return usage("x, y", "not finite", "pixels from the top left corner");
    const pol::CameraRay ray = inner(plan).camera.ray(x, y);
    return Ray{detail::outer(ray.origin), detail::outer(ray.direction), detail::outer(ray.x)};
}

Result<RayLight> trace_ray(const Plan& plan, const Ray& ray, std::uint32_t sample, const std::stop_token& stop) {
    return guarded([&]() -> Result<RayLight> {
        const pol::Plan& p = inner(plan);
        const auto start = unit_ray(ray);
        if (!start) return start.error();
        const int region = p.region_at(start.value().origin);
        if (!pol::is_fit_for_camera(p, region))
            return usage("ray.origin", "lies in a crystal or a metal", "a ray is seen from an isotropic, clear medium");
        if (const pol::Surface* body = pol::body_around(p, start.value().origin))
            return usage("ray.origin", "lies inside '" + body->name + "'", "lamps and absorbers are seen from outside");

        RayLight out;
        out.light.resize(p.wavelengths_nm.size());
        out.missing.resize(p.wavelengths_nm.size());
        out.surplus.resize(p.wavelengths_nm.size());
        for (std::size_t g = 0; g < p.groups.size(); ++g) {
            const std::vector<int>& members = p.groups[g].wavelengths;
            pol::TraceTask task;
            task.ray = start.value();
            task.group = static_cast<int>(g);
            task.region = region;
            task.key = {p.settings.seed, 0, sample, p.groups[g].key};
            task.residual = p.settings.residual_in_force();
            task.until_determined = p.settings.until_determined();
            task.node_budget = p.settings.node_budget.value();
            std::vector<pol::Stokes<double>> light(members.size());
            const pol::TraceResult result =
                pol::trace_sample(p, task, light, [&stop](std::size_t) { return !stop.stop_requested(); });
            if (result.cancelled) return detail::stopped();
            out.branches += result.nodes;
            out.failures += result.failures;
            for (std::size_t i = 0; i < members.size(); ++i) {
                const auto w = static_cast<std::size_t>(members[i]);
                out.light[w] = detail::outer(light[i]);
                out.missing[w] = (result.residual + result.tail) * p.brightest[w];
                out.surplus[w] = result.tail * p.brightest[w];
            }
        }
        if (stop.stop_requested()) return detail::stopped();
        return out;
    });
}

}  // namespace polariscope
