// SPDX-License-Identifier: Apache-2.0
// Long because proposing in float and deciding in double share the state of one query.
#include "geometry/ray_caster.h"

#if POL_EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "geometry/complaint.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_pieces.h"
#include "geometry/watertight.h"

namespace pol {
namespace {

// Lengths inside Embree, where the whole scene is a ball of radius 1. Float coordinates are off by 6e-8 and a robust
// query by a few of these: candidates closer to an edge than `edge_margin` have their neighbors tested too, and
// candidates up to `reach_margin` beyond the best hit in double may still turn out nearer.
constexpr double edge_margin = 1e-6;
constexpr double reach_margin = 1e-4;
constexpr double ball_radius = 1.001;
constexpr double infinity = std::numeric_limits<double>::infinity();

// The one place where geometry becomes float.
float to_float(double x) {
    return static_cast<float>(x);
}

struct DeviceDeleter {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneDeleter {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

// What double precision needs to know of one mesh.
struct Solid {
    Mesh mesh;
    bool closed = false;
    double slack = 0.0;                     // how far the surface may be from its planes, rounding included
    std::vector<char> flat;                 // per facet: its plane goes through its corners to rounding
    std::vector<double> lowest_height;      // per triangle, in the units of its Embree scene
    std::vector<std::uint32_t> ring_start;  // per vertex: where its triangles start in `ring`
    std::vector<std::uint32_t> ring;

    std::span<const std::uint32_t> around(std::uint32_t vertex) const {
        return std::span(ring).subspan(ring_start[vertex], ring_start[vertex + 1] - ring_start[vertex]);
    }
};

Solid prepared(Mesh mesh) {
    Solid s;
    double largest = 0.0;
    for (const DVec3& p : mesh.vertices) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    s.closed = static_cast<bool>(check_closed(mesh));
    s.flat.assign(mesh.facets.size(), 1);
    s.ring_start.assign(mesh.vertices.size() + 1, 0);
    double worst = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& v = mesh.triangles[t];
        const std::uint32_t facet = mesh.facet_of_triangle[t];
        double longest2 = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const DVec3& p = mesh.vertices[v[k]];
            const double off = std::abs(dot(mesh.facets[facet].normal, p) - mesh.facets[facet].offset);
            worst = std::max(worst, off);
            // Rounding of a plane equation is a few 1e-16; float32 files are off by 1e-8 and more.
            if (off > 1e-13 * largest) s.flat[facet] = 0;
            longest2 = std::max(longest2, length2(mesh.vertices[v[(k + 1) % 3]] - p));
            ++s.ring_start[v[k] + 1];
        }
        const DVec3 twice_area =
            cross(mesh.vertices[v[1]] - mesh.vertices[v[0]], mesh.vertices[v[2]] - mesh.vertices[v[0]]);
        s.lowest_height.push_back(std::sqrt(length2(twice_area) / longest2));
    }
    s.slack = 2.0 * worst + 1e-14 * largest;
    for (std::size_t v = 1; v < s.ring_start.size(); ++v) s.ring_start[v] += s.ring_start[v - 1];
    s.ring.resize(3 * mesh.triangles.size());
    std::vector<std::uint32_t> next(s.ring_start.begin(), s.ring_start.end() - 1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (const std::uint32_t v : mesh.triangles[t]) s.ring[next[v]++] = static_cast<std::uint32_t>(t);
    }
    s.mesh = std::move(mesh);
    return s;
}

// Whether a ray that starts as `left` says runs inside the mesh.
bool goes_inward(const Solid& solid, const LeftFacet& left, const DVec3& d) {
    if (left.facet < 0) return left.facet == LeftFacet::inside;
    return dot(solid.mesh.facets[static_cast<std::size_t>(left.facet)].normal, d) < 0.0;
}

// One ray: the decision in double about every triangle that is offered.
class Query {
public:
    Query(const std::vector<Solid>& solids, const DVec3& o, const DVec3& d, std::span<const LeftFacet> left)
        : solids_(solids), o_(o), d_(d), left_(left), ray_(o, d) {}

