// SPDX-License-Identifier: Apache-2.0
#include "verify/convergence/wide_replay.h"

#include <limits>
#include <variant>
#include <vector>

#include "core/overloaded.h"
#include "optics/boundary_solver.h"
#include "optics/elements.h"
#include "tracer/throughput.h"

namespace pol::verify {

namespace {

using WideVec3 = Vec3<Quad>;

/// A branch at its start, and at its end once it has arrived there.
struct WideNode {
    WideVec3 point{};
    Wave<Quad> wave{};
    Throughput<Quad> throughput{};
};

Wave<double> rounded(const Wave<Quad>& wave) {
    return {wave.kind, DVec3(wave.k), DVec3(wave.ray), {DVec3(wave.field[0]), DVec3(wave.field[1])}};
}

Dielectric<Quad> widened(const Dielectric<double>& medium) {
    return {medium.kind, Quad(medium.n), Quad(medium.n_e), Quad(medium.kappa), unit(WideVec3(medium.axis))};
}

CoherenceMatrix<Quad> widened(const CoherenceMatrix<double>& j) {
    return {Quad(j.xx), Quad(j.yy), {Quad(j.xy.re), Quad(j.xy.im)}};
}

/// Where a ray meets a body, and the outward unit normal there.
struct WideHit {
    Quad distance{};
    WideVec3 normal{};
    bool beyond_edge = false;
};

/// The plane through `on_it` across `across`, which need not be unit.
Quad distance_to_plane(const WideVec3& across, const WideVec3& on_it, const WideNode& ray) {
    return dot(across, on_it - ray.point) / dot(across, ray.wave.ray);
}

/// The facet of a recorded crossing, met by the wide ray.
class WideFacet {
public:
    WideFacet(const Crossing& crossing, const WideNode& ray, bool leaving)
        : crossing_(crossing), ray_(ray), leaving_(leaving) {}

    WideHit operator()(const HalfSpaceSolid& solid) const {
        const Plane& plane = solid.plane(crossing_.facet);
        const WideVec3 normal(plane.normal);
        const Quad distance = (Quad(plane.offset) - dot(normal, ray_.point)) / dot(normal, ray_.wave.ray);
        const WideVec3 point = ray_.point + distance * ray_.wave.ray;
        bool beyond = false;
        for (int i = 0; i < solid.facet_count(); ++i) {
            const Plane& other = solid.plane(i);
            beyond |= i != crossing_.facet && dot(WideVec3(other.normal), point) > Quad(other.offset);
        }
        return {distance, unit(normal), beyond};
    }

    WideHit operator()(const Sphere& sphere) const {
        const WideVec3 from_center = ray_.point - WideVec3(sphere.center);
        const Quad middle = -dot(from_center, ray_.wave.ray);
        const Quad radius(sphere.radius);
        const Quad half2 = radius * radius - length2(from_center + middle * ray_.wave.ray);
        const Quad half = half2 > Quad(0) ? sqrt(half2) : Quad(0);
        const Quad distance = leaving_ ? middle + half : middle - half;
        return {distance, unit(from_center + distance * ray_.wave.ray), half2 < Quad(0)};
    }

    WideHit operator()(const OpenSurface& open) const {
        const WideVec3 normal(open.plane().normal);
        return {distance_to_plane(normal, WideVec3(open.center()), ray_), unit(normal)};
    }

    /// Points lie in the triangle; normals are those of the facet, which neighbors share.
    WideHit operator()(const MeshBody& body) const {
        const auto& corners = body.mesh.triangles[static_cast<std::size_t>(crossing_.triangle)];
        const auto corner = [&](std::size_t i) { return WideVec3(body.mesh.vertices[corners[i]]); };
        const WideVec3 across = cross(corner(1) - corner(0), corner(2) - corner(0));
        const WideVec3 normal(body.mesh.facets[static_cast<std::size_t>(crossing_.facet)].normal);
        return {distance_to_plane(across, corner(0), ray_), unit(normal)};
    }

private:
    const Crossing& crossing_;
    const WideNode& ray_;
    bool leaving_;
};

class Replay {
public:
    Replay(const Plan& plan, const Explanation& explanation)
        : plan_(plan), explanation_(explanation), nodes_(explanation.tree.nodes.size()) {}

    std::optional<WideLight> run() {
        nodes_.front() = camera_node();
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const RayTreeNode& record = explanation_.tree.nodes[i];
            if (record.estimated) continue;
            if (record.brings_light())
                add_leaf(record, nodes_[i]);
            else if (!record.reason && !(plan_.is_solid(record.crossing.body) ? cross_boundary(record, nodes_[i])
                                                                              : pass_sheet(record, nodes_[i])))
                return std::nullopt;
        }
        return sum_;
    }

private:
    [[nodiscard]] const MediumAt& medium_of(int region) const {
        const WavelengthGroup& group = plan_.groups[static_cast<std::size_t>(explanation_.task.group)];
        return group.media[static_cast<std::size_t>(plan_.regions[static_cast<std::size_t>(region)].medium)];
    }

    /// The direction is kept, x made perpendicular to it, y follows as in CameraModel::ray.
    [[nodiscard]] WideNode camera_node() const {
        const CameraRay& ray = explanation_.task.ray;
        const WideVec3 direction = unit(WideVec3(ray.direction));
        const WideVec3 rough_x(ray.x);
        const WideVec3 x = unit(rough_x - dot(rough_x, direction) * direction);
        const Quad n(medium_of(explanation_.task.region).dielectric.n);
        return {WideVec3(ray.origin),
                {WaveKind::pair, n * direction, direction, {x, cross(x, direction)}},
                Throughput<Quad>::identity()};
    }

