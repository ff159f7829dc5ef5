// SPDX-License-Identifier: Apache-2.0
#include "plan/list_features.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "core/number_text.h"
#include "core/units.h"
#include "plan/coherence.h"
#include "plan/covers.h"
#include "plan/lanes.h"
#include "scene/check.h"

namespace pol {

namespace {

/// "a, b and 3 more"
std::string join(const std::vector<std::string>& names) {
    std::string text;
    constexpr std::size_t shown = 3;
    for (std::size_t i = 0; i < names.size() && i < shown; ++i) text += (i > 0 ? ", " : "") + names[i];
    if (names.size() > shown) text += " and " + std::to_string(names.size() - shown) + " more";
    return text;
}

/// Names of the solids whose medium has a property in some wavelength group.
std::vector<std::string> solids_with(const Plan& plan, const std::function<bool(const MediumAt&)>& property) {
    std::vector<std::string> names;
    for (const Solid& solid : plan.solids) {
        const bool any = std::any_of(plan.groups.begin(), plan.groups.end(), [&](const WavelengthGroup& group) {
            return property(group.media[static_cast<std::size_t>(solid.medium)]);
        });
        if (any) names.push_back(solid.name);
    }
    return names;
}

template <class Role>
std::vector<std::string> surfaces_with(const Plan& plan) {
    std::vector<std::string> names;
    for (const Surface& surface : plan.surfaces)
        if (std::holds_alternative<Role>(surface.role)) names.push_back(surface.name);
    return names;
}

/// Names of what Embree must meet.
std::vector<std::string> mesh_bodies(const Plan& plan) {
    std::vector<std::string> names;
    for (const Solid& solid : plan.solids)
        if (std::holds_alternative<MeshBody>(solid.shape)) names.push_back(solid.name);
    for (const Surface& surface : plan.surfaces)
        if (std::holds_alternative<MeshBody>(surface.shape)) names.push_back(surface.name);
    return names;
}

class Account {
public:
    /// `spare`: the code for it, if there is some that would run.
    void add(const std::string& name, const std::vector<std::string>& users, const std::string& use,
             const std::string& why_not, bool SpareParts::*spare = nullptr) {
        say(name, !users.empty(), users.empty() ? why_not : use + join(users), spare);
    }
    void say(const std::string& name, bool needed, const std::string& reason, bool SpareParts::*spare = nullptr) {
        list.push_back({name, needed, reason, needed ? nullptr : spare});
    }
    std::vector<Feature> list;
};

void account_for_matter(const Plan& plan, Account& account) {
    std::vector<std::string> dispersive;
    if (plan.groups.size() > 1) {
        for (const Solid& solid : plan.solids) {
            const auto m = static_cast<std::size_t>(solid.medium);
            const bool varies = std::any_of(plan.groups.begin(), plan.groups.end(), [&](const WavelengthGroup& g) {
                return !(g.media[m] == plan.groups[0].media[m]);
            });
            if (varies) dispersive.push_back(solid.name);
        }
        if (dispersive.empty())
            dispersive.emplace_back(plan.groups[0].places != 0 ? "an index that is a function of the wavelength"
                                                               : "a virtual crystal plate");
    }
    const std::string trees = std::to_string(plan.groups.size());
    account.add("dispersion", dispersive,
                trees + " trees for " + std::to_string(plan.wavelengths_nm.size()) + " wavelengths: ",
                plan.wavelengths_nm.size() == 1 ? "one wavelength asked"
                                                : "no medium changes with wavelength: one tree serves all",
                plan.wavelengths_nm.size() == 1 ? nullptr : &SpareParts::tree_per_wavelength);
    account.add("crystals (o and e rays)",
                solids_with(plan, [](const MediumAt& m) { return m.dielectric.kind == MediumKind::uniaxial; }),
                "double refraction in ", "no medium with two different indices", &SpareParts::crystals);
    account.add("metals",
                solids_with(plan, [](const MediumAt& m) { return m.dielectric.kind == MediumKind::conductor; }),
                "complex index of ", "no conductor");
    account.add("absorbing surfaces",
                solids_with(plan,
                            [](const MediumAt& m) {
                                return m.dielectric.kind == MediumKind::isotropic && m.dielectric.is_complex();
                            }),
                "complex index of ", "no isotropic medium absorbs");
    account.add("absorption along rays", solids_with(plan, [](const MediumAt& m) { return m.absorption.absorbs(); }),
                "Beer-Lambert in ", "no medium absorbs", &SpareParts::absorption);
    account.add("polarizers and retarders", surfaces_with<SheetRole>(plan), "", "no sheets");
}

void account_for_extinction(const Scene& scene, Account& account) {
    account.add("extinction taken as 0", unknown_extinctions(scene), "",
                "every record that has k has it at all wavelengths");
}

/// Whether a list by facet has any entry.
bool is_listed(const std::vector<std::vector<Contact>>& by_facet) {
    return std::any_of(by_facet.begin(), by_facet.end(), [](const auto& entries) { return !entries.empty(); });
}

/// What fills the regions that rays start in.
std::vector<std::string> region_names(const Plan& plan) {
    std::vector<std::string> names;
    for (const int region : plan.camera_regions) {
        const int owner = plan.regions[static_cast<std::size_t>(region)].owner;
        names.push_back(owner < 0 ? "the surroundings" : plan.solid(owner).name);
    }
    return names;
}

/// Surfaces that are not looked for in some region. There are three that take more than time if they are: one in a face
/// of a solid (`covered`), which a ray must not meet from inside, and a sheet or a mesh, which would make a region no
/// longer open (Region::is_open).
void account_for_reach(const Plan& plan, bool covered, Account& account) {
    std::vector<std::string> out_of_reach;
    bool only_time = !covered;
    for (std::size_t i = 0; i < plan.surfaces.size(); ++i) {
        const Surface& surface = plan.surfaces[i];
        const int body = plan.solid_count() + static_cast<int>(i);
        const bool everywhere = std::all_of(plan.regions.begin(), plan.regions.end(), [body](const Region& region) {
            return std::count(region.surfaces.begin(), region.surfaces.end(), body) > 0 ||
                   std::count(region.caster_body.begin(), region.caster_body.end(), body) > 0;
        });
        if (everywhere) continue;
        out_of_reach.push_back(surface.name);
        if (std::holds_alternative<SheetRole>(surface.role) || std::holds_alternative<MeshBody>(surface.shape))
            only_time = false;
    }
    if (out_of_reach.empty())
        account.say("surfaces in every region", !plan.surfaces.empty(),
                    plan.surfaces.empty() ? "no surface" : "all can be met from everywhere");
    else
        account.say("surfaces in every region", false, "not looked for where they cannot be: " + join(out_of_reach),
                    only_time ? &SpareParts::every_surface : nullptr);
}

void account_for_geometry(const Plan& plan, Account& account) {
    std::vector<std::string> half_spaces;
    std::vector<std::string> spheres;
    std::vector<std::string> touching;
    std::vector<std::string> covered;
    for (const Solid& solid : plan.solids) {
        if (std::holds_alternative<HalfSpaceSolid>(solid.shape)) half_spaces.push_back(solid.name);
        if (std::holds_alternative<Sphere>(solid.shape)) spheres.push_back(solid.name);
        if (is_listed(solid.contacts)) touching.push_back(solid.name);
        if (is_listed(solid.covers)) covered.push_back(solid.name);
    }
    std::vector<std::string> nested;
    for (const Region& region : plan.regions)
        if (region.members.size() > 1)
            for (const int member : region.members)
                if (std::find(nested.begin(), nested.end(), plan.solid(member).name) == nested.end())
                    nested.push_back(plan.solid(member).name);
    account.add("half-space solids", half_spaces, "exact planes in double: ", "no flat convex solid");
    account.add("analytic spheres", spheres, "", "no sphere");
    account.add(
        "Embree scene", mesh_bodies(plan), "meshes that are not convex, not closed, or of more than 4096 facets: ",
        "flat convex solids, spheres and flat surfaces need none", half_spaces.empty() ? nullptr : &SpareParts::meshes);
    account.add("shared faces", touching, "touching solids become one interface: ", "no two solids touch",
                plan.solids.empty() ? nullptr : &SpareParts::contacts);
    account.add("lamps or absorbers in faces", covered, "met before what lies behind them: faces of ",
                "none lies in a face of a solid", plan.solids.empty() ? nullptr : &SpareParts::covers);
    account.add("faces nearly in one plane", near_misses(plan),
                "traced as written, gap or overlap: ", "none within a millionth of each other that do not touch");
    account.add("nested or overlapping media", nested, "", "no solid lies inside another");
    account.add("start of every ray", plan.camera_region < 0 ? region_names(plan) : std::vector<std::string>(),
                "rays start in ", "all rays start in one region", &SpareParts::start_search);
    account_for_reach(plan, !covered.empty(), account);
}

void account_for_light(const Scene& scene, const Plan& plan, Account& account) {
    std::vector<std::string> textured;
    std::vector<std::string> polarized;
    for (const Object& object : scene.objects) {
        const auto* emission = std::get_if<Emission>(&object.role);
        if (emission == nullptr) continue;
        if (std::holds_alternative<TexturedRadiance>(emission->radiance)) textured.push_back(object.name);
        if (!std::holds_alternative<Unpolarized>(emission->state)) polarized.push_back(object.name);
    }
    account.add("textured emission", textured, "", "no emitter has a texture");
    account.add("polarized emission", polarized, "", "every emitter is unpolarized");
    const bool lit = std::any_of(plan.background.begin(), plan.background.end(), [](double v) { return v != 0.0; });
    account.say("background light", lit, lit ? "uniform surroundings" : "black surroundings");
    const bool area = plan.settings.mode == SampleMode::area;
    account.say("pixel area sampling", area,
                area ? "quasi-random over each pixel" : "point mode: one ray through the pixel centre");
    const bool halves = plan.settings.has_halves();
    account.say("halves of the samples", halves,
                halves ? "their difference tells the error of sampling"
                       : std::string(area ? "one sample" : "all samples are one ray") + ": no error to tell",
                &SpareParts::halves);
    const bool polarized_light = !plan.settings.unpolarized;
    account.say("polarization", polarized_light,
                polarized_light ? "a matrix for every branch" : "forgotten at every surface, as asked");
    const bool depth = plan.settings.depth.has_value();
    account.say("depth limit", depth,
                depth ? "the paper's mode: depth " + std::to_string(*plan.settings.depth) : "trees are cut by energy",
                &SpareParts::depth_limit);
}

/// Glass that absorbs, in solids with faces that are not parallel. Waves in it are followed as those behind one plane
/// face, Im k along its normal; at another face k_t is complex, and total reflection takes or gives a share of order k:
/// 6 to 11 percent at k = 0.005 for n = 1.5 and 1.45 at 45 degrees.
std::vector<std::string> doubts_of_absorbing_glass(const Plan& plan) {
    constexpr double share_of_k = 20.0;
    constexpr double noticed = 1e-6;
    std::vector<std::string> sentences;
    for (std::size_t m = 0; m < plan.medium_names.size(); ++m) {
        const bool has_faces = std::any_of(plan.solids.begin(), plan.solids.end(), [m](const Solid& solid) {
            return static_cast<std::size_t>(solid.medium) == m && !std::holds_alternative<Sphere>(solid.shape);
        });
        double most = 0.0;
        for (const WavelengthGroup& group : plan.groups) {
            const Dielectric<double>& d = group.media[m].dielectric;
            if (d.kind == MediumKind::isotropic && d.kappa < d.n) most = std::max(most, d.kappa);
        }
        if (has_faces && share_of_k * most > noticed)
            sentences.push_back("'" + plan.medium_names[m] + "' absorbs, up to k = " + number_text(most) +
                                ": where light in it is totally reflected by a face that is not parallel to the one it "
                                "came in by, its power is off by up to about " +
                                number_text(share_of_k * most));
    }
    return sentences;
}

/// Crystals whose absorption their faces should show (scene/medium.h, strongest_crystal_extinction).
std::vector<std::string> doubts_of_crystal_faces(const Scene& scene, const Plan& plan) {
    constexpr double noticed = 1e-6;
    std::vector<std::string> sentences;
    for (std::size_t m = 0; m < plan.medium_names.size(); ++m) {
        double worst = 0.0;
        double worst_k = 0.0;
        for (std::size_t w = 0; w < plan.wavelengths_nm.size(); ++w) {
            const MediumAt& medium = plan.groups[static_cast<std::size_t>(plan.group_of_wavelength[w])].media[m];
            if (medium.dielectric.kind != MediumKind::uniaxial) continue;
            const double alpha = std::max(medium.absorption.ordinary, medium.absorption.extraordinary);
            const double k = alpha * plan.wavelengths_nm[w] / (4.0 * pi * scene.unit_nm);
            const double n = std::min(medium.dielectric.n, medium.dielectric.n_e);
            const double off = 4.0 * n * k * k / std::pow(n + 1.0, 4);
            if (off <= worst) continue;
            worst = off;
            worst_k = k;
        }
        if (worst > noticed)
            sentences.push_back("faces of '" + plan.medium_names[m] +
                                "' are followed without its extinction, up to k = " + number_text(worst_k) +
                                ": what they reflect is off by " + number_text(worst) +
                                " at normal incidence and by about 3 k where reflection is total");
    }
    return sentences;
}

}  // namespace

Features list_features(const Scene& scene, const Plan& plan) {
    Account account;
    account_for_matter(plan, account);
    account_for_extinction(scene, account);
    account_for_geometry(plan, account);
    account_for_light(scene, plan, account);
    Features features;
    features.meshes = !mesh_bodies(plan).empty();
    features.kernel = to_string(plan.kernel());
    features.doubts = coherence_doubts(plan, scene.unit_nm);
    account.say("interference", false,
                features.doubts.empty()
                    ? "powers are added: nothing with parallel faces is thinner than light stays coherent"
                    : "powers are added, though this scene would show it: see below");
    const std::string one_by_one = why_not_in_lanes(plan);
    account.say("branches side by side", one_by_one.empty(),
                one_by_one.empty() ? "one solid of glass with flat faces, or a ball" : "one by one: " + one_by_one);
    for (std::string& doubt : doubts_of_crystal_faces(scene, plan)) features.doubts.push_back(std::move(doubt));
    for (std::string& doubt : doubts_of_absorbing_glass(plan)) features.doubts.push_back(std::move(doubt));
    features.list = std::move(account.list);
    return features;
}

}  // namespace pol
