// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/result.h"
#include "film/film_sums.h"
#include "io/live/live_address.h"
#include "io/live/sockets.h"

namespace pol {

/// The names under which a picture is sent: R, G and B, which every viewer shows, then the Stokes components: S0.R to
/// S3.B, S0.580,000000nm to S3.580,000000nm, ...; of a single band without a wavelength S0 to S3 alone. Components that
/// are not known are left out.
std::vector<std::string> live_channels(const std::vector<Band>& bands);

/// The numbers of a picture for live_channels(image.bands), one plane after another.
std::vector<float> live_planes(const StokesImage& image);

/// A picture that is sent while it is made. All functions are called on the sender's thread.
struct LiveSource {
    std::string name;
    int width = 0;
    int height = 0;
    std::vector<Band> bands;
    std::function<int()> tile_count;
    /// As Film::tile_if_newer.
    std::function<std::optional<TileSnapshot>(int tile, Version& seen)> tile_if_newer;
};

/// A finished picture, which must stay as long as the source.
LiveSource source_of(const StokesImage& picture, std::string name);

/// Sends a picture to tev, or to whoever speaks its protocol, on a thread of its own, and disturbs nobody by it.
///
/// A tile is asked for at most 4 times a second, when it is sent as it is then. A receiver that takes nothing for 3 s
/// is given up. A lost connection is tried again once a second, and the whole picture is sent anew.
class LiveSender {
public:
    /// `lost` is told once, on the sender's thread, when the first connection fails or is lost.
    LiveSender(LiveAddress address, LiveSource source, std::function<void(const Error&)> lost = {});
    /// Ends within about 0.1 s, whatever is still to be sent.
    ~LiveSender() = default;
    LiveSender(const LiveSender&) = delete;
    LiveSender& operator=(const LiveSender&) = delete;

    /// Waits until everything that the source has now is sent, at most `seconds`, or until the connection is
    /// lost. Error (kind output): it is not, and why.
    Result<Done> finish(double seconds);

private:
    void work(const std::stop_token& stop);
    [[nodiscard]] Result<Done> send_picture(const std::stop_token& stop);
    [[nodiscard]] Result<Done> send_news(const Descriptor& socket, std::vector<Version>& seen,
                                         const std::stop_token& stop);
    void wait_until(std::chrono::steady_clock::time_point time, const std::stop_token& stop);

    const LiveAddress address_;
    const LiveSource source_;
    const std::vector<std::string> channels_;
    const std::function<void(const Error&)> lost_;

    std::mutex mutex_;  // guards the members below
    std::condition_variable_any changed_;
    bool finish_ = false;    // the source will not change any more
    bool finished_ = false;  // and all of it is sent
    bool told_ = false;
    std::optional<Error> problem_;  // of the connection as it is now

    std::jthread thread_;
};

}  // namespace pol
