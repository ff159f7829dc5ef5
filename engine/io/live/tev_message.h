// SPDX-License-Identifier: Apache-2.0
// The messages of the image viewer tev (Tom94/tev), by which programs show pictures while they make them:
//
//     u32 length (of the whole message, these 4 bytes included) | i8 type | fields
//     string = UTF-8 and a zero byte, bool = u8 (true only if 1), numbers little-endian
//
// One direction only: nobody answers. Strangers write them, so that nothing in a message is believed before it is
// checked against the bytes that are there.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "film/tile.h"

namespace pol::tev {

/// Where tev listens, and its clients look for it.
inline constexpr std::uint16_t default_port = 14158;

// Numbers are copied between memory and message as they are.
static_assert(std::endian::native == std::endian::little && std::numeric_limits<float>::is_iec559);

enum class Type : std::uint8_t {
    open = 0,
    reload = 1,
    close = 2,
    update = 3,
    create = 4,
    update_planes = 5,
    update_strided = 6,
    open_with_selector = 7,
    vector_graphics = 8,
    attributes = 112,
};

/// The fewest bytes of a message: length, type, and one of fields.
inline constexpr std::size_t shortest_message = 6;

/// What is refused though the protocol allows it.
struct MessageLimits {
    std::size_t bytes = std::size_t{1} << 30U;  ///< of a message
    std::size_t name_bytes = 4096;              ///< of a name, a key or a path, without the zero byte
    std::size_t channels = 4096;
    std::uint64_t pixels = std::uint64_t{1} << 31U;
    std::size_t attributes = 256;
    std::size_t attribute_bytes = 16384;  ///< of a value
};

/// Why a message is dropped. The last two are found only by who knows the pictures, and who counts the memory.
enum class Fault {
    length,         ///< below 6 or above the limit: the connection has lost its place, and must end
    type,           ///< no message has this number
    cut_short,      ///< the fields go on where the message ends
    text_end,       ///< a string without its zero byte
    text_length,    ///< a string longer than the limit
    utf8,           ///< a string that is none
    size,           ///< width or height below 1, or too many pixels
    rectangle,      ///< below 1 in width or height, or a part of it lies outside the picture
    channel_count,  ///< below 1, or more than the limit
    channel_twice,  ///< a picture with two channels of one name
    stride,         ///< offset and stride lead out of the numbers of the message
    command,        ///< vector graphics of an unknown kind
    attributes,     ///< more than the limit, or fewer than none
    open,           ///< asks to open a file of this machine
    picture,        ///< an update of a picture that is not there
    channel,        ///< an update of a channel that the picture does not have
    memory,         ///< more pictures or bytes than are allowed
};
inline constexpr std::size_t fault_count = static_cast<std::size_t>(Fault::memory) + 1;

/// "its length is below 6 or above the limit": ends a sentence about a message.
std::string_view text(Fault fault);

struct OpenImage {
    bool grab_focus = false;
    std::string path;
    std::string selector;  ///< of channels
};
struct ReloadImage {
    bool grab_focus = false;
    std::string name;
};
struct CloseImage {
    std::string name;
};
/// A picture filled with 0, in place of one of this name.
struct CreateImage {
    bool grab_focus = false;
    std::string name;
    int width = 0;
    int height = 0;
    std::vector<std::string> channels;  ///< each once
};
/// Numbers for a rectangle of a picture. All three forms of the message become the most general, the third.
struct UpdateImage {
    bool grab_focus = false;
    std::string name;
    std::vector<std::string> channels;
    TileRect rect{};  ///< not empty, x0 and y0 >= 0
    /// By channel, counted in numbers: the pixel i of the rectangle, row by row, is at offset + i stride. All of them
    /// lie in `numbers`.
    std::vector<std::int64_t> offsets;
    std::vector<std::int64_t> strides;
    std::span<const std::byte> numbers;  ///< floats without alignment, in the message that was decoded

    [[nodiscard]] float at(std::size_t channel, std::size_t pixel) const {
        const auto index = offsets[channel] + static_cast<std::int64_t>(pixel) * strides[channel];
        float number = 0.0F;
        std::memcpy(&number, numbers.data() + static_cast<std::size_t>(index) * sizeof(float), sizeof(float));
        return number;
    }
};
/// Drawings over a picture: checked, and not kept, as a command of one byte would take a hundred in memory.
struct VectorGraphics {
    bool grab_focus = false;
    std::string name;
    bool append = false;
    std::size_t commands = 0;
};
/// Message 112, which is polariscope's own: what is known of a picture beside its numbers. Keys as the attributes of
/// our EXR files without their prefix: frame, polarisationHandedness, samples, scene_hash, progress, ... tev says that
/// it does not know it, and goes on.
struct Attributes {
    std::string name;
    std::vector<std::pair<std::string, std::string>> texts;
};

using Message = std::variant<OpenImage, ReloadImage, CloseImage, CreateImage, UpdateImage, VectorGraphics, Attributes>;

/// True if messages of this type are read; all others can be skipped without keeping them.
bool is_known_type(std::uint8_t type);

/// A whole message, from its length on: the number there must be bytes.size(), or the fault is `length`. Bytes behind
/// the last field are ignored, as tev does. An UpdateImage refers to `bytes`.
std::variant<Message, Fault> decode(std::span<const std::byte> bytes, const MessageLimits& limits = {});

/// The bytes of a message. Requires: none of the strings has a zero byte, and the message is below 4 GiB.
std::vector<std::byte> encode(const CreateImage& message);
std::vector<std::byte> encode(const CloseImage& message);
std::vector<std::byte> encode(const Attributes& message);
/// As version 3, with offsets and strides.
std::vector<std::byte> encode(const UpdateImage& message);

/// `numbers` one plane after another: plane c has the pixels of the rectangle for channel c. Requires: channels.size()
/// * rect.pixel_count() numbers.
std::vector<std::byte> encode_planes(const std::string& name, const std::vector<std::string>& channels,
                                     const TileRect& rect, std::span<const float> numbers);

}  // namespace pol::tev
