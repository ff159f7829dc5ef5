// SPDX-License-Identifier: Apache-2.0
#include "viewer/space/space_wireframe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/overloaded.h"
#include "core/units.h"

namespace pol {

namespace {

constexpr int circle_steps = 48;

using Edges = std::vector<SpaceLine>;

/// The ellipse center + cos u + sin v.
std::vector<DVec3> circle(const DVec3& center, const DVec3& u, const DVec3& v) {
    std::vector<DVec3> points;
    for (int i = 0; i < circle_steps; ++i) {
        const double angle = 2.0 * pi * i / circle_steps;
        points.push_back(center + std::cos(angle) * u + std::sin(angle) * v);
    }
    return points;
}

Edges closed_line(const std::vector<DVec3>& points) {
    Edges edges;
    for (std::size_t i = 0; i < points.size(); ++i) edges.push_back({points[i], points[(i + 1) % points.size()]});
    return edges;
}

Edges edges_of(const Mesh& mesh) {
    const double sharp = std::cos(radians(10.0));
    // Facets on both sides of an edge, by its two vertices in ascending order.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> sides;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i)
            sides[std::minmax(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3])].push_back(
                mesh.facet_of_triangle[t]);
    }
    Edges edges;
    for (const auto& [ends, facets] : sides) {
        if (facets.size() == 2) {
            if (facets[0] == facets[1]) continue;
            if (dot(mesh.facets[facets[0]].normal, mesh.facets[facets[1]].normal) > sharp) continue;
        }
        edges.push_back({mesh.vertices[ends.first], mesh.vertices[ends.second]});
    }
    return edges;
}

Edges edges_of(const Sphere& ball) {
    Edges edges;
    const DVec3 axes[3] = {{ball.radius, 0.0, 0.0}, {0.0, ball.radius, 0.0}, {0.0, 0.0, ball.radius}};
    for (int i = 0; i < 3; ++i) {
        const Edges ring = closed_line(circle(ball.center, axes[i], axes[(i + 1) % 3]));
        edges.insert(edges.end(), ring.begin(), ring.end());
    }
    return edges;
}

std::vector<DVec3> outline_of(const OpenSurface& surface) {
    const DVec3& u = surface.half_u();
    const DVec3& v = surface.half_v();
    const DVec3& c = surface.center();
    // A disk has less area than the parallelogram around it.
    const bool is_disk = surface.area() < 3.9 * glm::length(cross(u, v));
    if (is_disk) return circle(c, u, v);
    return {c - u - v, c + u - v, c + u + v, c - u + v};
}

BodyLines lines_of(int body, const std::variant<HalfSpaceSolid, Sphere, MeshBody>& shape) {
    return {body,
            std::visit(Overloaded{[](const HalfSpaceSolid& solid) { return edges_of(solid.mesh()); },
                                  [](const Sphere& ball) { return edges_of(ball); },
                                  [](const MeshBody& mesh) { return edges_of(mesh.mesh); }},
                       shape),
            {}};
}

BodyLines lines_of(int body, const std::variant<OpenSurface, HalfSpaceSolid, Sphere, MeshBody>& shape) {
    return std::visit(Overloaded{[&](const OpenSurface& surface) {
                                     const std::vector<DVec3> outline = outline_of(surface);
                                     return BodyLines{body, closed_line(outline), outline};
                                 },
                                 [&](const HalfSpaceSolid& solid) {
                                     return BodyLines{body, edges_of(solid.mesh()), {}};
                                 },
                                 [&](const Sphere& ball) {
                                     return BodyLines{body, edges_of(ball), {}};
                                 },
                                 [&](const MeshBody& mesh) {
                                     return BodyLines{body, edges_of(mesh.mesh), {}};
                                 }},
                      shape);
}

/// An interval of the line's parameter, empty if low >= high.
struct Hidden {
    double low = 1.0;
    double high = 0.0;
};

