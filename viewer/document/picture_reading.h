// SPDX-License-Identifier: Apache-2.0
// Large pictures are read beside the window, which goes on.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <thread>
#include <vector>

#include "core/result.h"
#include "io/pictures/picture_file.h"

namespace pol {

/// Pictures that take no more memory than this are read at once: nobody sees the frame that waits.
inline constexpr std::uintmax_t read_at_once_bytes = std::uintmax_t{32} << 20U;

/// A picture that is being read on a thread of its own, to which it belongs until take(). Thread safety: owner's thread
/// only.
class PictureReading {
public:
    /// Begins. `wake` is called from the reader's thread when it has ended.
    PictureReading(PictureSource source, PictureHeader header, std::function<void()> wake);
    /// Stops and waits for the reader: the time that a block of lines takes.
    ~PictureReading();
    PictureReading(const PictureReading&) = delete;
    PictureReading& operator=(const PictureReading&) = delete;

    [[nodiscard]] const PictureSource& source() const { return source_; }
    [[nodiscard]] const PictureHeader& header() const { return header_; }
    /// From 0 to 1.
    [[nodiscard]] double progress() const { return progress_.load(std::memory_order_relaxed); }
    /// By how long it took so far; none while that says nothing.
    [[nodiscard]] std::optional<double> seconds_left() const;
    /// Does not wait; what take() then gives is an error.
    void cancel() { stopped_.store(true, std::memory_order_relaxed); }
    [[nodiscard]] bool cancelled() const { return stopped_.load(std::memory_order_relaxed); }
    /// The picture, or why there is none, once; nothing while it is being read. Error: as read_picture.
    std::optional<Result<StokesImage>> take();

private:
    void read();

    const PictureSource source_;
    const PictureHeader header_;
    const std::function<void()> wake_;
    const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    std::atomic<double> progress_{0.0};
    std::atomic<bool> stopped_{false};
    std::atomic<bool> ended_{false};  // after which result_ is the owner's
    std::optional<Result<StokesImage>> result_;
    std::thread reader_;
};

/// Names of the layouts that the picture has by its header: several if its content does not say which. Slower than
/// read_picture_header, by the number of layouts.
std::vector<std::string_view> fitting_layouts(PictureSource source);

}  // namespace pol
