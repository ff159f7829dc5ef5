// SPDX-License-Identifier: Apache-2.0
// A picture that another program makes while we look: which of its channels mean what, and how its messages change it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "film/stokes_image.h"
#include "io/live/tev_message.h"

namespace pol {

/// What the client says of its picture in its name, which every client can choose: `render|handedness=left,zero=up`.
struct LiveName {
    std::string shown;                           ///< "render"
    std::optional<StokesConvention> convention;  ///< empty: not said
    std::string layout;                          ///< name of a PictureLayout, or empty
    std::string problem;  ///< a sentence if what stands behind the bar was not understood: then all of it is `shown`
};

/// Keys behind the last '|': handedness=left|right, zero=right|up, y=up|down,
/// layout=NAME.
LiveName read_live_name(std::string_view name);

/// What is known of a live picture from the message that creates it; no pixels. Never changes.
///
/// If find_stokes_channels() knows the channels, it is a Stokes picture. Otherwise a picture of colour: R, G and B, or
/// each channel as a band of its own, S0 alone.
class LivePicture {
public:
    explicit LivePicture(const tev::CreateImage& message);

    /// As clients call it, with what stands behind the bar.
    [[nodiscard]] const std::string& key() const { return key_; }
    /// What users read.
    [[nodiscard]] const std::string& name() const { return name_.shown; }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

    /// Bytes that blank() takes; in double, as a number of any size may be asked for.
    [[nodiscard]] double bytes() const;

    /// Its size, bands and origin, all numbers 0. `origin.convention` is what the name says.
    [[nodiscard]] StokesImage blank() const;

    /// Why an update does not fit the picture: `rectangle` or `channel`.
    [[nodiscard]] std::optional<tev::Fault> fault_of(const tev::UpdateImage& update) const;

    /// Takes the numbers of an update over, from image.origin.convention to ours. True if one of its channels is shown.
    /// Components that the update does not bring keep their values. Requires: `image` began as blank(), and the update
    /// has no fault.
    bool apply(const tev::UpdateImage& update, StokesImage& image) const;

    /// Keeps the texts as image.attributes, as many as one message may have. polarisationHandedness = left or right
    /// changes the convention, whatever the name has said; if the user has chosen one, it is to be read_in() again.
    void apply(const tev::Attributes& attributes, StokesImage& image) const;

private:
    struct Slot {
        std::size_t band = 0;
        unsigned component = 0;
    };
    void show_colour(const std::vector<std::string>& names);

    std::string key_;
    LiveName name_;
    int width_ = 0;
    int height_ = 0;
    std::vector<Band> bands_;
    PictureOrigin origin_;
    std::map<std::string, std::optional<Slot>, std::less<>> channels_;  ///< all; empty: not shown
};

}  // namespace pol
