// SPDX-License-Identifier: Apache-2.0
#include "report/explain_report.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/units.h"
#include "maps/error_bars.h"
#include "polarization/coherence_matrix.h"
#include "polarization/measures.h"
#include "tracer/tree_names.h"

namespace pol {

namespace {

using Json = nlohmann::ordered_json;

/// Error bars of the sample as of a picture with this one pixel.
std::optional<MeasureBounds<double>> bars_of(const Plan& plan, const Explanation& e) {
    StokesImage image;
    image.width = image.height = 1;
    const auto w = static_cast<std::size_t>(e.wavelength);
    image.bands = bands_at({plan.wavelengths_nm[w]});
    image.stokes = {e.sample_light};
    image.residual = {e.result.residual};
    image.tail = {e.result.tail};
    image.brightest = {plan.brightest[w]};
    return error_bars(image, 0, 0);
}

std::string text_of(const DVec3& v) {
    // Adding 0 turns -0 into 0, here and below.
    return fmt::format("({:.9f}, {:.9f}, {:.9f})", v.x + 0.0, v.y + 0.0, v.z + 0.0);
}

std::string text_of(const CoherenceMatrix<double>& j) {
    return fmt::format("[[{:.6g}, {:.6g}{:+.6g}i], [{:.6g}{:+.6g}i, {:.6g}]]", j.xx, j.xy.re + 0.0, j.xy.im + 0.0,
                       j.xy.re + 0.0, 0.0 - j.xy.im, j.yy);
}

std::string text_of(const Complex<double>& z) {
    return fmt::format("{:.6g}{:+.6g}i", z.re + 0.0, z.im + 0.0);
}

std::string text_of(const Stokes<double>& s) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g}, {:.6g})", s.s0 + 0.0, s.s1 + 0.0, s.s2 + 0.0, s.s3 + 0.0);
}

/// Rows are the camera's x and y, columns E1 and E2 of the branch.
std::string text_of(const Throughput<double>& t, bool single) {
    if (single) return fmt::format("[[{}], [{}]]", text_of(t.m[0][0]), text_of(t.m[1][0]));
    return fmt::format("[[{}, {}], [{}, {}]]", text_of(t.m[0][0]), text_of(t.m[0][1]), text_of(t.m[1][0]),
                       text_of(t.m[1][1]));
}

void write_measures(std::string& out, const Plan& plan, const Explanation& e) {
    const Stokes<double>& s = e.sample_light;
    const CoherenceMatrix<double> j = to_coherence(s);
    const Measures<double> m = measure(s, noise_threshold(static_cast<double>(e.tree.leaves.size()) + 1.0));
    const auto bars = bars_of(plan, e);
    auto to = std::back_inserter(out);
    fmt::format_to(to, "coherence matrix   [ {:<24.15g} {:.15g} {:+.15g} i ]\n", j.xx, j.xy.re, j.xy.im);
    fmt::format_to(to, "                   [ {:<24} {:.15g} ]\n", "conjugate", j.yy);
    fmt::format_to(to, "frame  x = {}  image right\n       y = {}  image up\n       k = {}  towards the camera\n",
                   text_of(e.task.ray.x), text_of(e.task.ray.y), text_of(-e.task.ray.direction));
    if (!bars) {
        fmt::format_to(to, "Stokes {:.15g} {:.15g} {:.15g} {:.15g}\n", s.s0, s.s1, s.s2, s.s3);
        return;
    }
    const auto row = [&](const char* name, double value, const Interval<double>& bar, bool defined, double scale,
                         const char* unit) {
        if (!defined) return static_cast<void>(fmt::format_to(to, "{:<20} undefined\n", name));
        fmt::format_to(to, "{:<20} {:<22.15g}{} {} in [{:.6g}, {:.6g}]{}\n", name, scale * value, unit,
                       plan.features.doubts.empty() ? "truth" : "but for what is doubted", scale * bar.low,
                       scale * bar.high, unit);
    };
    row("S0", s.s0, bars->s0, true, 1.0, "");
    row("S1", s.s1, bars->s1, true, 1.0, "");
    row("S2", s.s2, bars->s2, true, 1.0, "");
    row("S3", s.s3, bars->s3, true, 1.0, "");
    row("polarization", m.dop, bars->dop, m.has_light, 1.0, "");
    row("linear polarization", m.dolp, bars->dolp, m.has_light, 1.0, "");
    row("circular pol.", m.docp, bars->docp, m.has_light, 1.0, "");
    row("ellipticity b/a", m.ellipticity, bars->ellipticity, m.has_polarization, 1.0, "");
    row("azimuth", m.azimuth, {m.azimuth - bars->azimuth, m.azimuth + bars->azimuth}, m.has_azimuth, degrees(1.0),
        " deg");
    fmt::format_to(to, "{:<20} {}{}\n", "handedness", handedness_of(m),
                   m.handedness > 0 ? " (clockwise for the receiver)" : "");
    for (const std::string& doubt : plan.features.doubts) fmt::format_to(to, "doubt: {}\n", doubt);
}