    /// Moves a branch to the facet that it met, through what absorbs on the way. Returns the facet's outward normal.
    WideVec3 arrive(const RayTreeNode& record, WideNode& node) {
        const bool leaving = dot(record.crossing.normal, record.end.wave.ray) > 0.0;
        const WideFacet facet(record.crossing, node, leaving);
        const int body = record.crossing.body;
        const WideHit hit = plan_.is_solid(body) ? std::visit(facet, plan_.solid(body).shape)
                                                 : std::visit(facet, plan_.surface(body).shape);
        sum_.beyond_edge |= hit.beyond_edge;
        const MediumAt& medium = medium_of(record.end.region);
        if (medium.absorption.absorbs()) {
            const Dielectric<Quad> crystal = widened(medium.dielectric);
            const Quad alpha = node.wave.kind == WaveKind::pair
                                   ? pair_absorption(medium.absorption, crystal.n, node.wave.k)
                                   : mode_absorption(medium.absorption, crystal.n, crystal.n_e, crystal.axis,
                                                     node.wave.field[0], node.wave.k, node.wave.ray);
            node.throughput.scale(exp(-alpha * hit.distance / Quad(2)));
        }
        node.point += hit.distance * node.wave.ray;
        return hit.normal;
    }

    void add_leaf(const RayTreeNode& record, WideNode& node) {
        if (record.reason == LeafReason::emitter) arrive(record, node);
        const CoherenceMatrix<double> source = leaf_source(plan_, explanation_, record, rounded(node.wave));
        const Stokes<Quad> light = node.throughput.gather(widened(source));
        sum_.light += plan_.settings.unpolarized ? Stokes<Quad>{light.s0, Quad(0), Quad(0), Quad(0)} : light;
    }

    /// As the kernel hands it on to a branch of so many modes.
    [[nodiscard]] Throughput<Quad> kept(const Throughput<Quad>& behind, int modes) const {
        return plan_.settings.unpolarized ? Throughput<Quad>::of_weight(behind.weight(), modes) : behind;
    }

    bool pass_sheet(const RayTreeNode& record, WideNode& node) {
        const WideVec3 normal = arrive(record, node);
        const auto& role = std::get<SheetRole>(plan_.surface(record.crossing.body).role);
        const Wave<Quad>& wave = node.wave;
        const Throughput<Quad> behind =
            behind_sheet(node.throughput, sheet_jones(role.sheet, normal, -wave.ray, wave.field[0], wave.field[1]));
        for (const int child : record.children)
            nodes_[static_cast<std::size_t>(child)] = {node.point, wave, kept(behind, wave.mode_count())};
        return !record.children.empty() || !counts(behind);
    }

    /// False: the branches are not those of the record.
    bool cross_boundary(const RayTreeNode& record, WideNode& node) {
        WideVec3 normal = arrive(record, node);
        if (dot(normal, node.wave.ray) < Quad(0)) normal = -normal;
        const FarSide far = far_side(plan_, record.end.region, record.crossing, record.end.origin);
        const BoundaryResponse<Quad> response = respond(widened(medium_of(record.end.region).dielectric),
                                                        widened(medium_of(far.region).dielectric), normal, node.wave);
        if (!response.incident) return false;
        const Throughput<Quad> m =
            response.incident_modes == 2
                ? in_basis(node.throughput, node.wave.field, response.incident_field[0], response.incident_field[1])
                : node.throughput;
        int found = 0;
        for (int i = 0; i < response.outgoing_count; ++i) {
            const OutgoingWave<Quad>& out = response.outgoing[static_cast<std::size_t>(i)];
            const Throughput<Quad> behind = on_wave(m, out, response.incident_modes);
            if (const std::optional<std::size_t> child = child_of(record, out)) {
                nodes_[*child] = {node.point, out.wave, kept(behind, out.wave.mode_count())};
                ++found;
            } else if (counts(behind)) {
                return false;
            }
        }
        return found == static_cast<int>(record.children.size());
    }

    /// The child that a wave is: there are none or one of a kind.
    [[nodiscard]] std::optional<std::size_t> child_of(const RayTreeNode& record, const OutgoingWave<Quad>& out) const {
        for (const int index : record.children) {
            const RayTreeNode& child = explanation_.tree.nodes[static_cast<std::size_t>(index)];
            const bool reflected = child.interaction == Interaction::reflected;
            if (reflected == (out.side == Side::reflected) && child.start.wave.kind == out.wave.kind)
                return static_cast<std::size_t>(index);
        }
        return std::nullopt;
    }

    /// Whether a double that sums weights up to 1 would notice.
    static bool counts(const Throughput<Quad>& throughput) {
        return throughput.weight() > Quad(std::numeric_limits<double>::epsilon());
    }

    const Plan& plan_;
    const Explanation& explanation_;
    std::vector<WideNode> nodes_;
    WideLight sum_{};
};

}  // namespace

std::optional<WideLight> wide_light(const Plan& plan, const Explanation& explanation) {
    return Replay(plan, explanation).run();
}

Stokes<double> light_without_tail(const RayTree& tree) {
    Stokes<double> sum;
    for (const int leaf : tree.leaves) {
        const RayTreeNode& node = tree.nodes[static_cast<std::size_t>(leaf)];
        if (node.brings_light() && !node.estimated) sum += node.light;
    }
    return sum;
}

double rounding_distance(const Stokes<double>& rounded, const Stokes<Quad>& exact) {
    const Stokes<Quad> wide{Quad(rounded.s0), Quad(rounded.s1), Quad(rounded.s2), Quad(rounded.s3)};
    return static_cast<double>(sqrt(frobenius_square(wide - exact)));
}

}  // namespace pol::verify
