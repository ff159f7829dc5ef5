// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/exr_planes.h"

#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>

#include <algorithm>
#include <set>
#include <utility>

#include "io/pictures/exr_layout.h"

namespace pol::exr {

PlaneReader::PlaneReader(int width, int height, const std::map<std::string, int>& parts)
    : width_(static_cast<std::size_t>(width)),
      band_size_(width_ * static_cast<std::size_t>(std::min(height, band_height))),
      parts_(parts) {}

void PlaneReader::add(const std::string& channel, std::function<void(std::size_t, double)> store) {
    planes_.push_back({channel, std::vector<float>(band_size_), std::move(store)});
}

void PlaneReader::add_count(const std::string& channel, std::vector<std::uint32_t>& plane) {
    counts_.push_back({channel, &plane});
}

bool PlaneReader::read(Imf::MultiPartInputFile& file, const ReadProgress& progress) {
    std::set<int> used;
    for (const auto& [channel, part] : parts_) used.insert(part);
    double done = 0.0;
    for (const int part : used) {
        const auto share = [&](double of_part) {
            return !progress || progress((done + of_part) / static_cast<double>(used.size()));
        };
        if (!read_part(file, part, share)) return false;
        done += 1.0;
    }
    return true;
}

bool PlaneReader::read_part(Imf::MultiPartInputFile& file, int number, const ReadProgress& share) {
    Imf::InputPart part(file, number);
    const Imath::Box2i window = part.header().dataWindow();
    const double height = double{1} + window.max.y - window.min.y;
    for (int top = window.min.y; top <= window.max.y; top += band_height) {
        const int bottom = std::min(top + band_height - 1, window.max.y);
        const std::size_t first = width_ * static_cast<std::size_t>(top - window.min.y);
        Imf::FrameBuffer buffer;
        // A slice's base is the address of pixel (0, 0) of the file's own coordinates.
        const auto insert = [&](const std::string& name, Imf::PixelType type, void* band) {
            const std::intptr_t size = 4;
            const std::intptr_t offset =
                (std::intptr_t{top} * static_cast<std::intptr_t>(width_) + window.min.x) * size;
            const auto base = reinterpret_cast<std::intptr_t>(band) - offset;
            buffer.insert(name, Imf::Slice(type, reinterpret_cast<char*>(base), 4, 4 * width_));
        };
        const auto is_here = [&](const auto& plane) { return parts_.at(plane.channel) == number; };
        for (Plane& plane : planes_)
            if (is_here(plane)) insert(plane.channel, Imf::FLOAT, plane.band.data());
        for (Count& count : counts_)
            if (is_here(count)) insert(count.channel, Imf::UINT, count.plane->data() + first);
        part.setFrameBuffer(buffer);
        part.readPixels(top, bottom);
        const std::size_t size = width_ * static_cast<std::size_t>(bottom - top + 1);
        for (Plane& plane : planes_) {
            if (!is_here(plane)) continue;
            for (std::size_t i = 0; i < size; ++i) plane.store(first + i, static_cast<double>(plane.band[i]));
        }
        if (!share((double{1} + bottom - window.min.y) / height)) return false;
    }
    return true;
}

}  // namespace pol::exr
