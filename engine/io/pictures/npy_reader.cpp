// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <system_error>
#include <utility>

#include "io/pictures/npy_format.h"
#include "io/pictures/picture_reading.h"
#include "io/pictures/stokes_channels.h"
#include "io/pictures/stored_precision.h"

namespace pol {

Result<UnfilledPicture> open_npy(const std::filesystem::path& path, std::string_view layout) {
    std::error_code failed;
    const std::uint64_t size = std::filesystem::file_size(path, failed);
    if (failed) return input_error("cannot be read", "check its permissions");
    auto bytes = std::make_shared<FileBytes>(path, 0, size);
    POL_TRY(const NpyHeader header, read_npy_header(*bytes));
    POL_TRY(const NumberFormat format, number_format(header));
    POL_TRY_DONE(check_promise(header, format, *bytes));
    POL_TRY(ArrayLayout found, array_layout(header.shape, layout));
    note_precision(found.image, format);
    const std::uint64_t behind = bytes->left() - *number_count(header.shape) * format.bytes();
    if (behind > 0)
        found.image.origin.remarks.push_back(std::to_string(behind) + " bytes behind the array were not looked at.");

    StokesImage image = found.image;
    return UnfilledPicture{
        std::move(image),
        [bytes, format, found = std::move(found), header](StokesImage& target,
                                                          const ReadProgress& progress) -> Result<Done> {
            POL_TRY_DONE(read_numbers(*bytes, format, found, header.fortran_order, target, progress));
            if (found.may_be_mono) merge_equal_colors(target);
            return Done{};
        }};
}

}  // namespace pol
