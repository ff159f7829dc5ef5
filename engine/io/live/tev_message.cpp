// SPDX-License-Identifier: Apache-2.0
#include "io/live/tev_message.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "io/live/utf8.h"

namespace pol::tev {
namespace {

/// Numbers behind each kind of vector command, by its number (tev, VgCommand); two of them have a string, too.
constexpr std::array<std::uint8_t, 26> vector_numbers{0, 0, 4, 0, 4, 0, 0, 0, 1, 0, 2, 2, 5,
                                                      6, 6, 3, 4, 4, 4, 5, 8, 2, 1, 0, 2, 2};
constexpr std::uint8_t text_command = 21;
constexpr std::uint8_t font_command = 23;

/// Takes one field after another. The first fault stays, and all fields after it are empty.
class Fields {
public:
    Fields(std::span<const std::byte> bytes, const MessageLimits& limits) : rest_(bytes), limits_(limits) {}

    void fail(Fault fault) {
        if (!fault_) fault_ = fault;
        rest_ = {};
    }
    [[nodiscard]] const std::optional<Fault>& fault() const { return fault_; }
    [[nodiscard]] bool failed() const { return fault_.has_value(); }
    [[nodiscard]] std::span<const std::byte> rest() const { return rest_; }

    template <class Number>
    Number number() {
        Number value{};
        if (rest_.size() < sizeof value) {
            fail(Fault::cut_short);
            return value;
        }
        std::memcpy(&value, rest_.data(), sizeof value);
        rest_ = rest_.subspan(sizeof value);
        return value;
    }

    bool flag() { return number<std::uint8_t>() == 1; }

    void skip(std::size_t bytes) {
        if (rest_.size() < bytes) return fail(Fault::cut_short);
        rest_ = rest_.subspan(bytes);
    }

    std::string string() { return string(limits_.name_bytes); }
    std::string string(std::size_t longest) {
        if (failed()) return {};
        const auto end = std::find(rest_.begin(), rest_.end(), std::byte{0});
        if (end == rest_.end()) {
            fail(Fault::text_end);
            return {};
        }
        const auto length = static_cast<std::size_t>(end - rest_.begin());
        const std::string_view bytes(reinterpret_cast<const char*>(rest_.data()), length);
        if (length > longest || !is_utf8(bytes)) {
            fail(length > longest ? Fault::text_length : Fault::utf8);
            return {};
        }
        std::string value(bytes);
        rest_ = rest_.subspan(length + 1);
        return value;
    }

    /// A number of things, of which each takes at least one byte.
    std::size_t count(std::size_t least, std::size_t most, Fault otherwise) {
        const auto value = number<std::int32_t>();
        if (failed()) return 0;
        if (value < 0 || static_cast<std::size_t>(value) < least || static_cast<std::size_t>(value) > most) {
            fail(otherwise);
            return 0;
        }
        if (static_cast<std::size_t>(value) > rest_.size()) {
            fail(Fault::cut_short);
            return 0;
        }
        return static_cast<std::size_t>(value);
    }

    std::vector<std::string> channels() {
        const std::size_t n = count(1, limits_.channels, Fault::channel_count);
        std::vector<std::string> names;
        for (std::size_t i = 0; i < n && !failed(); ++i) names.push_back(string());
        return names;
    }

    TileRect rectangle() {
        const auto x = number<std::int32_t>();
        const auto y = number<std::int32_t>();
        const auto width = number<std::int32_t>();
        const auto height = number<std::int32_t>();
        if (failed()) return {};
        constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
        const bool fits = x >= 0 && y >= 0 && width >= 1 && height >= 1 && width <= most - x && height <= most - y;
        if (!fits || is_too_large(width, height)) {
            fail(Fault::rectangle);
            return {};
        }
        return {x, y, x + width, y + height};
    }

    /// Requires: neither is negative.
    [[nodiscard]] bool is_too_large(std::int32_t width, std::int32_t height) const {
        return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) > limits_.pixels;
    }

private:
    std::span<const std::byte> rest_;
    const MessageLimits& limits_;
    std::optional<Fault> fault_;
};

OpenImage take_open(Fields& fields, bool has_selector) {
    OpenImage message;
    message.grab_focus = fields.flag();
    message.path = fields.string();
    if (has_selector) {
        message.selector = fields.string();
    } else if (const std::size_t colon = message.path.rfind(':'); colon != std::string::npos) {
        message.selector = message.path.substr(colon + 1);
        message.path.resize(colon);
    }
    return message;
}

CreateImage take_create(Fields& fields) {
    CreateImage message;
    message.grab_focus = fields.flag();
    message.name = fields.string();
    message.width = fields.number<std::int32_t>();
    message.height = fields.number<std::int32_t>();
    if (!fields.failed() &&
        (message.width < 1 || message.height < 1 || fields.is_too_large(message.width, message.height)))
        fields.fail(Fault::size);
    message.channels = fields.channels();
    std::vector<std::string_view> sorted(message.channels.begin(), message.channels.end());
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) fields.fail(Fault::channel_twice);
    return message;
}

/// Whether offset + i stride lies in 0..numbers-1 for every i of 0..pixels-1. Requires: pixels >= 1.
bool stays_inside(std::int64_t offset, std::int64_t stride, std::uint64_t pixels, std::uint64_t numbers) {
    if (offset < 0 || static_cast<std::uint64_t>(offset) >= numbers) return false;
    const std::uint64_t steps = pixels - 1;
    if (steps == 0 || stride == 0) return true;
    const std::uint64_t before = static_cast<std::uint64_t>(offset);
    // Its size also where the negative number has no positive one.
    const std::uint64_t step =
        stride > 0 ? static_cast<std::uint64_t>(stride) : std::uint64_t{0} - static_cast<std::uint64_t>(stride);
    const std::uint64_t room = stride > 0 ? numbers - 1 - before : before;
    return step <= room / steps;
}

