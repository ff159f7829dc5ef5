// SPDX-License-Identifier: Apache-2.0
#include "tracer/leaf_light.h"

#include <algorithm>
#include <variant>

#include "core/overloaded.h"
#include "optics/crystal_plate.h"

namespace pol {

namespace {

constexpr double parallel2 = 1e-24;

/// Coherence matrix of a fixed state (S0 = 1) in the ray's field basis. The two bases are real and orthonormal, so the
/// change of basis is O J O^T even where the ray's basis is left-handed about the light.
CoherenceMatrix<double> fixed_state(const PlanFixedState& state, const Node& node) {
    const DVec3 light = -node.wave.ray;
    const DVec3 transverse = state.x_axis - light * dot(state.x_axis, light);
    const DVec3 x = length2(transverse) > parallel2 ? unit(transverse) : any_perpendicular(light);
    const DVec3 y = cross(light, x);
    const Complex<double> xy{0.5 * state.s2, 0.5 * state.s3};
    const double xx = 0.5 * (1.0 + state.s1);
    const double yy = 0.5 * (1.0 - state.s1);
    const auto element = [&](const DVec3& a, const DVec3& b) {
        const double ax = dot(a, x);
        const double ay = dot(a, y);
        const double bx = dot(b, x);
        const double by = dot(b, y);
        return Complex<double>(ax * bx * xx + ay * by * yy) + xy * (ax * by) + conj(xy) * (ay * bx);
    };
    const auto& field = node.wave.field;
    return {element(field[0], field[0]).re, element(field[1], field[1]).re, element(field[0], field[1])};
}

/// (n_camera / N)^2 with N^2 of PHYSICS.md 2.3: from radiance at the leaf to radiance at the camera. For a pair along
/// the axis of a crystal the ordinary index stands for both modes.
double radiance_factor(const Dielectric<double>& medium, const Wave<double>& wave, double camera_n) {
    double n2 = medium.n * medium.n;
    if (wave.kind == WaveKind::extraordinary) {
        const double ray_index = dot(wave.k, wave.ray);
        const double ratio = medium.n_e * medium.n_e / (ray_index * ray_index);
        n2 *= ratio * ratio;
    }
    const double camera_n2 = camera_n * camera_n;
    return n2 == camera_n2 ? 1.0 : camera_n2 / n2;
}

const Dielectric<double>& medium_of(const Plan& plan, const WavelengthGroup& group, int region) {
    return group.media[static_cast<std::size_t>(plan.regions[static_cast<std::size_t>(region)].medium)].dielectric;
}

/// Stokes vector at the camera per unit radiance of the emitter.
Stokes<double> emitted_state(const Emitter& emitter, int group, const Node& node, const DVec3& normal, double n) {
    return std::visit(Overloaded{
                          [&](const Unpolarized&) { return node.throughput.unpolarized(); },
                          [&](const PlanFixedState& state) { return node.throughput.gather(fixed_state(state, node)); },
                          [&](const PlanCrystalPlate& plate) {
                              return node.throughput.gather(crystal_plate_state(
                                  plate.crystal[static_cast<std::size_t>(group)], normal, -node.wave.ray, n,
                                  plate.passed, plate.fresnel, node.wave.field[0], node.wave.field[1]));
                          },
                      },
                      emitter.state);
}

/// Linear sRGB of the nearest texel; row 0 is the top, v points up, the border belongs to the last texel.
const float* texel(const RgbImage& image, const DVec2& uv) {
    const auto index = [](double t, int count) {
        return static_cast<std::size_t>(std::clamp(static_cast<int>(t * count), 0, count - 1));
    };
    return &image.rgb[3 * (index(1.0 - uv.y, image.height) * static_cast<std::size_t>(image.width) +
                           index(uv.x, image.width))];
}

}  // namespace

Stokes<double> background_light(const Plan& plan, const WavelengthGroup& group, const Node& node, double camera_n,
                                std::span<Stokes<double>> light) {
    const Stokes<double> state =
        radiance_factor(medium_of(plan, group, node.region), node.wave, camera_n) * node.throughput.unpolarized();
    for (std::size_t i = 0; i < light.size(); ++i)
        light[i] = plan.background[static_cast<std::size_t>(group.wavelengths[i])] * state;
    return plan.background_luminance * state;
}

bool has_state_along(const Emitter& emitter, const DVec3& ray) {
    const auto* state = std::get_if<PlanFixedState>(&emitter.state);
    if (state == nullptr || (state->s1 == 0.0 && state->s2 == 0.0)) return true;
    return length2(cross(state->x_axis, ray)) > parallel2;
}

Stokes<double> emitter_light(const Plan& plan, int group, const Emitter& emitter, const Node& node,
                             const Crossing& crossing, double camera_n, std::span<Stokes<double>> light) {
    const WavelengthGroup& wavelengths = plan.groups[static_cast<std::size_t>(group)];
    const Dielectric<double>& medium = medium_of(plan, wavelengths, node.region);
    const bool front = dot(crossing.normal, node.wave.ray) < 0.0;
    const Stokes<double> state =
        radiance_factor(medium, node.wave, camera_n) *
        emitted_state(emitter, group, node, front ? crossing.normal : -crossing.normal, medium.n);
    return std::visit(Overloaded{
                          [&](const std::vector<double>& radiance) {
                              for (std::size_t i = 0; i < light.size(); ++i)
                                  light[i] = radiance[static_cast<std::size_t>(wavelengths.wavelengths[i])] * state;
                              return emitter.luminance * state;
                          },
                          [&](const PlanTexture& texture) {
                              const float* rgb = texel(*texture.image, crossing.uv);
                              const auto sum = [&](const auto& weight) {
                                  double value = 0.0;
                                  for (std::size_t c = 0; c < 3; ++c) value += static_cast<double>(rgb[c]) * weight(c);
                                  return value;
                              };
                              for (std::size_t i = 0; i < light.size(); ++i) {
                                  const auto w = static_cast<std::size_t>(wavelengths.wavelengths[i]);
                                  light[i] = sum([&](std::size_t c) { return texture.basis[c][w]; }) * state;
                              }
                              return sum([&](std::size_t c) { return texture.luminance[c]; }) * state;
                          },
                      },
                      emitter.radiance);
}

}  // namespace pol
