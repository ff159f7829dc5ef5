// SPDX-License-Identifier: Apache-2.0
// Reads planes of numbers of an EXR file, a band of lines at a time. For exr_reader.cpp.
#pragma once

#include <ImfMultiPartInputFile.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "io/pictures/picture_file.h"

namespace pol::exr {

class PlaneReader {
public:
    /// `parts` is the part of each channel; it must live as long as this.
    PlaneReader(int width, int height, const std::map<std::string, int>& parts);

    /// `store(pixel, value)` is called once for every pixel.
    void add(const std::string& channel, std::function<void(std::size_t pixel, double value)> store);
    void add_count(const std::string& channel, std::vector<std::uint32_t>& plane);

    /// False: `progress` stopped it. Throws what OpenEXR throws.
    bool read(Imf::MultiPartInputFile& file, const ReadProgress& progress);

private:
    struct Plane {
        std::string channel;
        std::vector<float> band;
        std::function<void(std::size_t, double)> store;
    };
    struct Count {
        std::string channel;
        std::vector<std::uint32_t>* plane;
    };

    /// `share(done)` hears which share of the part is read.
    bool read_part(Imf::MultiPartInputFile& file, int number, const ReadProgress& share);

    std::size_t width_;
    std::size_t band_size_;
    const std::map<std::string, int>& parts_;  ///< by channel
    std::vector<Plane> planes_;
    std::vector<Count> counts_;
};

}  // namespace pol::exr