UpdateImage take_update(Fields& fields, Type type) {
    UpdateImage message;
    message.grab_focus = fields.flag();
    message.name = fields.string();
    if (type == Type::update)
        message.channels.push_back(fields.string());
    else
        message.channels = fields.channels();
    message.rect = fields.rectangle();
    if (fields.failed()) return message;
    const auto pixels = static_cast<std::int64_t>(message.rect.pixel_count());
    for (std::size_t c = 0; c < message.channels.size(); ++c) {
        const bool strided = type == Type::update_strided;
        message.offsets.push_back(strided ? fields.number<std::int64_t>() : static_cast<std::int64_t>(c) * pixels);
    }
    for (std::size_t c = 0; c < message.channels.size(); ++c)
        message.strides.push_back(type == Type::update_strided ? fields.number<std::int64_t>() : 1);
    if (fields.failed()) return message;
    message.numbers = fields.rest();
    const std::uint64_t numbers = message.numbers.size() / sizeof(float);
    for (std::size_t c = 0; c < message.channels.size(); ++c)
        if (!stays_inside(message.offsets[c], message.strides[c], static_cast<std::uint64_t>(pixels), numbers))
            fields.fail(type == Type::update_strided ? Fault::stride : Fault::cut_short);
    return message;
}

VectorGraphics take_vector_graphics(Fields& fields, const MessageLimits& limits) {
    VectorGraphics message;
    message.grab_focus = fields.flag();
    message.name = fields.string();
    message.append = fields.flag();
    message.commands = fields.count(0, limits.bytes, Fault::command);
    for (std::size_t i = 0; i < message.commands && !fields.failed(); ++i) {
        const auto kind = fields.number<std::uint8_t>();
        if (kind >= vector_numbers.size()) {
            fields.fail(Fault::command);
            break;
        }
        fields.skip(vector_numbers[kind] * sizeof(float));
        if (kind == text_command || kind == font_command) fields.string();
    }
    return message;
}

Attributes take_attributes(Fields& fields, const MessageLimits& limits) {
    Attributes message;
    message.name = fields.string();
    const std::size_t n = fields.count(0, limits.attributes, Fault::attributes);
    for (std::size_t i = 0; i < n && !fields.failed(); ++i) {
        std::string key = fields.string();
        message.texts.emplace_back(std::move(key), fields.string(limits.attribute_bytes));
    }
    return message;
}

Message take_fields(Fields& fields, Type type, const MessageLimits& limits) {
    switch (type) {
        case Type::open:
            return take_open(fields, false);
        case Type::open_with_selector:
            return take_open(fields, true);
        case Type::reload: {
            ReloadImage message;
            message.grab_focus = fields.flag();
            message.name = fields.string();
            return message;
        }
        case Type::close:
            return CloseImage{fields.string()};
        case Type::create:
            return take_create(fields);
        case Type::update:
        case Type::update_planes:
        case Type::update_strided:
            return take_update(fields, type);
        case Type::vector_graphics:
            return take_vector_graphics(fields, limits);
        case Type::attributes:
            return take_attributes(fields, limits);
    }
    fields.fail(Fault::type);
    return {};
}

}  // namespace

std::string_view text(Fault fault) {
    switch (fault) {
        case Fault::length:
            return "its length is below 6 or above the limit";
        case Fault::type:
            return "its type is unknown";
        case Fault::cut_short:
            return "it is shorter than its fields";
        case Fault::text_end:
            return "a name has no end";
        case Fault::text_length:
            return "a name or an attribute is too long";
        case Fault::utf8:
            return "a name is not UTF-8";
        case Fault::size:
            return "a picture of that size is not taken";
        case Fault::rectangle:
            return "its rectangle does not lie in the picture";
        case Fault::channel_count:
            return "it has no channels, or too many";
        case Fault::channel_twice:
            return "it has two channels of one name";
        case Fault::stride:
            return "offset and stride lead out of its numbers";
        case Fault::command:
            return "it draws what is unknown";
        case Fault::attributes:
            return "it has too many attributes";
        case Fault::open:
            return "it asks to open a file, which is not allowed";
        case Fault::picture:
            return "there is no picture of that name";
        case Fault::channel:
            return "the picture has no channel of that name";
        case Fault::memory:
            return "there are too many pictures, or they take too much memory";
    }
    return {};
}

bool is_known_type(std::uint8_t type) {
    return type <= static_cast<std::uint8_t>(Type::vector_graphics) ||
           type == static_cast<std::uint8_t>(Type::attributes);
}

std::variant<Message, Fault> decode(std::span<const std::byte> bytes, const MessageLimits& limits) {
    Fields fields(bytes, limits);
    const auto length = fields.number<std::uint32_t>();
    if (bytes.size() < shortest_message || bytes.size() > limits.bytes || length != bytes.size()) return Fault::length;
    const auto type = fields.number<std::uint8_t>();
    if (!is_known_type(type)) return Fault::type;
    Message message = take_fields(fields, static_cast<Type>(type), limits);
    if (fields.fault()) return *fields.fault();
    return message;
}

}  // namespace pol::tev