void write_branch(std::string& out, const Plan& plan, const Explanation& e, int index, int indent, double least_share,
                  int& hidden) {
    const RayTreeNode& node = e.tree.nodes[static_cast<std::size_t>(index)];
    if (node.start.weight < least_share && index != 0) {
        ++hidden;
        return;
    }
    auto to = std::back_inserter(out);
    const std::string pad(static_cast<std::size_t>(2 * indent), ' ');
    fmt::format_to(to, "{}#{} {} in {}, {}, n = {:.6f}, weight {:.6g}{}\n", pad, index, interaction_of(plan, e, index),
                   medium_name(plan, node.start.region), mode_of(node.start.wave), index_of(node), node.start.weight,
                   node.estimated ? "  (random tail)" : "");
    fmt::format_to(to, "{}   ray {}  k {}\n", pad, text_of(node.start.wave.ray), text_of(node.start.wave.k));
    fmt::format_to(to, "{}   E1 {}  E2 {}\n", pad, text_of(node.start.wave.field[0]),
                   text_of(node.start.wave.field[1]));
    fmt::format_to(to, "{}   M to the camera {}\n", pad,
                   text_of(node.start.throughput, node.start.wave.kind != WaveKind::pair));
    if (node.arriving)
        fmt::format_to(to, "{}   light S {}  J {}  {}\n", pad, text_of(to_stokes(*node.arriving)),
                       text_of(*node.arriving), handedness_of(measure_arriving(e, node)));
    fmt::format_to(
        to, "{}   share S {}{}\n", pad, text_of(node.share),
        e.sample_light.s0 > 0.0 ? fmt::format("  {:.3g} % of S0", 100.0 * node.share.s0 / e.sample_light.s0) : "");
    if (node.arrived)
        fmt::format_to(to, "{}   meets {} facet {} at {}, {:.6f} deg\n", pad, plan.body_name(node.crossing.body),
                       node.crossing.facet, text_of(node.end.origin), degrees(node.angle));
    if (node.reason) fmt::format_to(to, "{}   ends: {} ({})\n", pad, name_of(*node.reason), help_of(*node.reason));
    for (const int child : node.children) write_branch(out, plan, e, child, indent + 1, least_share, hidden);
}

Json json_of(const DVec3& v) {
    return Json::array({v.x, v.y, v.z});
}
Json json_of(const Complex<double>& z) {
    return Json::array({z.re, z.im});
}
Json json_of(const Stokes<double>& s) {
    return Json::array({s.s0, s.s1, s.s2, s.s3});
}
Json json_of(const Interval<double>& i) {
    return Json::array({i.low, i.high});
}
Json json_of(const CoherenceMatrix<double>& j) {
    return {{"xx", j.xx}, {"yy", j.yy}, {"xy", json_of(j.xy)}};
}

Json json_of(const Plan& plan, const Explanation& e, int index) {
    const RayTreeNode& node = e.tree.nodes[static_cast<std::size_t>(index)];
    const Wave<double>& wave = node.start.wave;
    Json out;
    out["id"] = index;
    out["parent"] = node.parent;
    out["interaction"] = interaction_of(plan, e, index);
    out["depth"] = node.start.depth;
    out["medium"] = medium_name(plan, node.start.region);
    out["mode"] = mode_of(wave);
    out["index"] = index_of(node);
    out["origin"] = json_of(node.start.origin);
    out["k"] = json_of(wave.k);
    out["ray"] = json_of(wave.ray);
    out["frame"] = {{"E1", json_of(wave.field[0])}, {"E2", json_of(wave.field[1])}, {"k", json_of(-wave.ray)}};
    out["weight"] = node.start.weight;
    out["matrix"] = Json::array();
    for (const auto& row : node.start.throughput.m) {
        Json columns = Json::array({json_of(row[0])});
        if (wave.kind == WaveKind::pair) columns.push_back(json_of(row[1]));
        out["matrix"].push_back(columns);
    }
    if (node.arriving)
        out["light"] = {{"stokes", json_of(to_stokes(*node.arriving))},
                        {"coherence", json_of(*node.arriving)},
                        {"handedness", measure_arriving(e, node).handedness}};
    out["share"] = json_of(node.share);
    out["estimated"] = node.estimated;
    if (node.arrived) {
        out["surface"] = plan.body_name(node.crossing.body);
        out["facet"] = node.crossing.facet;
        out["point"] = json_of(node.end.origin);
        out["normal"] = json_of(node.crossing.normal);
        out["angle_deg"] = degrees(node.angle);
    }
    if (node.reason) out["ended"] = name_of(*node.reason);
    return out;
}

}  // namespace