    const std::optional<MeshHit>& best() const { return best_; }

    // The line's crossing of a triangle, whatever becomes of it as a hit.
    std::optional<TriangleCrossing> offer(std::size_t mesh, std::size_t triangle) {
        const Mesh& m = solids_[mesh].mesh;
        const auto& v = m.triangles[triangle];
        const auto crossing = ray_.cross(m.vertices[v[0]], m.vertices[v[1]], m.vertices[v[2]]);
        if (crossing) judge(mesh, triangle, *crossing);
        return crossing;
    }

    void offer_with_neighbors(std::size_t mesh, std::size_t triangle) {
        for (const std::uint32_t v : solids_[mesh].mesh.triangles[triangle]) {
            for (const std::uint32_t t : solids_[mesh].around(v)) offer(mesh, t);
        }
    }

    // Rounding may have put the origin, on a facet just left inward, beyond a convex edge or corner of it: the line may
    // then miss the solid, yet in truth the ray leaves here through the other side. Those neighbors are taken as
    // planes.
    void offer_planes_beside(const LeftFacet& left) {
        const Solid& solid = solids_[static_cast<std::size_t>(left.mesh)];
        const Mesh& m = solid.mesh;
        const Plane& own = m.facets[static_cast<std::size_t>(left.facet)];
        const double own_along = dot(own.normal, d_);
        if (!solid.closed || own_along >= 0.0) return;
        // The origin is off by rounding across its plane, and by more along the ray that found it if that was grazing.
        const double slack = solid.slack * (1.0 + std::sqrt(length2(d_)) / -own_along);
        for (const std::uint32_t v : m.triangles[static_cast<std::size_t>(left.triangle)]) {
            for (const std::uint32_t t : solid.around(v)) {
                const auto facet = static_cast<int>(m.facet_of_triangle[t]);
                const Plane& plane = m.facets[m.facet_of_triangle[t]];
                const double along = dot(plane.normal, d_);
                const double ahead = plane.offset - dot(plane.normal, o_);
                if (facet == left.facet || !(along > 0.0) || std::abs(ahead) > slack) continue;
                const auto& corners = m.triangles[t];
                const bool convex = std::all_of(corners.begin(), corners.end(), [&](std::uint32_t p) {
                    return dot(own.normal, m.vertices[p]) - own.offset <= solid.slack;
                });
                if (convex && distance_outside(solid, t) <= 10.0 * slack) {
                    keep({left.mesh, facet, static_cast<int>(t), ahead / along});
                }
            }
        }
    }

    void offer_all() {
        for (std::size_t m = 0; m < solids_.size(); ++m) {
            for (std::size_t t = 0; t < solids_[m].mesh.triangles.size(); ++t) offer(m, t);
        }
    }

    // In and out alternate along a ray: a surface seen on the way that faces wrongly proves that another was missed.
    bool missed_something() const { return refused_ < (best_ ? best_->distance : infinity); }

private:
    void judge(std::size_t mesh, std::size_t triangle, const TriangleCrossing& crossing) {
        const Solid& solid = solids_[mesh];
        const std::uint32_t facet = solid.mesh.facet_of_triangle[triangle];
        const Plane& plane = solid.mesh.facets[facet];
        const double along = dot(plane.normal, d_);
        const bool agrees = (along > 0.0) == crossing.leaving && along != 0.0;
        double distance = crossing.distance;
        if (solid.flat[facet] && agrees) distance = (plane.offset - dot(plane.normal, o_)) / along;
        double earliest = 0.0;
        for (const LeftFacet& l : left_) {
            if (l.mesh != static_cast<int>(mesh)) continue;
            if (l.facet == static_cast<int>(facet)) return;
            if (!solid.closed) continue;
            earliest = -solid.slack / std::abs(along);
            if (crossing.leaving == goes_inward(solid, l, d_)) continue;
            if (distance > -earliest) refused_ = std::min(refused_, distance);
            return;
        }
        if (!(distance >= earliest)) return;
        const MeshHit hit{static_cast<int>(mesh), static_cast<int>(facet), static_cast<int>(triangle), distance};
        keep(hit);
    }

