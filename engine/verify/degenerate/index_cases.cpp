// SPDX-License-Identifier: Apache-2.0
// Degenerate cases about indices: nearly equal, equal, very different, complex.
#include <cmath>

#include "core/units.h"
#include "verify/degenerate/case_lists.h"
#include "verify/degenerate/interface_experiment.h"

namespace pol::verify {

namespace {

const DVec3 crystal_axis(1.0, 2.0, 3.0);
Dielectric<double> crystal(double n_o, double n_e, const Turn& turn) {
    return make_uniaxial(n_o, n_e, turn(crystal_axis));
}

Experiment meet(const Dielectric<double>& from, const Dielectric<double>& to, double incidence, const Turn& turn,
                InterfaceResults asked, Accuracy accuracy = Accuracy::absolute) {
    return interface_experiment({from, to, turn(face_normal), turn(polar_direction(incidence))}, asked, accuracy);
}

/// What a crystal of two equal indices does, minus what glass does: zero to the last bit.
Experiment crystal_minus_glass(double incidence, const Turn& turn) {
    const InterfaceSetup glass{air, make_isotropic(1.5), turn(face_normal), turn(polar_direction(incidence))};
    InterfaceSetup twin = glass;
    twin.to = crystal(1.5, 1.5, turn);
    Experiment experiment = interface_experiment(glass, InterfaceResults::waves, Accuracy::relative);
    experiment.program = [glass, twin](std::span<const double>) {
        std::vector<double> difference =
            interface_experiment(twin, InterfaceResults::waves).program(interface_inputs(twin));
        const std::vector<double> results =
            interface_experiment(glass, InterfaceResults::waves).program(interface_inputs(glass));
        for (std::size_t i = 0; i < results.size(); ++i) difference[i] -= results[i];
        return difference;
    };
    const std::size_t count = experiment.program(experiment.inputs).size();
    experiment.reference = [count](std::span<const Quad>) { return std::vector<Quad>(count, Quad(0)); };
    return experiment;
}

}  // namespace

std::vector<DegenerateCase> index_cases() {
    const std::string birefringence = "n_e - n_o";
    return {
        {"equal-indices",
         "A crystal with n_o = n_e is glass to the last bit",
         "angle of incidence [rad]",
         "difference of power and ray of each wave",
         "zero",
         {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.2, 1.4, 1.5},
         crystal_minus_glass,
         usual_turns},
        {"small-birefringence", "As n_e tends to n_o each wave keeps its accuracy, entering", birefringence, of_waves,
         same_formulas, and_zero(decades(-1, -15)),
         [](double step, const Turn& turn) {
             return meet(air, crystal(1.5, 1.5 + step, turn), 0.9, turn, InterfaceResults::waves);
         },
         usual_turns},
        {"small-birefringence-inside", "As n_e tends to n_o each wave keeps its accuracy, leaving", birefringence,
         of_waves, same_formulas, and_zero(decades(-1, -15)),
         [](double step, const Turn& turn) {
             return meet(crystal(1.5, 1.5 + step, turn), air, 0.5, turn, InterfaceResults::waves);
         },
         usual_turns},
        {"huge-birefringence", "A wave may walk off by almost 90 degrees and is told apart by its energy",
         "n_e, with n_o = 1", of_waves, same_formulas, decades(0, 8, 2),
         [](double n, const Turn& turn) {
             return meet(air, crystal(1.0, 1.5 * n, turn), 0.7, turn, InterfaceResults::waves);
         },
         usual_turns},
        {"matched-liquid", "A liquid of index n_o on calcite reflects nothing of the o wave",
         "index of the liquid / n_o - 1", "sum of the fields of all waves, both sides", same_formulas,
         and_zero(decades(-1, -16)),
         [](double step, const Turn& turn) {
             return meet(make_isotropic(calcite_n_o * (1.0 + step)), calcite_crystal(turn({0.0, 1.0, 0.0})), 0.7, turn,
                         InterfaceResults::merged_fields);
         },
         usual_turns},
        {"twins-in-contact", "Equal crystals in contact are one crystal", "difference of the indices", of_waves,
         same_formulas, and_zero(decades(-1, -16)),
         [](double step, const Turn& turn) {
             return meet(crystal(1.6, 1.5, turn), crystal(1.6 + step, 1.5 + step, turn), 0.7, turn,
                         InterfaceResults::waves);
         },
         usual_turns},
        {"matched-glasses", "Nearly equal glasses reflect a share of the size of the square of their contrast",
         "index ratio - 1", "reflected powers, each to its own size", same_formulas, and_zero(decades(-1, -15)),
         [](double step, const Turn& turn) {
             return meet(air, make_isotropic(1.0 + step), 0.5, turn, InterfaceResults::reflected_powers,
                         Accuracy::relative);
         },
         usual_turns},
        {"metal", "A metal swallows what it does not reflect, from faint extinction to a perfect mirror",
         "extinction kappa, n = 0.3", "reflected and absorbed powers, each to its own size", same_formulas,
         decades(-16, 8),
         [](double kappa, const Turn& turn) {
             return meet(air, make_conductor(0.3, kappa), 0.7, turn, InterfaceResults::reflected_powers,
                         Accuracy::relative);
         },
         usual_turns},
        {"metal-in-crystal", "A metal behind a crystal swallows what it does not reflect", "extinction kappa, n = 0.3",
         of_waves, same_formulas, decades(-16, 8),
         [](double kappa, const Turn& turn) {
             return meet(crystal(calcite_n_o, calcite_n_e, turn), make_conductor(0.3, kappa), 0.7, turn,
                         InterfaceResults::waves);
         },
         usual_turns},
    };
}

}  // namespace pol::verify
