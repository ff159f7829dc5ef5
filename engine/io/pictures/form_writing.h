// SPDX-License-Identifier: Apache-2.0
// What the writers of picture_writer.cpp share.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "io/pictures/picture_writer.h"

namespace pol {

/// A picture on its way out: its numbers in the convention of the file, and the sentences of what is lost.
struct OutgoingPicture {
    const StokesImage& image;
    FormOptions options;
    std::vector<std::string> lost{};

    [[nodiscard]] Stokes<double> at(std::size_t band, std::size_t pixel) const {
        return options.convention.from_ours(image.at(band, pixel));
    }
    /// Components that every band has.
    [[nodiscard]] StokesComponents known() const;
    /// That all bands have S0, S1 and S2, or all. Error (kind usage), in words of `form`.
    [[nodiscard]] Result<Done> require_linear(std::string_view form) const;
};

inline Error cannot_hold(std::string what, std::string hint) {
    return Error{ErrorKind::usage, std::move(what), {}, "--as", std::move(hint)};
}

/// A plane of a file and the rule that gives its numbers.
struct OutgoingPlane {
    std::string name;
    std::function<double(std::size_t pixel)> value;
};

Result<Done> write_npy(OutgoingPicture& picture, const std::filesystem::path& path);
Result<Done> write_npz(OutgoingPicture& picture, const std::filesystem::path& path);
Result<Done> write_fits(OutgoingPicture& picture, const std::filesystem::path& path);
Result<Done> write_mitsuba(OutgoingPicture& picture, const std::filesystem::path& path);
Result<Done> write_four(OutgoingPicture& picture, const std::filesystem::path& path);
Result<Done> write_png4(OutgoingPicture& picture, const std::filesystem::path& path);

/// Says what share of the numbers has changed by rounding, if any.
struct Rounding {
    std::size_t changed = 0;
    std::size_t infinite = 0;  ///< finite numbers above the range
    void note(std::string_view type, std::vector<std::string>& lost) const;
};

}  // namespace pol
