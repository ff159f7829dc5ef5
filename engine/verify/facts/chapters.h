// SPDX-License-Identifier: Apache-2.0
// The chapters of the list of facts, one file each, and the words in which they are written.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "polarization/stokes.h"
#include "verify/facts/fact.h"

namespace pol::verify {

std::vector<Fact> reflection_facts();        // T1 to T3, T16 to T20
std::vector<Fact> plate_facts();             // T4 to T8, T14
std::vector<Fact> total_reflection_facts();  // T9 to T12
std::vector<Fact> element_facts();           // T13, T52, T53
std::vector<Fact> drop_facts();              // T15
std::vector<Fact> crystal_plate_facts();     // T21 to T25, T35, T44, T45, T51
std::vector<Fact> crystal_contact_facts();   // T26, T36, T37
std::vector<Fact> crystal_prism_facts();     // T27 to T29
std::vector<Fact> crystal_face_facts();      // T30 to T34, T38, T39
std::vector<Fact> algebra_facts();           // T46 to T50
std::vector<Fact> lamp_facts();              // T54 to T58
std::vector<Fact> unmodelled_facts();        // T40 to T43

using Measurement = std::function<double(const Explanation&)>;
using StokesMeasure = std::function<double(const Stokes<double>&)>;

/// Adds a scene to the fact and returns its index. `yaml` is written with camera_*() and picture() of scene_text.h: the
/// pixel is the middle of that picture.
std::size_t add_view(Fact& fact, std::string name, std::string yaml, double wavelength_nm = 580.0);

/// Adds a number to the fact.
void expect(Fact& fact, std::size_t view, std::string what, double expected, Tolerance tolerance, Measurement measure,
            std::string unit = "");

/// `measure` of the pixel's light, or of the light that came along one path ("TRT", tree_paths.h).
Measurement of_pixel(StokesMeasure measure);
Measurement along(std::string route, StokesMeasure measure);

// Stokes measures: components, the shares of s and p where the picture's x axis is s (S0 + S1 and S0 - S1 of a lamp of
// radiance 1 that is not polarized), and the quantities of the maps; angles in degrees.
double s0(const Stokes<double>& s);
double s1(const Stokes<double>& s);
double s2(const Stokes<double>& s);
double s3(const Stokes<double>& s);
double s_share(const Stokes<double>& s);
double p_share(const Stokes<double>& s);
double dop(const Stokes<double>& s);
double ellipticity(const Stokes<double>& s);
double handedness(const Stokes<double>& s);
double azimuth_degrees(const Stokes<double>& s);

// Tolerances. One operation rounds by half of epsilon; a surface is some 20 operations (60 in a crystal) on numbers of
// order 1, with slopes of order 1 in the angle, which a camera makes good to a few epsilon.
constexpr double epsilon = std::numeric_limits<double>::epsilon();
Tolerance rounding(double epsilons, std::string_view of);
/// 60 epsilon, for one surface of a crystal.
Tolerance one_crystal_surface();
/// Light that was not traced, at most `residual` of the lamp's, moves the reading by up to `slope` times as much.
Tolerance residual_bound(double residual, double slope, const Tolerance& otherwise);
/// Half of the last digit that the source prints.
Tolerance last_printed_digit(int decimals, std::string_view source);
/// A count, or a state that the closed form gives without rounding.
Tolerance exact();

}  // namespace pol::verify
