// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <type_traits>

#include "core/contract.h"
#include "io/live/tev_message.h"

namespace pol::tev {
namespace {

/// Writes one field after another, and the length at the end.
class Writer {
public:
    explicit Writer(Type type) {
        number(std::uint32_t{0});
        number(static_cast<std::uint8_t>(type));
    }
    template <class Number>
    void number(Number value) {
        static_assert(std::is_arithmetic_v<Number>);
        append(std::as_bytes(std::span(&value, 1)));
    }
    void flag(bool value) { number(static_cast<std::uint8_t>(value ? 1 : 0)); }
    void string(std::string_view value) {
        POL_EXPECTS(value.find('\0') == std::string_view::npos);
        append(std::as_bytes(std::span(value)));
        number(std::uint8_t{0});
    }
    void count(std::size_t value) { number(static_cast<std::int32_t>(value)); }
    void channels(const std::vector<std::string>& names) {
        count(names.size());
        for (const std::string& name : names) string(name);
    }
    void append(std::span<const std::byte> more) { bytes_.insert(bytes_.end(), more.begin(), more.end()); }

    std::vector<std::byte> done() {
        POL_EXPECTS(bytes_.size() <= std::numeric_limits<std::uint32_t>::max());
        const auto length = static_cast<std::uint32_t>(bytes_.size());
        std::memcpy(bytes_.data(), &length, sizeof length);
        return std::move(bytes_);
    }

private:
    std::vector<std::byte> bytes_;
};

}  // namespace

std::vector<std::byte> encode(const CreateImage& message) {
    Writer writer(Type::create);
    writer.flag(message.grab_focus);
    writer.string(message.name);
    writer.number(static_cast<std::int32_t>(message.width));
    writer.number(static_cast<std::int32_t>(message.height));
    writer.channels(message.channels);
    return writer.done();
}

std::vector<std::byte> encode(const CloseImage& message) {
    Writer writer(Type::close);
    writer.string(message.name);
    return writer.done();
}

std::vector<std::byte> encode(const Attributes& message) {
    Writer writer(Type::attributes);
    writer.string(message.name);
    writer.count(message.texts.size());
    for (const auto& [key, value] : message.texts) {
        writer.string(key);
        writer.string(value);
    }
    return writer.done();
}

std::vector<std::byte> encode(const UpdateImage& message) {
    Writer writer(Type::update_strided);
    writer.flag(message.grab_focus);
    writer.string(message.name);
    writer.channels(message.channels);
    writer.number(static_cast<std::int32_t>(message.rect.x0));
    writer.number(static_cast<std::int32_t>(message.rect.y0));
    writer.number(static_cast<std::int32_t>(message.rect.width()));
    writer.number(static_cast<std::int32_t>(message.rect.height()));
    for (const std::int64_t offset : message.offsets) writer.number(offset);
    for (const std::int64_t stride : message.strides) writer.number(stride);
    writer.append(message.numbers);
    return writer.done();
}

std::vector<std::byte> encode_planes(const std::string& name, const std::vector<std::string>& channels,
                                     const TileRect& rect, std::span<const float> numbers) {
    POL_EXPECTS(numbers.size() == channels.size() * rect.pixel_count());
    UpdateImage message{false, name, channels, rect, {}, {}, std::as_bytes(numbers)};
    for (std::size_t c = 0; c < channels.size(); ++c) {
        message.offsets.push_back(static_cast<std::int64_t>(c * rect.pixel_count()));
        message.strides.push_back(1);
    }
    return encode(message);
}

}  // namespace pol::tev