/// The points of the triangle a, b, eye are a + v (b - a) + w (eye - a); the solid cuts a polygon out of it, which
/// hides the points of the line that lie on rays through it from the eye: t = v / (1 - w).
Hidden hidden_by(const HalfSpaceSolid& solid, const SpaceLine& line, const DVec3& eye, double margin) {
    std::vector<DVec2> polygon{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
    for (int facet = 0; facet < solid.facet_count() && !polygon.empty(); ++facet) {
        const Plane& plane = solid.plane(facet);
        const auto excess = [&](const DVec2& p) {
            const DVec3 at = line.a + p.x * (line.b - line.a) + p.y * (eye - line.a);
            return dot(plane.normal, at) - plane.offset + margin;
        };
        std::vector<DVec2> inside;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const DVec2& p = polygon[i];
            const DVec2& q = polygon[(i + 1) % polygon.size()];
            const double at_p = excess(p);
            const double at_q = excess(q);
            if (at_p <= 0.0) inside.push_back(p);
            if ((at_p <= 0.0) != (at_q <= 0.0)) inside.push_back(p + (q - p) * (at_p / (at_p - at_q)));
        }
        polygon = std::move(inside);
    }
    Hidden hidden;
    for (const DVec2& p : polygon) {
        // The eye itself is inside: it sees everything through that solid.
        if (p.y >= 1.0 - 1e-12) return {};
        hidden.low = std::min(hidden.low, p.x / (1.0 - p.y));
        hidden.high = std::max(hidden.high, p.x / (1.0 - p.y));
    }
    return hidden;
}

/// How deep the line of sight from `eye` to `p` dives into the ball, as a distance below its surface.
double depth_inside(const Sphere& ball, const DVec3& p, const DVec3& eye) {
    const DVec3 way = p - eye;
    const double nearest = std::clamp(dot(ball.center - eye, way) / length2(way), 0.0, 1.0);
    return ball.radius - glm::length(eye + nearest * way - ball.center);
}

/// The shadow of a ball is convex, so its part of a line is an interval: looked for at points, then by bisection.
Hidden hidden_by(const Sphere& ball, const SpaceLine& line, const DVec3& eye, double margin) {
    if (glm::length(eye - ball.center) < ball.radius) return {};
    const auto is_hidden = [&](double t) { return depth_inside(ball, line.a + t * (line.b - line.a), eye) > margin; };
    const auto border = [&](double visible, double covered) {
        for (int i = 0; i < 30; ++i) {
            const double middle = 0.5 * (visible + covered);
            (is_hidden(middle) ? covered : visible) = middle;
        }
        return covered;
    };
    constexpr int steps = 16;
    int first = 0;
    while (first <= steps && !is_hidden(static_cast<double>(first) / steps)) ++first;
    if (first > steps) return {};
    int last = steps;
    while (!is_hidden(static_cast<double>(last) / steps)) --last;
    const double at_first = static_cast<double>(first) / steps;
    const double at_last = static_cast<double>(last) / steps;
    return {first == 0 ? 0.0 : border(at_first - 1.0 / steps, at_first),
            last == steps ? 1.0 : border(at_last + 1.0 / steps, at_last)};
}

void grow(std::pair<DVec3, DVec3>& box, const DVec3& p) {
    box.first = glm::min(box.first, p);
    box.second = glm::max(box.second, p);
}

}  // namespace

std::vector<BodyLines> body_lines(const Plan& plan) {
    std::vector<BodyLines> bodies;
    for (int i = 0; i < plan.solid_count(); ++i) bodies.push_back(lines_of(i, plan.solid(i).shape));
    for (int i = 0; i < static_cast<int>(plan.surfaces.size()); ++i) {
        const int body = plan.solid_count() + i;
        bodies.push_back(lines_of(body, plan.surface(body).shape));
    }
    return bodies;
}

std::vector<SpaceLine> ball_outline(const Sphere& ball, const DVec3& eye) {
    const DVec3 out = eye - ball.center;
    const double distance = glm::length(out);
    if (distance <= ball.radius) return {};
    const double sine = ball.radius / distance;
    const DVec3 u = any_perpendicular(out / distance);
    const DVec3 v = cross(out / distance, u);
    const double ring = ball.radius * std::sqrt(1.0 - sine * sine);
    return closed_line(circle(ball.center + out * (sine * sine), ring * u, ring * v));
}

