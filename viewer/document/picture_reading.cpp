// SPDX-License-Identifier: Apache-2.0
#include "viewer/document/picture_reading.h"

#include <new>
#include <utility>

#include "viewer/document/give_way.h"

namespace pol {

PictureReading::PictureReading(PictureSource source, PictureHeader header, std::function<void()> wake)
    : source_(std::move(source)), header_(std::move(header)), wake_(std::move(wake)), reader_([this] { read(); }) {}

PictureReading::~PictureReading() {
    cancel();
    reader_.join();
}

void PictureReading::read() {
    give_way();
    const auto go_on = [this](double share) {
        progress_.store(share, std::memory_order_relaxed);
        return !cancelled();
    };
    try {
        result_.emplace(read_picture(source_, go_on));
    } catch (const std::bad_alloc&) {
        result_.emplace(Error{ErrorKind::input,
                              "is larger than the memory that is free",
                              {source_.path().string()},
                              {},
                              "close other documents, or cut the picture"});
    }
    ended_.store(true, std::memory_order_release);
    if (wake_) wake_();
}

std::optional<double> PictureReading::seconds_left() const {
    constexpr double says_something = 0.03;
    const double done = progress();
    if (done < says_something) return std::nullopt;
    const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    return passed * (1.0 - done) / done;
}

std::optional<Result<StokesImage>> PictureReading::take() {
    if (!ended_.load(std::memory_order_acquire)) return std::nullopt;
    return std::exchange(result_, std::nullopt);
}

std::vector<std::string_view> fitting_layouts(PictureSource source) {
    std::vector<std::string_view> fitting;
    for (const PictureLayout& layout : picture_layouts()) {
        source.layout = layout.name;
        if (read_picture_header(source)) fitting.push_back(layout.name);
    }
    return fitting;
}

}  // namespace pol