    static bool before(const MeshHit& a, const MeshHit& b) {
        const auto order = [](const MeshHit& h) { return std::tuple(h.distance, h.mesh, h.facet, h.triangle); };
        return order(a) < order(b);
    }

    void keep(const MeshHit& hit) {
        if (!best_ || before(hit, *best_)) best_ = hit;
    }

    // How far the origin is beyond the edges of a triangle in whose plane it lies; negative inside.
    double distance_outside(const Solid& solid, std::uint32_t triangle) const {
        const auto& v = solid.mesh.triangles[triangle];
        const DVec3& normal = solid.mesh.facets[solid.mesh.facet_of_triangle[triangle]].normal;
        double outside = -infinity;
        for (std::size_t k = 0; k < 3; ++k) {
            const DVec3& a = solid.mesh.vertices[v[k]];
            const DVec3 edge = solid.mesh.vertices[v[(k + 1) % 3]] - a;
            outside = std::max(outside, dot(cross(edge, normal), o_ - a) / std::sqrt(length2(edge)));
        }
        return outside;
    }

    const std::vector<Solid>& solids_;
    const DVec3& o_;
    const DVec3& d_;
    std::span<const LeftFacet> left_;
    WatertightRay ray_;
    std::optional<MeshHit> best_;
    double refused_ = infinity;
};

// Embree 3 and 4 differ in the name of a query's context and in how it is passed, and in nothing else that is used
// here.
#if POL_EMBREE == 3
using QueryContext = RTCIntersectContext;
void intersect(RTCScene scene, QueryContext& context, RTCRayHit& ray) {
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
}
#else
using QueryContext = RTCRayQueryContext;
void intersect(RTCScene scene, QueryContext& context, RTCRayHit& ray) {
    rtcInitRayQueryContext(&context);
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    rtcIntersect1(scene, &ray, &arguments);
}
#endif

// Triangles of one mesh in an Embree scene, by Embree's number; empty: all, in their own order.
struct Geometry {
    std::size_t mesh = 0;
    std::vector<std::uint32_t> triangles;

