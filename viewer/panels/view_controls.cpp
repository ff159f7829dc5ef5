// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/view_controls.h"

#include <imgui.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "viewer/pages/readout_text.h"
#include "viewer/session/map_look.h"
#include "viewer/shown/glyphs.h"
#include "viewer/widgets/ink.h"

namespace pol {

namespace {

constexpr std::array<const char*, 3> style_names{"scientific", "paper", "Wilkie & Weidlich"};
constexpr std::array<const char*, 11> scale_names{
    "by style and map", "gray",        "sequential",  "diverging",          "cyclic",          "degree (Wilkie)",
    "type (Wilkie)",    "S1 (Wilkie)", "S2 (Wilkie)", "chirality (Wilkie)", "azimuth (Wilkie)"};
constexpr std::array<const char*, 4> glyph_names{"none", "ellipses", "azimuth strokes", "combined"};
constexpr std::array<const char*, 3> length_names{"equal", "by DoP", "by intensity"};

/// A combo box over the values of an enumeration that begins at 0.
template <class Choice, std::size_t count>
bool choose(const char* name, Choice& choice, const std::array<const char*, count>& names) {
    int index = static_cast<int>(choice);
    if (!ImGui::Combo(name, &index, names.data(), static_cast<int>(count))) return false;
    choice = static_cast<Choice>(index);
    return true;
}

bool slide(const char* name, double& value, double low, double high, const char* format) {
    return ImGui::SliderScalar(name, ImGuiDataType_Double, &value, &low, &high, format);
}

void choose_band(const Session& session, Wishes& wishes) {
    const std::vector<Band>& bands = session.current()->picture().bands;
    const bool is_spectrum = !wavelengths_of(bands).empty();
    int index = static_cast<int>(session.view().band);
    const std::string shown = band_text(bands[session.view().band]);
    if (ImGui::SliderInt(is_spectrum ? "wavelength" : "band", &index, 0, static_cast<int>(bands.size()) - 1,
                         shown.c_str(), ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput))
        wishes.add([chosen = static_cast<std::size_t>(index)](Session& s) { s.choose_band(chosen); });
    tooltip(is_spectrum
                ? "In vacuum. Every map but the color picture shows one of the rendered wavelengths; the keys [ and ] "
                  "step through them."
                : "As the file names it: no wavelength is known. The keys [ and ] step through the bands.");
}

void choose_scale(std::optional<ColorScale> scale, Wishes& wishes) {
    int index = scale ? static_cast<int>(*scale) + 1 : 0;
    if (ImGui::Combo("scale", &index, scale_names.data(), static_cast<int>(scale_names.size())))
        wishes.set(&ViewSettings::scale, index > 0 ? std::optional(static_cast<ColorScale>(index - 1)) : std::nullopt);
    tooltip("Colors of the map. Sequential, diverging and cyclic can be read without color vision.");
}

}  // namespace

void draw_view_controls(const Session& session, Wishes& wishes) {
    ViewSettings view = session.view();
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x - 80.0F);
    choose_band(session, wishes);
    if (choose("style", view.style, style_names)) wishes.set(&ViewSettings::style, view.style);
    tooltip(
        "Scientific: scales that need no color vision, states without a value in colors of their own. Paper: value "
        "times D65, black where there is no light or no polarization, as Debelov & Kozlov print it; signed maps and "
        "the "
        "azimuth as scientific. Wilkie & Weidlich: their colors of 2010.");
    choose_scale(view.scale, wishes);
    if (slide("exposure", view.exposure, -10.0, 10.0, "%+.2f stops"))
        wishes.set(&ViewSettings::exposure, view.exposure);
    tooltip(
        "Light is multiplied by 2^exposure: color, intensity and maps over the intensity. E brightens, Shift+E "
        "darkens.");
    if (slide("offset", view.offset, -1.0, 1.0, "%+.3f")) wishes.set(&ViewSettings::offset, view.offset);
    tooltip("Added after exposure: color and intensity. O and Shift+O.");
    if (slide("gamma", view.gamma, 0.2, 5.0, "%.2f")) wishes.set(&ViewSettings::gamma, view.gamma);
    tooltip("value^(1/gamma) after the offset, on top of sRGB: color and intensity. G and Shift+G.");
    ImGui::PopItemWidth();
    if (ImGui::SmallButton("normalize")) wishes.add(fit_bar_range);
    tooltip("From the smallest to the largest value that the picture has (N).");
    ImGui::SameLine();
    if (ImGui::SmallButton("own range")) wishes.add(reset_bar_range);
    tooltip("The range that the quantity has of itself.");
    if (ImGui::Checkbox("over intensity", &view.over_intensity))
        wishes.set(&ViewSettings::over_intensity, view.over_intensity);
    tooltip("The map's color with the lightness of the picture.");
    ImGui::SameLine();
    if (ImGui::Checkbox("fade by bar", &view.fade_by_bar)) wishes.set(&ViewSettings::fade_by_bar, view.fade_by_bar);
    tooltip(
        "The wider the error bar of a pixel, the weaker its color; gray where the bar covers half of the range. Not on "
        "a "
        "gray scale, where gray is a value, and not for intensity and residual.");
    if (ImGui::Checkbox("numbers", &view.numbers_in_pixels))
        wishes.set(&ViewSettings::numbers_in_pixels, view.numbers_in_pixels);
    tooltip(
        "The value inside each pixel when it is zoomed large enough. ? not determined, - undefined, dark or no "
        "light, ! unphysical.");
}

void draw_glyph_controls(const ViewSettings& view, Wishes& wishes) {
    GlyphSettings glyphs = view.glyphs;
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x - 80.0F);
    choose("ellipses", glyphs.kind, glyph_names);
    tooltip(("Polarization of the mean light around each glyph, where it stands above rounding and above what was not "
             "traced. " +
             glyph_key(view.convention))
                .c_str());
    if (glyphs.kind != GlyphKind::none) {
        choose("length", glyphs.length, length_names);
        tooltip(
            "What the major axis of a glyph says: nothing, the degree of polarization, or S0 relative to the "
            "brightest glyph.");
        slide("spacing", glyphs.spacing, 12.0, 80.0, "%.0f points");
        tooltip("Distance of the glyphs on screen, whatever the zoom.");
    }
    ImGui::PopItemWidth();
    if (glyphs != view.glyphs) wishes.set(&ViewSettings::glyphs, glyphs);
}

}  // namespace pol
