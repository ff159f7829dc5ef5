// SPDX-License-Identifier: Apache-2.0
#include "plan/arrangement.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "core/overloaded.h"
#include "core/result.h"
#include "geometry/overlap.h"
#include "plan/compile_media.h"
#include "plan/covers.h"
#include "plan/reach.h"
#include "scene/place.h"

namespace pol {

namespace {

using Relations = std::vector<std::vector<Arrangement>>;

bool share_volume(Arrangement a) {
    return a == Arrangement::a_contains_b || a == Arrangement::b_contains_a || a == Arrangement::overlapping;
}

/// Whether `a` fills the volume that both have in common.
bool outranks(const Plan& plan, const Relations& relations, int a, int b) {
    const int rank_a = plan.solid(a).priority.value_or(0);
    const int rank_b = plan.solid(b).priority.value_or(0);
    if (rank_a != rank_b) return rank_a > rank_b;
    return relations[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] == Arrangement::b_contains_a;
}

Error overlap_error(const Scene& scene, const Solid& a, const Solid& b) {
    return at_object({ErrorKind::input,
                      "'" + a.name + "' and '" + b.name + "' overlap: which of them fills the volume that both claim?",
                      {},
                      "priority",
                      "move them apart, let them touch, or give one a higher priority"},
                     scene, b.object);
}

Result<Relations> relate(const Scene& scene, Plan& plan) {
    const int count = plan.solid_count();
    Relations relations(static_cast<std::size_t>(count),
                        std::vector<Arrangement>(static_cast<std::size_t>(count), Arrangement::disjoint));
    for (int a = 0; a < count; ++a) {
        for (int b = a + 1; b < count; ++b) {
            const SolidRef ref_a = solid_ref(plan.solid(a));
            const SolidRef ref_b = solid_ref(plan.solid(b));
            const Arrangement ab = arrangement(ref_a, ref_b);
            relations[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] = ab;
            const Arrangement ba = ab == Arrangement::a_contains_b   ? Arrangement::b_contains_a
                                   : ab == Arrangement::b_contains_a ? Arrangement::a_contains_b
                                                                     : ab;
            relations[static_cast<std::size_t>(b)][static_cast<std::size_t>(a)] = ba;
            const bool equal_rank = plan.solid(a).priority.value_or(0) == plan.solid(b).priority.value_or(0);
            const bool equal_solids = ab == Arrangement::a_contains_b && arrangement(ref_b, ref_a) == ab;
            const bool undecided =
                ab == Arrangement::overlapping || (equal_solids && plan.solid(a).medium != plan.solid(b).medium);
            if (undecided && equal_rank) return overlap_error(scene, plan.solid(a), plan.solid(b));
            if (ab == Arrangement::disjoint) continue;
            const bool flush = share_volume(ab);
            for (const FacetPair& pair : common_facets(ref_a, ref_b, flush ? Facing::same : Facing::opposite)) {
                add_contact(plan.solids[static_cast<std::size_t>(a)], &Solid::contacts, pair.a,
                            {b, pair.b, flush, pair.distance});
                add_contact(plan.solids[static_cast<std::size_t>(b)], &Solid::contacts, pair.b,
                            {a, pair.a, flush, pair.distance});
            }
        }
    }
    return relations;
}

bool has(const std::vector<int>& sorted, int value) {
    return std::binary_search(sorted.begin(), sorted.end(), value);
}

class RegionBuilder {
public:
    RegionBuilder(const Scene& scene, const Relations& relations, Plan& plan)
        : scene_(scene), relations_(relations), plan_(plan), reach_(plan.solids) {}

