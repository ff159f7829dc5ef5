// SPDX-License-Identifier: Apache-2.0
// What leaves the window as files. All of them are written in the background, under names that no file has yet; the
// log says where they are.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "io/live/live_address.h"
#include "maps/colorize.h"
#include "viewer/session/export_queue.h"
#include "viewer/session/session.h"

namespace pol {

/// `stem.ending`, or `stem-2.ending` and so on: neither there nor about to be written. In the folder `out` of the
/// current folder if there is one, else in the current folder. `ending` has its dot.
std::filesystem::path free_export_path(const Session& session, const std::string& stem, const std::string& ending);

// Each of them first takes over all that the workers have finished.

/// Writes all wavelengths of what is there now as EXR, without stopping the render. What has no sample yet is black and
/// wholly untraced in the file; a preview is no result. In the tracer's convention, as the file says. Nothing open:
/// does nothing.
void export_snapshot(Session& session);

/// Writes the whole map on screen, at the picture's size, with color bar and legend as PNG: behind the polarimeter, in
/// the shown range, style, scale and convention, which the legend names. The legend says so if samples are missing.
/// Nothing open: does nothing. Returns the whole path of the file; empty: none.
std::filesystem::path export_map(Session& session);

/// Writes the marked pixels, else those of the region, else all, at all wavelengths as CSV, behind the polarimeter, in
/// the camera's frame and the shown convention, which is the last column. A pixel without a sample has no numbers.
/// Nothing open: does nothing.
void export_pixels(Session& session);

/// Sends all bands of what is there now, in the tracer's convention, to the viewer tev or whoever speaks its protocol;
/// the log says when it is there. Nothing open: does nothing.
void send_picture(Session& session, const LiveAddress& to);

/// Asks for the whole window as it will look in the next frame, menus closed (Session::wanted_window_picture).
void export_window(Session& session);

/// Writes the window that was asked for, rows from the top, as PNG. Requires: it was.
void write_window(Session& session, RgbPicture picture);

}  // namespace pol