    std::size_t triangle(std::size_t primitive) const { return triangles.empty() ? primitive : triangles[primitive]; }
};

// Pieces of like size near each other, in an Embree scene of their own: float has no digits left for what is small
// against its scene.
struct Cluster {
    DVec3 center{};
    double scale = 1.0;  // world -> Embree lengths
    std::vector<Geometry> geometries;
    std::unique_ptr<RTCSceneTy, SceneDeleter> scene;
};

// Embree hands the context back to the filter; it must come first.
struct EmbreeQuery {
    QueryContext context{};
    Query* query = nullptr;
    const std::vector<Solid>* solids = nullptr;
    const Cluster* cluster = nullptr;
    double speed = 1.0;     // Embree length per unit of t
    double start = 0.0;     // t at Embree's ray origin
    float farthest = 0.0F;  // current end of Embree's ray
};

// Called for every candidate: judge it in double, and shorten the ray to just beyond the best hit so far. Accepting is
// the way to shorten (Embree restores the end of the ray for refused ones); its own idea of the hit is never read.
void consider(const RTCFilterFunctionNArguments* args) {
    auto& e = *reinterpret_cast<EmbreeQuery*>(args->context);
    const Geometry& geometry = e.cluster->geometries[RTCHitN_geomID(args->hit, args->N, 0)];
    const std::size_t mesh = geometry.mesh;
    const std::size_t triangle = geometry.triangle(RTCHitN_primID(args->hit, args->N, 0));
    const Solid& solid = (*e.solids)[mesh];
    const auto crossing = e.query->offer(mesh, triangle);
    const DVec3 normal{RTCHitN_Ng_x(args->hit, args->N, 0), RTCHitN_Ng_y(args->hit, args->N, 0),
                       RTCHitN_Ng_z(args->hit, args->N, 0)};
    const DVec3 direction{RTCRayN_dir_x(args->ray, args->N, 0), RTCRayN_dir_y(args->ray, args->N, 0),
                          RTCRayN_dir_z(args->ray, args->N, 0)};
    const double slope = std::abs(dot(normal, direction)) / std::sqrt(length2(normal));
    const bool well_inside = crossing && crossing->low_weight * solid.lowest_height[triangle] * slope > edge_margin;
    if (!well_inside) e.query->offer_with_neighbors(mesh, triangle);

    args->valid[0] = 0;
    if (!e.query->best()) return;
    const float end = to_float((e.query->best()->distance - e.start) * e.speed + reach_margin);
    if (end >= e.farthest) return;
    e.farthest = end;
    RTCRayN_tfar(args->ray, args->N, 0) = end;
    args->valid[0] = -1;
}

// A ray that was inside a closed mesh must meet it again.
bool must_hit(const std::vector<Solid>& solids, std::span<const LeftFacet> left, const DVec3& d) {
    return std::any_of(left.begin(), left.end(), [&](const LeftFacet& l) {
        const Solid& solid = solids[static_cast<std::size_t>(l.mesh)];
        return solid.closed && goes_inward(solid, l, d);
    });
}

}  // namespace

struct RayCaster::Impl {
    std::vector<Solid> solids;
    std::unique_ptr<RTCDeviceTy, DeviceDeleter> device;
    std::vector<Cluster> clusters;

    Result<Done> fill_scenes();
    void fill_scene(Cluster& cluster) const;
    void ask_embree(const Cluster& cluster, Query& query, const DVec3& o, const DVec3& d) const;
};

Result<Done> RayCaster::Impl::fill_scenes() {
    device.reset(rtcNewDevice("threads=1"));
    if (!device) return complaint("", "Embree does not start on this machine", "it needs SSE2 and memory");
    for (Cluster& cluster : clusters) fill_scene(cluster);
    if (const RTCError code = rtcGetDeviceError(device.get()); code != RTC_ERROR_NONE) {
        return complaint("", "Embree cannot build its scene (error " + std::to_string(code) + ")",
                         "the meshes may need more memory than there is");
    }
    return Done{};
}

void RayCaster::Impl::fill_scene(Cluster& cluster) const {
    cluster.scene.reset(rtcNewScene(device.get()));
    RTCScene scene = cluster.scene.get();
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    for (std::size_t i = 0; i < cluster.geometries.size(); ++i) {
        const Geometry& part = cluster.geometries[i];
        const Mesh& mesh = solids[part.mesh].mesh;
        const std::size_t count = part.triangles.empty() ? mesh.triangles.size() : part.triangles.size();
        RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
        auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count));
        if (vertices != nullptr && indices != nullptr) {
            for (const DVec3& p : mesh.vertices) {
                for (int axis = 0; axis < 3; ++axis) {
                    *vertices++ = to_float((p[axis] - cluster.center[axis]) * cluster.scale);
                }
            }
            for (std::size_t k = 0; k < count; ++k) {
                const auto& triangle = mesh.triangles[part.triangle(k)];
                indices = std::copy(triangle.begin(), triangle.end(), indices);
            }
            rtcSetGeometryIntersectFilterFunction(geometry, consider);
            rtcCommitGeometry(geometry);
            rtcAttachGeometryByID(scene, geometry, static_cast<unsigned>(i));
        }
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(scene);
}