    /// All sets of solids that a point can be inside of, reached from outside by crossing one boundary at a time.
    Result<Done> build() {
        find({});
        for (std::size_t i = 0; i < plan_.regions.size(); ++i) {
            std::vector<int> toggled(plan_.solids.size(), -1);
            for (int solid = 0; solid < plan_.solid_count(); ++solid) {
                std::vector<int> members = plan_.regions[i].members;
                if (has(members, solid))
                    std::erase(members, solid);
                else
                    members.insert(std::upper_bound(members.begin(), members.end(), solid), solid);
                if (possible(members)) toggled[static_cast<std::size_t>(solid)] = find(members);
            }
            plan_.regions[i].toggled = std::move(toggled);
            if (plan_.regions.size() > 4096)
                return refusal(plan_.regions.back(), "overlaps others, in more than 4096 ways in all",
                               "use fewer overlapping solids");
        }
        for (Region& region : plan_.regions) {
            POL_TRY_DONE(list_candidates(region));
        }
        return Done{};
    }

private:
    [[nodiscard]] Arrangement relation(int a, int b) const {
        return relations_[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
    }

    [[nodiscard]] bool possible(const std::vector<int>& members) const {
        for (const int a : members)  // few: in most scenes nearly all sets end here
            for (const int b : members)
                if (a < b && !share_volume(relation(a, b))) return false;
        for (const int member : members)
            for (int host = 0; host < plan_.solid_count(); ++host)
                if (relation(host, member) == Arrangement::a_contains_b && !has(members, host)) return false;
        return true;
    }

    /// About the solid that owns the region.
    [[nodiscard]] Error refusal(const Region& region, const std::string& what, std::string hint) const {
        const Solid& owner = plan_.solid(region.owner);
        return at_object({ErrorKind::input, "'" + owner.name + "' " + what, {}, {}, std::move(hint)}, scene_,
                         owner.object);
    }

    int find(const std::vector<int>& members) {
        const auto [entry, is_new] = index_.try_emplace(members, static_cast<int>(plan_.regions.size()));
        if (is_new) {
            Region region;
            region.members = members;
            for (const int member : members)
                if (region.owner < 0 || outranks(plan_, relations_, member, region.owner)) region.owner = member;
            region.medium = region.owner < 0 ? 0 : plan_.solid(region.owner).medium;
            plan_.regions.push_back(std::move(region));
        }
        return entry->second;
    }

    Result<Done> list_candidates(Region& region) {
        std::vector<Mesh> meshes;
        const auto add = [&](int body, const auto& shape, std::vector<int>& list) {
            if (const auto* mesh = std::get_if<MeshBody>(&shape)) {
                meshes.push_back(mesh->mesh);
                region.caster_body.push_back(body);
            } else {
                list.push_back(body);
            }
        };
        for (int solid = 0; solid < plan_.solid_count(); ++solid) {
            if (region.toggled[static_cast<std::size_t>(solid)] < 0) continue;
            add(solid, plan_.solid(solid).shape, has(region.members, solid) ? region.exits : region.entries);
        }
        for (std::size_t i = 0; i < plan_.surfaces.size(); ++i) {
            if (plan_.kept.every_surface || reach_.into(region, plan_.surfaces[i].shape))
                add(plan_.solid_count() + static_cast<int>(i), plan_.surfaces[i].shape, region.surfaces);
        }
        region.is_open = region.members.empty() && meshes.empty() &&
                         std::none_of(region.surfaces.begin(), region.surfaces.end(), [&](int body) {
                             return std::holds_alternative<SheetRole>(plan_.surface(body).role);
                         });
        if (meshes.empty()) return Done{};
        for (std::size_t mesh = 0; mesh < region.caster_body.size(); ++mesh)
            if (has(region.members, region.caster_body[mesh]))
                region.caster_inside.push_back({static_cast<int>(mesh), -1, -1});
        if (region.caster_inside.size() > max_nested_meshes)
            return refusal(region, "is nested with other meshes more than 8 deep",
                           "flat convex solids and spheres may be");
        POL_TRY(auto caster, RayCaster::build(std::move(meshes)));
        region.caster = std::make_unique<const RayCaster>(std::move(caster));
        return Done{};
    }

    const Scene& scene_;
    const Relations& relations_;
    Plan& plan_;
    const Reach reach_;
    std::map<std::vector<int>, int> index_;
};

}  // namespace

Result<Done> arrange(const Scene& scene, Plan& plan) {
    POL_TRY_DONE(find_covers(scene, plan));
    POL_TRY(const auto relations, relate(scene, plan));
    for (Solid& solid : plan.solids) {
        if (plan.kept.contacts) solid.contacts.resize(facet_count(solid));
        if (plan.kept.covers) solid.covers.resize(facet_count(solid));
    }
    return RegionBuilder(scene, relations, plan).build();
}

Kernel Plan::kernel() const {
    Kernel kernel{kept.crystals, kept.absorption};
    for (const WavelengthGroup& group : groups)
        for (const MediumAt& medium : group.media) {
            if (medium.dielectric.kind == MediumKind::uniaxial) kernel.anisotropic = true;
            if (medium.absorption.absorbs()) kernel.absorbing = true;
        }
    return kernel;
}

int Plan::region_at(const DVec3& point) const {
    std::vector<int> members;
    for (int i = 0; i < solid_count(); ++i) {
        const bool inside = std::visit(Overloaded{
                                           [&](const MeshBody&) {
                                               for (const Region& region : regions)
                                                   for (std::size_t m = 0; m < region.caster_body.size(); ++m)
                                                       if (region.caster_body[m] == i)
                                                           return region.caster->contains(static_cast<int>(m), point);
                                               return false;
                                           },
                                           [&](const auto& shape) { return shape.contains(point, 0.0); },
                                       },
                                       solid(i).shape);
        if (inside) members.push_back(i);
    }
    for (std::size_t i = 0; i < regions.size(); ++i)
        if (regions[i].members == members) return static_cast<int>(i);
    return 0;
}

}  // namespace pol
