// SPDX-License-Identifier: Apache-2.0
// Degenerate cases about where the optic axis of a crystal points.
#include "core/units.h"
#include "verify/degenerate/case_lists.h"
#include "verify/degenerate/interface_experiment.h"

namespace pol::verify {

namespace {

/// `axis` in the frame of the face: normal z, plane of incidence xz.
InterfaceSetup into_calcite(const DVec3& axis, double incidence, const Turn& turn) {
    return {air, calcite_crystal(turn(axis)), turn(face_normal), turn(polar_direction(incidence))};
}

InterfaceSetup out_of_calcite(double axis_to_wave, const Turn& turn) {
    const DVec3 s = turn(polar_direction(radians(20.0)));
    return {calcite_crystal(beside(s, axis_to_wave)), air, turn(face_normal), s};
}

constexpr double around = 0.7;  // some azimuth of the axis, radians

}  // namespace

std::vector<DegenerateCase> axis_cases() {
    const InterfaceResults waves = InterfaceResults::waves;
    return {
        {"along-axis", "On and near the optic axis the pair of modes acts as one wave of index n_o",
         "angle between wave and optic axis [rad]", "sum of the fields of o and e, both sides", same_formulas,
         and_zero(decades(-1, -17, 2)),
         [](double angle, const Turn& turn) {
             return interface_experiment(out_of_calcite(angle, turn), InterfaceResults::merged_fields);
         },
         usual_turns},
        {"near-axis-modes", "Near the optic axis o and e by themselves are as good as the direction of k x c allows",
         "angle between wave and optic axis [rad]", of_waves, same_formulas, decades(-1, -14, 2),
         [](double angle, const Turn& turn) { return interface_experiment(out_of_calcite(angle, turn), waves); },
         usual_turns},
        {"axis-along-normal", "A c-cut face turns s into o and p into e and never mixes them",
         "angle between optic axis and normal [rad]", of_waves, same_formulas, and_zero(decades(-1, -16, 2)),
         [](double angle, const Turn& turn) {
             return interface_experiment(into_calcite(polar_direction(angle, around), radians(40.0), turn), waves);
         },
         usual_turns},
        {"axis-in-face", "With the axis in the face o and e keep one ray at normal incidence",
         "angle between optic axis and face [rad]", of_waves, same_formulas, and_zero(decades(-1, -16, 2)),
         [](double angle, const Turn& turn) {
             const DVec3 axis(std::cos(angle) * std::cos(around), std::cos(angle) * std::sin(around), std::sin(angle));
             return interface_experiment(into_calcite(axis, 0.0, turn), waves);
         },
         usual_turns},
        {"axis-across-plane", "With the axis across the plane of incidence both waves obey Snell's law",
         "angle between optic axis and s [rad]", of_waves, same_formulas, and_zero(decades(-1, -16, 2)),
         [](double angle, const Turn& turn) {
             return interface_experiment(into_calcite(beside({0.0, 1.0, 0.0}, angle), radians(40.0), turn), waves);
         },
         usual_turns},
        {"axis-in-plane", "With the axis in the plane of incidence s is o, p is e, and nothing is converted",
         "angle between optic axis and plane [rad]", of_waves, same_formulas, and_zero(decades(-1, -16, 2)),
         [](double angle, const Turn& turn) {
             const DVec3 axis(std::sin(around) * std::cos(angle), std::sin(angle), std::cos(around) * std::cos(angle));
             return interface_experiment(into_calcite(axis, radians(40.0), turn), waves);
         },
         usual_turns},
    };
}

}  // namespace pol::verify
