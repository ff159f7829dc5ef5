// SPDX-License-Identifier: Apache-2.0
#include "io/live/tev_message.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <variant>

#include "io/live/message_stream.h"
#include "io/live/utf8.h"
#include "io/tev_vectors.h"

namespace pol::tev {
namespace {

using test::tev_vector;
using test::tev_vectors;
using test::TevVector;

/// The message as the file of vectors describes one.
struct Described {
    nlohmann::json json;

    void operator()(const OpenImage& m) {
        // The file writes version 1 as it was sent.
        const bool first = json.at("type") == "OpenImage";
        json["grab"] = m.grab_focus;
        json["name"] = first ? m.path + ":" + m.selector : m.path;
        if (!first) json["selector"] = m.selector;
    }
    void operator()(const ReloadImage& m) {
        json["grab"] = m.grab_focus;
        json["name"] = m.name;
    }
    void operator()(const CloseImage& m) { json["name"] = m.name; }
    void operator()(const CreateImage& m) {
        json["grab"] = m.grab_focus;
        json["name"] = m.name;
        json["size"] = {m.width, m.height};
        json["channels"] = m.channels;
    }
    void operator()(const UpdateImage& m) {
        json["grab"] = m.grab_focus;
        json["name"] = m.name;
        json["channels"] = m.channels;
        json["rect"] = {m.rect.x0, m.rect.y0, m.rect.width(), m.rect.height()};
        json["offsets"] = m.offsets;
        json["strides"] = m.strides;
        for (std::size_t c = 0; c < m.channels.size(); ++c) {
            json["first"].push_back(m.at(c, 0));
            json["last"].push_back(m.at(c, m.rect.pixel_count() - 1));
        }
    }
    void operator()(const VectorGraphics& m) {
        json["grab"] = m.grab_focus;
        json["name"] = m.name;
        json["append"] = m.append;
        json["commands"] = m.commands;
    }
    void operator()(const Attributes& /*m*/) { FAIL() << "no client sends it"; }
};

TEST(TevMessage, WhatClientsSendIsReadAsTheyMeanIt) {
    const auto vectors = tev_vectors("good");
    ASSERT_EQ(vectors.size(), 15U);
    for (const TevVector& vector : vectors) {
        SCOPED_TRACE(vector.name);
        const auto decoded = decode(vector.bytes);
        ASSERT_TRUE(std::holds_alternative<Message>(decoded)) << text(std::get<Fault>(decoded));
        nlohmann::json expected = vector.decoded;
        for (const char* key : {"length", "rest", "slack_bytes"}) expected.erase(key);
        if (expected.contains("commands")) expected["commands"] = expected["commands"].size();
        Described described{{{"type", expected.at("type")}}};
        std::visit(described, std::get<Message>(decoded));
        EXPECT_EQ(described.json, expected);
    }
}

TEST(TevMessage, EachMalformedOneIsRefusedForItsOwnReason) {
    // "outside" and "open_path" are well formed: who knows the pictures refuses them (LiveListener).
    const std::map<std::string, std::optional<Fault>> expected{
        {"length_0", Fault::length},        {"length_4", Fault::length},
        {"length_4_gib", Fault::length},    {"type_9", Fault::type},
        {"no_nul", Fault::text_end},        {"negative_size", Fault::size},
        {"huge_size", Fault::size},         {"channels_minus_1", Fault::channel_count},
        {"negative_stride", Fault::stride}, {"offset_overflow", Fault::stride},
        {"short_data", Fault::stride},      {"outside", std::nullopt},
        {"bad_utf8", Fault::utf8},          {"open_path", std::nullopt},
    };
    const auto vectors = tev_vectors("bad");
    ASSERT_EQ(vectors.size(), expected.size());
    for (const TevVector& vector : vectors) {
        SCOPED_TRACE(vector.name);
        const auto decoded = decode(vector.bytes);
        const Fault* fault = std::get_if<Fault>(&decoded);
        EXPECT_EQ(fault ? std::optional(*fault) : std::nullopt, expected.at(vector.name));
        EXPECT_TRUE(!fault || !text(*fault).empty());
    }
}

TEST(TevMessage, EveryFaultHasAReasonOfItsOwn) {
    std::vector<std::string_view> reasons;
    for (std::size_t i = 0; i < fault_count; ++i) reasons.push_back(text(static_cast<Fault>(i)));
    std::sort(reasons.begin(), reasons.end());
    EXPECT_FALSE(reasons.front().empty());
    EXPECT_EQ(std::adjacent_find(reasons.begin(), reasons.end()), reasons.end());
}

TEST(TevMessage, AMessageCutAnywhereIsRefused) {
    for (TevVector& vector : tev_vectors("good")) {
        SCOPED_TRACE(vector.name);
        while (vector.bytes.size() > 5) {
            vector.bytes.pop_back();
            vector.bytes[0] = static_cast<std::byte>(vector.bytes.size() & 0xFFU);
            vector.bytes[1] = static_cast<std::byte>(vector.bytes.size() >> 8U);
            EXPECT_TRUE(std::holds_alternative<Fault>(decode(vector.bytes))) << vector.bytes.size();
        }
    }
}

TEST(TevMessage, WhatWeSendIsWhatTheirClientSends) {
    for (const char* name : {"create_stokes", "create_rgb12", "create_spectral", "close", "update_v3_all",
                             "update_v3_tile", "update_rgb12", "update_v3_planar"}) {
        SCOPED_TRACE(name);
        const TevVector vector = tev_vector(name);
        const auto decoded = decode(vector.bytes);
        ASSERT_TRUE(std::holds_alternative<Message>(decoded));
        std::vector<std::byte> sent;
        const Message& message = std::get<Message>(decoded);
        if (const auto* create = std::get_if<CreateImage>(&message)) sent = encode(*create);
        if (const auto* close = std::get_if<CloseImage>(&message)) sent = encode(*close);
        if (const auto* update = std::get_if<UpdateImage>(&message)) sent = encode(*update);
        EXPECT_EQ(sent, vector.bytes);
    }
}

TEST(TevMessage, PlanesAreSentAsWaveTracerSendsThem) {
    const std::vector<float> numbers{0, 1, 2, 3, 4, 5, 6, 7};
    EXPECT_EQ(encode_planes("wt", {"S0", "S1", "S2", "S3"}, {0, 0, 2, 1}, numbers),
              tev_vector("update_v3_planar").bytes);
}

TEST(TevMessage, AttributesComeBackAsTheyWereSent) {
    const Attributes sent{"stone", {{"frame", "x right"}, {"progress", ""}, {"scene", "Zwölf"}}};
    const auto decoded = decode(encode(sent));
    ASSERT_TRUE(std::holds_alternative<Message>(decoded));
    const auto& got = std::get<Attributes>(std::get<Message>(decoded));
    EXPECT_EQ(got.name, sent.name);
    EXPECT_EQ(got.texts, sent.texts);
}

Fault fault_of(const std::vector<std::byte>& bytes, const MessageLimits& limits = {}) {
    const auto decoded = decode(bytes, limits);
    return std::holds_alternative<Fault>(decoded) ? std::get<Fault>(decoded) : Fault::memory;
}

TEST(TevMessage, LimitsHoldUpToTheirLastNumber) {
    MessageLimits limits;
    const CreateImage message{false, "four", 3, 2, {"S0", "S1"}};
    const auto bytes = encode(message);
    limits.name_bytes = 4;
    limits.channels = 2;
    limits.pixels = 6;
    limits.bytes = bytes.size();
    EXPECT_TRUE(std::holds_alternative<Message>(decode(bytes, limits)));
    const auto with = [&](auto member, auto value) {
        MessageLimits tighter = limits;
        tighter.*member = value;
        return tighter;
    };
    EXPECT_EQ(fault_of(bytes, with(&MessageLimits::name_bytes, 3U)), Fault::text_length);
    EXPECT_EQ(fault_of(bytes, with(&MessageLimits::channels, 1U)), Fault::channel_count);
    EXPECT_EQ(fault_of(bytes, with(&MessageLimits::pixels, 5U)), Fault::size);
    EXPECT_EQ(fault_of(bytes, with(&MessageLimits::bytes, bytes.size() - 1)), Fault::length);
    const auto attributes = encode(Attributes{"a", {{"k", "abcd"}, {"l", ""}}});
    EXPECT_EQ(fault_of(attributes, with(&MessageLimits::attributes, 1U)), Fault::attributes);
    EXPECT_EQ(fault_of(attributes, with(&MessageLimits::attribute_bytes, 3U)), Fault::text_length);
}

TEST(TevMessage, AChannelIsNamedOnce) {
    EXPECT_EQ(fault_of(encode(CreateImage{false, "a", 1, 1, {"R", "G", "R"}})), Fault::channel_twice);
}

TEST(TevMessage, EveryNumberOfAStrideLiesInTheMessage) {
    const std::vector<float> numbers{1, 2, 3, 4};
    const auto fault_with = [&](std::int64_t offset, std::int64_t stride) {
        UpdateImage update{false, "a", {"R"}, {0, 0, 2, 1}, {offset}, {stride}, std::as_bytes(std::span(numbers))};
        return fault_of(encode(update)) == Fault::stride;
    };
    EXPECT_FALSE(fault_with(0, 3));
    EXPECT_FALSE(fault_with(3, -3));
    EXPECT_FALSE(fault_with(3, 0));
    EXPECT_TRUE(fault_with(0, 4));
    EXPECT_TRUE(fault_with(1, 3));
    EXPECT_TRUE(fault_with(2, -3));
    EXPECT_TRUE(fault_with(4, 0));
    EXPECT_TRUE(fault_with(-1, 1));
    for (const std::int64_t extreme :
         {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()}) {
        EXPECT_TRUE(fault_with(1, extreme));
        EXPECT_TRUE(fault_with(extreme, 0));
    }
}

TEST(TevMessage, ARectangleBeyondAllNumbersIsRefused) {
    const std::vector<float> numbers(4);
    for (const TileRect& rect : {TileRect{-1, 0, 1, 1}, TileRect{0, -1, 1, 1}, TileRect{0, 0, 0, 1}}) {
        UpdateImage update{false, "a", {"R"}, rect, {0}, {0}, std::as_bytes(std::span(numbers))};
        EXPECT_EQ(fault_of(encode(update)), Fault::rectangle);
    }
    // x + width would overflow.
    UpdateImage update{false, "a", {"R"}, {0, 0, 2, 1}, {0}, {0}, std::as_bytes(std::span(numbers))};
    auto bytes = encode(update);
    const std::int32_t x = std::numeric_limits<std::int32_t>::max() - 1;
    std::memcpy(bytes.data() + 4 + 1 + 1 + 2 + 4 + 2, &x, sizeof x);
    EXPECT_EQ(fault_of(bytes), Fault::rectangle);
}

TEST(TevMessage, DrawingsOfAnUnknownKindAreRefused) {
    TevVector vector = tev_vector("vector_graphics");
    vector.bytes[15] = std::byte{26};  // the kind of the first command
    EXPECT_EQ(fault_of(vector.bytes), Fault::command);
}

TEST(Utf8, IsWhatRfc3629Says) {
    for (const char* good : {"", "abc", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEF\xBF\xBF",
                             "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
        EXPECT_TRUE(is_utf8(good)) << good;
    for (const char* bad : {"\x80", "\xC1\xBF", "\xC2", "\xC2\x41", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xE2\x82",
                            "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF\xFE"})
        EXPECT_FALSE(is_utf8(bad)) << bad;
}

TEST(Utf8, AStrangersNameCannotWriteALineOfTheLog) {
    EXPECT_EQ(quoted_name("a\nb\x1B[2J\x7F\xC2\x9B"),
              "'a?b?[2J?"
              "?'");
    EXPECT_EQ(quoted_name("Zwölf"), "'Zwölf'");
    EXPECT_EQ(quoted_name(std::string(100, 'x')), "'" + std::string(80, 'x') + "...'");
}

/// What a stream makes of bytes that come in pieces of `piece`.
struct Fed {
    std::vector<std::vector<std::byte>> messages;
    bool goes_on = true;
    std::size_t waiting = 0;
};
Fed feed(const std::vector<std::byte>& bytes, std::size_t piece) {
    Fed fed;
    MessageStream stream(MessageLimits{});
    for (std::size_t i = 0; i < bytes.size() && fed.goes_on; i += piece)
        fed.goes_on = stream.feed(std::span(bytes).subspan(i, std::min(piece, bytes.size() - i)),
                                  [&](std::vector<std::byte> message) { fed.messages.push_back(std::move(message)); });
    fed.waiting = stream.waiting();
    return fed;
}

TEST(MessageStream, MessagesAreTheSameInPiecesOfAnySize) {
    std::vector<std::byte> all;
    std::vector<std::vector<std::byte>> expected;
    for (const TevVector& vector : tev_vectors("good")) {
        all.insert(all.end(), vector.bytes.begin(), vector.bytes.end());
        expected.push_back(vector.bytes);
        const auto& unknown = tev_vector("type_9").bytes;
        all.insert(all.end(), unknown.begin(), unknown.end());
        expected.emplace_back();
    }
    for (const std::size_t piece : {1U, 2U, 3U, 7U, 100U, 4096U}) {
        const Fed fed = feed(all, piece);
        EXPECT_TRUE(fed.goes_on);
        EXPECT_EQ(fed.messages, expected) << piece;
        EXPECT_EQ(fed.waiting, 0U);
    }
}

TEST(MessageStream, ABadLengthEndsItBeforeAnythingElseIsRead) {
    for (const char* name : {"length_0", "length_4", "length_4_gib"}) {
        std::vector<std::byte> bytes = tev_vector(name).bytes;
        bytes.resize(64);
        for (const std::size_t piece : {1U, 64U}) {
            const Fed fed = feed(bytes, piece);
            EXPECT_FALSE(fed.goes_on) << name;
            EXPECT_TRUE(fed.messages.empty()) << name;
        }
    }
}

TEST(MessageStream, AMessageOfUnknownTypeIsNotKept) {
    // What a web browser would send: "GET " is a length of 541 MB, "/" a type.
    const std::string request = "GET / HTTP/1.1\r\nHost: localhost:14158\r\n\r\n";
    std::vector<std::byte> bytes(request.size());
    std::memcpy(bytes.data(), request.data(), request.size());
    const Fed fed = feed(bytes, 5);
    EXPECT_TRUE(fed.goes_on);
    EXPECT_EQ(fed.waiting, 0U);
    EXPECT_EQ(fed.messages, std::vector<std::vector<std::byte>>{{}});
}

}  // namespace
}  // namespace pol::tev
