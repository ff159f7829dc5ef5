// SPDX-License-Identifier: Apache-2.0
#include "plan/coherence.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "core/number_text.h"
#include "core/units.h"
#include "geometry/overlap.h"
#include "plan/reach.h"

namespace pol {

namespace {

constexpr double single_band_nm = 10.0;
constexpr double parallel = 1e-3;  ///< radians
constexpr std::size_t most_facets = 20000;
/// exp(-14) of the amplitude: 1e-6 of the field comes back from behind.
constexpr double opaque = 14.0;

/// A flat face in world space.
struct Face {
    Plane plane{};
    DVec3 low{};
    DVec3 high{};
    int solid = -1;
};

void append_faces(std::vector<Face>& faces, const Mesh& mesh, int solid) {
    if (mesh.facets.size() > most_facets) return;
    const std::size_t first = faces.size();
    constexpr double far = std::numeric_limits<double>::max();
    for (const Plane& plane : mesh.facets) faces.push_back({plane, DVec3(far), DVec3(-far), solid});
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        Face& face = faces[first + mesh.facet_of_triangle[t]];
        for (const std::uint32_t corner : mesh.triangles[t]) {
            face.low = glm::min(face.low, mesh.vertices[corner]);
            face.high = glm::max(face.high, mesh.vertices[corner]);
        }
    }
}

/// Lengths over which a wavelength is coherent, in nm.
std::vector<double> coherence_lengths(const std::vector<double>& wavelengths_nm) {
    std::vector<double> lengths;
    for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
        double band = std::numeric_limits<double>::max();
        if (wavelengths_nm.size() == 1) band = single_band_nm;
        if (i > 0) band = std::min(band, wavelengths_nm[i] - wavelengths_nm[i - 1]);
        if (i + 1 < wavelengths_nm.size()) band = std::min(band, wavelengths_nm[i + 1] - wavelengths_nm[i]);
        lengths.push_back(wavelengths_nm[i] * wavelengths_nm[i] / band);
    }
    return lengths;
}

/// A length with the unit that people use for it.
std::string length_text(double nm) {
    const auto rounded = [](double value) {
        std::array<char, 32> buffer{};
        const auto end =
            std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 3);
        return std::string(buffer.data(), end.ptr);
    };
    if (nm < 1e3) return rounded(nm) + " nm";
    return nm < 1e6 ? rounded(nm / 1e3) + " um" : rounded(nm / 1e6) + " mm";
}

class Films {
public:
    Films(const Plan& plan, double unit_nm)
        : plan_(plan), unit_nm_(unit_nm), lengths_(coherence_lengths(plan.wavelengths_nm)) {}

    /// Thickest film that could matter, in scene units.
    [[nodiscard]] double reach() const {
        double most = 0.0;
        for (std::size_t w = 0; w < lengths_.size(); ++w)
            for (const MediumAt& medium : media_at(w)) most = std::max(most, lengths_[w] / smallest_path(medium));
        return most / unit_nm_;
    }

    /// Looks at what lies at `inside`, between faces of the solids `a` and `b` that are `thickness` apart.
    void add(const DVec3& inside, double thickness, int a, int b) {
        const int region = plan_.region_at(inside);
        if (region < 0) return;
        const Region& here = plan_.regions[static_cast<std::size_t>(region)];
        const double nm = thickness * unit_nm_;
        for (std::size_t w = 0; w < lengths_.size(); ++w) {
            const MediumAt& medium = media_at(w)[static_cast<std::size_t>(here.medium)];
            const bool metal = medium.dielectric.kind == MediumKind::conductor;
            const double exponent =
                metal ? 4.0 * pi * medium.dielectric.kappa * nm / plan_.wavelengths_nm[w]
                      : std::min(medium.absorption.ordinary, medium.absorption.extraordinary) * thickness;
            if (exponent > opaque || (!metal && nm * smallest_path(medium) >= lengths_[w])) continue;
            const std::string name = here.owner >= 0 ? "'" + plan_.solid(here.owner).name + "'" : gap_name(a, b);
            const auto [found, is_new] = films_.try_emplace(name, Film{nm, w, here.medium});
            if (!is_new && nm < found->second.nm) found->second = {nm, w, here.medium};
            return;
        }
    }

    [[nodiscard]] std::vector<std::string> sentences() const {
        std::vector<std::pair<double, std::string>> by_thickness;
        for (const auto& [name, film] : films_) by_thickness.emplace_back(film.nm, sentence(name, film));
        std::sort(by_thickness.begin(), by_thickness.end());
        std::vector<std::string> list;
        for (auto& entry : by_thickness) list.push_back(std::move(entry.second));
        return list;
    }

private:
    struct Film {
        double nm = 0.0;
        std::size_t wavelength = 0;
        int medium = 0;
    };

    [[nodiscard]] const std::vector<MediumAt>& media_at(std::size_t wavelength) const {
        return plan_.groups[static_cast<std::size_t>(plan_.group_of_wavelength[wavelength])].media;
    }

    /// Smallest difference of optical paths per length: of o and e, or of two passes.
    static double smallest_path(const MediumAt& medium) {
        const Dielectric<double>& d = medium.dielectric;
        return d.kind == MediumKind::uniaxial ? std::min(std::abs(d.n_e - d.n), 2.0 * d.n) : 2.0 * d.n;
    }

