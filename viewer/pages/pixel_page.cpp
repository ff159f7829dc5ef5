// SPDX-License-Identifier: Apache-2.0
#include "viewer/pages/pixel_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "maps/error_bars.h"
#include "maps/evaluate.h"
#include "viewer/pages/page_frame.h"
#include "viewer/pages/pixel_readout.h"
#include "viewer/pages/readout_text.h"
#include "viewer/shown/shown_picture.h"

namespace pol {

namespace {

constexpr std::string_view degree = "\u00b0";

std::string exact_text(double value, std::string_view unit) {
    return fmt::format("{:.17g}{}{}", value + 0.0, unit.empty() || unit == degree ? "" : " ", unit);
}

/// The same of a bar.
std::string exact_text(const Interval<double>& bar, std::string_view unit) {
    return fmt::format("[{}, {}]", exact_text(bar.low, unit), exact_text(bar.high, unit));
}

/// `rounding` as in number_text.
PageRow row(std::string name, double value, const std::optional<Interval<double>>& bar, double rounding,
            std::string_view unit, std::string_view help) {
    PageRow out{std::move(name), {}, {}, {}, help};
    if (!std::isfinite(value)) {
        out.value = "not a number";
        return out;
    }
    const NumberText text = number_text(value, bar, rounding, 9, unit);
    out.value = text.value;
    out.bar = text.bar;
    out.exact = exact_text(value, unit);
    if (!out.bar.empty()) out.exact_bar = exact_text(*bar, unit);
    return out;
}

PageRow unmeasured_row(std::string name, std::string_view help) {
    return {std::move(name), std::string(state_text(PixelState::not_measured)), {}, {}, help};
}

PageRow exact_row(std::string name, double value, std::string_view unit, std::string_view help) {
    return row(std::move(name), value, std::nullopt, 0.0, unit, help);
}

PageRow axis_row(std::string name, const DVec3& v, std::string_view help) {
    return {std::move(name), vector_text(v, 1.0), {}, fmt::format("({:.17g}, {:.17g}, {:.17g})", v.x, v.y, v.z), help};
}

/// Bar of an amount of light: it grows by at most `share` of what is missing, and falls by as much of the surplus, but
/// not below 0.
Interval<double> one_sided(double amount, const PixelLight& light, double share) {
    return {std::min(amount, std::max(0.0, amount - share * light.surplus)), amount + share * light.missing};
}

/// "0.25 - 0.1 i".
std::string complex_text(const std::string& re, const std::string& im) {
    const bool is_negative = im.front() == '-';
    return fmt::format("{} {} {} i", re, is_negative ? '-' : '+', im.substr(is_negative ? 1 : 0));
}

/// Also fills the page's matrix_texts.
PageGroup matrix_group(PixelPage& page, const PixelLight& light, const Convention& convention) {
    const CoherenceMatrix<double>& j = page.matrix;
    PageGroup group{"Coherence matrix", {}};
    const bool has_diagonal = light.known.has(0) && light.known.has(1);
    const bool has_re = light.known.has(2);
    const bool has_im = light.known.has(3);
    // J_true = J + A - B, both positive semidefinite: 0 <= A_xx <= tr A and |A_xy| <= tr A / 2, the same for B.
    const auto diagonal = [&](double value) { return one_sided(value, light, 1.0); };
    const double radius = 0.5 * (light.missing + light.surplus);
    const auto around = [&](double value) { return Interval<double>{value - radius, value + radius}; };
    const double rounding = rounding_of(light);
    const auto add = [&](const char* name, bool is_known, double value, const Interval<double>& bar, const char* help) {
        group.rows.push_back(is_known ? row(name, value, bar, rounding, "", help) : unmeasured_row(name, help));
    };
    add("Jxx", has_diagonal, j.xx, diagonal(j.xx), "<Ex Ex*>, radiance along x");
    add("Re Jxy", has_re, j.xy.re, around(j.xy.re), "Real part of <Ex Ey*> = S2 / 2");
    add("Im Jxy", has_im, j.xy.im, around(j.xy.im),
        convention.s3_of_matrix() > 0 ? "Imaginary part of <Ex Ey*> = S3 / 2" : "Imaginary part of <Ex Ey*> = -S3 / 2");
    add("Jyy", has_diagonal, j.yy, diagonal(j.yy), "<Ey Ey*>, radiance along y");

    if (!std::isfinite(j.xx + j.yy + j.xy.re + j.xy.im)) return group;
    constexpr int digits = 4;  // what fits into a panel of 400 points
    const auto text = [&](double value, const Interval<double>& bar) {
        return number_text(value, bar, rounding, digits, "").value;
    };
    const std::string unknown(state_text(PixelState::not_measured));
    const auto on_diagonal = [&](double value) { return has_diagonal ? text(value, diagonal(value)) : unknown; };
    const auto off_diagonal = [&](const Complex<double>& z) {
        return has_re || has_im
                   ? complex_text(has_re ? text(z.re, around(z.re)) : "?", has_im ? text(z.im, around(z.im)) : "?")
                   : unknown;
    };
    const auto exact_part = [](bool is_known, double part) { return is_known ? fmt::format("{:.17g}", part) : "?"; };
    const auto exact_off_diagonal = [&](const Complex<double>& z) {
        if (has_re && has_im) return exact_text(z);
        return has_re || has_im ? complex_text(exact_part(has_re, z.re), exact_part(has_im, z.im)) : std::string();
    };
    page.matrix_texts = {on_diagonal(j.xx), off_diagonal(j.xy),       off_diagonal(conj(j.xy)),
                         on_diagonal(j.yy), exact_off_diagonal(j.xy), exact_off_diagonal(conj(j.xy))};
    return group;
}

PageGroup frame_group(const Document& document, const std::optional<CameraRay>& axes, double angle,
                      const Convention& convention) {
    PageGroup group{"Frame", {}};
    if (axes) {
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        group.rows.push_back(axis_row("x", convention.x_sign() * (angle == 0.0 ? axes->x : axes->x * c + axes->y * s),
                                      "Unit vector in the scene; image right in the camera frame"));
        group.rows.push_back(axis_row("y", angle == 0.0 ? axes->y : axes->y * c - axes->x * s,
                                      "Unit vector in the scene; image up in the camera frame"));
        group.rows.push_back(axis_row("k", -axes->direction, "Direction of the light, towards the camera"));
    } else {
        const auto& attributes = document.picture().attributes;
        const PictureOrigin& origin = document.picture().origin;
        for (const char* name : {"frame", "azimuthZero", "timeSign"})
            if (const auto found = attributes.find(name); found != attributes.end())
                group.rows.push_back(word_row(name, found->second, "What the file says"));
        if (group.rows.empty())
            group.rows.push_back(
                word_row("frame", "the file says nothing; taken as camera frame", "x image right, y image up"));
        if (origin != PictureOrigin{})
            group.rows.push_back(word_row("numbers", origin.convention.text(),
                                          "What the numbers of the file are taken for; the Picture panel changes it"));
    }
    if (angle != 0.0)
        group.rows.push_back(
            exact_row("turned by", degrees(angle), degree,
                      "Angle by which the axes are turned from the camera's x towards its y, as the receiver sees it"));
    return group;
}

PageGroup parts_group(const PixelPage& page, const PixelLight& light) {
    const double s0 = page.stokes.s0;
    const double p = polarized_part(page.stokes);
    const double radius = light.missing + light.surplus;
    const double rounding = rounding_of(light);
    PageGroup group{"Parts", {}};
    if (light.known != StokesComponents::all()) {
        for (const char* name : {"polarized", "unpolarized", "eigenvalue 1", "eigenvalue 2"})
            group.rows.push_back(unmeasured_row(name, "Needs all four Stokes components"));
        return group;
    }
    // Weyl: adding A and taking B away moves each eigenvalue up by at most tr A and down by at most tr B.
    const auto add = [&](const char* name, double value, double share, const char* help) {
        group.rows.push_back(row(name, value, one_sided(value, light, share), rounding, "", help));
    };
    group.rows.push_back(row("polarized", p, Interval<double>{std::max(0.0, p - radius), p + radius}, rounding, "",
                             "|(S1, S2, S3)|, radiance of the fully polarized part"));
    add("unpolarized", s0 - p, 2.0, "S0 - |(S1, S2, S3)|, half of it in any state");
    add("eigenvalue 1", 0.5 * (s0 + p), 1.0, "Larger eigenvalue of J, (S0 + |S|) / 2");
    add("eigenvalue 2", 0.5 * (s0 - p), 1.0, "Smaller eigenvalue of J, (S0 - |S|) / 2");
    return group;
}

PageGroup stokes_group(const PixelPage& page, const PixelLight& light, const Convention& convention) {
    const Stokes<double>& s = page.stokes;
    const auto bars = stokes_bars(light);
    const double rounding = rounding_of(light);
    PageGroup group{"Stokes vector", {}};
    const auto add = [&](unsigned component, double value, Interval<double> MeasureBounds<double>::*bar,
                         std::string_view help) {
        std::string name = "S" + std::to_string(component);
        group.rows.push_back(
            light.known.has(component)
                ? row(std::move(name), value, bars ? std::optional((*bars).*bar) : std::nullopt, rounding, "", help)
                : unmeasured_row(std::move(name), help));
    };
    add(0, s.s0, &MeasureBounds<double>::s0, "Jxx + Jyy, spectral radiance");
    add(1, s.s1, &MeasureBounds<double>::s1, "Jxx - Jyy: along x minus along y");
    add(2, s.s2, &MeasureBounds<double>::s2, "+45 degrees minus -45 degrees");
    add(3, s.s3, &MeasureBounds<double>::s3,
        convention.handedness_name(1) == "right" ? "Circular: right minus left" : "Circular: left minus right");
    return group;
}

/// As the maps see it, so that hover and inspector agree about what is undefined.
PageRow measure_row(std::string name, const QuantityReadout& readout, std::string_view unit, std::string_view help) {
    if (readout.pixel.state == PixelState::defined)
        return row(std::move(name), readout.pixel.value, readout.bar, readout.rounding, unit, help);
    PageRow out{std::move(name), std::string(state_text(readout.pixel.state)), {}, {}, help};
    if (!may_be_any(readout.pixel.state) || !readout.bar) return out;
    out.bar = interval_text(*readout.bar, readout.rounding, unit);
    out.exact_bar = exact_text(*readout.bar, unit);
    return out;
}

/// Right, left or linear, where no light that is missing can make it another one.
PageRow handedness_row(const QuantityReadout& readout, int handedness, const Convention& convention) {
    const QuantityInfo& about = info(Quantity::handedness);
    PageRow out{std::string(about.row_name), std::string(state_text(readout.pixel.state)), {}, {}, about.in_a_frame};
    if (readout.pixel.state != PixelState::defined) return out;
    const bool has_bar = readout.bar && readout.bar->width() > readout.rounding;
    const bool may_be_other = has_bar && (handedness == 0 || (readout.bar->low <= 0.0 && readout.bar->high >= 0.0));
    out.value = may_be_other      ? std::string(state_text(PixelState::undetermined))
                : handedness == 0 ? "linear"
                                  : std::string(convention.handedness_name(handedness));
    if (!may_be_other) out.exact = out.value;
    return out;
}

/// Known as well as the handedness, which is the sine of twice this angle.
PageRow ellipticity_angle_row(const PixelLight& light, const Measures<double>& m) {
    QuantityReadout chi = read_light(light, Quantity::handedness, 1.0);
    chi.pixel.value = degrees(m.ellipticity_angle);
    chi.rounding *= 90.0;
    if (const auto bars = error_bars(light))
        chi.bar = Interval<double>{degrees(bars->ellipticity_angle.low), degrees(bars->ellipticity_angle.high)};
    return measure_row("ellipticity angle", chi, degree, "atan2(S3, |(S1, S2)|) / 2, sign of S3");
}

/// The maps of the polarization, the handedness as a word, and the angle that is no map.
PageGroup measures_group(const PixelPage& page, const PixelLight& light, const Convention& convention) {
    const Measures<double>& m = page.measures;
    PageGroup group{"Measures", {}};
    for (const QuantityInfo& about : quantities()) {
        if (about.group != MapGroup::polarization) continue;
        const QuantityReadout readout = read_light(light, about.quantity, 1.0);
        const std::string_view help = about.in_a_frame.empty() ? about.definition : about.in_a_frame;
        group.rows.push_back(about.quantity == Quantity::handedness
                                 ? handedness_row(readout, m.handedness, convention)
                                 : measure_row(std::string(about.row_name), readout, about.unit, help));
        if (about.quantity == Quantity::ellipticity) group.rows.push_back(ellipticity_angle_row(light, m));
    }
    return group;
}

/// Only what the picture says: a foreign one says nothing of what was not traced.
PageGroup making_group(const PixelReadout& readout, const BandReadout& at) {
    PageGroup group{"How it was made", {}};
    if (readout.samples)
        group.rows.push_back(exact_row("samples", *readout.samples, "", "Rays through this pixel so far"));
    if (readout.has_residual) {
        group.rows.push_back(exact_row("residual", at.light.residual, "", info(Quantity::residual).definition));
        group.rows.push_back(exact_row("tail", at.tail, "", "Share of the throughput that one random path stands for"));
    }
    if (at.brightest > 0.0)
        group.rows.push_back(exact_row("brightest", at.brightest, "", "Most S0 that any path can bring"));
    if (readout.has_residual || readout.failures)
        group.rows.push_back(
            exact_row("failures", readout.failures.value_or(0), "", "Samples whose arithmetic failed"));
    if (group.rows.empty())
        group.rows.push_back(
            word_row("samples", "the file says nothing", "Nor what was left out, nor how well it is known"));
    return group;
}

/// Of a pixel that the render has not reached yet, behind the polarimeter.
BandReadout readout_of(const Explanation& e, const Plan& plan, const Polarimeter& polarimeter) {
    const auto w = static_cast<std::size_t>(e.wavelength);
    StokesImage image;
    image.width = image.height = 1;
    image.bands = bands_at({plan.wavelengths_nm[w]});
    image.stokes = {e.sample_light};
    image.residual = {e.result.residual};
    image.tail = {e.result.tail};
    image.brightest = {plan.brightest[w]};
    BandReadout at;
    at.band = image.bands[0];
    at.light = ShownPicture(image, polarimeter).light(0, 0);
    at.tail = e.result.tail;
    at.brightest = plan.brightest[w];
    return at;
}

}  // namespace

std::string complex_text(const Complex<double>& z, int digits, double size) {
    if (!std::isfinite(z.re) || !std::isfinite(z.im)) return "not a number";
    const double largest = std::max({size, std::abs(z.re), std::abs(z.im)});
    return complex_text(short_number(z.re, digits, largest), short_number(z.im, digits, largest));
}

std::string vector_text(const DVec3& v, double size) {
    return fmt::format("({}, {}, {})", short_number(v.x, 6, size), short_number(v.y, 6, size),
                       short_number(v.z, 6, size));
}

std::string exact_text(const Complex<double>& z) {
    return fmt::format("{:.17g} {} {:.17g} i", z.re + 0.0, z.im < 0.0 ? '-' : '+', std::abs(z.im));
}

PixelPage make_pixel_page(const Session& session) {
    const PageSettings& settings = session.page();
    const Convention& convention = session.view().convention;
    const Document& document = *session.current();
    PixelPage page;
    const PixelAddress pixel = *session.selection().pinned();
    page.pixel = {document.picture().left + pixel.x, document.picture().top + pixel.y};
    page.convention = convention.text();
    // The frame is turned before the convention labels it.
    const PixelReadout readout = read_pixel(session, pixel, Convention{});
    BandReadout at = readout.bands[std::min(session.view().band, readout.bands.size() - 1)];
    if (readout.samples == 0U && session.explanation() != nullptr) {
        at = readout_of(*session.explanation(), *document.plan(), session.polarimeter());
        page.from_tree = true;
    }
    page.band = at.band;

    const auto axes = camera_axes(document, pixel);
    const double angle = frame_angle(settings, axes, page.trouble);
    const Stokes<double> turned = angle == 0.0 ? at.light.stokes : rotate_basis(at.light.stokes, angle);
    const double noise = noise_threshold(1000.0);
    page.seen = measure(Convention{convention.viewpoint}.stokes(turned), noise);
    PixelLight light = at.light;
    light.known = page.known = known_in_frame(at.light.known, angle);
    light.stokes = page.stokes = convention.stokes(only(page.known, turned));
    page.measures = measure(page.stokes, noise);
    page.matrix = convention.matrix(to_coherence(turned));
    page.groups = {matrix_group(page, light, convention),
                   frame_group(document, axes, angle, convention),
                   stokes_group(page, light, convention),
                   measures_group(page, light, convention),
                   parts_group(page, light),
                   making_group(readout, at)};
    return page;
}

std::string text_of(const PixelPage& page) {
    std::string out =
        fmt::format("pixel {},{}  {}\n{}\n", page.pixel.x, page.pixel.y, page.band.label(), page.convention);
    for (const PageGroup& group : page.groups) {
        out += "\n" + group.title + "\n";
        for (const PageRow& r : group.rows)
            out += fmt::format("{:<18} {}{}{}\n", r.name, r.exact.empty() ? r.value : r.exact,
                               r.exact_bar.empty() ? "" : "  ", r.exact_bar);
    }
    return out;
}

}  // namespace pol
