// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <variant>

#include "core/nearest_word.h"
#include "core/number_text.h"
#include "core/overloaded.h"
#include "scene/check_rules.h"
#include "scene/medium_fields.h"
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

void check_index(SceneCheck& check, const RefractiveIndex& index, bool in_use, const std::string& field,
                 Extinction extinction) {
    std::visit(Overloaded{[&](const ConstantIndex& constant) { check_value(check, constant.value, field); },
                          [](const DispersiveIndex&) {}},
               index);
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
        std::visit(Overloaded{[&](const FilledWith& filled) { names.insert(filled.medium); },
                              [&](const Emission& emission) {
                                  std::visit(
                                      Overloaded{[](const Unpolarized&) {}, [](const FixedState&) {},
                                                 [&](const CrystalPlateState& plate) { names.insert(plate.medium); }},
                                      emission.state);
                              },
                              [](const Sheet&) {}, [](const Absorber&) {}},
                   object.role);
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
    const auto look_at = [&](const auto& field, const RefractiveIndex& index) {
        const std::string text = field.extinction == Extinction::needed
                                     ? std::string()  // a problem of the scene, not a remark
                                     : unknown_extinction(index, scene.render.wavelengths_nm);
        if (!text.empty() && std::find(found.begin(), found.end(), text) == found.end()) found.push_back(text);
    };
    const std::set<std::string> used = media_in_use(scene);
    for (const Medium& medium : scene.media) {
        if (used.count(medium.name) == 0) continue;
        for_each_field(medium.matter, Overloaded{look_at, [](const auto&, const Absorption&) {},
                                                 [](const auto&, const DVec3&) {}, [](const auto&, AxisSpace) {}});
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
        const auto named = [&](const auto& row) { return field + "." + std::string(row.key); };
        for_each_field(medium.matter,
                       Overloaded{
                           [&](const auto& row, const RefractiveIndex& index) {
                               check_index(check, index, in_use, named(row), row.extinction);
                           },
                           [&](const auto& row, const Absorption& absorption) {
                               check_spectrum(check, absorption, wavelengths, named(row));
                           },
                           [&](const auto& row, const DVec3& axis) { check.require_axis(axis, named(row)); },
                           [](const auto&, AxisSpace) {},
                       });
    }
}

}  // namespace pol
