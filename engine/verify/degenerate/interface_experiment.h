// SPDX-License-Identifier: Apache-2.0
// One interface as numbers in, numbers out: experiments on the formulas of optics/.
#pragma once

#include <vector>

#include "core/vec.h"
#include "optics/dielectric.h"
#include "verify/degenerate/experiment.h"

namespace pol::verify {

/// An interface and the wave normal of what arrives, as a scene gives them.
struct InterfaceSetup {
    Dielectric<double> from;
    Dielectric<double> to;
    DVec3 normal{0.0, 0.0, 1.0};
    DVec3 wave_normal{0.0, 0.0, 1.0};
};

/// What is asked about the interface.
enum class InterfaceResults {
    /// Per incident polarization and outgoing wave: its power, and the power times its ray. Two fixed linear states
    /// arrive where the medium has pairs, else each crystal mode by itself.
    waves,
    /// Per fixed linear state and side: the sum of all outgoing fields, times the root of the flux. Independent of any
    /// choice of basis, so it has a limit where o and e become one.
    merged_fields,
    /// What unpolarized light gives: all reflected, all transmitted, all absorbed power, and their sum. Independent of
    /// any
    /// choice of basis as well, and of the last digits of a wave vector of o or e by itself.
    unpolarized_powers,
    transmitted_powers,
    reflected_powers,
};

/// Normal, wave normal, media, as the experiment takes them.
std::vector<double> interface_inputs(const InterfaceSetup& setup);

/// The solver of the program against itself with 113 bits.
Experiment interface_experiment(const InterfaceSetup& setup, InterfaceResults asked,
                                Accuracy accuracy = Accuracy::absolute);

}  // namespace pol::verify
