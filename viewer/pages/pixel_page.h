// SPDX-License-Identifier: Apache-2.0
// The inspector's page of one pixel as text: what each number is, how it is shown, and what a copy of it says. No
// ImGui.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "polarization/coherence_matrix.h"
#include "polarization/measures.h"
#include "polarization/stokes.h"
#include "viewer/session/session.h"

namespace pol {

/// A number for a person, for the clipboard, and what is known about its error.
struct PageRow {
    std::string name;
    std::string value;  ///< a few digits with the unit, or why there is none: "undefined", "no light"
    std::string bar;    ///< "± 0.002" or "[0.531, 0.998]", empty: exact but for rounding
    std::string exact;  ///< 17 significant digits and the unit; empty if there is no number
    std::string_view help;
    std::string exact_bar{};  ///< "[low, high]" with 17 digits; empty as `bar`
};

/// A row of words, which a copy takes as they are.
inline PageRow word_row(std::string name, const std::string& words, std::string_view help) {
    return {std::move(name), words, {}, words, help};
}

/// Entries of the matrix in as many digits as fit beside each other, "?" for a part that was not measured; empty unless
/// they are numbers.
struct MatrixTexts {
    std::string xx;
    std::string xy;
    std::string yx;
    std::string yy;
    std::string exact_xy;  ///< with 17 digits; empty if neither part was measured
    std::string exact_yx;
};

struct PageGroup {
    std::string title;
    std::vector<PageRow> rows;
};

/// One pixel behind the polarimeter of the shown band, in the frame of Session::page and the shown convention.
struct PixelPage {
    PixelAddress pixel{};
    Band band;
    std::string convention;  ///< its text
    std::string trouble;     ///< why the frame is not the one asked for; empty: it is
    bool from_tree = false;  ///< not rendered yet: the light is that of the explained sample

    StokesComponents known = StokesComponents::all();  ///< in this frame; others are 0 in what follows
    Stokes<double> stokes{};
    CoherenceMatrix<double> matrix{};
    MatrixTexts matrix_texts;
    Measures<double> measures{};  ///< of `stokes`
    /// As who looks sees it, x to the right and y up: handedness +1 is clockwise, whatever the sign of S3.
    Measures<double> seen{};

    std::vector<PageGroup> groups;  ///< matrix, frame, parts, Stokes, measures, how it was made
};

/// Requires: a pinned pixel of the current picture.
PixelPage make_pixel_page(const Session& session);

/// Unit axes of the frame and convention that the page is written in, as they lie on the picture: y down, as on
/// screen.
struct PageAxes {
    DVec2 x{1.0, 0.0};
    DVec2 y{0.0, -1.0};
};
/// Requires: as make_pixel_page.
PageAxes page_axes(const Session& session);

/// "0.25 - 0.1 i", or "not a number". A part that is nothing but rounding beside `size`, or beside the other part, is
/// 0.
std::string complex_text(const Complex<double>& z, int digits = 7, double size = 0.0);
/// The same with 17 digits, for the clipboard.
std::string exact_text(const Complex<double>& z);
/// "(0, 0.6, 0.8)", rounded as complex_text does.
std::string vector_text(const DVec3& v, double size);

/// What the curves over wavelength show; none where it is undefined.
struct PageCurve {
    std::string name;  ///< with unit
    std::vector<std::optional<double>> values;
    std::vector<std::string> texts;  ///< the same for a person, with bars, or why there is no value
    double low = 0.0;
    double high = 1.0;
    bool cyclic = false;
};
/// S0, DoP, azimuth, ellipticity of the pinned pixel at all wavelengths. Requires: as make_pixel_page.
std::vector<PageCurve> spectrum_curves(const Session& session);

/// The whole page, one line per number at full precision.
std::string text_of(const PixelPage& page);

}  // namespace pol
