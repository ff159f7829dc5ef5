// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <string_view>

#include "core/nearest_word.h"
#include "core/number_text.h"
#include "core/overloaded.h"
#include "scene/check_rules.h"
#include "spectrum/refractive_index.h"

namespace pol {
namespace {

/// No substance has an index near 100 in the range of light; a larger one is a slip of the pen.
constexpr double max_index = 100.0;

void check_value(SceneCheck& check, const ComplexIndex& index, const std::string& field) {
    check.require(index.n > 0.0 && index.n <= max_index, field, "the refractive index must lie between 0 and 100",
                  "glass has about 1.5");
    check.require(index.k >= 0.0 && index.k <= max_index, field, "the extinction k must lie between 0 and 100",
                  "n + i k with k >= 0 absorbs");
}

/// A metal is nothing without its k; in other matter a k that is not known counts as 0 (unknown_extinctions).
enum class Extinction { needed, welcome };

void check_index(SceneCheck& check, const RefractiveIndex& index, bool in_use, const std::string& field,
                 Extinction extinction = Extinction::welcome) {
    if (const auto* constant = std::get_if<ConstantIndex>(&index)) check_value(check, constant->value, field);
    if (!in_use) return;
    for (const double nm : check.scene().render.wavelengths_nm) {
        const Result<ComplexIndex> value = index_at(index, nm);
        if (!value) {
            check.require(false, field, value.error().what, value.error().hint);
            return;
        }
        check_value(check, value.value(), field);
        check.require(extinction == Extinction::welcome || !extinction_is_unknown(index, nm), field,
                      "k is not known at " + number_text(nm) + " nm",
                      "a conductor needs it: render at wavelengths inside the range of k, or use another record");
    }
}

std::set<std::string> media_in_use(const Scene& scene) {
    std::set<std::string> names{scene.ambient};
    for (const Object& object : scene.objects) {
        if (const auto* filled = std::get_if<FilledWith>(&object.role)) names.insert(filled->medium);
        if (const auto* emission = std::get_if<Emission>(&object.role)) {
            if (const auto* plate = std::get_if<CrystalPlateState>(&emission->state)) names.insert(plate->medium);
        }
    }
    return names;
}

/// "k of 'kapton' is not known at 2 of 3 wavelengths, the first at 580 nm"; empty: it is.
std::string unknown_extinction(const RefractiveIndex& index, const std::vector<double>& wavelengths_nm) {
    std::vector<double> unknown;
    std::copy_if(wavelengths_nm.begin(), wavelengths_nm.end(), std::back_inserter(unknown),
                 [&](double nm) { return extinction_is_unknown(index, nm); });
    if (unknown.empty()) return {};
    std::string text = "k of '" + std::get<DispersiveIndex>(index).name + "' is not known at ";
    if (wavelengths_nm.size() > 1)
        text += std::to_string(unknown.size()) + " of " + std::to_string(wavelengths_nm.size()) +
                " wavelengths, the first of them ";
    return text + number_text(unknown.front()) + " nm: 0 is used";
}

}  // namespace

std::vector<std::string> unknown_extinctions(const Scene& scene) {
    std::vector<std::string> found;
    const auto look_at = [&](const RefractiveIndex& index) {
        const std::string text = unknown_extinction(index, scene.render.wavelengths_nm);
        if (!text.empty() && std::find(found.begin(), found.end(), text) == found.end()) found.push_back(text);
    };
    const std::set<std::string> used = media_in_use(scene);
    for (const Medium& medium : scene.media) {
        if (used.count(medium.name) == 0) continue;
        if (const auto* isotropic = std::get_if<IsotropicMedium>(&medium.matter)) look_at(isotropic->index);
        if (const auto* crystal = std::get_if<UniaxialMedium>(&medium.matter)) {
            look_at(crystal->ordinary);
            look_at(crystal->extraordinary);
        }
    }
    return found;
}

const Medium* find_medium(const Scene& scene, const std::string& name) {
    const auto found =
        std::find_if(scene.media.begin(), scene.media.end(), [&](const Medium& m) { return m.name == name; });
    return found == scene.media.end() ? nullptr : &*found;
}

void require_medium(SceneCheck& check, const std::string& name, const std::string& field) {
    const Scene& scene = check.scene();
    if (find_medium(scene, name) != nullptr) return;
    std::vector<std::string_view> known;
    for (const Medium& medium : scene.media) known.emplace_back(medium.name);
    std::string hint = "add it under 'media'";
    if (const auto nearest = nearest_word(name, known)) {
        hint = "did you mean '" + std::string(*nearest) + "'?";
    } else if (!known.empty()) {
        hint += "; defined there:";
        for (const std::string_view word : known) hint.append(" ").append(word);
    }
    check.require(false, field, "there is no medium called '" + name + "'", hint);
}

void check_media(SceneCheck& check) {
    const Scene& scene = check.scene();
    const std::set<std::string> used = media_in_use(scene);
    std::set<std::string> names;
    for (const Medium& medium : scene.media) {
        check.about(medium.place);
        const std::string field = "media." + medium.name;
        check.require(!medium.name.empty(), "media", "a medium needs a name", "write NAME: {index: 1.5}");
        check.require(names.insert(medium.name).second, field, "another medium has the same name",
                      "rename one of them");
        const bool in_use = used.count(medium.name) > 0;
        const std::vector<double> wavelengths = in_use ? scene.render.wavelengths_nm : std::vector<double>{};
        std::visit(Overloaded{
                       [&](const IsotropicMedium& m) {
                           check_index(check, m.index, in_use, field + ".index");
                           check_spectrum(check, m.absorption, wavelengths, field + ".absorption");
                       },
                       [&](const UniaxialMedium& m) {
                           check_index(check, m.ordinary, in_use, field + ".ordinary");
                           check_index(check, m.extraordinary, in_use, field + ".extraordinary");
                           check.require_axis(m.axis, field + ".axis");
                           check_spectrum(check, m.absorption_o, wavelengths, field + ".absorption_o");
                           check_spectrum(check, m.absorption_e, wavelengths, field + ".absorption_e");
                       },
                       [&](const ConductorMedium& m) {
                           check_index(check, m.index, in_use, field + ".conductor", Extinction::needed);
                       },
                   },
                   medium.matter);
    }
}

}  // namespace pol