std::string explanation_as_text(const Plan& plan, const Explanation& e, double least_share) {
    std::string out;
    auto to = std::back_inserter(out);
    const bool in_picture = static_cast<int>(e.sample) >= plan.settings.first_sample();
    fmt::format_to(to, "pixel {},{}  {}  {} nm\n\n", e.x, e.y,
                   in_picture ? fmt::format("sample {} of {}", e.sample, plan.settings.samples_per_pixel)
                              : "its centre, which is none of the samples of an area picture",
                   plan.wavelengths_nm[static_cast<std::size_t>(e.wavelength)]);
    write_measures(out, plan, e);
    fmt::format_to(to, "\nresolved {:.6g} + absorbed {:.6g} + residual {:.6g} + random tail {:.6g} = 1 {:+.1e}\n",
                   e.result.resolved, e.result.absorbed, e.result.residual, e.result.tail,
                   e.result.resolved + e.result.absorbed + e.result.residual + e.result.tail - 1.0);
    fmt::format_to(
        to, "{} leaves; their sum {} the rendered sample{}\n\n", e.tree.leaves.size(), e.exact() ? "is" : "IS NOT",
        e.exact() ? " to the last bit" : fmt::format(": S0 differs by {:.3e}", e.leaf_sum.s0 - e.sample_light.s0));
    fmt::format_to(
        to,
        "ray and k of a branch run from the camera, its light (S, J) the other way; E1, E2 and -ray are the\n"
        "right-handed frame of the light and of M, share is what the branch and all that grew from it bring\n"
        "to the pixel, in the pixel's frame\n\n");
    int hidden = 0;
    write_branch(out, plan, e, 0, 0, least_share, hidden);
    if (hidden > 0)
        fmt::format_to(
            to, "\n{} branches of weight below {:g} (and what grew from them) are not shown: --least 0 shows all\n",
            hidden, least_share);
    return out;
}

std::string explanation_as_json(const Plan& plan, const Explanation& e) {
    Json out;
    out["pixel"] = {e.x, e.y};
    out["sample"] = e.sample;
    out["samples_per_pixel"] = plan.settings.samples_per_pixel;
    out["wavelength_nm"] = plan.wavelengths_nm[static_cast<std::size_t>(e.wavelength)];
    out["frame"] = {{"x", json_of(e.task.ray.x)}, {"y", json_of(e.task.ray.y)}, {"k", json_of(-e.task.ray.direction)}};
    out["coherence"] = json_of(to_coherence(e.sample_light));
    out["stokes"] = json_of(e.sample_light);
    const Measures<double> m =
        measure(e.sample_light, noise_threshold(static_cast<double>(e.tree.leaves.size()) + 1.0));
    out["measures"] = {{"dop", m.dop},
                       {"dolp", m.dolp},
                       {"docp", m.docp},
                       {"ellipticity", m.ellipticity},
                       {"ellipticity_angle_rad", m.ellipticity_angle},
                       {"azimuth_rad", m.azimuth},
                       {"handedness", m.handedness},
                       {"has_light", m.has_light},
                       {"has_polarization", m.has_polarization},
                       {"has_azimuth", m.has_azimuth}};
    if (const auto bars = bars_of(plan, e))
        out[plan.features.doubts.empty() ? "bounds" : "bounds_but_for_doubts"] = {
            {"s0", json_of(bars->s0)},     {"s1", json_of(bars->s1)},
            {"s2", json_of(bars->s2)},     {"s3", json_of(bars->s3)},
            {"dop", json_of(bars->dop)},   {"dolp", json_of(bars->dolp)},
            {"docp", json_of(bars->docp)}, {"ellipticity", json_of(bars->ellipticity)},
            {"azimuth_rad", bars->azimuth}};
    out["doubts"] = plan.features.doubts;
    out["resolved"] = e.result.resolved;
    out["absorbed"] = e.result.absorbed;
    out["residual"] = e.result.residual;
    out["tail"] = e.result.tail;
    out["failures"] = e.result.failures;
    out["leaf_sum"] = json_of(e.leaf_sum);
    out["leaves_sum_to_sample"] = e.exact();
    out["leaves"] = e.tree.leaves;
    out["nodes"] = Json::array();
    for (int i = 0; i < static_cast<int>(e.tree.nodes.size()); ++i) out["nodes"].push_back(json_of(plan, e, i));
    return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace pol
