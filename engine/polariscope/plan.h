// SPDX-License-Identifier: Apache-2.0
// A scene ready to be traced, and single rays through it.
#pragma once

#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "polariscope/light.h"
#include "polariscope/result.h"
#include "polariscope/scene.h"

namespace polariscope {

namespace detail {
struct PlanData;
}

/// A compiled scene. Immutable; thread-safe.
class Plan {
public:
    Plan(const Plan&) = default;
    Plan& operator=(const Plan&) = default;
    ~Plan() = default;

    [[nodiscard]] const RenderSettings& settings() const;
    /// Bound of S0 over all that any path of the scene can bring, per wavelength: the L_max of error bounds; twice that
    /// where lamps are polarized.
    [[nodiscard]] const std::vector<double>& brightest() const;
    /// What the model of light leaves out though this scene would show it, a sentence each. Error bounds are those of
    /// the model; where this is empty, they are those of the truth.
    [[nodiscard]] const std::vector<std::string>& doubts() const;

private:
    friend struct detail::Inside;
    explicit Plan(std::shared_ptr<const detail::PlanData> data) : data_(std::move(data)) {}
    std::shared_ptr<const detail::PlanData> data_;
};

/// Error (input): what is wrong with the scene or its settings, with the place in its file: no wavelengths, one outside
/// an index record, solids that overlap without a priority, a camera inside a crystal ...
Result<Plan> compile(const Scene& scene);

/// A ray against the light, from where it is seen into the scene, and the frame of its Stokes vectors: x, and y such
/// that (x, y, -direction) is right-handed.
struct Ray {
    Vector origin{};                  ///< scene units
    Vector direction{0.0, 0.0, 1.0};  ///< any length
    Vector x{1.0, 0.0, 0.0};          ///< any length; only what is across the direction counts
};

/// The camera's ray through (x, y), in pixels from the top left corner of the picture: (0.5, 0.5) is the middle of the
/// first pixel. Its frame is the picture's (Stokes). Error (usage): not finite.
Result<Ray> camera_ray(const Plan& plan, double x, double y);

/// What comes back along a ray. The truth lies within
///     light - surplus <= truth <= light + missing,
/// as matrices: what is missing has a coherence matrix that is positive semidefinite with at most that trace.
struct RayLight {
    std::vector<Stokes> light;    ///< per wavelength of the plan
    std::vector<double> missing;  ///< most S0 that was left out, per wavelength
    std::vector<double> surplus;  ///< most S0 that is there too much, per wavelength: one random path stood for a part
    std::uint32_t branches = 0;   ///< that were followed
    std::uint32_t failures = 0;   ///< branches whose arithmetic failed; they count as missing
};

/// One tree of rays per wavelength at which media differ, cut as the plan's settings say. `sample` picks other random
/// numbers for the path that ends a tree whose node budget is used up. Error (usage): no direction, an origin where no
/// camera can stand (inside a crystal, a metal, a lamp); (stopped): `stop` was requested.
Result<RayLight> trace_ray(const Plan& plan, const Ray& ray, std::uint32_t sample = 0,
                           const std::stop_token& stop = {});

}  // namespace polariscope
