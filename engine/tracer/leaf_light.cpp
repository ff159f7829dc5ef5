// SPDX-License-Identifier: Apache-2.0
#include "tracer/leaf_light.h"

#include <algorithm>
#include <variant>

#include "core/overloaded.h"
#include "optics/crystal_plate.h"

namespace pol {

namespace {

/// Coherence matrix of a fixed state (S0 = 1) in the ray's field basis. The two bases are real and orthonormal, so the
/// change of basis is O J O^T even where the ray's basis is left-handed about the light.
CoherenceMatrix<double> fixed_state(const PlanFixedState& state, const Node& node) {
    const DVec3 light = -node.wave.ray;
    const DVec3 transverse = state.x_axis - light * dot(state.x_axis, light);
    const DVec3 x = length2(transverse) > 1e-24 ? unit(transverse) : any_perpendicular(light);
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

}  // namespace

Stokes<double> emitted_state(const Emitter& emitter, int group, const Node& node, const DVec3& normal, double n) {
    return std::visit(Overloaded{
                          [&](const Unpolarized&) { return node.throughput.unpolarized(); },
                          [&](const PlanFixedState& state) { return node.throughput.gather(fixed_state(state, node)); },
                          [&](const PlanCrystalPlate& plate) {
                              return node.throughput.gather(crystal_plate_state(
                                  plate.crystal[static_cast<std::size_t>(group)], normal, -node.wave.ray, n, plate.passed,
                                  plate.fresnel, node.wave.field[0], node.wave.field[1]));
                          },
                      },
                      emitter.state);
}

void emitted_radiance(const Emitter& emitter, std::span<const int> wavelengths, const DVec2& uv, const Stokes<double>& state,
                      std::vector<Stokes<double>>& light) {
    std::visit(Overloaded{
                   [&](const std::vector<double>& radiance) {
                       for (const int w : wavelengths) light.push_back(radiance[static_cast<std::size_t>(w)] * state);
                   },
                   [&](const PlanTexture& texture) {
                       const RgbImage& image = *texture.image;
                       // Nearest texel; row 0 is the top, v points up. The border belongs to the last texel.
                       const auto texel = [](double t, int count) {
                           return static_cast<std::size_t>(std::min(static_cast<int>(t * count), count - 1));
                       };
                       const std::size_t column = texel(uv.x, image.width);
                       const std::size_t row = texel(1.0 - uv.y, image.height);
                       const float* rgb = &image.rgb[3 * (row * static_cast<std::size_t>(image.width) + column)];
                       for (const int w : wavelengths) {
                           const auto i = static_cast<std::size_t>(w);
                           const double radiance = static_cast<double>(rgb[0]) * texture.basis[0][i] +
                                                   static_cast<double>(rgb[1]) * texture.basis[1][i] +
                                                   static_cast<double>(rgb[2]) * texture.basis[2][i];
                           light.push_back(radiance * state);
                       }
                   },
               },
               emitter.radiance);
}

}  // namespace pol
