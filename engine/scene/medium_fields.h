// SPDX-License-Identifier: Apache-2.0
// What each kind of matter is made of, a row per property: scene files, their hash, the checks and the window read the
// rows. A kind of matter without rows does not compile.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "scene/medium.h"

namespace pol {

/// Whether a property must be written; those that must, tell by their keys which kind of matter it is.
enum class Presence { required, optional };

/// Metal is nothing without its k; in other matter a k that is not known counts as 0 (unknown_extinctions).
enum class Extinction { welcome, needed };

/// `Value` is RefractiveIndex, Absorption, DVec3 (a direction) or AxisSpace.
template <class Matter, class Value>
struct MatterField {
    Value Matter::*value;
    std::string_view key;  ///< in scene files
    Presence presence;
    std::string_view label;                       ///< in the window
    Extinction extinction = Extinction::welcome;  ///< of an index
};
template <class Matter, class Value>
MatterField(Value Matter::*, std::string_view, Presence, std::string_view, Extinction = Extinction::welcome)
    -> MatterField<Matter, Value>;

template <class Matter>
struct MatterFields;

template <>
struct MatterFields<IsotropicMedium> {
    using M = IsotropicMedium;
    static constexpr std::tuple rows{
        MatterField{&M::index, "index", Presence::required, "n"},
        MatterField{&M::absorption, "absorption", Presence::optional, "\u03b1"},
    };
};

template <>
struct MatterFields<UniaxialMedium> {
    using M = UniaxialMedium;
    static constexpr std::tuple rows{
        MatterField{&M::ordinary, "ordinary", Presence::required, "n_o"},
        MatterField{&M::extraordinary, "extraordinary", Presence::required, "n_e"},
        MatterField{&M::axis, "axis", Presence::optional, "optic axis"},
        MatterField{&M::axis_space, "axis_space", Presence::optional, "axes"},
        MatterField{&M::absorption_o, "absorption_o", Presence::optional, "\u03b1_o"},
        MatterField{&M::absorption_e, "absorption_e", Presence::optional, "\u03b1_e"},
    };
};

template <>
struct MatterFields<ConductorMedium> {
    using M = ConductorMedium;
    static constexpr std::tuple rows{
        MatterField{&M::index, "conductor", Presence::required, "n", Extinction::needed},
    };
};

/// What scene files call the values of AxisSpace, in their order.
inline constexpr std::array<std::string_view, 2> axis_space_words{"object", "world"};

/// Calls visit(row, value) for every property of a kind of matter, in the order of the rows.
template <class Kind, class Visit>
void for_each_field(Kind& kind, const Visit& visit) {
    const auto visit_all = [&](const auto&... row) { (visit(row, kind.*row.value), ...); };
    std::apply(visit_all, MatterFields<std::remove_const_t<Kind>>::rows);
}

/// The same for whatever kind of matter there is.
template <class Visit>
void for_each_field(const Matter& matter, const Visit& visit) {
    std::visit([&](const auto& kind) { for_each_field(kind, visit); }, matter);
}
template <class Visit>
void for_each_field(Matter& matter, const Visit& visit) {
    std::visit([&](auto& kind) { for_each_field(kind, visit); }, matter);
}

/// Calls visit(kind) with an example of every kind of matter, the last one first.
template <class Visit>
void for_each_kind(const Visit& visit) {
    const auto visit_all = [&]<std::size_t... I>(std::index_sequence<I...>) {
        (visit(std::variant_alternative_t<sizeof...(I) - 1 - I, Matter>{}), ...);
    };
    visit_all(std::make_index_sequence<std::variant_size_v<Matter>>{});
}

}  // namespace pol