void RayCaster::Impl::ask_embree(const Cluster& cluster, Query& query, const DVec3& o, const DVec3& d) const {
    // The chord of the ray inside the scene's ball, in double: float sees only numbers of order 1.
    const double scale = cluster.scale;
    const DVec3 from = (o - cluster.center) * scale;
    const double speed = scale * std::sqrt(length2(d));
    const DVec3 direction = d * (scale / speed);
    const double middle = -dot(from, direction);
    const double off_axis2 = length2(from + middle * direction);
    if (!(off_axis2 <= ball_radius * ball_radius)) return;
    const double half = std::sqrt(ball_radius * ball_radius - off_axis2);
    const double begin = std::max(middle - half, -reach_margin);
    const double end = middle + half;
    if (!(end > begin)) return;
    const DVec3 origin = from + begin * direction;

    EmbreeQuery e;
    e.query = &query;
    e.solids = &solids;
    e.cluster = &cluster;
    e.speed = speed;
    e.start = begin / speed;
    e.farthest = to_float(end - begin + reach_margin);
    RTCRayHit ray{};
    ray.ray = {.org_x = to_float(origin.x),
               .org_y = to_float(origin.y),
               .org_z = to_float(origin.z),
               .tnear = 0.0F,
               .dir_x = to_float(direction.x),
               .dir_y = to_float(direction.y),
               .dir_z = to_float(direction.z),
               .time = 0.0F,
               .tfar = e.farthest,
               .mask = ~0U,
               .id = 0,
               .flags = 0};
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    intersect(cluster.scene.get(), e.context, ray);
}

RayCaster::RayCaster(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;
RayCaster::~RayCaster() = default;

namespace {

// Connected triangles of one mesh. Several of them make a cluster.
struct Piece {
    std::size_t mesh = 0;
    std::vector<std::uint32_t> triangles;
    DVec3 low{infinity};
    DVec3 high{-infinity};

    double radius() const { return 0.5 * glm::length(high - low); }
};

std::vector<Piece> pieces_of(const std::vector<Solid>& solids) {
    std::vector<Piece> pieces;
    for (std::size_t m = 0; m < solids.size(); ++m) {
        const Mesh& mesh = solids[m].mesh;
        const std::vector<std::uint32_t> piece_of_vertex = pol::pieces_of(mesh.vertices, mesh.triangles);
        const std::size_t first = pieces.size();
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const std::size_t index = first + piece_of_vertex[mesh.triangles[t][0]];
            if (index >= pieces.size()) pieces.resize(index + 1);
            Piece& piece = pieces[index];
            piece.mesh = m;
            piece.triangles.push_back(t);
            for (const std::uint32_t v : mesh.triangles[t]) {
                piece.low = glm::min(piece.low, mesh.vertices[v]);
                piece.high = glm::max(piece.high, mesh.vertices[v]);
            }
        }
    }
    std::erase_if(pieces, [](const Piece& p) { return p.triangles.empty(); });  // of vertices that no triangle uses
    return pieces;
}

// Largest first, each to the first cluster that stays within a thousand of its own radius: there a float is off by no
// more than 6e-5 of it.
std::vector<Cluster> clusters_of(std::vector<Solid>& solids) {
    constexpr double most = 1e3;
    std::vector<Piece> pieces = pieces_of(solids);
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const Piece& a, const Piece& b) { return a.radius() > b.radius(); });
    struct Group {
        Piece bounds;
        std::map<std::size_t, std::vector<std::uint32_t>> triangles;  // by mesh
    };
    std::vector<Group> groups;
    for (const Piece& piece : pieces) {
        const auto joined = [&](const Piece& bounds) {
            return Piece{0, {}, glm::min(bounds.low, piece.low), glm::max(bounds.high, piece.high)};
        };
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const Group& g) { return joined(g.bounds).radius() <= most * piece.radius(); });
        if (group == groups.end()) {
            groups.emplace_back();
            group = std::prev(groups.end());
        }
        group->bounds = joined(group->bounds);
        auto& triangles = group->triangles[piece.mesh];
        triangles.insert(triangles.end(), piece.triangles.begin(), piece.triangles.end());
    }
    std::vector<Cluster> clusters;
    for (Group& group : groups) {
        Cluster& cluster = clusters.emplace_back();
        cluster.center = 0.5 * (group.bounds.low + group.bounds.high);
        cluster.scale = 1.0 / group.bounds.radius();
        for (auto& [m, triangles] : group.triangles) {
            for (const std::uint32_t t : triangles) solids[m].lowest_height[t] *= cluster.scale;
            if (triangles.size() == solids[m].mesh.triangles.size()) triangles.clear();
            cluster.geometries.push_back({m, std::move(triangles)});
        }
    }
    return clusters;
}

}  // namespace

