// SPDX-License-Identifier: Apache-2.0
// Stokes pictures as OpenEXR files in the spectral layout of Fichet, Pacanowski & Wilkie, "An OpenEXR layout for
// spectral images", JCGT 10(3), 2021, with what that layout leaves open (frame, azimuth zero, time sign, residual)
// added beside it.
//
// Channels: `S0.580,000000nm` ... `S3.580,000000nm` (FLOAT; those that were measured), `residual` and `tail` (one
// plane, or one per band as `residual.580,000000nm`), `sampling_error.S0.580,000000nm` ... (FLOAT), `samples` and
// `failures` (UINT), `R G B` (HALF, linear sRGB, for other viewers). A band without a wavelength has its name there:
// `S0.R`. String attributes: spectralLayoutVersion, emissiveUnits, polarisationHandedness, and ours as
// `polariscope.NAME`, among them what bands there are and where the picture came from (exr_origin.h).
#pragma once

#include <filesystem>
#include <functional>

#include "core/result.h"
#include "film/stokes_image.h"

namespace pol {

/// Writes `image` with PIZ compression; crash safe (io/files/output_file.h). The values are rounded to 32-bit floats,
/// NaN and infinity are kept; components that were not measured are left out; the attributes frame, azimuthZero,
/// timeSign and version are filled in if `image` does not set them. read_exr gives bands, origin, `stored` and place
/// back. Requires: the plane sets of `image` have the sizes that StokesImage states. Error: kind output if the file
/// cannot be written; kind usage if the picture has no pixel or no band, if nothing of a band was measured, or if two
/// wavelengths get the same channel name (less than 1e-6 nm apart). `progress` hears from time to time which share of
/// the lines is written.
Result<Done> write_exr(const StokesImage& image, const std::filesystem::path& path,
                       const std::function<void(double)>& progress = {});

/// read_picture of a single EXR file, whatever lies beside it: any layout that README.md of this folder has, channels
/// in any order, of any type and in any parts, wavelengths in any unit, left-handed files turned right-handed (S3
/// negated). The numbers are those of the file to the last bit, and StokesImage::stored says what they went through.
/// The data window gives StokesImage::left and ::top, the display window ::whole_width and ::whole_height where it is
/// another. `attributes` has what the file says under `polariscope.`. Error (kind input): not an EXR file, truncated,
/// too large; sound but not read, by name: channels of no layout, S0 to S3 with different wavelengths, sampling other
/// than 1 x 1, deep data, parts that do not fit together, a younger format.
Result<StokesImage> read_exr(const std::filesystem::path& path);

}  // namespace pol
