// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "viewer/commands/command_actions.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/unsaved_edits.h"
#include "viewer/session/exports.h"
#include "viewer/session/map_look.h"

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

using namespace action;

/// One key of nine; only the first is in menu and help.
template <std::size_t number>
constexpr Command document_command(std::string_view title, std::string_view help = "Shows an open file.",
                                   bool is_listed = false) {
    return {.group = "Compare",
            .title = title,
            .chord = ctrl(letter(static_cast<char>('0' + number))),
            .help = help,
            .run = show_document<number>,
            .enabled = has_document<number>,
            .is_listed = is_listed};
}

/// All but those of the maps.
constexpr std::array command_table{
    Command{"File", "Open...", ctrl(letter('O')),
            "Opens a scene (*.yaml) or a picture (*.exr, *.npy, *.png); files can be dropped, too.",
            toggle<&WindowState::path_entry_visible>},
    Command{"File",
            "Reload",
            {Key::f5},
            "Reads the file again; it is also read when another program saves it.",
            [](Session& s) { s.reload(); },
            has_file,
            ctrl(letter('R'))},
    Command{"File", "Save scene", ctrl_shift(letter('S')),
            "Writes what was edited into the scene file; its comments stay.", [](Session& s) { save_scene(s); },
            is_rendering},
    Command{"File", "Save scene as...", ctrl_shift(letter('A')), "Writes the scene as YAML under another name.",
            toggle<&WindowState::save_as_visible>, is_rendering},
    Command{"File", "Save snapshot (EXR)", ctrl(letter('S')),
            "Writes all wavelengths of what is there now, in the tracer's convention, without stopping the render.",
            export_snapshot, is_open},
    Command{"File", "Save map (PNG)", ctrl(letter('E')),
            "Writes the map on screen with color bar and legend, in its range, style, convention and behind the "
            "polarimeter.",
            export_map, is_open},
    Command{"File", "Save window (PNG)", ctrl_shift(letter('E')), "Writes the whole window as it is.", export_window},
    Command{
        "File",
        "Save pixels (CSV)",
        {},
        "Writes the marked pixels, else those of the region, else all, at all wavelengths as a table that names the "
        "convention.",
        export_pixels,
        is_open},
    Command{"File",
            "Listen for pictures",
            {},
            "Takes pictures that programs on this machine send as to the viewer tev, at 127.0.0.1:14158; off at first.",
            toggle_listening,
            nullptr,
            {},
            false,
            [](const Session& s) { return s.listener() != nullptr; }},
    Command{"File", "Close document", ctrl(letter('W')),
            "Closes the file on screen; asks first if its edits are not saved.", close_or_ask, is_open},
    Command{"File", "Quit", ctrl(letter('Q')), "Ends the program; asks first if an edited scene is not saved.",
            end_or_ask},

    Command{"Edit",
            "Undo",
            ctrl(letter('Z')),
            "Takes the last edit of the scene back.",
            [](Session& s) { s.undo(); },
            can_undo,
            {},
            true},
    Command{"Edit", "Redo", ctrl_shift(letter('Z')), "Makes the edit again.", [](Session& s) { s.redo(); }, can_redo,
            ctrl(letter('Y')), true},
    Command{"Edit",
            "Isotropic twin",
            {letter('I')},
            "The same scene with every crystal replaced by a glass of its mean permittivity, minus this one.",
            [](Session& s) { s.open_isotropic_twin(); },
            is_rendering},
    Command{"Edit", "Unpolarized twin", shift(letter('I')),
            "The same scene as a renderer without polarization would show it, minus this one.",
            [](Session& s) { s.open_unpolarized_twin(); }, is_rendering},

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

    Command{.group = "Compare",
            .title = "Next picture",
            .chord = {Key::page_down},
            .help = "Shows the next open file at the same place (Down only while no pixel is pinned).",
            .run = [](Session& s) { s.step_document(1); },
            .enabled = has_several,
            .also = ctrl(Key::tab),
            .repeats = true,
            .if_free = {Key::down}},
    Command{.group = "Compare",
            .title = "Previous picture",
            .chord = {Key::page_up},
            .help = "Shows the previous open file at the same place (Up only while no pixel is pinned).",
            .run = [](Session& s) { s.step_document(-1); },
            .enabled = has_several,
            .also = ctrl_shift(Key::tab),
            .repeats = true,
            .if_free = {Key::up}},
    document_command<1>("Show picture 1", "Ctrl+1 to Ctrl+9 show the open files, as the list counts them.", true),
    document_command<2>("Show picture 2"),
    document_command<3>("Show picture 3"),
    document_command<4>("Show picture 4"),
    document_command<5>("Show picture 5"),
    document_command<6>("Show picture 6"),
    document_command<7>("Show picture 7"),
    document_command<8>("Show picture 8"),
    document_command<9>("Show picture 9"),
    Command{"Compare", "Use as reference", shift(letter('X')), "Other pictures are compared with this one.",
            [](Session& s) { s.set_reference(); }, is_open},
    Command{.group = "Compare",
            .title = "Show the reference while held",
            .chord = {letter('H')},
            .help = "The reference at the same place, until the key is let go.",
            .run = [](Session& s) { s.flip_to_reference(); },
            .enabled = has_reference,
            .released = [](Session& s) { s.flip_back(); }},
    Command{"Compare",
            "Difference from the reference",
            {letter('X')},
            "The map minus that of the reference picture, or the map itself again.",
            [](Session& s) { s.toggle_difference(); },
            is_open,
            {},
            false,
            [](const Session& s) { return s.comparison().has_value(); }},

    Command{"View", "Fit", {letter('F')}, "The whole picture, as large as it can be.", fit_picture, is_open},
    Command{"View", "One to one", ctrl(letter('0')), "One pixel of the picture per point of the screen.", one_to_one,
            is_open},
    Command{"View", "Center", {letter('C')}, "Moves the picture to the middle.", center_picture, is_open},
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
    Command{"View",
            "Normalize",
            {letter('N')},
            "Stretches the scale from the least to the largest value on screen.",
            fit_bar_range,
            is_open},
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
            [](Session& s) { s.change_window().theme = s.window().theme == Theme::dark ? Theme::light : Theme::dark; },
            nullptr,
            {},
            false,
            [](const Session& s) { return s.window().theme == Theme::light; }},

    Command{"Pixel", "Move pin left", {Key::left}, "Pins the neighboring pixel.", nudge<-1, 0>, is_pinned, {}, true},
    Command{"Pixel", "Move pin right", {Key::right}, "Pins the neighboring pixel.", nudge<1, 0>, is_pinned, {}, true},
    Command{"Pixel", "Move pin up", {Key::up}, "Pins the neighboring pixel.", nudge<0, -1>, is_pinned, {}, true},
    Command{"Pixel", "Move pin down", {Key::down}, "Pins the neighboring pixel.", nudge<0, 1>, is_pinned, {}, true},
    Command{"Pixel",
            "Close or release",
            {Key::escape},
            "Closes the menu or question on top; else takes away marks, the region, the pin.",
            escape},
    Command{"Pixel",
            "Save as test case",
            {},
            "Writes scene, pixel and matrix; polariscope explain --case checks them again.",
            save_pixel_case,
            has_tree},
    Command{"Pixel",
            "Export ray states as CSV",
            {},
            "Writes one line per segment of the pixel's paths, in the tracer's convention.",
            export_tree<RayFormat::csv>,
            has_tree},
    Command{"Pixel",
            "Export tree as JSON",
            {},
            "Writes what polariscope explain --json prints, in the tracer's convention.",
            export_tree<RayFormat::json>,
            has_tree},
    Command{"Pixel",
            "Export paths as OBJ",
            {},
            "Writes the pixel's paths as lines in space.",
            export_tree<RayFormat::obj>,
            has_tree},

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
            "This help.",
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

template <Quantity quantity>
Command map_command() {
    const QuantityInfo& about = info(quantity);
    return {"Map", about.title, chord_of(quantity),  about.definition, show_map<quantity>, nullptr,
            {},    false,       shows_map<quantity>, quantity};
}

template <std::size_t... i>
std::array<Command, sizeof...(i)> map_commands(std::index_sequence<i...> /*all*/) {
    return {map_command<static_cast<Quantity>(i)>()...};
}

std::vector<Command> all_commands() {
    std::vector<Command> all(command_table.begin(), command_table.end());
    const auto maps = map_commands(std::make_index_sequence<quantity_count>());
    const auto menu =
        std::find_if(all.begin(), all.end(), [](const Command& command) { return command.group == "Map"; });
    all.insert(menu, maps.begin(), maps.end());
    return all;
}

}  // namespace

std::span<const Command> commands() {
    static const std::vector<Command> all = all_commands();
    return all;
}

}  // namespace pol
