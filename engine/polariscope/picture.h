// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "polariscope/light.h"
#include "polariscope/result.h"

namespace polariscope {

namespace detail {
struct PictureData;
struct Inside;
}  // namespace detail

/// Stokes vectors of all pixels at all wavelengths, with what is known about their error. Row 0 is the top row; frame
/// as stated at Stokes. Wavelengths are counted from 0. Immutable; thread-safe.
class Picture {
public:
    Picture(const Picture&) = default;
    Picture& operator=(const Picture&) = default;
    ~Picture() = default;

    [[nodiscard]] int width() const;
    [[nodiscard]] int height() const;
    /// Empty if a band has none: R, G, B or mono of another program's picture. What counts wavelengths here counts
    /// bands.
    [[nodiscard]] std::vector<double> wavelengths_nm() const;
    /// Of each band: "580 nm", or its name.
    [[nodiscard]] std::vector<std::string> bands() const;
    /// True if the Stokes component (0 to 3) was measured in the band. Where not, its numbers are 0 and mean nothing.
    [[nodiscard]] bool is_measured(int component, int band = 0) const;
    /// What the reader had to take for granted, one sentence each.
    [[nodiscard]] const std::vector<std::string>& assumed() const;
    /// What the file says about itself: scene, scene_hash, frame, settings ...
    [[nodiscard]] const std::map<std::string, std::string>& attributes() const;

    /// Of one pixel. Error (usage): there is no such pixel or wavelength.
    [[nodiscard]] Result<Stokes> stokes(int x, int y, int wavelength = 0) const;
    /// Error (usage), too: a component was not measured.
    [[nodiscard]] Result<Coherence> coherence(int x, int y, int wavelength = 0) const;
    /// Most S0 that may have been left out there, and most that may be there too much, as in RayLight. 0 where the
    /// picture does not say.
    [[nodiscard]] Result<double> missing(int x, int y, int wavelength = 0) const;
    [[nodiscard]] Result<double> surplus(int x, int y, int wavelength = 0) const;
    /// Standard error (68 %) of each component by the finite number of samples; 0 where there is none.
    [[nodiscard]] Result<Stokes> sampling_error(int x, int y, int wavelength = 0) const;

    /// All pixels at one wavelength, width x height of them: pixel (x, y) is entry y * width + x.
    [[nodiscard]] Result<std::vector<Stokes>> plane(int wavelength = 0) const;

private:
    friend struct detail::Inside;
    explicit Picture(std::shared_ptr<const detail::PictureData> data) : data_(std::move(data)) {}
    std::shared_ptr<const detail::PictureData> data_;
};

/// A picture of any origin. `stokes` has one plane of width x height entries per wavelength, in their order. Error
/// (usage): the sizes do not fit, wavelengths are not positive and ascending.
Result<Picture> make_picture(int width, int height, const std::vector<double>& wavelengths_nm,
                             const std::vector<Stokes>& stokes);

/// A Stokes picture of any program, told by its content: OpenEXR (the spectral layout, Mitsuba 3, wave_tracer, four
/// files,
/// ...), numpy, photographs behind polarizers, FITS. The numbers are turned into the convention of Stokes; assumed()
/// says what the file does not. Error (input): none of these, truncated, too large, or several layouts fit.
Result<Picture> read_picture(const std::filesystem::path& file);

/// OpenEXR in the spectral layout of Fichet, Pacanowski & Wilkie, "An OpenEXR layout for spectral images", JCGT 10(3),
/// 2021, 32-bit floats; what was there stays until all is written. Error (output): it cannot be written.
Result<Done> write_exr(const Picture& picture, const std::filesystem::path& file);

}  // namespace polariscope