Result<RayCaster> RayCaster::build(std::vector<Mesh> meshes) {
    std::size_t triangles = 0;
    for (const Mesh& mesh : meshes) {
        triangles += mesh.triangles.size();
        for (const DVec3& p : mesh.vertices) {
            if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
                return complaint("", "a mesh vertex is not finite", "check the file and the transform");
            }
        }
    }
    if (triangles == 0) return complaint("", "the meshes have no extent", "a ray caster needs at least one triangle");
    auto impl = std::make_unique<Impl>();
    for (Mesh& mesh : meshes) impl->solids.push_back(prepared(std::move(mesh)));
    impl->clusters = clusters_of(impl->solids);
    POL_TRY_DONE(impl->fill_scenes());
    return RayCaster(std::move(impl));
}

std::optional<MeshHit> RayCaster::nearest(const DVec3& o, const DVec3& d, std::span<const LeftFacet> left) const {
    Query query(impl_->solids, o, d, left);
    // A next surface within rounding of the origin may hide from floats behind the one just left.
    for (const LeftFacet& l : left) {
        if (l.triangle < 0) continue;
        const auto mesh = static_cast<std::size_t>(l.mesh);
        const auto triangle = static_cast<std::size_t>(l.triangle);
        const Solid& solid = impl_->solids[mesh];
        const auto& v = solid.mesh.triangles[triangle];
        const WatertightRay down(o, solid.mesh.facets[static_cast<std::size_t>(l.facet)].normal);
        const auto foot = down.cross(solid.mesh.vertices[v[0]], solid.mesh.vertices[v[1]], solid.mesh.vertices[v[2]]);
        const bool well_inside = foot && foot->low_weight * solid.lowest_height[triangle] > reach_margin;
        if (well_inside) continue;
        query.offer_with_neighbors(mesh, triangle);
        query.offer_planes_beside(l);
    }
    for (const Cluster& cluster : impl_->clusters) impl_->ask_embree(cluster, query, o, d);
    if (query.missed_something() || (!query.best() && must_hit(impl_->solids, left, d))) query.offer_all();
    if (!query.best()) return std::nullopt;

    // Out of a mesh that the ray was never inside of: where a line touches an edge or corner, or nearly so, the way in
    // was missed or comes a rounding error later. Ask for it.
    const MeshHit& hit = *query.best();
    const Solid& solid = impl_->solids[static_cast<std::size_t>(hit.mesh)];
    const bool leaves = dot(solid.mesh.facets[static_cast<std::size_t>(hit.facet)].normal, d) > 0.0;
    const bool fresh = std::none_of(left.begin(), left.end(), [&](const LeftFacet& l) { return l.mesh == hit.mesh; });
    if (!solid.closed || !leaves || !fresh || encloses(solid.mesh, o)) return hit;
    std::vector<LeftFacet> outside(left.begin(), left.end());
    outside.push_back({hit.mesh, hit.facet, -1});
    Query again(impl_->solids, o, d, outside);
    again.offer_all();
    return again.best();
}

bool RayCaster::contains(int mesh, const DVec3& p) const {
    return encloses(this->mesh(mesh), p);
}

int RayCaster::mesh_count() const {
    return static_cast<int>(impl_->solids.size());
}

const Mesh& RayCaster::mesh(int index) const {
    return impl_->solids[static_cast<std::size_t>(index)].mesh;
}

}  // namespace pol
