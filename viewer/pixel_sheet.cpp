// SPDX-License-Identifier: Apache-2.0
#include "viewer/pixel_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "maps/error_bars.h"
#include "maps/evaluate.h"
#include "viewer/pixel_reading.h"
#include "viewer/reading_text.h"
#include "viewer/shown_picture.h"

namespace pol {

namespace {

constexpr std::string_view plus_minus = "\u00b1 ";
constexpr std::string_view degree = "\u00b0";

std::string exact_text(double value, std::string_view unit) {
    return fmt::format("{:.17g}{}{}", value + 0.0, unit.empty() || unit == degree ? "" : " ", unit);
}

SheetRow row(std::string name, double value, double half_width, std::string_view unit, std::string_view help) {
    SheetRow out{std::move(name), {}, {}, {}, help};
    if (!std::isfinite(value)) {
        out.value = "not a number";
        return out;
    }
    out.value = short_number(value, 9) + std::string(unit);
    out.exact = exact_text(value, unit);
    if (half_width > 0.0) out.bar = std::string(plus_minus) + short_number(half_width, 2) + std::string(unit);
    return out;
}

SheetRow words(std::string name, const std::string& value, std::string_view help) {
    return {std::move(name), value, {}, value, help};
}

std::string vector_text(const DVec3& v) {
    return fmt::format("({}, {}, {})", short_number(v.x, 6), short_number(v.y, 6), short_number(v.z, 6));
}

SheetRow axis_row(std::string name, const DVec3& v, std::string_view help) {
    return {std::move(name), vector_text(v), {}, fmt::format("({:.17g}, {:.17g}, {:.17g})", v.x, v.y, v.z), help};
}

/// Axes of the pixel's centre in the scene, or none for a picture without one.
std::optional<CameraRay> camera_axes(const Document& document, PixelAddress pixel) {
    if (!document.has_scene()) return std::nullopt;
    return document.plan()->camera.ray(pixel.x + 0.5, pixel.y + 0.5);
}

/// Angle from the camera's x to the x asked for; 0, and the reason in `trouble`, if there is none.
double frame_angle(const SheetSettings& settings, const std::optional<CameraRay>& axes, std::string& trouble) {
    switch (settings.frame) {
        case FrameChoice::camera:
            return 0.0;
        case FrameChoice::own_angle:
            return settings.own_angle;
        case FrameChoice::scene_x:
        case FrameChoice::scene_y:
        case FrameChoice::scene_z:
            break;
    }
    if (!axes) {
        trouble = "A picture has no scene axes: camera frame";
        return 0.0;
    }
    const int axis = static_cast<int>(settings.frame) - static_cast<int>(FrameChoice::scene_x);
    const double along_x = axes->x[axis];
    const double along_y = axes->y[axis];
    constexpr double seen_end_on = 1e-9;
    if (std::hypot(along_x, along_y) < seen_end_on) {
        trouble = "That axis points along the ray: camera frame";
        return 0.0;
    }
    return std::atan2(along_y, along_x);
}

SheetGroup matrix_group(const PixelSheet& sheet, const PixelLight& light, const Convention& convention) {
    const CoherenceMatrix<double>& j = sheet.matrix;
    SheetGroup group{"Coherence matrix", {}};
    // J_true = J + A - B, both positive semidefinite: 0 <= A_xx <= tr A and |A_xy| <= tr A / 2, the same for B.
    const double diagonal = std::max(light.missing, light.surplus);
    const double radius = light.missing + light.surplus;
    group.rows.push_back(row("Jxx", j.xx, diagonal, "", "<Ex Ex*>, radiance along x"));
    group.rows.push_back(row("Re Jxy", j.xy.re, 0.5 * radius, "", "Real part of <Ex Ey*> = S2 / 2"));
    group.rows.push_back(row("Im Jxy", j.xy.im, 0.5 * radius, "",
                             convention.s3_of_matrix() > 0 ? "Imaginary part of <Ex Ey*> = S3 / 2"
                                                           : "Imaginary part of <Ex Ey*> = -S3 / 2"));
    group.rows.push_back(row("Jyy", j.yy, diagonal, "", "<Ey Ey*>, radiance along y"));
    return group;
}

SheetGroup frame_group(const Document& document, const std::optional<CameraRay>& axes, double angle,
                       const Convention& convention) {
    SheetGroup group{"Frame", {}};
    if (axes) {
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        group.rows.push_back(axis_row("x", convention.x_axis(angle == 0.0 ? axes->x : axes->x * c + axes->y * s),
                                      "Unit vector in the scene; image right in the camera frame"));
        group.rows.push_back(axis_row("y", angle == 0.0 ? axes->y : axes->y * c - axes->x * s,
                                      "Unit vector in the scene; image up in the camera frame"));
        group.rows.push_back(axis_row("k", -axes->direction, "Direction of the light, towards the camera"));
    } else {
        const auto& attributes = document.picture().attributes;
        for (const char* name : {"frame", "azimuthZero", "timeSign"})
            if (const auto found = attributes.find(name); found != attributes.end())
                group.rows.push_back(words(name, found->second, "What the file says"));
        if (group.rows.empty())
            group.rows.push_back(
                words("frame", "the file says nothing; taken as camera frame", "x image right, y image up"));
    }
    if (angle != 0.0)
        group.rows.push_back(row("turned by", degrees(angle), 0.0, degree,
                                 "Angle from the camera's x to this x, towards the camera's y"));
    return group;
}

SheetGroup parts_group(const PixelSheet& sheet, const PixelLight& light) {
    const double s0 = sheet.stokes.s0;
    const double p = polarized_part(sheet.stokes);
    const double radius = light.missing + light.surplus;
    const double one_sided = std::max(light.missing, light.surplus);
    SheetGroup group{"Parts", {}};
    group.rows.push_back(row("polarized", p, radius, "", "|(S1, S2, S3)|, radiance of the fully polarized part"));
    group.rows.push_back(
        row("unpolarized", s0 - p, 2.0 * one_sided, "", "S0 - |(S1, S2, S3)|, half of it in any state"));
    group.rows.push_back(row("eigenvalue 1", 0.5 * (s0 + p), one_sided, "", "Larger eigenvalue of J, (S0 + |S|) / 2"));
    group.rows.push_back(row("eigenvalue 2", 0.5 * (s0 - p), one_sided, "", "Smaller eigenvalue of J, (S0 - |S|) / 2"));
    return group;
}

SheetGroup stokes_group(const PixelSheet& sheet, const PixelLight& light) {
    const Stokes<double>& s = sheet.stokes;
    const double radius = light.missing + light.surplus;
    SheetGroup group{"Stokes vector", {}};
    group.rows.push_back(row("S0", s.s0, std::max(light.missing, light.surplus), "", "Jxx + Jyy, spectral radiance"));
    group.rows.push_back(row("S1", s.s1, radius, "", "Jxx - Jyy: along x minus along y"));
    group.rows.push_back(row("S2", s.s2, radius, "", "+45 degrees minus -45 degrees"));
    group.rows.push_back(row("S3", s.s3, radius, "", "Circular: right minus left, or as the convention has it"));
    return group;
}

/// As the maps see it, so that hover and inspector agree about what is undefined.
SheetRow measure_row(std::string name, const PixelLight& light, Quantity quantity, double value, std::string_view unit,
                     std::string_view help) {
    const MapPixel pixel = evaluate_light(light, quantity, 1.0);
    if (pixel.state != PixelState::defined && pixel.state != PixelState::undetermined)
        return {std::move(name), std::string(state_text(pixel.state)), {}, {}, help};
    double bar = 0.0;
    if (const auto interval = error_bar(light, quantity, 1.0))
        bar = half_width(*interval, quantity == Quantity::azimuth ? degrees(measure(light.stokes).azimuth) : value);
    SheetRow out = row(std::move(name), value, bar, unit, help);
    if (pixel.state == PixelState::undetermined) out.bar = "not determined";
    return out;
}

SheetGroup measures_group(const PixelSheet& sheet, const PixelLight& light, const Convention& convention) {
    const Measures<double>& m = sheet.measures;
    SheetGroup group{"Measures", {}};
    const auto add = [&](const char* name, Quantity quantity, double value, std::string_view unit,
                         std::string_view help) {
        group.rows.push_back(measure_row(name, light, quantity, value, unit, help));
    };
    add("DoP", Quantity::dop, m.dop, "", info(Quantity::dop).definition);
    add("DoLP", Quantity::dolp, m.dolp, "", info(Quantity::dolp).definition);
    add("DoCP", Quantity::docp, m.docp, "", info(Quantity::docp).definition);
    add("ellipticity b/a", Quantity::ellipticity, m.ellipticity, "", info(Quantity::ellipticity).definition);
    SheetRow chi = measure_row("ellipticity angle", light, Quantity::ellipticity, degrees(m.ellipticity_angle), degree,
                               "atan2(S3, |(S1, S2)|) / 2, sign of S3");
    if (!chi.exact.empty() && chi.bar != "not determined") {
        const auto bars = error_bars(light);
        const double width = bars ? degrees(half_width(bars->ellipticity_angle, m.ellipticity_angle)) : 0.0;
        chi = row(chi.name, degrees(m.ellipticity_angle), width, degree, chi.help);
    }
    group.rows.push_back(std::move(chi));
    add("azimuth", Quantity::azimuth, degrees(m.azimuth), degree,
        "atan2(S2, S1) / 2: major axis of the ellipse, from x towards y");
    SheetRow hand = measure_row("handedness", light, Quantity::handedness, 0.0, "", "Clockwise for who looks: right");
    if (!hand.exact.empty()) {
        hand.exact = m.handedness == 0 ? std::string("linear") : std::string(convention.handedness_name(m.handedness));
        hand.value = hand.exact;
        hand.bar = hand.bar == "not determined" ? hand.bar : std::string();
    }
    group.rows.push_back(std::move(hand));
    return group;
}

SheetGroup making_group(const PixelReading& reading, const WavelengthReading& at) {
    SheetGroup group{"How it was made", {}};
    if (reading.samples)
        group.rows.push_back(row("samples", *reading.samples, 0.0, "", "Rays through this pixel so far"));
    group.rows.push_back(row("residual", at.light.residual, 0.0, "", info(Quantity::residual).definition));
    group.rows.push_back(row("tail", at.tail, 0.0, "", "Share of the throughput that one random path stands for"));
    if (at.brightest > 0.0)
        group.rows.push_back(row("brightest", at.brightest, 0.0, "", "Most S0 that any path can bring"));
    group.rows.push_back(row("failures", reading.failures.value_or(0), 0.0, "", "Samples whose arithmetic failed"));
    return group;
}

/// Of a pixel that the render has not reached yet, behind the bench.
WavelengthReading reading_of(const Explanation& e, const Plan& plan, const Bench& bench) {
    const auto w = static_cast<std::size_t>(e.wavelength);
    StokesImage image;
    image.width = image.height = 1;
    image.wavelengths_nm = {plan.wavelengths_nm[w]};
    image.stokes = {e.sample_light};
    image.residual = {e.result.residual};
    image.tail = {e.result.tail};
    image.brightest = {plan.brightest[w]};
    WavelengthReading at;
    at.wavelength_nm = image.wavelengths_nm[0];
    at.light = ShownPicture(image, bench).light(0, 0);
    at.tail = e.result.tail;
    at.brightest = plan.brightest[w];
    return at;
}

}  // namespace

std::string complex_text(const Complex<double>& z, int digits) {
    if (!std::isfinite(z.re) || !std::isfinite(z.im)) return "not a number";
    return fmt::format("{} {} {} i", short_number(z.re, digits), z.im < 0.0 ? '-' : '+',
                       short_number(std::abs(z.im), digits));
}

std::string exact_text(const Complex<double>& z) {
    return fmt::format("{:.17g} {} {:.17g} i", z.re + 0.0, z.im < 0.0 ? '-' : '+', std::abs(z.im));
}

PixelSheet make_pixel_sheet(const Session& session) {
    const SheetSettings& settings = session.sheet;
    const Document& document = *session.current();
    PixelSheet sheet;
    sheet.pixel = *session.selection.pinned();
    const PixelReading reading = read_pixel(session, sheet.pixel);
    WavelengthReading at = reading.wavelengths[std::min(session.view.wavelength, reading.wavelengths.size() - 1)];
    if (reading.samples == 0U && session.explanation() != nullptr) {
        at = reading_of(*session.explanation(), *document.plan(), session.bench);
        sheet.from_tree = true;
    }
    sheet.wavelength_nm = at.wavelength_nm;

    const auto axes = camera_axes(document, sheet.pixel);
    const double angle = frame_angle(settings, axes, sheet.trouble);
    const Stokes<double> turned = angle == 0.0 ? at.light.stokes : rotate_basis(at.light.stokes, angle);
    const double noise = noise_threshold(1000.0);
    sheet.seen = measure(Convention{settings.convention.viewpoint}.stokes(turned), noise);
    PixelLight light = at.light;
    light.stokes = sheet.stokes = settings.convention.stokes(turned);
    sheet.measures = measure(sheet.stokes, noise);
    sheet.matrix = settings.convention.matrix(to_coherence(turned));
    sheet.groups = {matrix_group(sheet, light, settings.convention),
                    frame_group(document, axes, angle, settings.convention),
                    stokes_group(sheet, light),
                    measures_group(sheet, light, settings.convention),
                    parts_group(sheet, light),
                    making_group(reading, at)};
    return sheet;
}

double sheet_frame_angle(const Session& session) {
    std::string trouble;
    return frame_angle(session.sheet, camera_axes(*session.current(), *session.selection.pinned()), trouble);
}

std::vector<SheetCurve> spectrum_curves(const Session& session) {
    const PixelReading reading = read_pixel(session, *session.selection.pinned());
    const double angle = sheet_frame_angle(session);
    std::vector<SheetCurve> curves;
    SheetCurve s0{"S0", {}, 0.0, 0.0, false};
    for (const WavelengthReading& at : reading.wavelengths) {
        const double value = at.light.stokes.s0;
        s0.values.push_back(std::isfinite(value) ? std::optional(value) : std::nullopt);
        if (std::isfinite(value)) s0.high = std::max(s0.high, value);
    }
    curves.push_back(std::move(s0));
    for (const Quantity quantity : {Quantity::dop, Quantity::azimuth, Quantity::ellipticity}) {
        const QuantityInfo& about = info(quantity);
        SheetCurve curve{std::string(about.title), {}, about.low, about.high, about.kind == ScaleKind::cyclic};
        if (!about.unit.empty()) curve.name += fmt::format(" ({})", about.unit);
        for (const WavelengthReading& at : reading.wavelengths) {
            PixelLight light = at.light;
            light.stokes = session.sheet.convention.stokes(rotate_basis(at.light.stokes, angle));
            const MapPixel pixel = evaluate_light(light, quantity, 1.0);
            curve.values.push_back(pixel.state == PixelState::defined ? std::optional(pixel.value) : std::nullopt);
        }
        curves.push_back(std::move(curve));
    }
    return curves;
}

std::string text_of(const PixelSheet& sheet) {
    std::string out = fmt::format("pixel {},{}  {} nm\n", sheet.pixel.x, sheet.pixel.y, sheet.wavelength_nm);
    for (const SheetGroup& group : sheet.groups) {
        out += "\n" + group.title + "\n";
        for (const SheetRow& r : group.rows)
            out += fmt::format("{:<18} {}{}{}\n", r.name, r.exact.empty() ? r.value : r.exact,
                               r.bar.empty() ? "" : "  ", r.bar);
    }
    return out;
}

}  // namespace pol
