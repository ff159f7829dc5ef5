// SPDX-License-Identifier: Apache-2.0
// What the commands that open a picture have in common: where it is, how it is laid out, and which convention its
// numbers are in.
#pragma once

#include "cli/command_line.h"

#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "film/stokes_image.h"
#include "io/pictures/picture_file.h"

namespace pol {

/// What help and completions call a picture (type_name).
inline constexpr const char* picture_names = "NAME.exr|NAME.npy|NAME.npz|NAME.png|NAME.fits";

/// The choices of a StokesConvention that the command line makes; the others stay as they are.
struct ConventionOptions {
    std::optional<bool> left_handed;
    std::optional<double> azimuth_zero_deg;
    std::optional<bool> y_down;

    [[nodiscard]] bool given() const { return left_handed || azimuth_zero_deg || y_down; }
    [[nodiscard]] StokesConvention over(StokesConvention convention) const;
};

/// Adds --handedness, --zero and --y, with `before` after the dashes ("from-"). `whose` begins their help: "OUT".
void add_convention_options(ProgramCommand command, ConventionOptions& options, const std::string& before,
                            const std::string& whose);

struct PictureOptions {
    std::vector<std::string> files;
    std::string layout;
    std::string stokes;  ///< "s0=F,s1=F,...", in any order
    std::string angles;  ///< "0,60,120", one for each file
    ConventionOptions from;

    /// True if an option speaks of a picture, so that the file is none of the other kinds that a command may take.
    [[nodiscard]] bool given() const { return !layout.empty() || !stokes.empty() || !angles.empty() || from.given(); }
    /// Error (kind usage): no picture or several, files and --stokes, a component twice, or angles that are no numbers.
    [[nodiscard]] Result<PictureSource> source() const;
    /// The picture of source() in our convention (read_in, where an option says so). Error as source and read_picture.
    [[nodiscard]] Result<StokesImage> read(const ReadProgress& progress = {}) const;
};

/// Adds --layout, --stokes, --angles and the --from-... options, with `before` after the dashes ("b-"), for commands
/// of two pictures. The argument is the command's own.
void add_picture_options(ProgramCommand command, PictureOptions& options, const std::string& before = {});

/// "Layouts:" and a line for each, for the help.
std::string picture_layouts_text();

}  // namespace pol