std::vector<SpacePiece> pieces_of(const SpaceLine& line, const Plan& plan, const DVec3& eye) {
    const double margin = 1e-6 * plan.length_scale;
    std::vector<Hidden> covers;
    for (const Solid& solid : plan.solids) {
        const Hidden hidden =
            std::visit(Overloaded{[&](const HalfSpaceSolid& shape) { return hidden_by(shape, line, eye, margin); },
                                  [&](const Sphere& shape) { return hidden_by(shape, line, eye, margin); },
                                  [](const MeshBody&) { return Hidden{}; }},
                       solid.shape);
        if (hidden.high - hidden.low > 1e-9) covers.push_back(hidden);
    }
    std::sort(covers.begin(), covers.end(), [](const Hidden& x, const Hidden& y) { return x.low < y.low; });

    std::vector<SpacePiece> pieces;
    const auto add = [&](double from, double to, bool hidden) {
        // A sliver at an end is a rounding error.
        if (to - from <= 1e-5) return;
        pieces.push_back({{line.a + from * (line.b - line.a), line.a + to * (line.b - line.a)}, hidden});
    };
    double done = 0.0;
    for (const Hidden& cover : covers) {
        add(done, cover.low, false);
        add(std::max(done, cover.low), cover.high, true);
        done = std::max(done, cover.high);
    }
    add(done, 1.0, false);
    return pieces;
}

BoundingBall scene_ball(const std::vector<BodyLines>& bodies, const Plan& plan) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::pair<DVec3, DVec3> nothing{DVec3(infinity), DVec3(-infinity)};
    auto solids = nothing;
    auto everything = nothing;
    for (const BodyLines& body : bodies) {
        for (const SpaceLine& edge : body.edges) {
            for (const DVec3& p : {edge.a, edge.b}) {
                grow(everything, p);
                if (plan.is_solid(body.body)) grow(solids, p);
            }
        }
    }
    const auto& box = solids.first.x <= solids.second.x ? solids : everything;
    if (!(box.first.x <= box.second.x)) return {};
    const double radius = 0.5 * glm::length(box.second - box.first);
    return {0.5 * (box.first + box.second), radius > 0.0 ? radius : 1.0};
}

std::optional<SpaceLine> optic_axis(const Plan& plan, const BodyLines& body) {
    if (!plan.is_solid(body.body) || body.edges.empty()) return std::nullopt;
    const int medium = plan.solid(body.body).medium;
    const Dielectric<double>& matter = plan.groups.front().media[static_cast<std::size_t>(medium)].dielectric;
    if (matter.kind != MediumKind::uniaxial) return std::nullopt;
    DVec3 sum{};
    for (const SpaceLine& edge : body.edges) sum += edge.a + edge.b;
    const DVec3 middle = sum / (2.0 * static_cast<double>(body.edges.size()));
    double reach = 0.0;
    for (const SpaceLine& edge : body.edges) reach = std::max(reach, std::abs(dot(edge.a - middle, matter.axis)));
    return SpaceLine{middle - 1.25 * reach * matter.axis, middle + 1.25 * reach * matter.axis};
}

std::vector<SpaceLine> camera_lines(const Plan& plan, double length) {
    const auto width = static_cast<double>(plan.settings.width);
    const auto height = static_cast<double>(plan.settings.height);
    std::vector<DVec3> far_corners;
    std::vector<DVec3> near_corners;
    for (const DVec2& corner : {DVec2(0.0, 0.0), DVec2(width, 0.0), DVec2(width, height), DVec2(0.0, height)}) {
        const CameraRay ray = plan.camera.ray(corner.x, corner.y);
        near_corners.push_back(ray.origin);
        far_corners.push_back(ray.origin + length * ray.direction);
    }
    Edges lines = closed_line(far_corners);
    for (std::size_t i = 0; i < 4; ++i) lines.push_back({near_corners[i], far_corners[i]});
    if (near_corners[0] != near_corners[1]) {
        const Edges frame = closed_line(near_corners);
        lines.insert(lines.end(), frame.begin(), frame.end());
    }
    return lines;
}

}  // namespace pol
