// SPDX-License-Identifier: Apache-2.0
// One backward step: what a boundary or a thin sheet makes of a branch. The interface is solved as if the camera ray
// were light; light going the other way is transformed by the transpose (PHYSICS.md 2.8).
#pragma once

#include <cmath>

#include "optics/boundary_solver.h"
#include "optics/elements.h"
#include "optics/fresnel.h"
#include "tracer/absorbing_boundary.h"
#include "tracer/node.h"
#include "tracer/transparent_boundary.h"

namespace pol {

/// Children of a branch at a boundary. Their origin, region, left facet, depth and id are the caller's to set.
///
/// A tracer keeps one and fills it again at every step: zeroing a new one would cost as much as Fresnel's formulas.
struct Branches {
    Node node[4];
    Side side[4]{};
    int count = 0;
    double absorbed = 0.0;  ///< weight that is lost at the boundary (BoundaryResponse::absorption)
    bool valid = true;      ///< false: the ray brings no energy to the boundary, a numerical failure

    void clear() {
        count = 0;
        absorbed = 0.0;
        valid = true;
    }
};

/// Isotropic medium, absorbing or not, to isotropic medium or conductor. `normal` is unit and leans along the ray.
inline void cross_isotropic_boundary(const Node& node, const Dielectric<double>& from, const Dielectric<double>& to,
                                     const DVec3& normal, Branches& out) {
    out.clear();
    const DVec3& d = node.wave.ray;
    const double cos_1 = dot(normal, d);
    if (!(cos_1 > 0.0)) {
        out.valid = false;
        return;
    }

    const auto take = [&](Side side, double n, const DVec3& s, const PairChild<double>& wave) {
        out.side[out.count] = side;
        Node& child = out.node[out.count++];
        child.wave.kind = WaveKind::pair;
        child.wave.ray = wave.ray;
        child.wave.k = wave.ray * n;
        child.wave.field[0] = s;
        child.wave.field[1] = wave.p;
        child.throughput = wave.throughput;
        child.weight = wave.weight;
    };
    const auto take_both = [&](const auto& boundary, double n1, double n2) {
        if (boundary.reflected.weight != 0.0) take(Side::reflected, n1, boundary.s, boundary.reflected);
        if (boundary.transmitted.weight != 0.0) take(Side::transmitted, n2, boundary.s, boundary.transmitted);
    };
    if (!from.is_complex() && !to.is_complex())
        return take_both(transparent_boundary(d, node.wave.field, node.throughput, normal, from.n, to.n), from.n, to.n);

    const double k1 = from.is_complex() ? std::sqrt(length2(node.wave.k)) : from.n;
    if (from == to) {
        const DVec3 s = across_incidence(d, node.wave.field[0], normal);
        const Throughput<double> m = in_basis(node.throughput, node.wave.field, s, cross(d, s));
        return take(Side::transmitted, k1, s, pair_child(m, s, d, Complex<double>(1.0), Complex<double>(1.0)));
    }
    const auto boundary = absorbing_boundary<double>(d, node.wave.field, node.throughput, normal, {from.n, from.kappa},
                                                     {to.n, to.kappa}, k1, to.kind != MediumKind::isotropic);
    take_both(boundary, k1, boundary.behind);
    out.absorbed = boundary.absorbed;
}

/// A crystal on one side or both, through the general solver.
inline void cross_crystal_boundary(const Node& node, const Dielectric<double>& from, const Dielectric<double>& to,
                                   const DVec3& normal, Branches& out) {
    out.clear();
    const BoundaryResponse<double> response = respond(from, to, normal, node.wave);
    if (!response.incident) {
        out.valid = false;
        return;
    }
    const bool pair = response.incident_modes == 2;
    const Throughput<double> m =
        pair ? in_basis(node.throughput, node.wave.field, response.incident_field[0], response.incident_field[1])
             : node.throughput;
    for (int i = 0; i < response.outgoing_count; ++i) {
        const OutgoingWave<double>& wave = response.outgoing[static_cast<std::size_t>(i)];
        Node& child = out.node[out.count];
        out.side[out.count++] = wave.side;
        child.wave = wave.wave;
        child.throughput = on_wave(m, wave, response.incident_modes);
        child.weight = child.throughput.weight();
    }
    if (response.absorbs) {
        // absorbed = sum over camera rows of m A m^H / 2, with the transpose of A since m acts backward
        Complex<double> sum;
        for (int row = 0; row < 2; ++row)
            for (std::size_t i = 0; i < (pair ? 2U : 1U); ++i)
                for (std::size_t j = 0; j < (pair ? 2U : 1U); ++j)
                    sum += m.m[row][i] * response.absorption[j][i] * conj(m.m[row][j]);
        out.absorbed = 0.5 * sum.re;
    }
}

/// Any pair of media, the cheaper way where there is one.
inline void cross_boundary(const Node& node, const Dielectric<double>& from, const Dielectric<double>& to,
                           const DVec3& normal, Branches& out) {
    if (from.kind == MediumKind::uniaxial || to.kind == MediumKind::uniaxial)
        cross_crystal_boundary(node, from, to, normal, out);
    else
        cross_isotropic_boundary(node, from, to, normal, out);
}

/// Straight through an ideal sheet in an isotropic medium. `normal` of the sheet is unit, of either sign.
inline Node through_sheet(const Node& node, const Sheet& sheet, const DVec3& normal, const Left& left) {
    Node child = node;
    child.left = left;
    child.throughput = behind_sheet(node.throughput,
                                    sheet_jones(sheet, normal, -node.wave.ray, node.wave.field[0], node.wave.field[1]));
    child.weight = child.throughput.weight();
    return child;
}

}  // namespace pol