    [[nodiscard]] std::string gap_name(int a, int b) const {
        if (a == b) return "the gap in '" + plan_.solid(a).name + "'";
        const auto [first, second] = std::minmax(a, b);
        return "the gap between '" + plan_.solid(first).name + "' and '" + plan_.solid(second).name + "'";
    }

    [[nodiscard]] std::string sentence(const std::string& name, const Film& film) const {
        const MediumAt& medium = media_at(film.wavelength)[static_cast<std::size_t>(film.medium)];
        if (medium.dielectric.kind == MediumKind::conductor)
            return name + " is " + length_text(film.nm) +
                   " of metal: light would go through it, but metals are opaque here";
        const bool crystal = medium.dielectric.kind == MediumKind::uniaxial;
        const std::string nm = number_text(plan_.wavelengths_nm[film.wavelength]);
        const std::string band = plan_.wavelengths_nm.size() == 1 ? ", taken as 10 nm wide," : "";
        return name + " is " + length_text(film.nm) + " thick: " + (crystal ? "its rays o and e" : "two passes of it") +
               " differ by an optical path of " + length_text(film.nm * smallest_path(medium)) + ", light of " + nm +
               " nm" + band + " stays coherent over " + length_text(lengths_[film.wavelength]) +
               ", but powers are added here and not fields: " +
               (crystal ? "between polarizers this plate would show interference"
                        : "it would show interference colors");
    }

    const Plan& plan_;
    double unit_nm_;
    std::vector<double> lengths_;
    std::map<std::string, Film> films_;
};

/// The distance of two parallel faces where their bounding boxes, grown by `reach`, meet, and a point half way.
std::optional<std::pair<double, DVec3>> apart(const Face& a, const Face& b, double reach) {
    const DVec3 low = glm::max(a.low, b.low) - DVec3(0.5 * reach);
    const DVec3 high = glm::min(a.high, b.high) + DVec3(0.5 * reach);
    if (low.x > high.x || low.y > high.y || low.z > high.z) return std::nullopt;
    const double sense = dot(a.plane.normal, b.plane.normal);
    if (std::abs(sense) < std::cos(parallel)) return std::nullopt;
    const DVec3 middle = 0.5 * (low + high);
    const double to_a = dot(a.plane.normal, middle) - a.plane.offset;
    const double to_b = (dot(b.plane.normal, middle) - b.plane.offset) * (sense < 0.0 ? -1.0 : 1.0);
    return std::pair(std::abs(to_a - to_b), middle - a.plane.normal * (0.5 * (to_a + to_b)));
}

/// Faces and spheres nearer than that touch (geometry/overlap.h).
double slack_of(const Plan& plan, int solid) {
    return slack(solid_ref(plan.solid(solid)));
}

void look_between_faces(const Plan& plan, Films& films, double reach) {
    std::vector<Face> faces;
    std::vector<double> slacks;
    for (int i = 0; i < plan.solid_count(); ++i) slacks.push_back(slack_of(plan, i));
    for (int i = 0; i < plan.solid_count(); ++i) {
        if (const auto* flat = std::get_if<HalfSpaceSolid>(&plan.solid(i).shape)) append_faces(faces, flat->mesh(), i);
        if (const auto* mesh = std::get_if<MeshBody>(&plan.solid(i).shape)) append_faces(faces, mesh->mesh, i);
    }
    std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.low.x < b.low.x; });
    for (auto face = faces.begin(); face != faces.end(); ++face)
        for (auto other = face + 1; other != faces.end() && other->low.x <= face->high.x + reach; ++other) {
            const auto found = apart(*face, *other, reach);
            if (!found || found->first >= reach) continue;
            // Both sides of a film in one solid face away from each other; else they are parts of a face that rounding
            // bent.
            if (face->solid == other->solid && dot(face->plane.normal, other->plane.normal) > 0.0) continue;
            const double touching =
                slacks[static_cast<std::size_t>(face->solid)] + slacks[static_cast<std::size_t>(other->solid)];
            if (found->first > touching) films.add(found->second, found->first, face->solid, other->solid);
        }
}

/// Shells between spheres, and spheres that are films themselves.
void look_between_spheres(const Plan& plan, Films& films, double reach) {
    for (int i = 0; i < plan.solid_count(); ++i) {
        const auto* outer = std::get_if<Sphere>(&plan.solid(i).shape);
        if (outer == nullptr) continue;
        if (2.0 * outer->radius < reach) films.add(outer->center, 2.0 * outer->radius, i, i);
        for (int j = 0; j < plan.solid_count(); ++j) {
            const auto* inner = std::get_if<Sphere>(&plan.solid(j).shape);
            if (inner == nullptr || j == i) continue;
            const DVec3 shift = inner->center - outer->center;
            const double distance = std::sqrt(length2(shift));
            const double gap = outer->radius - inner->radius - distance;
            if (!(gap > slack_of(plan, i) + slack_of(plan, j) && gap < reach)) continue;
            const DVec3 nearest = distance > 0.0 ? shift / distance : DVec3(1.0, 0.0, 0.0);
            films.add(outer->center + nearest * (outer->radius - 0.5 * gap), gap, i, j);
        }
    }
}

}  // namespace

std::vector<std::string> coherence_doubts(const Plan& plan, double unit_nm) {
    Films films(plan, unit_nm);
    const double reach = films.reach();
    look_between_faces(plan, films, reach);
    look_between_spheres(plan, films, reach);
    return films.sentences();
}

}  // namespace pol
