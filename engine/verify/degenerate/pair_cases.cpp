// SPDX-License-Identifier: Apache-2.0
// Degenerate cases of two knobs at once: formulas that are sound at each of two singular points need not be where they
// meet.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/hypot.h"
#include "core/units.h"
#include "optics/uniaxial_modes.h"
#include "verify/degenerate/case_lists.h"
#include "verify/degenerate/interface_experiment.h"

namespace pol::verify {

namespace {

enum class Way { out_of_crystal, into_crystal };

/// What the knobs act on, in the frame of the face: normal z, plane of incidence xz. At rest all is in general
/// position, and the index behind the face is the lower one.
struct Knobs {
    explicit Knobs(Way way) : leaves(way == Way::out_of_crystal), other(make_isotropic(leaves ? 1.3 : 2.5)) {}

    bool leaves;  ///< the crystal
    double n_o = calcite_n_o;
    double n_e = calcite_n_e;
    DVec3 axis = unit(DVec3(1.0, 2.0, 3.0));
    Dielectric<double> other;
    DVec3 wave = polar_direction(radians(40.0));

    [[nodiscard]] Dielectric<double> crystal() const { return make_uniaxial(n_o, n_e, axis); }
    /// `n` but for a share that leaves the index behind the face the lower one.
    [[nodiscard]] double almost(double n, double share) const { return leaves ? n * (1.0 - share) : n * (1.0 + share); }
};

double o_critical(const Knobs& b) {
    return std::asin(b.leaves ? b.other.n / b.n_o : b.n_o / b.other.n);
}

/// From inside: where k_t of the e wave is the index outside. From outside: where k_t ends the e sheet
/// (PHYSICS.md 2.5).
double e_critical(const Knobs& b) {
    IncidenceFrame<double> frame;
    frame.x = {1.0, 0.0, 0.0};
    frame.s = {0.0, 1.0, 0.0};
    frame.normal = face_normal;
    frame.k_t = b.other.n;
    const CrystalFace<double> face = crystal_face(b.crystal(), frame);
    if (b.leaves) return std::atan2(face.k_t, crystal_roots(face, face.eps_o - face.k_t * face.k_t, 1.0).q_e.re);
    const double end2 = face.eps_e * face.normal_eps / (face.eps_e - face.delta * face.axis.y * face.axis.y);
    return std::asin(std::sqrt(end2) / b.other.n);
}

/// Of the o wave in the crystal.
DVec3 ordinary_wave_normal(const Knobs& b) {
    if (b.leaves) return b.wave;
    const double sine = b.wave.x * b.other.n / b.n_o;
    return {sine, 0.0, std::sqrt((1.0 - sine) * (1.0 + sine))};
}

/// What a knob sets or asks for. Two knobs that share one of these cannot both be near their points.
enum Claim : unsigned {
    indices = 1U,
    neighbour = 2U,
    incidence = 4U,
    from_normal = 8U,    ///< angle between axis and normal
    from_plane = 16U,    ///< angle between axis and plane of incidence
    upright = 32U,       ///< axis along the normal, along s, or along the wave
    axis_first = 64U,    ///< needs the final axis, or gives it
    other_index = 128U,  ///< an index behind the face that ends some wave
};

/// What else there is to know of a knob.
enum Note : unsigned {
    leaving_only = 1U,   ///< light has to come from the crystal
    o_evanescent = 2U,   ///< in the crystal, when light comes from outside
    o_needed = 4U,       ///< an o wave in the crystal
    ratio_setting = 8U,  ///< the setting is a ratio of indices
};

/// One singular point, and how far from it.
struct Knob {
    std::string name;
    std::string text;  ///< what is set, with its unit
    unsigned claims;
    unsigned notes;
    void (*set)(Knobs&, double);
};

/// In the order in which they act.
const std::vector<Knob>& knobs() {
    static const std::vector<Knob> all = {
        {"weak-crystal", "n_e/n_o - 1", indices, 0, [](Knobs& b, double x) { b.n_e = b.n_o * (1.0 + x); }},
        {"strong-positive", "n_e/n_o", indices, ratio_setting, [](Knobs& b, double ratio) { b.n_e = b.n_o * ratio; }},
        {"strong-negative", "n_o/n_e", indices, ratio_setting, [](Knobs& b, double ratio) { b.n_e = b.n_o / ratio; }},
        {"matched-o", "|n/n_o - 1|", neighbour, 0,
         [](Knobs& b, double x) { b.other = make_isotropic(b.almost(b.n_o, x)); }},
        {"matched-e", "|n/n_e - 1|", neighbour, 0,
         [](Knobs& b, double x) { b.other = make_isotropic(b.almost(b.n_e, x)); }},
        {"weak-metal", "kappa", neighbour, leaving_only, [](Knobs& b, double x) { b.other = make_conductor(1.3, x); }},
        {"axis-along-normal", "angle between axis and normal [rad]", from_normal | upright, 0,
         [](Knobs& b, double x) { b.axis = beside(face_normal, x); }},
        {"axis-in-face", "angle between axis and face [rad]", from_normal, 0,
         [](Knobs& b, double x) { b.axis = unit(DVec3(b.axis.x, b.axis.y, x * pol::hypot(b.axis.x, b.axis.y))); }},
        {"normal-incidence", "angle of incidence [rad]", incidence, 0,
         [](Knobs& b, double x) { b.wave = polar_direction(x); }},
        // Exactly above the face: nothing of the small angle is lost in a direction.
        {"grazing", "angle above the face [rad]", incidence, o_evanescent,
         [](Knobs& b, double x) {
             b.wave = {std::cos(x), 0.0, std::sin(x)};
         }},
        {"below-o-critical", "distance to the critical angle of o [rad]", incidence | other_index, 0,
         [](Knobs& b, double x) { b.wave = polar_direction(o_critical(b) - x); }},
        {"beyond-o-critical", "distance to the critical angle of o [rad]", incidence | other_index, o_evanescent,
         [](Knobs& b, double x) { b.wave = polar_direction(o_critical(b) + x); }},
        {"wave-along-axis", "angle between wave and axis [rad]", from_normal | upright | axis_first, o_needed,
         [](Knobs& b, double x) { b.axis = beside(ordinary_wave_normal(b), x); }},
        {"axis-in-plane", "angle between axis and plane of incidence [rad]", from_plane, 0,
         [](Knobs& b, double x) { b.axis = unit(DVec3(b.axis.x, x * pol::hypot(b.axis.x, b.axis.z), b.axis.z)); }},
        {"axis-along-s", "angle between axis and s [rad]", from_plane | upright, 0,
         [](Knobs& b, double x) { b.axis = unit(DVec3(x * b.axis.x, pol::hypot(b.axis.x, b.axis.z), x * b.axis.z)); }},
        {"below-e-critical", "distance to the critical angle of e [rad]", incidence | other_index | axis_first, 0,
         [](Knobs& b, double x) { b.wave = polar_direction(e_critical(b) - x); }},
        {"beyond-e-critical", "distance to the critical angle of e [rad]", incidence | other_index | axis_first, 0,
         [](Knobs& b, double x) { b.wave = polar_direction(e_critical(b) + x); }},
        {"twin", "angle between the axes of two crystals [rad]", neighbour | other_index, leaving_only,
         [](Knobs& b, double x) { b.other = make_uniaxial(b.n_o, b.n_e, beside(b.axis, x)); }},
    };
    return all;
}

/// Whether both can be near their points.
bool meet(const Knob& a, const Knob& b, Way way) {
    if ((a.claims & b.claims) != 0) return false;
    if (way == Way::out_of_crystal) return true;
    const unsigned notes = a.notes | b.notes;
    return (notes & leaving_only) == 0 && ((notes & o_evanescent) == 0 || (notes & o_needed) == 0);
}

/// Where the wave may be a pair, or o and e, as roundings will have it, only what needs no basis can be compared.
bool needs_no_basis(const Knob& a, const Knob& b) {
    const auto either = [&](const char* name) { return a.name == name || b.name == name; };
    return either("wave-along-axis") || (either("axis-along-normal") && either("normal-incidence"));
}

std::vector<double> settings_of(const Knob& knob) {
    if ((knob.notes & ratio_setting) != 0) return {1.25, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0, 64.0};
    return {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-15, 0.0};
}
const std::vector<double> second_settings = {1e-2, 1e-4, 1e-8, 1e-12, 1e-15, 0.0};

/// Sums of eps_o and eps_e lose as many digits as their ratio has. Below a ratio of the indices of 8 the margin for
/// rounding hides that; no natural crystal comes near it.
double lost_to_strength(double ratio) {
    return ratio >= 8.0 ? ratio * ratio : 1.0;
}

DegenerateCase pair_case(const Knob& a, const Knob& b, const std::vector<Way>& ways) {
    DegenerateCase pair;
    pair.name = a.name + "-and-" + b.name;
    pair.sentence = "Where two singular points meet, no more is lost than at each";
    pair.knob = a.text;
    pair.second_knob = b.text;
    const bool unpolarized = needs_no_basis(a, b);
    pair.results = unpolarized ? "R, T and their sum for unpolarized light" : "power and ray of each wave";
    pair.reference = same_formulas;
    pair.settings = settings_of(a);
    pair.second_settings = second_settings;
    if ((a.notes & ratio_setting) != 0) {
        pair.sentence += " but the digits that the ratio of eps_o and eps_e has, from a ratio of indices of 8 on";
        pair.loss = lost_to_strength;
    }
    pair.turns = second_settings.size() * ways.size();
    pair.at = [a, b, ways, unpolarized](double x, const Turn& turn) {
        Knobs bench(ways[turn.number() / second_settings.size()]);
        a.set(bench, x);
        b.set(bench, second_settings[turn.number() % second_settings.size()]);
        InterfaceSetup setup{bench.crystal(), bench.other, face_normal, bench.wave};
        if (!bench.leaves) std::swap(setup.from, setup.to);
        return interface_experiment(setup,
                                    unpolarized ? InterfaceResults::unpolarized_powers : InterfaceResults::waves);
    };
    return pair;
}

}  // namespace

std::vector<DegenerateCase> pair_cases() {
    std::vector<DegenerateCase> cases;
    for (auto a = knobs().begin(); a != knobs().end(); ++a) {
        for (auto b = a + 1; b != knobs().end(); ++b) {
            std::vector<Way> ways;
            for (const Way way : {Way::out_of_crystal, Way::into_crystal})
                if (meet(*a, *b, way)) ways.push_back(way);
            if (!ways.empty()) cases.push_back(pair_case(*a, *b, ways));
        }
    }
    return cases;
}

}  // namespace pol::verify
