// SPDX-License-Identifier: Apache-2.0
// What the parts of an EXR file hold, from their headers alone. For exr_reader.cpp; throws what OpenEXR throws.
#pragma once

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfMultiPartInputFile.h>

#include <map>
#include <string>
#include <vector>

#include "core/result.h"
#include "film/stokes_image.h"

namespace pol::exr {

/// The channels of all parts together, as if the file had one part.
class Parts {
public:
    explicit Parts(const Imf::MultiPartInputFile& file);

    /// Names of the channels, ascending.
    [[nodiscard]] std::vector<std::string> names() const;
    /// Values of a string attribute, each once, in the order of the parts.
    [[nodiscard]] std::vector<std::string> texts(const std::string& attribute) const;
    /// The first of them, else "".
    [[nodiscard]] std::string text(const std::string& attribute) const;
    [[nodiscard]] const Imf::Header& header(int part) const { return headers_.at(part); }

    /// The part of each of `channels`. Error (kind input, without a place), by name: a channel is in two parts, deep or
    /// not of full resolution, or two parts have different data windows.
    [[nodiscard]] Result<std::map<std::string, int>> locate(const std::vector<std::string>& channels) const;

    /// The coarsest of the ways in which `channels` are stored.
    [[nodiscard]] StoredNumbers stored(const std::vector<std::string>& channels) const;

private:
    struct Found {
        std::vector<int> parts;  ///< that have the channel
        Imf::Channel channel;
    };
    std::map<int, Imf::Header> headers_;  ///< by part
    std::map<std::string, Found> channels_;
};

}  // namespace pol::exr
