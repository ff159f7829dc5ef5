// SPDX-License-Identifier: Apache-2.0
#include "plan/reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "core/overloaded.h"
#include "geometry/mesh_check.h"

namespace pol {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Box box_of(const std::vector<DVec3>& points) {
    Box box{DVec3(infinity), DVec3(-infinity)};
    for (const DVec3& p : points) {
        box.low = glm::min(box.low, p);
        box.high = glm::max(box.high, p);
    }
    return box;
}

/// Points whose convex hull holds the surface, widened by a radius.
struct Hull {
    std::vector<DVec3> points;
    double radius = 0.0;
};

Hull hull_of(const SurfaceShape& shape) {
    return std::visit(Overloaded{
                          [](const OpenSurface& s) {
                              const DVec3& c = s.center();
                              const DVec3& u = s.half_u();
                              const DVec3& v = s.half_v();
                              return Hull{{c + u + v, c + u - v, c - u + v, c - u - v}, 0.0};
                          },
                          [](const HalfSpaceSolid& s) {
                              return Hull{s.vertices(), 0.0};
                          },
                          [](const Sphere& s) {
                              return Hull{{s.center}, s.radius};
                          },
                          [](const MeshBody& s) {
                              return Hull{s.mesh.vertices, 0.0};
                          },
                      },
                      shape);
}

Box box_around(const Hull& hull) {
    Box box = box_of(hull.points);
    box.low -= DVec3(hull.radius);
    box.high += DVec3(hull.radius);
    return box;
}

/// True if the whole solid lies on one side of the plane; touching it counts as beside.
bool beside(const Plane& plane, const Solid& solid, double margin) {
    const auto one_side = [&](const std::vector<DVec3>& points) {
        double low = infinity;
        double high = -low;
        for (const DVec3& p : points) {
            const double height = dot(plane.normal, p) - plane.offset;
            low = std::min(low, height);
            high = std::max(high, height);
        }
        return low >= -margin || high <= margin;
    };
    return std::visit(
        Overloaded{
            [&](const HalfSpaceSolid& s) { return one_side(s.vertices()); },
            [&](const Sphere& s) { return std::abs(dot(plane.normal, s.center) - plane.offset) >= s.radius - margin; },
            [&](const MeshBody& s) { return one_side(s.mesh.vertices); },
        },
        solid.shape);
}

/// True if the surface surely has no point inside the solid.
bool surely_outside(const SurfaceShape& shape, const Hull& hull, const Solid& solid, double margin) {
    if (const auto* open = std::get_if<OpenSurface>(&shape); open != nullptr && beside(open->plane(), solid, margin))
        return true;
    const auto* half_spaces = std::get_if<HalfSpaceSolid>(&solid.shape);
    if (half_spaces == nullptr) return false;
    for (int i = 0; i < half_spaces->facet_count(); ++i) {
        const Plane& plane = half_spaces->plane(i);
        if (std::all_of(hull.points.begin(), hull.points.end(),
                        [&](const DVec3& p) { return dot(plane.normal, p) - plane.offset >= hull.radius - margin; }))
            return true;
    }
    return false;
}

/// True if the surface surely lies wholly inside the solid.
bool surely_inside(const Hull& hull, const Solid& solid, double margin) {
    const auto all_in = [&](const auto& shape) {
        return std::all_of(hull.points.begin(), hull.points.end(),
                           [&](const DVec3& p) { return shape.contains(p, hull.radius + margin); });
    };
    return std::visit(Overloaded{
                          [&](const HalfSpaceSolid& s) { return all_in(s); },
                          [&](const Sphere& s) { return all_in(s); },
                          [](const MeshBody&) { return false; },
                      },
                      solid.shape);
}

}  // namespace

SolidRef solid_ref(const Solid& solid) {
    return std::visit(Overloaded{
                          [](const HalfSpaceSolid& s) -> SolidRef { return &s; },
                          [](const Sphere& s) -> SolidRef { return &s; },
                          [](const MeshBody& s) -> SolidRef { return &s.mesh; },
                      },
                      solid.shape);
}

double slack(const SurfaceShape& shape) {
    return std::visit(Overloaded{
                          [](const OpenSurface& s) { return slack(s.mesh()); },
                          [](const HalfSpaceSolid& s) { return s.slack(); },
                          [](const Sphere& s) { return slack(SolidRef{&s}); },
                          [](const MeshBody& s) { return slack(s.mesh); },
                      },
                      shape);
}

bool Box::apart(const Box& other, double margin) const {
    const DVec3 between = glm::max(low - other.high, other.low - high);
    return std::max({between.x, between.y, between.z}) > margin;
}

Box box_around(const SurfaceShape& shape) {
    return box_around(hull_of(shape));
}

Box box_around(const Solid& solid) {
    return std::visit([](const auto& shape) { return box_around(SurfaceShape{shape}); }, solid.shape);
}

Reach::Reach(const std::vector<Solid>& solids) {
    for (const Solid& solid : solids) solids_.push_back({&solid, box_around(solid), slack(solid_ref(solid))});
}

bool Reach::into(const Region& region, const SurfaceShape& shape) const {
    const Hull hull = hull_of(shape);
    const Box box = box_around(hull);
    const double own_slack = slack(shape);
    for (std::size_t i = 0; i < solids_.size(); ++i) {
        const Known& known = solids_[i];
        const double margin = own_slack + known.slack;
        const bool member = std::binary_search(region.members.begin(), region.members.end(), static_cast<int>(i));
        if (member ? known.box.apart(box, margin) || surely_outside(shape, hull, *known.solid, margin)
                   : surely_inside(hull, *known.solid, margin))
            return false;
    }
    return true;
}

}  // namespace pol
