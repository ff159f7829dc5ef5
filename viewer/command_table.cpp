// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "viewer/commands.h"

namespace pol {

namespace {

constexpr KeyChord ctrl(Key key) {
    return {key, true, false};
}
constexpr KeyChord shift(Key key) {
    return {key, false, true};
}
constexpr KeyChord ctrl_shift(Key key) {
    return {key, true, true};
}

bool is_open(const Session& session) {
    return session.current() != nullptr;
}
bool has_several(const Session& session) {
    return session.documents().size() > 1;
}
bool is_pinned(const Session& session) {
    return is_open(session) && session.selection.pinned().has_value();
}
bool is_free(const Session& session) {
    return is_open(session) && !session.selection.pinned();
}
bool is_free_of_several(const Session& session) {
    return has_several(session) && !session.selection.pinned();
}
bool is_rendering(const Session& session) {
    return is_open(session) && session.current()->has_scene();
}

template <Quantity quantity>
void show_map(Session& session) {
    session.show(quantity);
}
template <Quantity quantity>
bool shows_map(const Session& session) {
    return session.view.quantity == quantity;
}
template <Quantity quantity>
constexpr Command map_command(KeyChord chord, std::string_view title, std::string_view help) {
    return {"Map", title, chord, help, show_map<quantity>, nullptr, {}, false, shows_map<quantity>};
}

template <int by>
void step_map(Session& session) {
    constexpr int count = static_cast<int>(quantity_count);
    session.show(static_cast<Quantity>((static_cast<int>(session.view.quantity) + by + count) % count));
}

template <int by>
void step_wavelength(Session& session) {
    const int count = static_cast<int>(session.current()->picture().wavelengths_nm.size());
    session.view.wavelength =
        static_cast<std::size_t>(std::clamp(static_cast<int>(session.view.wavelength) + by, 0, count - 1));
}

template <MapStyle style>
void use_style(Session& session) {
    session.view.style = style;
}
template <MapStyle style>
bool uses_style(const Session& session) {
    return session.view.style == style;
}

DVec2 extent(const Session& session) {
    const StokesImage& picture = session.current()->picture();
    return {picture.width, picture.height};
}

void zoom(Session& session, double factor) {
    session.transform.zoom_at(0.5 * session.view_size, factor);
}

void one_to_one(Session& session) {
    session.transform.zoom_at(0.5 * session.view_size, 1.0 / session.transform.scale);
}

constexpr double stops_per_press = 0.5;
constexpr double offset_per_press = 0.05;
constexpr double gamma_per_press = 0.1;

template <int sign>
void step_exposure(Session& session) {
    session.view.exposure += sign * stops_per_press;
}
template <int sign>
void step_offset(Session& session) {
    session.view.offset += sign * offset_per_press;
}
template <int sign>
void step_gamma(Session& session) {
    session.view.gamma = std::max(gamma_per_press, session.view.gamma + sign * gamma_per_press);
}

void reset_tone(Session& session) {
    const ViewSettings fresh;
    session.view.exposure = fresh.exposure;
    session.view.offset = fresh.offset;
    session.view.gamma = fresh.gamma;
    session.view.range = fresh.range;
    session.view.scale = fresh.scale;
}

void step_glyphs(Session& session) {
    constexpr int count = static_cast<int>(GlyphKind::combined) + 1;
    session.view.glyphs.kind = static_cast<GlyphKind>((static_cast<int>(session.view.glyphs.kind) + 1) % count);
}

template <int dx, int dy>
void nudge(Session& session) {
    session.nudge(dx, dy);
}

/// What Esc means: the sheet on top goes first, then the pin.
void escape(Session& session) {
    WindowState& window = session.window;
    if (window.help_visible)
        window.help_visible = false;
    else if (window.log_visible)
        window.log_visible = false;
    else
        session.unpin();
}

template <bool WindowState::*flag>
void toggle(Session& session) {
    session.window.*flag = !(session.window.*flag);
}
template <bool WindowState::*flag>
bool is_on(const Session& session) {
    return session.window.*flag;
}

template <bool ViewSettings::*flag>
void toggle_view(Session& session) {
    session.view.*flag = !(session.view.*flag);
}
template <bool ViewSettings::*flag>
bool view_has(const Session& session) {
    return session.view.*flag;
}

constexpr std::array command_table{
    Command{"File", "Open...", ctrl(letter('O')),
            "Opens a scene (*.yaml) or an EXR picture; files can be dropped, too.",
            toggle<&WindowState::path_entry_visible>},
    Command{"File",
            "Next document",
            {Key::down},
            "Shows the next open file (Down only while no pixel is pinned).",
            [](Session& s) { s.step_document(1); },
            is_free_of_several,
            {},
            true},
    Command{"File",
            "Previous document",
            {Key::up},
            "Shows the previous open file (Up only while no pixel is pinned).",
            [](Session& s) { s.step_document(-1); },
            is_free_of_several,
            {},
            true},
    Command{"File", "Quit", ctrl(letter('Q')), "Ends the program; asks first if an edited scene is not saved.",
            [](Session& s) { s.window.quit = Quit::asked; }},

    map_command<Quantity::color>({letter('1')}, "Color", "The picture as the eye sees it."),
    map_command<Quantity::intensity>({letter('2')}, "Intensity", "S0 at one wavelength."),
    map_command<Quantity::dop>({letter('3')}, "Degree of polarization", "DoP, from 0 (unpolarized) to 1."),
    map_command<Quantity::ellipticity>({letter('4')}, "Ellipticity", "Angle \u03c7 from left to right circular."),
    map_command<Quantity::azimuth>({letter('5')}, "Azimuth", "Direction of the ellipse's long axis, modulo 180\u00b0."),
    map_command<Quantity::handedness>({letter('6')}, "Handedness", "Right or left, as the receiver sees it."),
    map_command<Quantity::s1>({letter('7')}, "S1", "Horizontal minus vertical."),
    map_command<Quantity::s2>({letter('8')}, "S2", "+45\u00b0 minus \u221245\u00b0."),
    map_command<Quantity::s3>({letter('9')}, "S3", "Right minus left circular."),
    map_command<Quantity::residual>({letter('0')}, "Residual", "Share of the light that was not traced."),
    map_command<Quantity::dolp>({letter('D')}, "Degree of linear polarization", "DoLP, from 0 to 1."),
    map_command<Quantity::docp>(shift(letter('D')), "Degree of circular polarization", "DoCP, from 0 to 1."),
    map_command<Quantity::dop_error>(shift(letter('3')), "Error of DoP", "How far DoP may be off."),
    map_command<Quantity::ellipticity_error>(shift(letter('4')), "Error of ellipticity", "How far \u03c7 may be off."),
    map_command<Quantity::azimuth_error>(shift(letter('5')), "Error of azimuth", "How far the azimuth may be off."),
    map_command<Quantity::unphysical>({letter('U')}, "Unphysical", "Pixels with DoP above 1, negative S0, NaN or Inf."),
    Command{"Map",
            "Next map",
            {Key::right},
            "Next in this list (while no pixel is pinned).",
            step_map<1>,
            is_free,
            {},
            true},
    Command{"Map",
            "Previous map",
            {Key::left},
            "Previous in this list (while no pixel is pinned).",
            step_map<-1>,
            is_free,
            {},
            true},
    Command{"Map",
            "Longer wavelength",
            {letter(']')},
            "Next wavelength that was rendered.",
            step_wavelength<1>,
            is_open,
            {},
            true},
    Command{"Map",
            "Shorter wavelength",
            {letter('[')},
            "Previous wavelength that was rendered.",
            step_wavelength<-1>,
            is_open,
            {},
            true},
    Command{"Map",
            "Scientific colors",
            {},
            "Scales that need no color vision.",
            use_style<MapStyle::scientific>,
            nullptr,
            {},
            false,
            uses_style<MapStyle::scientific>},
    Command{"Map",
            "Paper colors",
            {},
            "Value times D65, as in Debelov & Kozlov.",
            use_style<MapStyle::paper>,
            nullptr,
            {},
            false,
            uses_style<MapStyle::paper>},
    Command{"Map",
            "Wilkie & Weidlich colors",
            {},
            "Their standardized colors of 2010.",
            use_style<MapStyle::wilkie>,
            nullptr,
            {},
            false,
            uses_style<MapStyle::wilkie>},

    Command{"View",
            "Fit",
            {letter('F')},
            "The whole picture, as large as it can be.",
            [](Session& s) { s.transform.fit(extent(s), s.view_size); },
            is_open},
    Command{"View", "One to one", ctrl(letter('0')), "One pixel of the picture per point of the screen.", one_to_one,
            is_open},
    Command{"View",
            "Center",
            {letter('C')},
            "Moves the picture to the middle.",
            [](Session& s) { s.transform.center(extent(s), s.view_size); },
            is_open},
    Command{"View",
            "Zoom in",
            {letter('=')},
            "Also with the mouse wheel, at the cursor.",
            [](Session& s) { zoom(s, 1.25); },
            is_open,
            shift(letter('=')),
            true},
    Command{"View",
            "Zoom out",
            {letter('-')},
            "Also with the mouse wheel, at the cursor.",
            [](Session& s) { zoom(s, 0.8); },
            is_open,
            {},
            true},
    Command{"View", "Brighter", {letter('E')}, "Exposure up by half a stop.", step_exposure<1>, nullptr, {}, true},
    Command{
        "View", "Darker", shift(letter('E')), "Exposure down by half a stop.", step_exposure<-1>, nullptr, {}, true},
    Command{"View", "Raise offset", {letter('O')}, "Adds 0.05 after exposure.", step_offset<1>, nullptr, {}, true},
    Command{"View",
            "Lower offset",
            shift(letter('O')),
            "Subtracts 0.05 after exposure.",
            step_offset<-1>,
            nullptr,
            {},
            true},
    Command{"View", "Raise gamma", {letter('G')}, "Lifts the dark parts.", step_gamma<1>, nullptr, {}, true},
    Command{"View", "Lower gamma", shift(letter('G')), "Deepens the dark parts.", step_gamma<-1>, nullptr, {}, true},
    Command{
        "View", "Reset tone", {letter('R')}, "Exposure, offset, gamma, ranges and scales as they were.", reset_tone},
    Command{"View",
            "Map over intensity",
            {letter('B')},
            "Colors of the map, lightness of the picture.",
            toggle_view<&ViewSettings::over_intensity>,
            nullptr,
            {},
            false,
            view_has<&ViewSettings::over_intensity>},
    Command{"View",
            "Ellipses",
            {letter('P')},
            "Polarization ellipses over the picture, azimuth strokes, both, none.",
            step_glyphs},
    Command{"View",
            "Hide panels",
            {Key::tab},
            "Shows the picture alone, or the panels again.",
            toggle<&WindowState::panels_visible>},
    Command{"View",
            "Full screen",
            {Key::f11},
            "Uses the whole screen.",
            toggle<&WindowState::full_screen>,
            nullptr,
            {},
            false,
            is_on<&WindowState::full_screen>},
    Command{"View",
            "Light theme",
            {},
            "Dark on light instead of light on dark.",
            [](Session& s) { s.window.theme = s.window.theme == Theme::dark ? Theme::light : Theme::dark; },
            nullptr,
            {},
            false,
            [](const Session& s) { return s.window.theme == Theme::light; }},

    Command{"Pixel", "Move pin left", {Key::left}, "Pins the neighboring pixel.", nudge<-1, 0>, is_pinned, {}, true},
    Command{"Pixel", "Move pin right", {Key::right}, "Pins the neighboring pixel.", nudge<1, 0>, is_pinned, {}, true},
    Command{"Pixel", "Move pin up", {Key::up}, "Pins the neighboring pixel.", nudge<0, -1>, is_pinned, {}, true},
    Command{"Pixel", "Move pin down", {Key::down}, "Pins the neighboring pixel.", nudge<0, 1>, is_pinned, {}, true},
    Command{
        "Pixel", "Close or release", {Key::escape}, "Closes the sheet on top; else releases the pinned pixel.", escape},

    Command{"Render",
            "Pause",
            {Key::space},
            "Pauses the render or lets it go on.",
            [](Session& s) { s.current()->set_paused(!s.current()->paused()); },
            is_rendering,
            {},
            false,
            [](const Session& s) { return is_open(s) && s.current()->paused(); }},

    Command{"Help",
            "Keys and mouse",
            {Key::f1},
            "This sheet.",
            toggle<&WindowState::help_visible>,
            nullptr,
            shift(Key::slash),
            false,
            is_on<&WindowState::help_visible>},
    Command{"Help", "Find a command...", ctrl_shift(letter('P')), "Type a part of its name.",
            toggle<&WindowState::palette_visible>},
    Command{"Help",
            "Log",
            ctrl(letter('L')),
            "All messages so far.",
            toggle<&WindowState::log_visible>,
            nullptr,
            {},
            false,
            is_on<&WindowState::log_visible>},
};

}  // namespace

std::span<const Command> commands() {
    return command_table;
}

}  // namespace pol
