// SPDX-License-Identifier: Apache-2.0
// What the axes of an array of numbers are: rows, columns, Stokes components, bands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "film/stokes_image.h"
#include "io/pictures/byte_source.h"
#include "io/pictures/number_format.h"
#include "io/pictures/picture_file.h"

namespace pol {

using ArrayShape = std::vector<std::uint64_t>;

/// "(4, 20, 30)".
std::string shape_text(const ArrayShape& shape);

/// Where one step along an axis leads in StokesImage::stokes.
struct AxisStep {
    std::size_t value = 0;   ///< added to the index of the Stokes vector
    unsigned component = 0;  ///< added to that of the component; 4 or more: the number is none of the picture's
};

/// A picture that an array holds, and where each of its numbers goes.
struct ArrayLayout {
    StokesImage image;                        ///< size, bands, origin
    std::vector<std::vector<AxisStep>> axes;  ///< by axis of the array, then by place on it
    bool may_be_mono = false;                 ///< three equal bands R, G, B are one, "mono"
};

/// What an array of this shape is, by its shape or as `asked`, a name of array_layouts(). Takes no memory that grows
/// with the number of pixels. Error (without a place): kind input if nothing fits, or several do (it names them), or
/// there is no pixel, or more than max_picture_bytes; kind usage if `asked` is another or does not fit.
Result<ArrayLayout> array_layout(const ArrayShape& shape, std::string_view asked);

/// An array of rows and columns only, one component of one band, or with a third axis of three, R, G and B.
Result<ArrayLayout> plane_layout(const ArrayShape& shape, unsigned component);

/// Checks that width x height pixels and `bands` bands can be a picture in memory. Error (kind input, no place).
Result<Done> check_picture_size(std::uint64_t width, std::uint64_t height, std::uint64_t bands);

/// How many numbers; none if that is more than 2^63.
std::optional<std::uint64_t> number_count(const ArrayShape& shape);

/// Reads all numbers to their places in `image`. `fortran_order`: the first axis changes fastest. Error (kind input, no
/// place): the bytes end too early, are damaged, or `progress` said stop.
Result<Done> read_numbers(ByteSource& bytes, const NumberFormat& format, const ArrayLayout& layout, bool fortran_order,
                          StokesImage& image, const ReadProgress& progress);

}  // namespace pol
