// SPDX-License-Identifier: Apache-2.0
// Arrays as numpy saves them: "\x93NUMPY", version, length of the header, a Python dictionary with exactly the keys
// descr, fortran_order and shape, then the numbers (numpy.lib.format).
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "io/pictures/array_layout.h"
#include "io/pictures/byte_source.h"
#include "io/pictures/number_format.h"

namespace pol {

inline constexpr std::string_view npy_magic = "\x93NUMPY";

struct NpyHeader {
    std::string descr;  ///< "<f4"
    bool fortran_order = false;
    ArrayShape shape;
};

/// Takes at most 64 KiB. Error (kind input, no place): no such array, of another version, or records.
Result<NpyHeader> read_npy_header(ByteSource& bytes);

/// What the numbers are. Error (kind input, no place), by name: pickled objects, text, complex numbers, or integers
/// other than u1 and u2.
Result<NumberFormat> number_format(const NpyHeader& header);

/// That all numbers of the array can be left in `bytes`. Error (kind input, no place).
Result<Done> check_promise(const NpyHeader& header, const NumberFormat& format, const ByteSource& bytes);

/// Magic, version 1.0 and header of an array in C order, padded to a multiple of 64.
std::string npy_header(std::string_view descr, const ArrayShape& shape);

}  // namespace pol
