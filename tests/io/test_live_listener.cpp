// SPDX-License-Identifier: Apache-2.0
#include "io/live/live_listener.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>

#include "io/live_client.h"
#include "io/tev_vectors.h"

namespace pol {
namespace {

using test::listener_with;
using test::LiveClient;
using test::LiveViewer;
using test::soon;
using test::tev_vector;
using test::tev_vectors;
using tev::Fault;

std::uint64_t count_of(const LiveListener& listener, Fault fault) {
    return listener.counts().faults[static_cast<std::size_t>(fault)];
}

std::vector<std::byte> all_good() {
    std::vector<std::byte> bytes;
    for (const char* name : {"create_stokes", "update_v3_all", "update_v3_tile", "create_rgb12", "update_rgb12",
                             "create_spectral", "vector_graphics"})
        for (const std::byte one : tev_vector(name).bytes) bytes.push_back(one);
    return bytes;
}

TEST(LiveListener, PicturesArriveWhateverPiecesTheirBytesComeIn) {
    std::atomic<int> woken{0};
    const auto listener = listener_with({}, [&] { ++woken; });
    const auto bytes = all_good();
    for (const std::size_t piece : {1U, 13U, 1000U}) {
        LiveViewer viewer;
        const LiveClient client(listener->address().port);
        for (std::size_t i = 0; i < bytes.size(); i += piece)
            client.send(std::span(bytes).subspan(i, std::min(piece, bytes.size() - i)));
        ASSERT_TRUE(soon([&] {
            viewer.take(*listener);
            return viewer.pictures.size() == 3;
        }));
        const auto* stokes = viewer.named("stokes");
        ASSERT_NE(stokes, nullptr);
        EXPECT_EQ(stokes->updates, 2);
        EXPECT_EQ(stokes->image.at(0, 3).s0, 1.5);
        EXPECT_EQ(stokes->image.at(0, 5), (Stokes<double>{0.5, 0.625, 0.75, 0.875}));
        EXPECT_TRUE(viewer.lines.empty());
    }
    EXPECT_TRUE(soon([&] { return woken > 0; }));
}

TEST(LiveListener, EveryMalformedMessageIsALineInTheLogAndNothingElse) {
    const auto listener = listener_with();
    LiveViewer viewer;
    for (const auto& vector : tev_vectors("bad")) {
        SCOPED_TRACE(vector.name);
        const LiveClient client(listener->address().port);
        client.send(tev_vector("create_stokes").bytes);
        client.send(vector.bytes);
        viewer.lines.clear();
        EXPECT_TRUE(soon([&] {
            viewer.take(*listener);
            return viewer.lines.size() == 1;
        }));
        ASSERT_EQ(viewer.pictures.size(), 1U);
        EXPECT_EQ(viewer.pictures.begin()->second.updates, 0);
        if (vector.name.starts_with("length")) {
            EXPECT_TRUE(client.is_closed());
            continue;
        }
        // The connection goes on.
        client.send(tev_vector("update_v3_all").bytes);
        EXPECT_TRUE(soon([&] {
            viewer.take(*listener);
            return viewer.pictures.begin()->second.updates == 1;
        }));
    }
    EXPECT_EQ(count_of(*listener, Fault::length), 3U);
    EXPECT_EQ(count_of(*listener, Fault::open), 1U);
    EXPECT_EQ(count_of(*listener, Fault::rectangle), 1U);
}

TEST(LiveListener, AFaultIsLoggedOnceAConnectionAndCountedEachTime) {
    const auto listener = listener_with();
    LiveViewer viewer;
    {
        const LiveClient client(listener->address().port);
        for (int i = 0; i < 20; ++i) client.send(tev_vector("update_gray_unknown_image").bytes);
        client.send(tev_vector("bad_utf8").bytes);
    }
    EXPECT_TRUE(soon([&] {
        viewer.take(*listener);
        return viewer.lines.size() == 3;
    }));
    EXPECT_EQ(count_of(*listener, Fault::picture), 20U);
    EXPECT_EQ(count_of(*listener, Fault::utf8), 1U);
    ASSERT_EQ(viewer.lines.size(), 3U);
    EXPECT_NE(viewer.lines[0].find("there is no picture of that name"), std::string::npos);
    EXPECT_NE(viewer.lines[2].find("21 of its messages were dropped"), std::string::npos);
}

TEST(LiveListener, TwoProgramsMayWorkAtOnePicture) {
    const auto listener = listener_with();
    LiveViewer viewer;
    const LiveClient first(listener->address().port);
    const LiveClient second(listener->address().port);
    first.send(tev_vector("create_stokes").bytes);
    ASSERT_TRUE(soon([&] {
        viewer.take(*listener);
        return viewer.named("stokes") != nullptr;
    }));
    second.send(tev_vector("update_v3_all").bytes);
    ASSERT_TRUE(soon([&] {
        viewer.take(*listener);
        return viewer.named("stokes")->updates == 1;
    }));
    // Creating it again replaces it; closing it ends it.
    second.send(tev_vector("create_stokes").bytes);
    ASSERT_TRUE(soon([&] {
        viewer.take(*listener);
        return viewer.named("stokes")->updates == 0;
    }));
    EXPECT_EQ(viewer.pictures.size(), 1U);
    second.send(tev_vector("close").bytes);
    EXPECT_TRUE(soon([&] {
        viewer.take(*listener);
        return viewer.pictures.empty();
    }));
}

TEST(LiveListener, MoreConnectionsThanAllowedAreClosed) {
    LiveRules rules;
    rules.connections = 2;
    const auto listener = listener_with(rules);
    const LiveClient first(listener->address().port);
    LiveClient second(listener->address().port);
    ASSERT_TRUE(soon([&] { return listener->counts().connections == 2; }));
    const LiveClient third(listener->address().port);
    EXPECT_TRUE(third.is_closed());
    second.close();
    // Each try is a client of its own, and two of them may have been let in before the count is read.
    EXPECT_TRUE(soon([&] {
        const LiveClient another(listener->address().port);
        return listener->counts().connections >= 3;
    }));
}

TEST(LiveListener, PicturesAndTheirMemoryHaveLimits) {
    LiveRules rules;
    rules.pictures = 2;
    rules.picture_bytes = 1000.0 * 32.0;
    const auto listener = listener_with(rules);
    LiveViewer viewer;
    const LiveClient client(listener->address().port);
    const auto create = [&](const std::string& name, int width) {
        client.send(tev::encode(tev::CreateImage{false, name, width, 1, {"S0", "S1", "S2", "S3"}}));
    };
    create("too large", 1000);  // with its names
    create("a", 900);
    create("b", 900);
    create("too many", 1);
    create("a", 800);  // replaces
    ASSERT_TRUE(soon([&] { return listener->counts().messages == 5; }));
    viewer.take(*listener);
    EXPECT_EQ(viewer.pictures.size(), 2U);
    EXPECT_EQ(viewer.named("a")->image.width, 800);
    EXPECT_EQ(count_of(*listener, Fault::memory), 2U);
    // What the window closes makes room, and is unknown from then on.
    listener->forget(viewer.pictures.begin()->first);
    create("c", 1);
    ASSERT_TRUE(soon([&] { return listener->counts().messages == 6; }));
    EXPECT_EQ(count_of(*listener, Fault::memory), 2U);
}

TEST(LiveListener, AllMemoryTogetherHasALimit) {
    LiveRules rules;
    rules.all_bytes = 2e6;
    const auto listener = listener_with(rules);
    // A message that never ends.
    const LiveClient client(listener->address().port);
    std::vector<std::byte> bytes(4000000);
    const std::uint32_t length = 1U << 30U;
    std::memcpy(bytes.data(), &length, sizeof length);
    bytes[4] = std::byte{3};
    client.send(bytes);
    EXPECT_TRUE(client.is_closed());
    EXPECT_EQ(count_of(*listener, Fault::memory), 1U);
}

TEST(LiveListener, ASlowWindowPushesBack) {
    LiveRules rules;
    rules.unread_bytes = 100000;
    const auto listener = listener_with(rules);
    const LiveClient client(listener->address().port);
    client.send(tev::encode(tev::CreateImage{false, "a", 64, 64, {"R"}}));
    const std::vector<float> numbers(64 * 64, 1.0F);
    const auto tile = tev::encode_planes("a", {"R"}, {0, 0, 64, 64}, numbers);
    // Nobody takes: what is sent stays between the two programs, until nothing more fits there.
    constexpr int far_too_many = 4000;  // 65 MB
    int sent = 0;
    std::size_t rest = 0;
    for (int quiet = 0; sent < far_too_many && quiet < 100;) {
        const std::size_t now = client.send(std::span(tile).subspan(rest), MSG_DONTWAIT);
        rest += now;
        if (rest == tile.size()) {
            rest = 0;
            ++sent;
            quiet = 0;
        } else {
            ++quiet;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }
    EXPECT_LT(sent, far_too_many);
    EXPECT_LE(listener->counts().messages, 25U) << "it read on";
    // As soon as somebody takes, all of it comes.
    LiveViewer viewer;
    std::thread rest_of_it([&] {
        client.send(std::span(tile).subspan(rest));
        for (int i = 0; i < 10; ++i) client.send(tile);
    });
    EXPECT_TRUE(soon([&] {
        viewer.take(*listener, 50000);
        const auto* shown = viewer.named("a");
        return shown != nullptr && shown->updates == sent + 11;
    }));
    rest_of_it.join();
}

TEST(LiveListener, AMessageLargerThanWhatMayWaitGetsThrough) {
    LiveRules rules;
    rules.unread_bytes = 1000;
    const auto listener = listener_with(rules);
    const LiveClient client(listener->address().port);
    client.send(tev::encode(tev::CreateImage{false, "a", 500, 500, {"R"}}));
    client.send(tev::encode_planes("a", {"R"}, {0, 0, 500, 500}, std::vector<float>(250000, 2.0F)));
    LiveViewer viewer;
    EXPECT_TRUE(soon([&] {
        viewer.take(*listener, 10);
        return viewer.named("a") != nullptr && viewer.named("a")->updates == 1;
    }));
    EXPECT_EQ(viewer.named("a")->image.stokes.back().s0, 2.0);
}

TEST(LiveListener, FilesAreOpenedFromTheGivenFolderOnly) {
    namespace fs = std::filesystem;
    const fs::path base = fs::temp_directory_path() / ("polariscope-live-" + std::to_string(getpid()));
    fs::create_directories(base / "open");
    fs::create_directories(base / "open-not");
    std::ofstream(base / "open" / "a.exr") << "x";
    std::ofstream(base / "open-not" / "b.exr") << "x";
    fs::create_symlink(base / "open-not" / "b.exr", base / "open" / "link.exr");
    LiveRules rules;
    rules.open_folder = base / "open";
    LiveDesk desk(rules);
    const auto opens = [&](const std::string& path) {
        // Version 2 of the message has no encoder, as nobody here sends it.
        std::vector<std::byte> bytes(4);
        bytes.push_back(std::byte{7});
        bytes.push_back(std::byte{1});
        for (const char c : path) bytes.push_back(static_cast<std::byte>(c));
        bytes.resize(bytes.size() + 2);
        const auto length = static_cast<std::uint32_t>(bytes.size());
        std::memcpy(bytes.data(), &length, sizeof length);
        const auto answer = desk.receive(bytes, 0.0);
        if (const auto* fault = std::get_if<Fault>(&answer)) {
            EXPECT_EQ(*fault, Fault::open);
            return false;
        }
        return std::holds_alternative<LiveOpened>(*std::get<std::optional<LiveEvent>>(answer));
    };
    EXPECT_TRUE(opens("a.exr"));
    EXPECT_TRUE(opens((base / "open" / "a.exr").string()));
    EXPECT_TRUE(opens("../open/a.exr"));
    EXPECT_FALSE(opens("../open-not/b.exr"));
    EXPECT_FALSE(opens("link.exr"));
    EXPECT_FALSE(opens("."));
    EXPECT_FALSE(opens("missing.exr"));
    EXPECT_FALSE(opens("/etc/passwd"));
    fs::remove_all(base);
}

TEST(LiveListener, ATakenPortIsNamedWithTheNextOne) {
    const auto first = listener_with();
    const std::uint16_t port = first->address().port;
    const auto second = LiveListener::start({"127.0.0.1", port}, {}, {});
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().kind, ErrorKind::usage);
    EXPECT_EQ(second.error().what, "tev or another program has port " + std::to_string(port));
    EXPECT_EQ(second.error().hint, "use --listen 127.0.0.1:" + std::to_string(port + 1));
}

TEST(LiveListener, OthersReachItOnlyIfThatIsMeant) {
    const auto refused = LiveListener::start({"0.0.0.0", 0}, {}, {});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().hint.find("--listen-anywhere"), std::string::npos);
    LiveRules rules;
    rules.anywhere = true;
    EXPECT_TRUE(LiveListener::start({"0.0.0.0", 0}, rules, {}));
}

TEST(LiveListener, ASocketInTheFileSystemIsForThisUserAndGoesAway) {
    namespace fs = std::filesystem;
    const std::string path =
        (fs::temp_directory_path() / ("polariscope-live-" + std::to_string(getpid()) + ".sock")).string();
    LiveAddress address;
    address.unix_path = path;
    {
        const auto listener = LiveListener::start(address, {}, {});
        ASSERT_TRUE(listener) << to_string(listener.error());
        EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
        EXPECT_FALSE(LiveListener::start(address, {}, {})) << "it is taken";
        EXPECT_TRUE(connect_to(address, 1.0, [] { return false; }));
    }
    EXPECT_FALSE(fs::exists(path));
    // What is no socket stays.
    std::ofstream(path) << "mine";
    EXPECT_FALSE(LiveListener::start(address, {}, {}));
    EXPECT_TRUE(fs::exists(path));
    fs::remove(path);
}

TEST(LiveAddress, IsReadAsItIsWritten) {
    const auto text_of = [](std::string_view text) {
        const auto address = read_live_address(text);
        return address ? address.value().text() : "error";
    };
    EXPECT_EQ(text_of(""), "127.0.0.1:14158");
    EXPECT_EQ(text_of("14159"), "127.0.0.1:14159");
    EXPECT_EQ(text_of("stone"), "stone:14158");
    EXPECT_EQ(text_of("stone:1"), "stone:1");
    EXPECT_EQ(text_of("[::1]:7"), "[::1]:7");
    EXPECT_EQ(text_of("[::1]"), "[::1]:14158");
    EXPECT_EQ(text_of("unix:/run/x"), "unix:/run/x");
    for (const char* bad : {":1", "a:", "a:b", "a:65536", "a:-1", "::1", "[::1", "[::1]7", "[::1]:", "unix:", "99999"})
        EXPECT_EQ(text_of(bad), "error") << bad;
    EXPECT_EQ(text_of("unix:" + std::string(108, 'a')), "error");
}

}  // namespace
}  // namespace pol
