// SPDX-License-Identifier: Apache-2.0
// Degenerate cases about the angle at which light arrives: normal, grazing,
// critical.
#include <cmath>

#include "core/units.h"
#include "verify/degenerate/case_lists.h"
#include "verify/degenerate/interface_experiment.h"

namespace pol::verify {

namespace {

const DVec3 oblique_axis = unit(DVec3(1.0, 2.0, 3.0));  // in the frame of the face: x, s, normal

/// Largest tangential wave vector of an e wave of calcite behind a face, its
/// axis in the frame of the face: where the discriminant of PHYSICS.md 2.5
/// vanishes.
double end_of_e_sheet(const DVec3& axis) {
    const Dielectric<double> crystal = calcite_crystal(axis);
    const double eps_o = crystal.n * crystal.n;
    const double eps_e = crystal.n_e * crystal.n_e;
    const double delta = (crystal.n_e - crystal.n) * (crystal.n_e + crystal.n);
    return std::sqrt(eps_e * (eps_o + delta * axis.z * axis.z) / (eps_e - delta * axis.y * axis.y));
}

InterfaceSetup at_angle(const Dielectric<double>& from, const Dielectric<double>& to, double incidence,
                        const Turn& turn) {
    const auto turned = [&turn](Dielectric<double> medium) {
        medium.axis = turn(medium.axis);
        return medium;
    };
    return {turned(from), turned(to), turn(face_normal), turn(polar_direction(incidence))};
}

/// `above` the plane of the face, exactly: nothing of the small angle is lost
/// in a direction.
InterfaceSetup grazing(const Dielectric<double>& from, const Dielectric<double>& to, double above) {
    return {from, to, face_normal, {std::cos(above), 0.0, std::sin(above)}};
}

const std::string from_critical = "distance to the critical angle [rad]";
/// One side of a critical angle: `sense` -1 below it, +1 beyond.
DegenerateCase critical_case(std::string name, std::string sentence, const Dielectric<double>& from,
                             const Dielectric<double>& to, double critical, double sense) {
    return {std::move(name),
            std::move(sentence),
            from_critical,
            of_waves,
            same_formulas,
            and_zero(decades(-1, -16, 2)),
            [=](double distance, const Turn& turn) {
                return interface_experiment(at_angle(from, to, critical + sense * distance, turn),
                                            InterfaceResults::waves);
            },
            usual_turns};
}

std::vector<DegenerateCase> critical_cases() {
    const Dielectric<double> dense = make_isotropic(2.5);
    const Dielectric<double> glass = make_isotropic(1.5);
    const Dielectric<double> crystal = calcite_crystal(oblique_axis);
    const DVec3 diagonal = unit(DVec3(1.0, 1.0, 1.0));
    const double o_critical = std::asin(crystal.n / dense.n);
    const double e_critical = std::asin(end_of_e_sheet(oblique_axis) / dense.n);
    return {
        critical_case("critical-inside-crystal", "At the critical angle of o inside a crystal T = 0 and R = 1", crystal,
                      air, std::asin(1.0 / crystal.n), -1.0),
        critical_case("critical-glass-below", "Powers are continuous up to the critical angle of glass", glass, air,
                      std::asin(1.0 / glass.n), -1.0),
        critical_case("critical-glass-beyond", "Powers and phases are continuous beyond the critical angle of glass",
                      glass, air, std::asin(1.0 / glass.n), 1.0),
        critical_case("critical-o-below", "Powers are continuous up to the critical angle of the o wave", dense,
                      crystal, o_critical, -1.0),
        critical_case("critical-o-beyond", "Powers are continuous beyond the critical angle of the o wave", dense,
                      crystal, o_critical, 1.0),
        critical_case("critical-e-below", "Powers are continuous up to the critical angle of the e wave", dense,
                      crystal, e_critical, -1.0),
        critical_case("critical-e-beyond", "With one of o and e evanescent power goes to the other waves only", dense,
                      crystal, e_critical, 1.0),
        critical_case("inhibited-reflection", "Where the reflected e wave ends, o alone takes all the power",
                      calcite_crystal(diagonal), air, std::asin(end_of_e_sheet(diagonal) / crystal.n), 1.0),
    };
}

}  // namespace

std::vector<DegenerateCase> incidence_cases() {
    const Dielectric<double> crystal = calcite_crystal(oblique_axis);
    const std::string above = "angle above the face [rad]";
    const std::string transmittance = "transmitted powers, each to its own size";
    std::vector<DegenerateCase> cases = {
        {"normal-incidence",
         "At normal incidence nothing depends on the plane of incidence, which "
         "is undefined",
         "angle of incidence [rad]", of_waves, same_formulas, and_zero(decades(-1, -17, 2)),
         [=](double angle, const Turn& turn) {
             return interface_experiment(at_angle(air, crystal, angle, turn), InterfaceResults::waves);
         },
         usual_turns},
        {"normal-from-inside",
         "A crystal wave along the normal leaves with its ray oblique and its k "
         "straight",
         "angle of incidence [rad]", of_waves, same_formulas, and_zero(decades(-1, -17, 2)),
         [=](double angle, const Turn& turn) {
             return interface_experiment(at_angle(crystal, air, angle, turn), InterfaceResults::waves);
         },
         usual_turns},
        {"grazing-glass", "Grazing light enters glass in proportion to the cosine", above, transmittance, same_formulas,
         decades(-1, -16, 2),
         [](double angle, const Turn&) {
             return interface_experiment(grazing(air, make_isotropic(1.5), angle), InterfaceResults::transmitted_powers,
                                         Accuracy::relative);
         }},
        {"grazing-crystal",
         "Grazing light enters both waves of a crystal in proportion to the "
         "cosine",
         above, transmittance, same_formulas, decades(-1, -16, 2),
         [=](double angle, const Turn&) {
             return interface_experiment(grazing(air, crystal, angle), InterfaceResults::transmitted_powers,
                                         Accuracy::relative);
         }},
        {"grazing-inside-crystal",
         "Light that grazes a face from inside a crystal leaves in proportion to "
         "the cosine",
         above, transmittance, same_formulas, decades(-1, -16, 2),
         [](double angle, const Turn&) {
             return interface_experiment(grazing(calcite_crystal({0.6, 0.8, 0.0}), make_isotropic(1.8), angle),
                                         InterfaceResults::transmitted_powers, Accuracy::relative);
         }},
        {"grazing-twin",
         "Light that grazes the seam of two crystals crosses it in proportion to "
         "the cosine",
         above, transmittance, same_formulas, decades(-1, -16, 2),
         [](double angle, const Turn&) {
             return interface_experiment(
                 grazing(calcite_crystal({0.6, 0.8, 0.0}), make_uniaxial(1.8, 1.9, DVec3(1.0, 2.0, 3.0)), angle),
                 InterfaceResults::transmitted_powers, Accuracy::relative);
         }},
        {"backward-wave-normal", "Energy decides what arrives, also where the wave normal points away",
         "angle of the wave normal behind the face [rad]", of_waves, same_formulas, and_zero(decades(-1, -16, 2)),
         [](double angle, const Turn& turn) {
             const auto strong = make_uniaxial(1.5, 2.5, DVec3(1.0, 0.0, 1.0));
             return interface_experiment(at_angle(strong, air, 0.5 * pi + angle, turn), InterfaceResults::waves);
         },
         usual_turns},
        {"mirror-frames",
         "Near normal incidence a mirror turns p over and leaves s, whatever s "
         "is",
         "angle of incidence [rad]", "sum of the fields, both sides", same_formulas, and_zero(decades(-1, -17, 5)),
         [](double angle, const Turn& turn) {
             return interface_experiment(at_angle(air, make_conductor(0.3, 2.8), angle, turn),
                                         InterfaceResults::merged_fields);
         },
         usual_turns},
    };
    std::vector<DegenerateCase> critical = critical_cases();
    cases.insert(cases.end(), std::make_move_iterator(critical.begin()), std::make_move_iterator(critical.end()));
    return cases;
}

}  // namespace pol::verify
